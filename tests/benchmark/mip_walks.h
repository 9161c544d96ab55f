#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "runtime/voxel/ray_walk.h"

namespace rubble {

/// One object as Teardown stores it: a byte per voxel and two coarser levels, each cell of which says whether any of
/// its 2x2x2 cells is occupied. Sizes are padded to multiples of 4.
class MipGrid {
public:
    static constexpr int kLevels = 3;
    /// Builds all levels from the occupied voxels of a grid.
    explicit MipGrid(const VoxelGrid& grid);
    /// Whether a cell of a level is occupied; level 0 is the finest.
    bool occupied(int level, glm::ivec3 cell) const {
        const glm::ivec3 size = m_size[size_t(level)];
        return m_cells[size_t(level)]
                      [(size_t(cell.z) * size_t(size.y) + size_t(cell.y)) * size_t(size.x) + size_t(cell.x)];
    }
    /// Cells of a level along each axis.
    glm::ivec3 size(int level) const { return m_size[size_t(level)]; }

private:
    std::array<glm::ivec3, kLevels> m_size;
    std::array<std::vector<uint8_t>, kLevels> m_cells;
};

/// Walks a level finer where a cell is occupied, and a level coarser where it leaves the parent of an empty cell; in
/// floats, as Teardown's shader. True if it hits.
bool walkMips(const MipGrid& grid, const CellRay& ray);

/// Visits every voxel on the ray by a 3D-DDA (Amanatides & Woo 1987), in floats. True if it hits.
bool walkVoxels(const MipGrid& grid, const CellRay& ray);

}  // namespace rubble
