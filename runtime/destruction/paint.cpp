#include "runtime/destruction/paint.h"

#include "runtime/destruction/blend_palette.h"
#include "runtime/destruction/spray.h"

namespace rubble {
namespace {

constexpr uint32_t kSecondNoise = 0x51ed270bu;  ///< a pattern that has nothing to do with the first

/// What of a spray reaches one voxel.
struct Drop {
    int strength;  ///< 0..255, less toward the rim
    int rim;       ///< see rimShare()
    glm::ivec3 cell;
    int axis;
};

/// Whether the spray touches a cell at all: always in the middle, at the rim with the given probability.
bool isTouched(const Drop& drop, const Paint& paint) {
    return surfaceNoise(drop.cell, drop.axis, paint.seed) < 255 - (255 - paint.probability) * drop.rim / 255;
}

/// What a brush covers: the exposed voxels within it.
struct Sprayed {
    const Brush& brush;
    const Paint& paint;

    template <class F>
    void forEachBrick(const VoxelGrid& grid, F&& f) const {
        const CellBox range = brushBricks(brush, grid.sizeInBricks());
        for (int z = range.low.z; z < range.high.z; ++z)
            for (int y = range.low.y; y < range.high.y; ++y)
                for (int x = range.low.x; x < range.high.x; ++x)
                    if (const Brick* brick = grid.brickAt({x, y, z})) f(BrickShare{{x, y, z}, brushBits(brush, {x, y, z}, brush.radii[0])}, *brick);
    }
    template <class F>
    void forEachDrop(const VoxelGrid& grid, const BrickShare& share, const Brick& brick, F&& f) const {
        const ExposedBits exposed = exposedBits(grid, share.brick, brick);
        const BrickBits visible = exposed.all();
        BrickBits cells = share.voxels;
        for (size_t i = 0; i < 8; ++i) cells[i] &= visible[i];
        forEachVoxel(cells, [&](int i) {
            const glm::ivec3 cell = share.brick * kBrickSize + voxelInBrick(i);
            const int rim = rimShare(brush, cell);
            const Drop drop{paint.strength * (255 - (255 - paint.falloff) * rim / 255) / 255, rim, cell, exposed.axis(i)};
            if (isTouched(drop, paint)) f(i, drop);
        });
    }
};

/// The voxels that a caller names.
struct Named {
    std::span<const BrickShare> cells;
    const Paint& paint;

    template <class F>
    void forEachBrick(const VoxelGrid& grid, F&& f) const {
        for (const BrickShare& share : cells)
            if (const Brick* brick = grid.brickAt(share.brick)) f(share, *brick);
    }
    template <class F>
    void forEachDrop(const VoxelGrid&, const BrickShare& share, const Brick& brick, F&& f) const {
        BrickBits solid = share.voxels;
        for (size_t i = 0; i < 8; ++i) solid[i] &= brick.occupancy[i];
        forEachVoxel(solid, [&](int i) { f(i, Drop{paint.strength, 0, share.brick * kBrickSize + voxelInBrick(i), 2}); });
    }
};

/// Repaints every brick by repaint(share, brick), which returns null for one that does not change.
template <class Area, class F>
void forEachBrickOf(VoxelGrid& grid, const Area& area, Painted& out, F&& repaint) {
    std::vector<std::pair<glm::ivec3, BrickRef>> repainted;
    area.forEachBrick(grid, [&](const BrickShare& share, const Brick& brick) {
        if (BrickRef after = repaint(share, brick)) repainted.emplace_back(share.brick, std::move(after));
    });
    for (auto& [position, brick] : repainted) {
        grid.setBrick(position, std::move(brick));
        out.bricks.push_back(position);
    }
}

/// The paint byte after one step of `color`.
uint8_t layered(uint8_t before, int color, const Drop& drop, uint32_t seed) {
    const int noise = surfaceNoise(drop.cell, drop.axis, seed ^ kSecondNoise);
    const int steps = paintSteps(before);
    const int way = (kPaintSteps - steps) * drop.strength;  // in 255ths of a step, dithered to whole ones
    const int added = std::min(kPaintSteps - steps, std::max(1, (way + noise) / 255));
    const bool keepsColor = steps > 0 && paintColor(before) != color && noise >= std::max(drop.strength, 255 / kPaintSteps);
    return paintByte(keepsColor ? paintColor(before) : color, steps + added);
}

int distance2(Srgb a, Srgb b) {
    int sum = 0;
    for (size_t i = 0; i < 3; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

/// The number of a colour, 1 to 15: that of an equal one, else a new one, else the nearest.
int findColor(PaintColors& colors, Srgb color, uint64_t& merges) {
    int nearest = 0;
    for (int i = 1; i < colors.count; ++i)
        if (distance2(colors.colors[size_t(i)], color) < distance2(colors.colors[size_t(nearest)], color)) nearest = i;
    if (colors.count > 0 && colors.colors[size_t(nearest)] == color) return nearest + 1;
    if (colors.count == kPaintColors) {
        ++merges;
        return nearest + 1;
    }
    colors.colors[colors.count] = color;
    return ++colors.count;
}

template <class Area>
Painted blendPalette(VoxelGrid& grid, const PaletteRef& palette, const Area& area) {
    Painted out;
    const Paint& paint = area.paint;
    if (paint.strength == 0) return out;
    BlendPalette blend(grid, *palette, paint);
    forEachBrickOf(grid, area, out, [&](const BrickShare& share, const Brick& brick) -> BrickRef {
        BrickIndices indices;
        expandBrick(&brick, indices);
        uint64_t changed = 0;
        area.forEachDrop(grid, share, brick, [&](int i, const Drop& drop) {
            if (surfaceNoise(drop.cell, drop.axis, paint.seed ^ kSecondNoise) * paint.strength >= drop.strength * 255) return;
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
Painted coverLayer(VoxelGrid& grid, const PaintColorsRef& colors, const Area& area) {
    Painted out;
    const Paint& paint = area.paint;
    if (paint.strength == 0) return out;
    PaintColors table = colors ? *colors : PaintColors{};
    const uint8_t colorsBefore = table.count;
    uint64_t merges = 0;
    const int color = findColor(table, paint.color, merges);
    forEachBrickOf(grid, area, out, [&](const BrickShare& share, const Brick& brick) -> BrickRef {
        BrickIndices layer{};
        if (brick.paint) layer = *brick.paint;
        uint64_t changed = 0;
        area.forEachDrop(grid, share, brick, [&](int i, const Drop& drop) {
            if (drop.strength == 0) return;
            const uint8_t next = layered(layer[size_t(i)], color, drop, paint.seed);
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

Painted paintPalette(VoxelGrid& grid, const PaletteRef& palette, const Brush& brush, const Paint& paint) {
    return brush.radii[0] > 0 ? blendPalette(grid, palette, Sprayed{brush, paint}) : Painted{};
}
Painted paintPalette(VoxelGrid& grid, const PaletteRef& palette, std::span<const BrickShare> cells, const Paint& paint) {
    return blendPalette(grid, palette, Named{cells, paint});
}
Painted paintLayer(VoxelGrid& grid, const PaintColorsRef& colors, const Brush& brush, const Paint& paint) {
    return brush.radii[0] > 0 ? coverLayer(grid, colors, Sprayed{brush, paint}) : Painted{};
}
Painted paintLayer(VoxelGrid& grid, const PaintColorsRef& colors, std::span<const BrickShare> cells, const Paint& paint) {
    return coverLayer(grid, colors, Named{cells, paint});
}

Srgb paintOver(Srgb base, Srgb paint, int steps) {
    Srgb out;
    for (size_t i = 0; i < 3; ++i) out[i] = uint8_t((base[i] * (kPaintSteps - steps) + paint[i] * steps + kPaintSteps / 2) / kPaintSteps);
    return out;
}

}  // namespace rubble
