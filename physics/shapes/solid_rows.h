#pragma once
#include <array>
#include <bit>
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
    static constexpr int kPadding = 2, kMaxSide = 64, kMaxLength = kMaxSide - 2 * kPadding;
    /// box: at most kMaxLength cells long; it may stick out of the grid, where nothing is solid.
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
    /// The longest run of open cells between two solid ones along an axis, in cells; 0: there is none. What is wider is
    /// not inside.
    int widestGap() const;
    /// False for cells that are not covered.
    bool solid(glm::ivec3 cell) const {
        const glm::ivec3 c = cell - m_low;
        return covers(cell) && m_rows[size_t(c.y + m_ny * c.z)] >> c.x & 1;
    }
    /// Whether the cell and those beside it are covered.
    bool coversAround(glm::ivec3 cell) const { return covers(cell - 1) && covers(cell + 1); }
    /// Which of the cells beside one are solid: bit 2 * axis for the one before it along an axis, the next bit for the
    /// one behind. All must be covered.
    uint32_t solidNeighbours(glm::ivec3 cell) const {
        const glm::ivec3 c = cell - m_low;
        const uint64_t* row = m_rows.data() + (c.y + m_ny * c.z);
        const auto bit = [&](const uint64_t* at, int x) { return uint32_t(*at >> x & 1); };
        return bit(row, c.x - 1) | bit(row, c.x + 1) << 1 | bit(row - 1, c.x) << 2 | bit(row + 1, c.x) << 3 |
               bit(row - m_ny, c.x) << 4 | bit(row + m_ny, c.x) << 5;
    }
    /// Whether any covered cell from low to high, both included, is solid.
    bool any(Int4 low, Int4 high) const {
        const Int4 corner = {m_low.x, m_low.y, m_low.z, 0};
        low = max4(low - corner, Int4{0, 0, 0, 0}), high = min4(high - corner, Int4{m_nx - 1, m_ny - 1, m_nz - 1, 0});
        if (bitsOf(low > high) & 7) return false;
        return anyIn(low[0], high[0], low[1], high[1], low[2], high[2]);
    }
    /// The same for four boxes, given by their cells along each axis: bit i is that of lane i. lanes: those to look at.
    uint32_t any(const std::array<Int4, 3>& low, const std::array<Int4, 3>& high, uint32_t lanes) const {
        std::array<Int4, 3> from, to;
        Bool4 overlaps{-1, -1, -1, -1};
        for (size_t axis = 0; axis < 3; ++axis) {
            const int corner = m_low[int(axis)], last = (axis == 0 ? m_nx : axis == 1 ? m_ny : m_nz) - 1;
            from[axis] = max4(low[axis] - corner, Int4{}), to[axis] = min4(high[axis] - corner, Int4{} + last);
            overlaps &= from[axis] <= to[axis];
        }
        uint32_t found = 0;
        for (lanes &= bitsOf(overlaps); lanes; lanes &= lanes - 1) {
            const int i = std::countr_zero(lanes);
            found |= uint32_t(anyIn(from[0][i], to[0][i], from[1][i], to[1][i], from[2][i], to[2][i])) << i;
        }
        return found;
    }

private:
    /// Of places counted from the padding's low corner; the ranges must not be empty.
    bool anyIn(int x0, int x1, int y0, int y1, int z0, int z1) const {
        const uint64_t between = (~uint64_t(0) >> (63 - (x1 - x0))) << x0;
        const size_t dy = size_t(y1 - y0), dz = size_t(z1 - z0), layer = size_t(m_ny);
        const uint64_t* first = m_rows.data() + (size_t(y0) + layer * size_t(z0));
        if (dy <= 2 && dz <= 2) return anyOfFew(first, dy, dz * layer, between);
        for (size_t z = 0; z <= dz; ++z, first += layer) {
            uint64_t found = 0;
            for (size_t y = 0; y <= dy; ++y) found |= first[y];
            if (found & between) return true;
        }
        return false;
    }
    /// The same for up to three rows of up to three layers, from the first to the last: some are read twice, as that is
    /// faster than branches that the processor cannot predict.
    bool anyOfFew(const uint64_t* first, size_t lastRow, size_t lastLayer, uint64_t between) const {
        const size_t row = lastRow > 0, layer = lastLayer > 0 ? size_t(m_ny) : 0;
        const auto rows = [&](const uint64_t* at) { return at[0] | at[row] | at[lastRow]; };
        return ((rows(first) | rows(first + layer) | rows(first + lastLayer)) & between) != 0;
    }

    CellBox m_box;
    glm::ivec3 m_low;      ///< low corner of the padding
    int m_nx, m_ny, m_nz;  ///< size with the padding
    std::vector<uint64_t> m_rows;
};

}  // namespace rubble
