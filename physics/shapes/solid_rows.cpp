#include "physics/shapes/solid_rows.h"

#include <algorithm>
#include <array>
#include <bit>

#include "runtime/core/assertion.h"

namespace rubble {

SolidRows::SolidRows(const VoxelGrid& grid, const CellBox& box) : m_box(box), m_low(box.low - kPadding) {
    const glm::ivec3 size = box.high - m_low + kPadding, bricks = grid.sizeInBricks();
    RUBBLE_ASSERT(std::max({size.x, size.y, size.z}) <= kMaxSide);
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

namespace {

/// Of a row of cells, those between two solid ones.
uint64_t gapsOf(uint64_t row) {
    const int first = std::countr_zero(row), last = 63 - std::countl_zero(row);
    return row ? ~row & (~uint64_t(0) << first) & (~uint64_t(0) >> (63 - last)) : 0;
}

}  // namespace

int SolidRows::widestGap() const {
    int widest = 0;
    for (const uint64_t row : m_rows) {
        uint64_t gaps = gapsOf(row);
        for (int width = 1; gaps; gaps &= gaps << 1, ++width) widest = std::max(widest, width);
    }
    // Along the other two axes, all columns of a plane at once: each round shortens every run of open cells by one.
    const auto visitPlane = [&](size_t first, size_t stride, size_t count) {
        std::array<uint64_t, kMaxSide> gaps;
        uint64_t seen = 0, any = 0;
        for (size_t i = 0; i < count; ++i) {
            const uint64_t row = m_rows[first + i * stride];
            gaps[i] = seen & ~row, seen |= row;
        }
        seen = 0;
        for (size_t i = count; i-- > 0;) {
            any |= gaps[i] &= seen;
            seen |= m_rows[first + i * stride];
        }
        for (int width = 1; any; ++width) {
            widest = std::max(widest, width);
            any = 0;
            for (size_t i = count; i-- > 1;) any |= gaps[i] &= gaps[i - 1];
        }
    };
    for (size_t z = 0; z < size_t(m_nz); ++z) visitPlane(z * size_t(m_ny), 1, size_t(m_ny));
    for (size_t y = 0; y < size_t(m_ny); ++y) visitPlane(y, size_t(m_ny), size_t(m_nz));
    return widest;
}

}  // namespace rubble
