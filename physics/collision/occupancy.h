#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <glm/common.hpp>

#include "physics/shapes/voxel_collider.h"

namespace rubble {

using Cell = glm::ivec3;
class Cover;

/// Rounds down, for values within the range of int: without a call where the processor has no SSE 4.1.
inline int floorOf(float v) {
    const int i = int(v);
    return i - (float(i) > v);
}
/// The cell that a point in cells is in.
inline Cell cellOf(const glm::vec3& p) {
    return {floorOf(p.x), floorOf(p.y), floorOf(p.z)};
}

/// Looks up which cells of a part are solid, and remembers the last brick. One per thread and part.
class Occupancy {
public:
    /// The part and its cover (null: nothing lies around it) must outlive it.
    explicit Occupancy(const ColliderPart& part, Cover* cover = nullptr)
        : m_part(part), m_grid(part.grid()), m_whole(part.whole() ? &part.whole()->rows : nullptr), m_cover(cover) {
        const Cell last = m_grid.size() - 1;
        m_lastCell = Int4{last.x, last.y, last.z, 0};
    }

    /// Conservative: false only if no cell from low to high, both included, is solid. Exact for small parts, and in
    /// large ones for boxes of about one brick; true for larger boxes.
    bool mayContainSolid(Int4 low, Int4 high) {
        return m_whole ? m_whole->any(low, high) : mayContainSolidNear(low, high);
    }
    /// The same for four boxes at once: see SolidRows::any().
    uint32_t mayContainSolid(const std::array<Int4, 3>& low, const std::array<Int4, 3>& high, uint32_t lanes) {
        if (m_whole) return m_whole->any(low, high, lanes);
        uint32_t found = 0;
        for (; lanes; lanes &= lanes - 1) {
            const int i = std::countr_zero(lanes);
            const Int4 from{low[0][i], low[1][i], low[2][i], 0}, to{high[0][i], high[1][i], high[2][i], 0};
            found |= uint32_t(mayContainSolidNear(from, to)) << i;
        }
        return found;
    }
    /// Conservative, and cheaper for large parts: false only if every brick that the cells from..to touch is empty.
    /// True for boxes of more than four bricks on a side.
    bool mayContainBrick(Int4 from, Int4 to) const {
        if (m_whole) return m_whole->any(from, to);
        const Int4 low = max4(from, Int4{}) >> 3, high = min4(to, m_lastCell) >> 3;
        if (any(high - low > 3)) return true;
        for (int z = low[2]; z <= high[2]; ++z)
            for (int y = low[1]; y <= high[1]; ++y)
                for (int x = low[0]; x <= high[0]; ++x)
                    if (m_grid.brickAt({x, y, z})) return true;
        return false;
    }
    /// A box that holds all solid cells.
    const CellBox& bounds() const { return m_part.bounds(); }
    /// False outside the grid.
    bool solid(Cell c) {
        if (m_whole) return m_whole->solid(c);
        if (!m_grid.contains(c)) return false;
        const Cell brick = brickOfCell(c);
        if (brick != m_brickAt) m_brickAt = brick, m_brick = m_grid.brickAt(brick);
        return m_brick && m_brick->solid(voxelIndex(cellInBrick(c)));
    }
    /// Which of the cells beside one are solid: bit 2 * axis for the one before it along an axis, the next bit for the
    /// one behind. wanted: bits of those to look at.
    uint32_t solidNeighbours(Cell c, uint32_t wanted) {
        if (m_whole && m_whole->coversAround(c)) return m_whole->solidNeighbours(c) & wanted;
        uint32_t found = 0;
        for (uint32_t left = wanted; left; left &= left - 1) {
            const int bit = std::countr_zero(left);
            Cell neighbour = c;
            neighbour[bit / 2] += bit % 2 ? 1 : -1;
            found |= uint32_t(solid(neighbour)) << bit;
        }
        return found;
    }
    /// Whether the side (sign * axis) of a solid cell is a part of the surface beside a point: the next cell is empty,
    /// and nothing else lies against it.
    bool exposed(Cell c, const glm::vec3& p, int axis, int sign) {
        Cell next = c;
        next[axis] += sign;
        return !solid(next) && !(m_cover && isCovered(c, p, axis, sign));
    }
    /// Whether a cell is outside: neither solid nor taken by what lies around.
    bool open(Cell c) { return !solid(c) && !(m_cover && isCovered(c)); }

private:
    bool mayContainSolidNear(Int4 from, Int4 to) {
        const Int4 corner = max4(min4(from, m_lastCell), Int4{}) & -kBrickSize, low = corner - SolidRows::kPadding,
                   high = corner + (kBrickSize + SolidRows::kPadding - 1);
        if (any((from > high) | (to < low))) return false;
        if (any(to > high)) return true;
        if (const Cell at(corner[0], corner[1], corner[2]); at != m_rowsAt)
            m_rowsAt = at, m_rows = &m_part.rows(brickOfCell(at));
        return m_rows->any(from, to);
    }

    bool isCovered(Cell cell, const glm::vec3& p, int axis, int sign);  // in cover.cpp, as the next
    bool isCovered(Cell cell);

    const ColliderPart& m_part;
    const VoxelGrid& m_grid;
    const SolidRows* m_whole;  ///< null: a large part
    Cover* m_cover;
    Int4 m_lastCell;                   ///< of the grid
    Cell m_brickAt{-1}, m_rowsAt{-1};  ///< the brick, and the first cell of the brick, that were looked up last
    const Brick* m_brick = nullptr;
    const SolidRows* m_rows = nullptr;
};

}  // namespace rubble
