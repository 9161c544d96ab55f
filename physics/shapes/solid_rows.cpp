#include "physics/shapes/solid_rows.h"

#include <algorithm>
#include <bit>

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

int SolidRows::widestGap() const {
    int widest = 0;
    const auto visit = [&](int& last, int now) {
        if (last >= 0) widest = std::max(widest, now - last - 1);
        last = now;
    };
    std::vector<int> lastZ(size_t(m_nx) * size_t(m_ny), -1), lastY;
    for (int z = 0; z < m_nz; ++z) {
        lastY.assign(size_t(m_nx), -1);
        for (int y = 0; y < m_ny; ++y) {
            int lastX = -1;
            for (uint64_t cells = m_rows[size_t(y + m_ny * z)]; cells; cells &= cells - 1) {
                const int x = std::countr_zero(cells);
                visit(lastX, x), visit(lastY[size_t(x)], y), visit(lastZ[size_t(x + m_nx * y)], z);
            }
        }
    }
    return widest;
}

}  // namespace rubble
