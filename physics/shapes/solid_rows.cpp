#include "physics/shapes/solid_rows.h"

#include <algorithm>

#include "runtime/core/assertion.h"

namespace rubble {

SolidRows::SolidRows(const VoxelGrid& grid, const CellBox& box) : m_box(box), m_low(box.low - kPadding) {
    const glm::ivec3 size = box.high - m_low + kPadding, bricks = grid.sizeInBricks();
    RUBBLE_ASSERT(size.x <= 64);
    m_nx = size.x, m_ny = size.y, m_nz = size.z;
    m_rows.resize(size_t(m_ny) * size_t(m_nz));
    const glm::ivec3 first = brickOfCell(glm::max(m_low, glm::ivec3(0)));
    const glm::ivec3 last = glm::min(brickOfCell(m_low + size - 1), bricks - 1);
    const uint64_t mask = ~uint64_t(0) >> (64 - m_nx);
    for (int bz = first.z; bz <= last.z; ++bz)
        for (int by = first.y; by <= last.y; ++by)
            for (int bx = first.x; bx <= last.x; ++bx) {
                const Brick* brick = grid.brickAt({bx, by, bz});
                if (!brick) continue;
                const glm::ivec3 corner = glm::ivec3(bx, by, bz) * kBrickSize - m_low;
                const int z0 = std::max(0, -corner.z), z1 = std::min(kBrickSize, m_nz - corner.z);
                const int y0 = std::max(0, -corner.y), y1 = std::min(kBrickSize, m_ny - corner.y);
                for (int z = z0; z < z1; ++z)
                    for (int y = y0; y < y1; ++y) {
                        const uint64_t bits = brick->occupancy[size_t(z)] >> (8 * y) & 0xff;
                        m_rows[size_t(corner.y + y + m_ny * (corner.z + z))] |=
                            (corner.x < 0 ? bits >> -corner.x : bits << corner.x) & mask;
                    }
            }
}

bool SolidRows::hasGaps() const {
    for (const uint64_t row : m_rows)
        if (const uint64_t starts = row & ~(row << 1); starts & (starts - 1)) return true;
    const auto hasGapsAlong = [&](int outer, int outerStride, int inner, int innerStride) {
        for (int i = 0; i < outer; ++i) {
            uint64_t seen = 0, gaps = 0;
            for (int k = 0; k < inner; ++k) {
                const uint64_t row = m_rows[size_t(i * outerStride + k * innerStride)];
                if (row & gaps) return true;
                seen |= row, gaps |= seen & ~row;
            }
        }
        return false;
    };
    return hasGapsAlong(m_nz, m_ny, m_ny, 1) || hasGapsAlong(m_ny, 1, m_nz, m_ny);
}

}  // namespace rubble
