#include "runtime/shadow/rasterize_large.h"

#include <cstdlib>

namespace rubble {
namespace {

/// From the first sample of a box of cells to the lowest and to the highest coordinates of its samples.
struct Reach {
    FixedPoint low{}, high{};
};

/// Of a cube of so many cells.
Reach reachOf(const ShadowCellTransform& cellTransform, int side) {
    Reach out;
    for (const FixedPoint& step : cellTransform.step)
        for (size_t k = 0; k < 3; ++k) (step[k] < 0 ? out.low : out.high)[k] += step[k] * (side - 1);
    return out;
}

int voxelAt(int64_t coordinate) {
    return int(coordinate >> 32);
}

/// Calls f(bit, solid) for the voxels of a box until it gives false. bit: x + 2 y + 4 z, from the box's low corner.
template <class F>
void forEachVoxelOf(const VoxelGrid& grid, const CellBox& box, F&& f) {
    for (int z = box.low.z; z < box.high.z; ++z)
        for (int y = box.low.y; y < box.high.y; ++y)
            for (int x = box.low.x; x < box.high.x; ++x)
                if (!f(x - box.low.x + 2 * (y - box.low.y) + 4 * (z - box.low.z), grid.at({x, y, z}) != 0)) return;
}

class BoxTree {
public:
    BoxTree(const VoxelGrid& grid, const ShadowCellTransform& cellTransform, glm::ivec3 corner, CellRows& rows)
        : m_grid(grid), m_transform(cellTransform), m_corner(corner), m_rows(rows) {
        for (size_t i = 0; i < m_reach.size(); ++i) m_reach[i] = reachOf(cellTransform, kShadowBrickCells >> i);
    }

    void add(const CellBox& cells) { add(cells, 0); }

private:
    /// cells: at most kShadowBrickCells >> level wide.
    void add(const CellBox& cells, size_t level) {
        const FixedPoint first = m_transform.sample(cells.low);
        const FixedPoint low = first + m_reach[level].low, high = first + m_reach[level].high;
        const CellBox voxels{{voxelAt(low[0]), voxelAt(low[1]), voxelAt(low[2])},
                             {voxelAt(high[0]) + 1, voxelAt(high[1]) + 1, voxelAt(high[2]) + 1}};
        bool isAnySolid = false, isAnyEmpty = false;
        forEachVoxelOf(m_grid, voxels, [&](int, bool solid) {
            (solid ? isAnySolid : isAnyEmpty) = true;
            return !isAnySolid || !isAnyEmpty;
        });
        if (!isAnySolid) return;
        if (!isAnyEmpty)
            fill(cells);
        else if (level + 1 == m_reach.size())
            sample(cells, first, voxels);
        else
            divide(cells, level + 1);
    }

    uint16_t& row(int y, int z) { return m_rows[size_t(y - m_corner.y + (z - m_corner.z) * kShadowBrickCells)]; }

    void divide(const CellBox& cells, size_t level) {
        const int side = kShadowBrickCells >> level;
        glm::ivec3 low;
        for (low.z = cells.low.z; low.z < cells.high.z; low.z += side)
            for (low.y = cells.low.y; low.y < cells.high.y; low.y += side)
                for (low.x = cells.low.x; low.x < cells.high.x; low.x += side)
                    add({low, glm::min(low + side, cells.high)}, level);
    }
    void fill(const CellBox& cells) {
        const int width = cells.high.x - cells.low.x;
        const auto bits = uint16_t(((1u << width) - 1u) << (cells.low.x - m_corner.x));
        for (int z = cells.low.z; z < cells.high.z; ++z)
            for (int y = cells.low.y; y < cells.high.y; ++y) row(y, z) |= bits;
    }
    void sample(const CellBox& cells, FixedPoint plane, const CellBox& voxels) {
        unsigned solid = 0;
        forEachVoxelOf(m_grid, voxels, [&](int bit, bool isSolid) {
            solid |= unsigned(isSolid) << bit;
            return true;
        });
        for (size_t k = 0; k < 3; ++k) plane[k] -= int64_t(voxels.low[int(k)]) << 32;  // so that voxels are 0 or 1
        for (int z = cells.low.z; z < cells.high.z; ++z, plane = plane + m_transform.step[2]) {
            FixedPoint first = plane;
            for (int y = cells.low.y; y < cells.high.y; ++y, first = first + m_transform.step[1]) {
                unsigned bits = 0;
                FixedPoint at = first;
                for (int x = 0; x < cells.high.x - cells.low.x; ++x, at = at + m_transform.step[0])
                    bits |= (solid >> ((at[0] >> 32) + 2 * (at[1] >> 32) + 4 * (at[2] >> 32)) & 1u) << x;
                row(y, z) |= uint16_t(bits << (cells.low.x - m_corner.x));
            }
        }
    }

    const VoxelGrid& m_grid;
    const ShadowCellTransform& m_transform;
    const glm::ivec3 m_corner;
    CellRows& m_rows;
    std::array<Reach, 3> m_reach;  ///< of boxes of 16, 8 and 4 cells
};

}  // namespace

bool hasLargeVoxels(const ShadowCellTransform& cellTransform) {
    if (cellTransform.samples != 1) return false;
    // A box that is sampled has 3 steps along each axis: with a quarter of a voxel it reaches over 2 voxels.
    constexpr int64_t kLongest = int64_t(1) << 30;
    for (size_t k = 0; k < 3; ++k) {
        int64_t along = 0;
        for (const FixedPoint& step : cellTransform.step) along += std::abs(step[k]);
        if (along > kLongest) return false;
    }
    return true;
}

void rasterizeLargeVoxels(const VoxelGrid& grid, const ShadowCellTransform& cellTransform, const CellBox& box,
                          glm::ivec3 corner, CellRows& rows) {
    BoxTree(grid, cellTransform, corner, rows).add(box);
}

}  // namespace rubble
