#include "runtime/destruction/paint.h"

#include "runtime/destruction/blend_palette.h"
#include "runtime/destruction/spray.h"

namespace rubble {
namespace {

constexpr uint32_t kSecondNoise = 0x51ed270bu;  ///< makes a pattern that is independent of the first

/// What a spray does to one voxel.
struct SpraySample {
    int strength;  ///< 0..255, smaller toward the rim
    int rim;       ///< see rimFraction()
    glm::ivec3 cell;
    int axis;
};

/// Whether the spray touches a cell: always in the centre, at the rim with the paint's probability.
bool isTouched(const SpraySample& sample, const Paint& paint) {
    return surfaceNoise(sample.cell, sample.axis, paint.seed) < 255 - (255 - paint.probability) * sample.rim / 255;
}

/// The exposed voxels within a brush.
struct SprayedVoxels {
    const Brush& brush;
    const Paint& paint;

    template <class F>
    void forEachBrick(const VoxelGrid& grid, F&& f) const {
        const CellBox range = brushBricks(brush, grid.sizeInBricks());
        for (int z = range.low.z; z < range.high.z; ++z)
            for (int y = range.low.y; y < range.high.y; ++y)
                for (int x = range.low.x; x < range.high.x; ++x)
                    if (const Brick* brick = grid.brickAt({x, y, z}))
                        f(BrickSubset{{x, y, z}, brushBits(brush, {x, y, z}, brush.radii[0])}, *brick);
    }
    template <class F>
    void forEachSample(const VoxelGrid& grid, const BrickSubset& subset, const Brick& brick, F&& f) const {
        const ExposedBits exposed = exposedBits(grid, subset.brick, brick);
        const BrickBits visible = exposed.all();
        BrickBits cells = subset.voxels;
        for (size_t i = 0; i < 8; ++i) cells[i] &= visible[i];
        forEachVoxel(cells, [&](int i) {
            const glm::ivec3 cell = subset.brick * kBrickSize + voxelInBrick(i);
            const int rim = rimFraction(brush, cell);
            const SpraySample sample{paint.strength * (255 - (255 - paint.falloff) * rim / 255) / 255, rim, cell,
                                     exposed.axis(i)};
            if (isTouched(sample, paint)) f(i, sample);
        });
    }
};

/// The voxels that a caller lists.
struct ListedVoxels {
    std::span<const BrickSubset> cells;
    const Paint& paint;

    template <class F>
    void forEachBrick(const VoxelGrid& grid, F&& f) const {
        for (const BrickSubset& subset : cells)
            if (const Brick* brick = grid.brickAt(subset.brick)) f(subset, *brick);
    }
    template <class F>
    void forEachSample(const VoxelGrid&, const BrickSubset& subset, const Brick& brick, F&& f) const {
        BrickBits solid = subset.voxels;
        for (size_t i = 0; i < 8; ++i) solid[i] &= brick.occupancy[i];
        forEachVoxel(solid, [&](int i) {
            f(i, SpraySample{paint.strength, 0, subset.brick * kBrickSize + voxelInBrick(i), 2});
        });
    }
};

/// Replaces every brick of an area by repaint(subset, brick), which returns null for a brick that does not change.
template <class Area, class F>
void forEachBrickOf(VoxelGrid& grid, const Area& area, PaintResult& out, F&& repaint) {
    std::vector<std::pair<glm::ivec3, BrickRef>> repainted;
    area.forEachBrick(grid, [&](const BrickSubset& subset, const Brick& brick) {
        if (BrickRef after = repaint(subset, brick)) repainted.emplace_back(subset.brick, std::move(after));
    });
    for (auto& [position, brick] : repainted) {
        grid.setBrick(position, std::move(brick));
        out.bricks.push_back(position);
    }
}

/// The paint byte after one step of `color`.
uint8_t paintedByte(uint8_t before, int color, const SpraySample& sample, uint32_t seed) {
    const int noise = surfaceNoise(sample.cell, sample.axis, seed ^ kSecondNoise);
    const int steps = paintSteps(before);
    const int amount = (kPaintSteps - steps) * sample.strength;  // in 1/255 of a step; dithered to whole steps below
    const int added = std::min(kPaintSteps - steps, std::max(1, (amount + noise) / 255));
    const bool keepsColor =
        steps > 0 && paintColor(before) != color && noise >= std::max(sample.strength, 255 / kPaintSteps);
    return paintByte(keepsColor ? paintColor(before) : color, steps + added);
}

/// The number of a colour, 1 to 15: that of an equal one, else of a new one, else of the nearest.
int findColor(PaintColors& colors, Srgb color, uint64_t& merges) {
    int nearest = 0;
    for (int i = 1; i < colors.count; ++i)
        if (distanceSquared(colors.colors[size_t(i)], color) < distanceSquared(colors.colors[size_t(nearest)], color))
            nearest = i;
    if (colors.count > 0 && colors.colors[size_t(nearest)] == color) return nearest + 1;
    if (colors.count == kPaintColors) {
        ++merges;
        return nearest + 1;
    }
    colors.colors[colors.count] = color;
    return ++colors.count;
}

template <class Area>
PaintResult blendPalette(VoxelGrid& grid, const PaletteRef& palette, const Area& area) {
    PaintResult out;
    const Paint& paint = area.paint;
    if (paint.strength == 0) return out;
    BlendPalette blend(grid, *palette, paint);
    forEachBrickOf(grid, area, out, [&](const BrickSubset& subset, const Brick& brick) -> BrickRef {
        BrickIndices indices;
        expandBrick(&brick, indices);
        uint64_t changed = 0;
        area.forEachSample(grid, subset, brick, [&](int i, const SpraySample& sample) {
            if (surfaceNoise(sample.cell, sample.axis, paint.seed ^ kSecondNoise) * paint.strength >=
                sample.strength * 255)
                return;
            const uint8_t next = blend.blended(indices[size_t(i)]);
            changed += next != indices[size_t(i)];
            indices[size_t(i)] = next;
        });
        out.voxels += changed;
        return changed ? makeBrick(indices, brick.paint.get()) : nullptr;
    });
    out.merges = blend.merges();
    if (blend.hasChanged()) out.palette = std::make_shared<const Palette>(blend.palette());
    return out;
}

template <class Area>
PaintResult coverLayer(VoxelGrid& grid, const PaintColorsRef& colors, const Area& area) {
    PaintResult out;
    const Paint& paint = area.paint;
    if (paint.strength == 0) return out;
    PaintColors table = colors ? *colors : PaintColors{};
    const uint8_t colorsBefore = table.count;
    uint64_t merges = 0;
    const int color = findColor(table, paint.color, merges);
    forEachBrickOf(grid, area, out, [&](const BrickSubset& subset, const Brick& brick) -> BrickRef {
        BrickIndices layer{};
        if (brick.paint) layer = *brick.paint;
        uint64_t changed = 0;
        area.forEachSample(grid, subset, brick, [&](int i, const SpraySample& sample) {
            if (sample.strength == 0) return;
            const uint8_t next = paintedByte(layer[size_t(i)], color, sample, paint.seed);
            changed += next != layer[size_t(i)];
            layer[size_t(i)] = next;
        });
        out.voxels += changed;
        if (!changed) return nullptr;
        BrickIndices indices;
        expandBrick(&brick, indices);
        return makeBrick(indices, &layer);
    });
    if (out.voxels == 0) return out;
    out.merges = merges;
    if (table.count > colorsBefore) out.colors = std::make_shared<const PaintColors>(table);
    return out;
}

}  // namespace

PaintResult paintPalette(VoxelGrid& grid, const PaletteRef& palette, const Brush& brush, const Paint& paint) {
    return brush.radii[0] > 0 ? blendPalette(grid, palette, SprayedVoxels{brush, paint}) : PaintResult{};
}
PaintResult paintPalette(VoxelGrid& grid, const PaletteRef& palette, std::span<const BrickSubset> cells,
                         const Paint& paint) {
    return blendPalette(grid, palette, ListedVoxels{cells, paint});
}
PaintResult paintLayer(VoxelGrid& grid, const PaintColorsRef& colors, const Brush& brush, const Paint& paint) {
    return brush.radii[0] > 0 ? coverLayer(grid, colors, SprayedVoxels{brush, paint}) : PaintResult{};
}
PaintResult paintLayer(VoxelGrid& grid, const PaintColorsRef& colors, std::span<const BrickSubset> cells,
                       const Paint& paint) {
    return coverLayer(grid, colors, ListedVoxels{cells, paint});
}

}  // namespace rubble
