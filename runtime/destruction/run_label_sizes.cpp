#include "runtime/destruction/run_label_sizes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>

#include "runtime/core/byte_bits.h"
#include "runtime/destruction/run_labels.h"

namespace rubble {
namespace {

/// Eight planes of a grid as rows of bits along x.
class Slab {
public:
    explicit Slab(const VoxelGrid& grid)
        : m_rows(size_t(grid.sizeInBricks().y) * kBrickSize),
          m_words((size_t(grid.sizeInBricks().x) + 7) / 8),
          m_bits(kBrickSize * m_rows * m_words) {}
    /// Reads the planes of one layer of bricks; empty outside of the grid.
    void read(const VoxelGrid& grid, int brickZ) {
        std::fill(m_bits.begin(), m_bits.end(), 0);
        uint8_t* bytes = reinterpret_cast<uint8_t*>(m_bits.data());
        if (brickZ < 0 || brickZ >= grid.sizeInBricks().z) return;
        glm::ivec3 brick(0, 0, brickZ);
        for (brick.y = 0; brick.y < grid.sizeInBricks().y; ++brick.y)
            for (brick.x = 0; brick.x < grid.sizeInBricks().x; ++brick.x) {
                const Brick* content = grid.brickAt(brick);
                if (!content) continue;
                for (size_t z = 0; z < 8; ++z)
                    for (size_t y = 0; y < 8; ++y)
                        bytes[(z * m_rows + size_t(brick.y) * 8 + y) * m_words * 8 + size_t(brick.x)] =
                            uint8_t(content->occupancy[z] >> 8 * y);
            }
    }
    size_t rows() const { return m_rows; }
    std::span<const uint64_t> row(size_t y, size_t z) const {
        return std::span(m_bits).subspan((z * m_rows + y) * m_words, m_words);
    }

private:
    size_t m_rows, m_words;
    std::vector<uint64_t> m_bits;
};

/// Removes the cells without a neighbour from a row and returns their number. `around`: the rows beside it.
uint64_t removeIsolatedCells(std::span<uint64_t> row, const std::array<std::span<const uint64_t>, 4>& around) {
    uint64_t count = 0, before = 0;
    for (size_t w = 0; w < row.size(); ++w) {
        const uint64_t bits = row[w], after = w + 1 < row.size() ? row[w + 1] << 63 : 0;
        const uint64_t near =
            (bits << 1 | before) | (bits >> 1 | after) | around[0][w] | around[1][w] | around[2][w] | around[3][w];
        count += uint64_t(std::popcount(bits & ~near));
        row[w] = bits & near;
        before = bits >> 63;
    }
    return count;
}

}  // namespace

std::vector<uint64_t> componentSizesByRuns(const VoxelGrid& grid) {
    const glm::ivec3 bricks = grid.sizeInBricks();
    RunLabels sets(bricks * kBrickSize, false);
    std::array<Slab, 3> slabs{Slab(grid), Slab(grid), Slab(grid)};  // below, current, above
    slabs[2].read(grid, 0);
    const std::vector<uint64_t> none(sets.wordsPerRow());
    std::vector<uint64_t> row;
    uint64_t isolated = 0;
    for (int z = 0; z < bricks.z; ++z) {
        std::rotate(slabs.begin(), slabs.begin() + 1, slabs.end());
        slabs[2].read(grid, z + 1);
        for (size_t plane = 0; plane < kBrickSize; ++plane)
            for (size_t y = 0; y < slabs[1].rows(); ++y) {
                const auto own = slabs[1].row(y, plane);
                row.assign(own.begin(), own.end());
                isolated += removeIsolatedCells(row, {y > 0 ? slabs[1].row(y - 1, plane) : none,
                                                      y + 1 < slabs[1].rows() ? slabs[1].row(y + 1, plane) : none,
                                                      plane > 0 ? slabs[1].row(y, plane - 1) : slabs[0].row(y, 7),
                                                      plane < 7 ? slabs[1].row(y, plane + 1) : slabs[2].row(y, 0)});
                sets.add(row);
            }
    }
    std::vector<uint64_t> voxels = sets.countComponents();
    voxels.insert(voxels.end(), isolated, 1);
    return voxels;
}

}  // namespace rubble
