#pragma once
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

#include "runtime/core/random.h"
#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/voxel_grid.h"

/// Grids that tests and benchmarks of several modules need.
namespace rubble {

/// Sets all cells of a box to an entry; 0 empties them.
inline void fillBox(GridWriter& writer, const CellBox& box, uint8_t entry) {
    for (int z = box.low.z; z < box.high.z; ++z)
        for (int y = box.low.y; y < box.high.y; ++y)
            for (int x = box.low.x; x < box.high.x; ++x) writer.set({x, y, z}, entry);
}
/// Sets all cells of a box to an entry; 0 empties them.
inline void fillBox(VoxelGrid& grid, const CellBox& box, uint8_t entry) {
    GridWriter writer(grid);
    fillBox(writer, box, entry);
}

/// A grid whose cells are f(cell), a palette entry; 0 is empty.
template <std::invocable<glm::ivec3> F>
VoxelGrid gridOf(glm::ivec3 size, F&& f) {
    VoxelGrid grid(size);
    GridWriter writer(grid);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) writer.set({x, y, z}, f(glm::ivec3(x, y, z)));
    writer.flush();
    return grid;
}

/// Whether a cell next to this one, across a face, is empty or outside.
inline bool isExposed(const VoxelGrid& grid, glm::ivec3 cell) {
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1}) {
            glm::ivec3 next = cell;
            next[axis] += sign;
            if (!grid.at(next)) return true;
        }
    return false;
}

/// A grid with every cell set to one entry.
inline VoxelGrid solidGrid(glm::ivec3 size, uint8_t entry = 1) {
    return gridOf(size, [entry](glm::ivec3) { return entry; });
}

/// Noise: each cell is solid with a probability of `percent`, with an entry of 1 to 3.
inline VoxelGrid noiseGrid(glm::ivec3 size, int percent, uint64_t seed) {
    Random random(seed);
    return gridOf(
        size, [&](glm::ivec3) { return int(random.below(100)) < percent ? uint8_t(1 + random.below(3)) : uint8_t(0); });
}

/// Floors (entry 1) on columns (entry 2), as in a building.
inline VoxelGrid towerGrid(glm::ivec3 size, int columnWidth = 3, int storey = 12) {
    return gridOf(size, [=](glm::ivec3 c) {
        const bool isFloor = c.y % storey >= storey - 2, isColumn = c.x % 16 < columnWidth && c.z % 16 < columnWidth;
        return uint8_t(isFloor ? 1 : isColumn ? 2 : 0);
    });
}

/// solidGrid() for large sizes: all full bricks share one brick.
inline VoxelGrid solidGridOfSharedBricks(glm::ivec3 size, uint8_t entry = 1) {
    VoxelGrid grid(size);
    BrickIndices full;
    full.fill(entry);
    const BrickRef shared = makeBrick(full);
    const glm::ivec3 bricks = grid.sizeInBricks();
    for (int z = 0; z < bricks.z; ++z)
        for (int y = 0; y < bricks.y; ++y)
            for (int x = 0; x < bricks.x; ++x) {
                const glm::ivec3 low = glm::ivec3(x, y, z) * kBrickSize, high = low + kBrickSize;
                if (high.x <= size.x && high.y <= size.y && high.z <= size.z) {
                    grid.setBrick({x, y, z}, shared);
                    continue;
                }
                BrickIndices indices{};
                for (int i = 0; i < kBrickVoxels; ++i)
                    indices[size_t(i)] = grid.contains(low + voxelInBrick(i)) ? entry : uint8_t(0);
                grid.setBrick({x, y, z}, makeBrick(indices));
            }
    return grid;
}

}  // namespace rubble
