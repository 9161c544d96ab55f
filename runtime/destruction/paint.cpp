#include "runtime/destruction/paint.h"

#include "runtime/core/random.h"
#include "runtime/destruction/blend_palette.h"

namespace rubble {
namespace {

constexpr uint64_t kFirstColumn = 0x0101010101010101ull;

/// The voxels of a brick with at least one empty neighbour cell.
BrickBits exposedBits(const VoxelGrid& grid, glm::ivec3 position, const Brick& brick) {
    const auto occupancy = [&](glm::ivec3 step) {
        const Brick* neighbour = grid.brickAt(position + step);
        return neighbour ? neighbour->occupancy : BrickBits{};
    };
    const BrickBits left = occupancy({-1, 0, 0}), right = occupancy({1, 0, 0}), below = occupancy({0, -1, 0}), above = occupancy({0, 1, 0});
    const BrickBits back = occupancy({0, 0, -1}), front = occupancy({0, 0, 1});
    BrickBits out;
    for (size_t z = 0; z < 8; ++z) {
        const uint64_t own = brick.occupancy[z];
        uint64_t covered = (own << 1 & ~kFirstColumn) | (left[z] >> 7 & kFirstColumn);
        covered &= (own >> 1 & ~(kFirstColumn << 7)) | (right[z] & kFirstColumn) << 7;
        covered &= own << 8 | below[z] >> 56;
        covered &= own >> 8 | above[z] << 56;
        covered &= z > 0 ? brick.occupancy[z - 1] : back[7];
        covered &= z < 7 ? brick.occupancy[z + 1] : front[0];
        out[z] = own & ~covered;
    }
    return out;
}

/// Whether the spray touches a cell: always in the middle, at the rim with the given probability.
bool isSprayed(glm::ivec3 cell, const Brush& sphere, const Paint& paint) {
    int64_t distance2 = 0;
    for (int i = 0; i < 3; ++i) {
        const int64_t away = int64_t(cell[i]) * kBrushUnit + kBrushUnit / 2 - sphere.a[size_t(i)];
        distance2 += away * away;
    }
    const int64_t radius2 = sphere.radii[0] * sphere.radii[0];
    const int64_t limit = 255 - (255 - paint.probability) * distance2 / radius2;
    return int64_t(hashCell(cell.x, cell.y, cell.z, paint.seed) % 255) < limit;
}

}  // namespace

Painted paint(VoxelGrid& grid, const PaletteRef& palette, const Brush& sphere, const Paint& paint) {
    Painted out;
    if (sphere.radii[0] <= 0 || paint.strength == 0) return out;
    const CellBox range = brushBricks(sphere, grid.sizeInBricks());
    BlendPalette blend(grid, *palette, paint);
    std::vector<std::pair<glm::ivec3, BrickRef>> repainted;
    for (int z = range.low.z; z < range.high.z; ++z)
        for (int y = range.low.y; y < range.high.y; ++y)
            for (int x = range.low.x; x < range.high.x; ++x) {
                const glm::ivec3 position(x, y, z);
                const Brick* brick = grid.brickAt(position);
                if (!brick) continue;
                BrickBits cells = brushBits(sphere, position, sphere.radii[0]);
                const BrickBits exposed = exposedBits(grid, position, *brick);
                for (size_t i = 0; i < 8; ++i) cells[i] &= exposed[i];
                BrickIndices indices;
                expandBrick(brick, indices);
                uint64_t changed = 0;
                forEachVoxel(cells, [&](int i) {
                    if (!isSprayed(position * kBrickSize + voxelInBrick(i), sphere, paint)) return;
                    const uint8_t next = blend.blended(indices[size_t(i)]);
                    changed += next != indices[size_t(i)];
                    indices[size_t(i)] = next;
                });
                if (!changed) continue;
                out.voxels += changed;
                repainted.emplace_back(position, makeBrick(indices, brick->paint.get()));
            }
    for (auto& [position, brick] : repainted) {
        grid.setBrick(position, std::move(brick));
        out.bricks.push_back(position);
    }
    out.merges = blend.merges();
    if (blend.hasChanged()) out.palette = std::make_shared<const Palette>(blend.palette());
    return out;
}

}  // namespace rubble
