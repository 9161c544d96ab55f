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

/// Samples along one row of the world, in a box of a shape's cells.
struct SampleRow {
    FixedPoint first, step;
    FixedPoint size;  ///< of the grid

    FixedPoint at(int64_t i) const { return {first[0] + i * step[0], first[1] + i * step[1], first[2] + i * step[2]}; }
    bool inside(int64_t i) const {
        const FixedPoint p = at(i);
        return uint64_t(p[0]) < uint64_t(size[0]) && uint64_t(p[1]) < uint64_t(size[1]) && uint64_t(p[2]) < uint64_t(size[2]);
    }
    /// The samples of [0, count) that lie inside the grid: an interval, as the grid's box is convex.
    void clip(int count, const std::array<double, 3>& inverseStep, int& low, int& high) const {
        double from = 0.0, to = count;
        for (size_t k = 0; k < 3; ++k) {
            if (step[k] == 0) {
                if (uint64_t(first[k]) >= uint64_t(size[k])) from = to;
                continue;
            }
            const double a = -double(first[k]) * inverseStep[k], b = double(size[k] - first[k]) * inverseStep[k];
            from = std::max(from, std::min(a, b));
            to = std::min(to, std::max(a, b));
        }
        low = high = 0;
        if (!(from <= to)) return;
        // The estimate errs by far less than a millionth of a sample; where that matters the integers decide.
        low = int(std::ceil(from - 1e-6));
        high = std::min(count, int(to + 1e-6) + 1);
        low = std::max(low, 0);
        while (low < high && !inside(low)) ++low;
        while (low < high && !inside(high - 1)) --high;
    }
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

/// Bit i / samples set for every sample i in [low, high) that lies in a solid voxel.
template <bool kOneSample, class Source>
uint64_t sampleRow(Source& source, const SampleRow& line, int low, int high, int samples) {
    uint64_t bits = 0;
    const FixedPoint start = line.at(low), step = line.step;
    int64_t x = start[0], y = start[1], z = start[2];
    for (int i = low; i < high; ++i) {
        bits |= source.solid(int(x >> 32), int(y >> 32), int(z >> 32)) << (kOneSample ? i : i / samples);
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
    SampleRow line;
    std::array<double, 3> inverseStep;
    line.step = lattice.step[0];
    for (size_t k = 0; k < 3; ++k) {
        line.size[k] = int64_t(grid.size()[int(k)]) << 32;
        inverseStep[k] = line.step[k] ? 1.0 / double(line.step[k]) : 0.0;
    }
    const glm::ivec3 count = (box.high - box.low) * samples;
    FixedPoint plane = lattice.sample(box.low);
    for (int z = 0; z < count.z; ++z, plane = plane + lattice.step[2]) {
        line.first = plane;
        for (int y = 0; y < count.y; ++y, line.first = line.first + lattice.step[1]) {
            int from, to;
            line.clip(count.x, inverseStep, from, to);
            if (from >= to) continue;
            if (samples == 1)
                row(y, z, sampleRow<true>(source, line, from, to, 1));
            else
                row(y / samples, z / samples, sampleRow<false>(source, line, from, to, samples));
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
    if (size.x > 64 || size.y > 256 || size.z > 256 || voxels.x > 64 || voxels.y > 256 || voxels.z > 256) return false;
    if (m_voxels.empty()) {
        m_voxels.assign(size_t(voxels.y) * size_t(voxels.z), 0);
        grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            forEachVoxel(brick->occupancy, [&](int i) {
                const glm::ivec3 voxel = position * kBrickSize + voxelInBrick(i);
                m_voxels[size_t(voxel.y + voxel.z * voxels.y)] |= uint64_t(1) << voxel.x;
            });
        });
    }
    m_bounds = bounds;
    m_rows.assign(size_t(size.y) * size_t(size.z), 0);
    rasterizeBox(grid, RowSource{m_voxels.data(), voxels.y}, lattice, bounds,
                 [&](int y, int z, uint64_t bits) { m_rows[size_t(y + z * size.y)] |= bits; });
    return true;
}

void ShapeRaster::addTo(glm::ivec3 brick, CellRows& rows) const {
    const glm::ivec3 offset = m_bounds.low - brick * kSide, size = m_bounds.high - m_bounds.low;
    if (offset.x >= kSide || offset.x <= -64) return;
    for (int z = std::max(0, -offset.z); z < std::min(size.z, kSide - offset.z); ++z)
        for (int y = std::max(0, -offset.y); y < std::min(size.y, kSide - offset.y); ++y) {
            const uint64_t bits = m_rows[size_t(y + z * size.y)];
            rows[size_t(y + offset.y + (z + offset.z) * kSide)] |= uint16_t(offset.x < 0 ? bits >> -offset.x : bits << offset.x);
        }
}

ShadowBrick packRows(const CellRows& rows) {
    ShadowBrick out;
    for (int z = 0; z < kSide; ++z)
        for (int y = 0; y < kSide; ++y) {
            const uint64_t row = rows[size_t(y + z * kSide)];
            if (!row) continue;
            uint64_t* words = &out.words[size_t((y >> 2) * 4 + (z >> 2) * 16)];
            const int bit = (y & 3) * 4 + (z & 3) * 16;
            for (int x = 0; x < 4; ++x) words[x] |= (row >> (x * 4) & 15) << bit;
        }
    return out;
}

}  // namespace rubble
