#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "runtime/voxel/voxel_grid.h"

namespace rubble::bench {

/// A grid as one byte per voxel, as most voxel games store it.
struct DenseGrid {
    glm::ivec3 size;
    std::vector<uint8_t> cells;
    /// Copies the palette entries of a grid; x is the fastest axis.
    explicit DenseGrid(const VoxelGrid& grid);
};

/// Counts the connected components of a whole grid. Baseline: runs along x, and union-find over runs that touch (He,
/// Chao & Suzuki 2008, in three dimensions).
size_t countComponentsByRuns(const DenseGrid& grid);

}  // namespace rubble::bench
