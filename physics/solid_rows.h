#pragma once
#include <cstdint>
#include <glm/common.hpp>
#include <vector>

#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// Which cells of a box, and of two more around it, are solid: a word a row along x, so that many are looked up at once.
class SolidRows {
public:
    static constexpr int kAround = 2, kLongest = 64 - 2 * kAround;
    /// The box is at most kLongest cells long.
    SolidRows(const VoxelGrid& grid, const CellBox& box);

    const CellBox& box() const { return m_box; }
    /// Bit x + 2; y and z count from the box's low corner, -2 to its size + 1.
    uint64_t row(int y, int z) const { return m_rows[size_t(y + kAround + m_ny * (z + kAround))]; }
    bool covers(glm::ivec3 cell) const {
        const glm::ivec3 c = cell - m_low;
        return unsigned(c.x) < unsigned(m_nx) && unsigned(c.y) < unsigned(m_ny) && unsigned(c.z) < unsigned(m_nz);
    }
    /// False for what is not covered.
    bool solid(glm::ivec3 cell) const {
        const glm::ivec3 c = cell - m_low;
        return covers(cell) && m_rows[size_t(c.y + m_ny * c.z)] >> c.x & 1;
    }
    /// Whether a covered cell of a box, both ends included, is solid.
    bool any(glm::ivec3 low, glm::ivec3 high) const {
        low = glm::max(low - m_low, glm::ivec3(0)), high = glm::min(high - m_low, glm::ivec3(m_nx, m_ny, m_nz) - 1);
        if (low.x > high.x) return false;
        uint64_t found = 0;
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y) found |= m_rows[size_t(y + m_ny * z)];
        return found >> low.x & (~uint64_t(0) >> (63 - (high.x - low.x)));
    }

private:
    CellBox m_box;
    glm::ivec3 m_low;  ///< of what is covered
    int m_nx, m_ny, m_nz;
    std::vector<uint64_t> m_rows;
};

}  // namespace rubble
