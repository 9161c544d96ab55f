#include "runtime/shadow/rasterize.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rubble {
namespace {

constexpr int kSide = kShadowBrickCells;

/// Voxels are cells, shifted: whole rows of 8 at once.
void copyShifted(const VoxelGrid& grid, const ShadowLattice& lattice, glm::ivec3 brick, CellRows& rows) {
    glm::ivec3 shift;  // cell - voxel
    for (int a = 0; a < 3; ++a) shift[a] = lattice.base[a] - int(lattice.origin[size_t(a)] >> 32);
    const glm::ivec3 low = brick * kSide - shift;
    for (int bz = low.z >> 3; bz <= (low.z + kSide - 1) >> 3; ++bz)
        for (int by = low.y >> 3; by <= (low.y + kSide - 1) >> 3; ++by)
            for (int bx = low.x >> 3; bx <= (low.x + kSide - 1) >> 3; ++bx) {
                const Brick* from = grid.brickAt({bx, by, bz});
                if (!from) continue;
                const glm::ivec3 at = glm::ivec3(bx, by, bz) * kBrickSize - low;
                for (int z = std::max(0, -at.z); z < std::min(kBrickSize, kSide - at.z); ++z)
                    for (int y = std::max(0, -at.y); y < std::min(kBrickSize, kSide - at.y); ++y) {
                        const uint32_t row = uint32_t(from->occupancy[size_t(z)] >> (y * 8) & 0xff);
                        rows[size_t(y + at.y + (z + at.z) * kSide)] |= uint16_t(at.x < 0 ? row >> -at.x : row << at.x);
                    }
            }
}

/// Cuts rows of samples along the world's x axis to the box of a shape's grid, which leaves one interval of each.
/// In doubles, which hold the lattice's fixed-point numbers exactly.
class RowClip {
public:
    RowClip(const VoxelGrid& grid, const FixedPoint& step, int count) : m_end(count - 0.5) {
        for (size_t k = 0; k < 3; ++k) {
            m_step[k] = double(step[k]);
            m_size[k] = double(int64_t(grid.size()[int(k)]) << 32);
            m_enter[k] = step[k] < 0 ? m_size[k] : 0.0;
            m_leave[k] = step[k] < 0 ? 0.0 : m_size[k];
            m_inverse[k] = step[k] ? 1.0 / m_step[k] : 1e100;  // from outside it never enters
        }
    }
    struct Interval {
        int low, high;
    };
    /// The samples of [0, count) that lie inside, of the row whose first sample is given.
    Interval operator()(double x, double y, double z) const {
        constexpr double kDoubt = 1e-6;  // more than the estimate errs; where that matters the exact place decides
        const double from = std::max(std::max(enters(x, 0), 0.0), std::max(enters(y, 1), enters(z, 2)));
        const double to = std::min(std::min(leaves(x, 0), m_end), std::min(leaves(y, 1), leaves(z, 2)));
        if (!(from <= to + kDoubt)) return {0, 0};
        const Interval estimate{int(from + (1.0 - kDoubt)), int(to + (1.0 + kDoubt))};
        if (estimate.low >= from + kDoubt && estimate.high <= to + (1.0 - kDoubt)) return estimate;
        return trim(estimate, {x, y, z});
    }

private:
    using Exact = std::array<double, 3>;
    double enters(double first, size_t k) const { return (m_enter[k] - first) * m_inverse[k]; }
    double leaves(double first, size_t k) const { return (m_leave[k] - first) * m_inverse[k]; }
    Interval trim(Interval row, const Exact& first) const {
        while (row.low < row.high && !isInside(first, row.low)) ++row.low;
        while (row.low < row.high && !isInside(first, row.high - 1)) --row.high;
        return row;
    }
    bool isInside(const Exact& first, int i) const {
        bool inside = true;
        for (size_t k = 0; k < 3; ++k) {
            const double at = first[k] + i * m_step[k];
            inside &= at >= 0.0 && at < m_size[k];
        }
        return inside;
    }
    Exact m_step, m_size, m_enter, m_leave, m_inverse;
    double m_end;
};

/// Voxels straight from the bricks, remembering the last one.
class BrickSource {
public:
    explicit BrickSource(const VoxelGrid& grid) : m_grid(grid) {}
    uint64_t solid(int x, int y, int z) {
        if (((x >> 3) ^ m_place.x) | ((y >> 3) ^ m_place.y) | ((z >> 3) ^ m_place.z)) {
            static constexpr std::array<uint64_t, 8> kNothing{};
            m_place = {x >> 3, y >> 3, z >> 3};
            const Brick* brick = m_grid.brickAt(m_place);
            m_occupancy = (brick ? brick->occupancy : kNothing).data();
        }
        return m_occupancy[z & 7] >> ((x & 7) | (y & 7) << 3) & 1;
    }

private:
    const VoxelGrid& m_grid;
    glm::ivec3 m_place{-1};
    const uint64_t* m_occupancy = nullptr;
};

/// Voxels from rows along x.
struct RowSource {
    const uint64_t* rows;
    int height;
    uint64_t solid(int x, int y, int z) const { return rows[y + z * height] >> x & 1; }
};

/// Bit i set for every sample i in [low, high) that lies in a solid voxel.
template <class Source>
uint64_t sampleRow(Source& source, const FixedPoint& first, const FixedPoint& step, int low, int high) {
    uint64_t bits = 0;
    const int64_t last = high - 1;
    int64_t x = first[0] + last * step[0], y = first[1] + last * step[1], z = first[2] + last * step[2];
    for (int i = low; i < high; ++i) {  // from the last one down: each makes room for the one before it
        bits = bits + bits + source.solid(int(x >> 32), int(y >> 32), int(z >> 32));
        x -= step[0], y -= step[1], z -= step[2];
    }
    return bits << low;
}

/// The same with several samples a cell: bit i / samples.
template <class Source>
uint64_t sampleFineRow(Source& source, const FixedPoint& first, const FixedPoint& step, int low, int high, int samples) {
    uint64_t bits = 0;
    int64_t x = first[0] + low * step[0], y = first[1] + low * step[1], z = first[2] + low * step[2];
    for (int i = low; i < high; ++i) {
        bits |= source.solid(int(x >> 32), int(y >> 32), int(z >> 32)) << (i / samples);
        x += step[0], y += step[1], z += step[2];
    }
    return bits;
}

/// False if no sample of a box of cells can lie in the grid: its centre is too far out along one of the grid's axes.
bool canMeet(const VoxelGrid& grid, const ShadowLattice& lattice, glm::ivec3 low, glm::ivec3 high) {
    const FixedPoint first = lattice.sample(low), last = lattice.sample(high);  // the last is one beyond: to be safe
    for (size_t k = 0; k < 3; ++k) {
        int64_t reach = 0;  // twice
        for (size_t a = 0; a < 3; ++a) reach += std::abs(lattice.step[a][k]) * (high[int(a)] - low[int(a)]) * lattice.samples;
        const int64_t size = int64_t(grid.size()[int(k)]) << 32;
        if (std::abs(first[k] + last[k] - size) > reach + size) return false;
    }
    return true;
}

FixedPoint operator+(FixedPoint a, const FixedPoint& b) {
    for (size_t k = 0; k < 3; ++k) a[k] += b[k];
    return a;
}

/// The cells of a box at most 64 wide: row(y, z) gets them from its low end on, rows without any are left out.
template <class Source, class Row>
void rasterizeBox(const VoxelGrid& grid, Source source, const ShadowLattice& lattice, const CellBox& box, Row&& row) {
    if (!canMeet(grid, lattice, box.low, box.high)) return;
    const int samples = lattice.samples;
    const FixedPoint& step = lattice.step[0];
    const glm::ivec3 count = (box.high - box.low) * samples;
    const RowClip clip(grid, step, count.x);
    FixedPoint plane = lattice.sample(box.low);
    for (int z = 0; z < count.z; ++z, plane = plane + lattice.step[2]) {
        FixedPoint first = plane;
        for (int y = 0; y < count.y; ++y, first = first + lattice.step[1]) {
            const auto [low, high] = clip(double(first[0]), double(first[1]), double(first[2]));
            if (low >= high) continue;
            if (samples == 1)
                row(y, z, sampleRow(source, first, step, low, high));
            else
                row(y / samples, z / samples, sampleFineRow(source, first, step, low, high, samples));
        }
    }
}

}  // namespace

void rasterize(const VoxelGrid& grid, const ShadowLattice& lattice, const CellBox& bounds, glm::ivec3 brick, CellRows& rows) {
    if (lattice.isShift()) return copyShifted(grid, lattice, brick, rows);
    const glm::ivec3 corner = brick * kSide;
    CellBox box;
    for (int a = 0; a < 3; ++a) {
        box.low[a] = std::max(corner[a], bounds.low[a]);
        box.high[a] = std::min(corner[a] + kSide, bounds.high[a]);
    }
    if (box.empty()) return;
    const glm::ivec3 low = box.low - corner;
    rasterizeBox(grid, BrickSource(grid), lattice, box,
                 [&](int y, int z, uint64_t bits) { rows[size_t(low.y + y + (low.z + z) * kSide)] |= uint16_t(bits << low.x); });
}

bool ShapeRaster::make(const VoxelGrid& grid, const ShadowLattice& lattice, const CellBox& bounds) {
    const glm::ivec3 size = bounds.high - bounds.low, voxels = grid.size();
    if (std::max({size.x, size.y, size.z, voxels.x, voxels.y, voxels.z}) > 64) return false;
    if (m_voxels.empty()) {
        m_voxels.assign(size_t(voxels.y) * size_t(voxels.z), 0);
        grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            forEachVoxel(brick->occupancy, [&](int i) {
                const glm::ivec3 voxel = position * kBrickSize + voxelInBrick(i);
                m_voxels[size_t(voxel.y + voxel.z * voxels.y)] |= uint64_t(1) << voxel.x;
            });
        });
    }
    m_lowBrick = bounds.low >> 4;
    m_bricks = ((bounds.high + (kSide - 1)) >> 4) - m_lowBrick;
    m_rows.assign(size_t(m_bricks.x) * size_t(m_bricks.y) * size_t(m_bricks.z), CellRows());
    const glm::ivec3 low = bounds.low - m_lowBrick * kSide;
    rasterizeBox(grid, RowSource{m_voxels.data(), voxels.y}, lattice, bounds, [&](int y, int z, uint64_t bits) {
        y += low.y, z += low.z;
        CellRows* brick = &m_rows[size_t(m_bricks.x) * size_t((y >> 4) + m_bricks.y * (z >> 4))];
        const size_t at = size_t((y & 15) + (z & 15) * kSide);
        (*brick)[at] |= uint16_t(bits << low.x);
        for (bits >>= kSide - low.x; bits; bits >>= kSide) (*++brick)[at] |= uint16_t(bits);
    });
    return true;
}

void ShapeRaster::addTo(glm::ivec3 brick, CellRows& rows) const {
    const glm::ivec3 at = brick - m_lowBrick;
    for (int a = 0; a < 3; ++a)
        if (at[a] < 0 || at[a] >= m_bricks[a]) return;
    const CellRows& own = m_rows[size_t(at.x + m_bricks.x * (at.y + m_bricks.y * at.z))];
    uint16_t* __restrict to = rows.data();
    for (size_t i = 0; i < own.size(); ++i) to[i] |= own[i];
}

ShadowWords packRows(const CellRows& rows) {
    ShadowWords out{};
    for (int z = 0; z < kSide; ++z)
        for (int y = 0; y < kSide; y += 4) {
            const uint16_t* row = &rows[size_t(y + z * kSide)];
            uint64_t v = uint64_t(row[0]) | uint64_t(row[1]) << 16 | uint64_t(row[2]) << 32 | uint64_t(row[3]) << 48;
            if (!v) continue;
            // Four rows of four times four cells, transposed: then 16 bits go to each of four words.
            uint64_t swap = (v ^ v >> 12) & 0x0000f0f00000f0f0u;
            v ^= swap ^ swap << 12;
            swap = (v ^ v >> 24) & 0x00000000ff00ff00u;
            v ^= swap ^ swap << 24;
            uint64_t* words = &out[size_t(y + (z >> 2) * 16)];
            const int shift = (z & 3) * 16;
            for (int x = 0; x < 4; ++x) words[x] |= (v >> (x * 16) & 0xffff) << shift;
        }
    return out;
}

}  // namespace rubble
