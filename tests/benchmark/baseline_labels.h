#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "runtime/voxel/voxel_grid.h"

namespace rubble::bench {

/// A grid as one byte a voxel: what most voxel games hold.
struct DenseGrid {
    glm::ivec3 size;
    std::vector<uint8_t> cells;
    explicit DenseGrid(const VoxelGrid& grid);
};

/// The reference method: components of the whole grid by runs along x and union-find over runs that touch (He, Chao &
/// Suzuki 2008, in three dimensions). Returns how many there are.
size_t countComponentsByRuns(const DenseGrid& grid);

}  // namespace rubble::bench
