#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "runtime/voxel/ray_walk.h"

namespace rubble {

/// One object as the reference game keeps it: a byte a voxel and two coarser levels, each cell of which says whether
/// any of its 2x2x2 cells holds something. Sizes are padded to multiples of 4.
class MipGrid {
public:
    static constexpr int kLevels = 3;
    explicit MipGrid(const VoxelGrid& grid);
    bool occupied(int level, glm::ivec3 cell) const {
        const glm::ivec3 size = m_size[size_t(level)];
        return m_cells[size_t(level)]
                      [(size_t(cell.z) * size_t(size.y) + size_t(cell.y)) * size_t(size.x) + size_t(cell.x)];
    }
    glm::ivec3 size(int level) const { return m_size[size_t(level)]; }

private:
    std::array<glm::ivec3, kLevels> m_size;
    std::array<std::vector<uint8_t>, kLevels> m_cells;
};

/// A walk that goes a level finer where a cell holds something and a level coarser where it leaves an empty one's
/// parent; in floats, as the reference's shader. True if it hits.
bool walkMips(const MipGrid& grid, const CellRay& ray);

/// Every voxel in turn, with accumulated differences (Amanatides & Woo 1987), in floats.
bool walkVoxels(const MipGrid& grid, const CellRay& ray);

}  // namespace rubble
