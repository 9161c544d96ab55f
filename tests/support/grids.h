#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

#include "runtime/voxel/voxel_grid.h"

/// Grids that tests and benchmarks of several modules need.
namespace rubble {

/// A grid whose cells are f(cell), a palette entry; 0 is empty.
template <class F>
VoxelGrid gridOf(glm::ivec3 size, F&& f) {
    VoxelGrid grid(size);
    GridWriter writer(grid);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) writer.set({x, y, z}, f(glm::ivec3(x, y, z)));
    writer.flush();
    return grid;
}

/// A grid with every cell set to one entry.
inline VoxelGrid solidGrid(glm::ivec3 size, uint8_t entry = 1) {
    return gridOf(size, [entry](glm::ivec3) { return entry; });
}

/// The same for large sizes: all full bricks share one brick.
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
