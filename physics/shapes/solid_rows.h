#pragma once
#include <cstdint>
#include <glm/common.hpp>
#include <vector>

#include "physics/math/simd4.h"
#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// The occupancy of a box of cells and of two cells around it, one 64-bit word for each row along x: a whole row is
/// tested or combined with its neighbours at once. Cells are those of the grid.
class SolidRows {
public:
    static constexpr int kPadding = 2, kMaxLength = 64 - 2 * kPadding;
    /// box: at most kMaxLength cells long in x; it may stick out of the grid, where nothing is solid.
    SolidRows(const VoxelGrid& grid, const CellBox& box);

    /// The box without its padding.
    const CellBox& box() const { return m_box; }
    /// The row at y and z, counted from the box's low corner, -2 to its size + 1. Bit i is the cell at x = i -
    /// kPadding.
    uint64_t row(int y, int z) const { return m_rows[size_t(y + kPadding + m_ny * (z + kPadding))]; }
    /// Whether the cell is in the box or its padding.
    bool covers(glm::ivec3 cell) const {
        const glm::ivec3 c = cell - m_low;
        return unsigned(c.x) < unsigned(m_nx) && unsigned(c.y) < unsigned(m_ny) && unsigned(c.z) < unsigned(m_nz);
    }
    /// Whether a row of cells along an axis is solid, open, and solid again: something may be inside.
    bool hasGaps() const;
    /// False for cells that are not covered.
    bool solid(glm::ivec3 cell) const {
        const glm::ivec3 c = cell - m_low;
        return covers(cell) && m_rows[size_t(c.y + m_ny * c.z)] >> c.x & 1;
    }
    /// Whether any covered cell from low to high, both included, is solid.
    bool any(Int4 low, Int4 high) const {
        const Int4 corner = {m_low.x, m_low.y, m_low.z, 0};
        low = max4(low - corner, Int4{0, 0, 0, 0}), high = min4(high - corner, Int4{m_nx - 1, m_ny - 1, m_nz - 1, 0});
        if (low[0] > high[0]) return false;
        uint64_t found = 0;
        for (int z = low[2]; z <= high[2]; ++z)
            for (int y = low[1]; y <= high[1]; ++y) found |= m_rows[size_t(y + m_ny * z)];
        return found >> low[0] & (~uint64_t(0) >> (63 - (high[0] - low[0])));
    }

private:
    CellBox m_box;
    glm::ivec3 m_low;      ///< low corner of the padding
    int m_nx, m_ny, m_nz;  ///< size with the padding
    std::vector<uint64_t> m_rows;
};

}  // namespace rubble
