#include "runtime/shadow/rasterize.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "runtime/shadow/rasterize_large.h"
#include "runtime/shadow/row_clip.h"

namespace rubble {
namespace {

constexpr int kSide = kShadowBrickCells;

/// For shapes whose voxels are cells, shifted: copies rows of 8 voxels.
void copyShifted(const VoxelGrid& grid, const ShadowCellTransform& cellTransform, glm::ivec3 brick, CellRows& rows) {
    glm::ivec3 shift;  // coordinates of a cell minus those of its voxel
    for (int a = 0; a < 3; ++a) shift[a] = cellTransform.base[a] - int(cellTransform.origin[size_t(a)] >> 32);
    const glm::ivec3 low = brick * kSide - shift;
    const glm::ivec3 first = brickOfCell(low), last = brickOfCell(low + (kSide - 1));
    for (int bz = first.z; bz <= last.z; ++bz)
        for (int by = first.y; by <= last.y; ++by)
            for (int bx = first.x; bx <= last.x; ++bx) {
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

/// Reads voxels from the grid's bricks and keeps the last brick.
class BrickSource {
public:
    explicit BrickSource(const VoxelGrid& grid) : m_grid(grid) {}
    uint64_t solid(int x, int y, int z) {
        const glm::ivec3 brickPosition = brickOfCell(glm::ivec3(x, y, z));
        if ((brickPosition.x ^ m_position.x) | (brickPosition.y ^ m_position.y) | (brickPosition.z ^ m_position.z)) {
            static constexpr std::array<uint64_t, 8> kNothing{};
            m_position = brickPosition;
            const Brick* brick = m_grid.brickAt(m_position);
            m_occupancy = (brick ? brick->occupancy : kNothing).data();
        }
        return m_occupancy[cellInBrick(z)] >> (cellInBrick(x) + kBrickSize * cellInBrick(y)) & 1;
    }

private:
    const VoxelGrid& m_grid;
    glm::ivec3 m_position{-1};  ///< of the last brick
    const uint64_t* m_occupancy = nullptr;
};

/// A row of samples: bit i is set for every sample i in [low, high) that lies in a solid voxel.
template <class Source>
uint64_t sampleRow(Source& source, const FixedPoint& first, const FixedPoint& step, int low, int high) {
    uint64_t bits = 0;
    const int64_t last = high - 1;
    int64_t x = first[0] + last * step[0], y = first[1] + last * step[1], z = first[2] + last * step[2];
    for (int i = low; i < high; ++i) {  // from the last one down, so that each shifts the bits behind it
        bits = bits + bits + source.solid(int(x >> 32), int(y >> 32), int(z >> 32));
        x -= step[0], y -= step[1], z -= step[2];
    }
    return bits << low;
}

/// The same with several samples per cell: bit i / samples.
template <class Source>
uint64_t sampleFineRow(Source& source, const FixedPoint& first, const FixedPoint& step, int low, int high,
                       int samples) {
    uint64_t bits = 0;
    int64_t x = first[0] + low * step[0], y = first[1] + low * step[1], z = first[2] + low * step[2];
    for (int i = low; i < high; ++i) {
        bits |= source.solid(int(x >> 32), int(y >> 32), int(z >> 32)) << (i / samples);
        x += step[0], y += step[1], z += step[2];
    }
    return bits;
}

/// False if no sample of a box of cells can lie in the grid: along one of the grid's axes they are too far apart.
bool canMeet(const VoxelGrid& grid, const ShadowCellTransform& cellTransform, glm::ivec3 low, glm::ivec3 high) {
    const FixedPoint first = cellTransform.sample(low),
                     last = cellTransform.sample(high);  // one beyond the last cell, which is safe
    for (size_t k = 0; k < 3; ++k) {
        int64_t extent = 0;  // of the box along axis k, twice
        for (size_t a = 0; a < 3; ++a)
            extent += std::abs(cellTransform.step[a][k]) * (high[int(a)] - low[int(a)]) * cellTransform.samples;
        const int64_t size = int64_t(grid.size()[int(k)]) << 32;
        if (std::abs(first[k] + last[k] - size) > extent + size) return false;
    }
    return true;
}

/// Samples a box of cells that is at most 64 wide. Calls row(y, z, bits) for rows with set cells; y, z and bits count
/// from the box's low corner.
template <class Source, class Row>
void rasterizeBox(const VoxelGrid& grid, Source source, const ShadowCellTransform& cellTransform, const CellBox& box,
                  Row&& row) {
    if (!canMeet(grid, cellTransform, box.low, box.high)) return;
    const int samples = cellTransform.samples;
    const FixedPoint& step = cellTransform.step[0];
    const glm::ivec3 count = (box.high - box.low) * samples;
    const RowClip clip({glm::ivec3(0), grid.size()}, cellTransform, count.x);
    FixedPoint plane = cellTransform.sample(box.low);
    for (int z = 0; z < count.z; ++z, plane = plane + cellTransform.step[2]) {
        clip.forEachRow(toDoubles(plane), count.y, [&](int y, RowClip::Interval in) {
            const FixedPoint first = plane + cellTransform.step[1] * y;
            if (samples == 1)
                row(y, z, sampleRow(source, first, step, in.low, in.high));
            else
                row(y / samples, z / samples, sampleFineRow(source, first, step, in.low, in.high, samples));
        });
    }
}

}  // namespace

void rasterize(const VoxelGrid& grid, const ShadowCellTransform& cellTransform, const CellBox& bounds, glm::ivec3 brick,
               CellRows& rows) {
    if (cellTransform.isShift()) return copyShifted(grid, cellTransform, brick, rows);
    const glm::ivec3 corner = brick * kSide;
    CellBox box;
    for (int a = 0; a < 3; ++a) {
        box.low[a] = std::max(corner[a], bounds.low[a]);
        box.high[a] = std::min(corner[a] + kSide, bounds.high[a]);
    }
    if (box.empty()) return;
    if (hasLargeVoxels(cellTransform)) return rasterizeLargeVoxels(grid, cellTransform, box, corner, rows);
    rasterizeByRows(grid, cellTransform, box, corner, rows);
}

void rasterizeByRows(const VoxelGrid& grid, const ShadowCellTransform& cellTransform, const CellBox& box,
                     glm::ivec3 corner, CellRows& rows) {
    const glm::ivec3 low = box.low - corner;
    rasterizeBox(grid, BrickSource(grid), cellTransform, box, [&](int y, int z, uint64_t bits) {
        rows[size_t(low.y + y + (low.z + z) * kSide)] |= uint16_t(bits << low.x);
    });
}

ShadowWords packRows(const CellRows& rows) {
    ShadowWords out{};
    for (int z = 0; z < kSide; ++z)
        for (int y = 0; y < kSide; y += 4) {
            const uint16_t* row = &rows[size_t(y + z * kSide)];
            uint64_t v = uint64_t(row[0]) | uint64_t(row[1]) << 16 | uint64_t(row[2]) << 32 | uint64_t(row[3]) << 48;
            if (!v) continue;
            // 4 rows of 16 cells are a 4x4 matrix of nibbles: its transpose has 16 bits for each of 4 words.
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
