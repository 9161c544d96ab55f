#include "runtime/shadow/shape_raster.h"

#include <bit>

#include "runtime/shadow/row_clip.h"

namespace rubble {
namespace {

constexpr int kSide = kShadowBrickCells;
/// Along an axis: with up to 3 cells of the first word before them they fit a row of 64 bits.
constexpr int kMaxCells = 60;
constexpr size_t kMaxBricks = 125;  ///< 60 cells touch at most 5 bricks along an axis
constexpr size_t kFewBricks = 8;    ///< a shape smaller than a brick is in at most so many

/// A mask of the bits [low, high).
uint64_t bitsOf(int low, int high) {
    return low < high ? ~uint64_t(0) >> (64 - (high - low)) << low : 0;
}

bool isSolid(const uint64_t* rows, int height, const CellBox& box) {
    const uint64_t all = bitsOf(box.low.x, box.high.x);
    for (int z = box.low.z; z < box.high.z; ++z)
        for (int y = box.low.y; y < box.high.y; ++y)
            if (~rows[y + z * height] & all) return false;
    return true;
}

/// Sets `out` to the voxels without those that have an empty neighbour (erosion). False if none is left.
bool erode(const std::vector<uint64_t>& rows, glm::ivec3 size, std::vector<uint64_t>& out) {
    out.assign(rows.size(), 0);
    uint64_t any = 0;
    for (int z = 1; z + 1 < size.z; ++z)
        for (int y = 1; y + 1 < size.y; ++y) {
            const uint64_t* row = &rows[size_t(y + z * size.y)];
            any |= out[size_t(y + z * size.y)] =
                row[0] & row[-1] & row[1] & row[-size.y] & row[size.y] & row[0] << 1 & row[0] >> 1;
        }
    return any;
}

/// 4 layers of cells, as rows along x, and their conversion to words.
struct Slab {
    static constexpr int kRows = 64;
    std::array<std::array<uint64_t, kRows>, 4> layers{};

    /// Moves 4 rows of each layer, from row `y` on, into words[shift] and behind; word i holds bits 4 i to 4 i + 3 of
    /// each. False if they hold no cells.
    bool takeWords(int y, std::array<uint64_t, 20>& words, int shift) {
        std::array<uint64_t, 16> rows;
        uint64_t any = 0;
        for (size_t i = 0; i < 16; ++i) {
            uint64_t& row = layers[i >> 2][size_t(y) + (i & 3)];
            rows[i] = row;
            any |= row;
            row = 0;
        }
        if (!any) return false;
        transposeNibbles(rows);
        words = {};
        for (size_t i = 0; i < 16; ++i) words[size_t(shift) + i] = rows[i];
        return true;
    }

private:
    /// Nibble i of row k becomes nibble k of row i.
    static void transposeNibbles(std::array<uint64_t, 16>& rows) {
        swapHalves<8>(rows, 0x00000000ffffffffu);
        swapHalves<4>(rows, 0x0000ffff0000ffffu);
        swapHalves<2>(rows, 0x00ff00ff00ff00ffu);
        swapHalves<1>(rows, 0x0f0f0f0f0f0f0f0fu);
    }
    template <size_t kHalf>
    static void swapHalves(std::array<uint64_t, 16>& rows, uint64_t mask) {
        for (size_t base = 0; base < 16; base += 2 * kHalf)
            for (size_t k = base; k < base + kHalf; ++k) {
                const uint64_t swap = (rows[k] >> (4 * kHalf) ^ rows[k + kHalf]) & mask;
                rows[k] ^= swap << (4 * kHalf);
                rows[k + kHalf] ^= swap;
            }
    }
};

/// Samples a shape along rows of shadow cells. What lies in the solid box needs no look-up.
class RowSampler {
public:
    RowSampler(const RasterSource& source, const ShadowCellTransform& cellTransform, int count)
        : m_rows(source.rows()),
          m_height(source.height()),
          m_samples(cellTransform.samples),
          m_step(cellTransform.step[0]),
          m_rowStep(cellTransform.step[1]),
          m_used(source.used(), cellTransform, count),
          m_solidBox(source.solidBox(), cellTransform, count),
          m_isBox(m_samples == 1 && source.solidBox() == source.used()),
          m_hasSolidBox(m_samples == 1 && !m_isBox && !source.solidBox().empty()) {}
    /// Calls row(y, bits) for the rows of a plane that can set cells; bit i / samples of `bits` is set for every sample
    /// i in a solid voxel.
    template <class Row>
    void forEachRow(const FixedPoint& plane, int count, Row&& row) const {
        const RowClip::Exact at = toDoubles(plane);
        const auto [yLow, yHigh] = m_used.rows(at, count);
        std::array<RowClip::Interval, RowClip::kBatch> used, solidBox{};
        for (int y = yLow; y < yHigh; y += RowClip::kBatch) {
            const int some = std::min(RowClip::kBatch, yHigh - y);
            m_used.intervals(at, y, some, used.data());
            if (m_hasSolidBox) m_solidBox.intervals(at, y, some, solidBox.data());
            for (size_t i = 0; i < size_t(some); ++i)
                if (used[i].low < used[i].high)
                    row(y + int(i), m_isBox ? bitsOf(used[i].low, used[i].high)
                                            : cells(plane + m_rowStep * (y + int(i)), used[i], solidBox[i]));
        }
    }

private:
    uint64_t cells(const FixedPoint& first, RowClip::Interval used, RowClip::Interval solidBox) const {
        if (m_samples > 1) return sampleFine(first, used.low, used.high);
        if (solidBox.low >= solidBox.high) return sample(first, used.low, used.high);
        uint64_t bits = bitsOf(solidBox.low, solidBox.high);
        if (used.low < solidBox.low) bits |= sample(first, used.low, solidBox.low);
        if (solidBox.high < used.high) bits |= sample(first, solidBox.high, used.high);
        return bits;
    }
    uint64_t solid(int64_t x, int64_t y, int64_t z) const {
        return m_rows[(y >> 32) + (z >> 32) * m_height] >> (x >> 32) & 1;
    }
    uint64_t sample(const FixedPoint& first, int low, int high) const {
        uint64_t bits = 0;
        const int64_t last = high - 1;
        int64_t x = first[0] + last * m_step[0], y = first[1] + last * m_step[1], z = first[2] + last * m_step[2];
        for (int i = low; i < high; ++i) {  // from the last one down, so that each shifts the bits behind it
            bits = bits + bits + solid(x, y, z);
            x -= m_step[0], y -= m_step[1], z -= m_step[2];
        }
        return bits << low;
    }
    uint64_t sampleFine(const FixedPoint& first, int low, int high) const {
        uint64_t bits = 0;
        int64_t x = first[0] + low * m_step[0], y = first[1] + low * m_step[1], z = first[2] + low * m_step[2];
        for (int i = low; i < high; ++i) {
            bits |= solid(x, y, z) << (i / m_samples);
            x += m_step[0], y += m_step[1], z += m_step[2];
        }
        return bits;
    }
    const uint64_t* m_rows;
    const int64_t m_height;
    const int m_samples;
    const FixedPoint m_step, m_rowStep;
    const RowClip m_used, m_solidBox;
    const bool m_isBox, m_hasSolidBox;
};

}  // namespace

void RasterSource::make(const VoxelGrid& grid) {
    const glm::ivec3 size = grid.size();
    m_height = size.y;
    m_rows.assign(size_t(size.y) * size_t(size.z), 0);
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        const glm::ivec3 low = position * kBrickSize, high = glm::min(low + kBrickSize, size);
        for (int z = low.z; z < high.z; ++z)
            for (int y = low.y; y < high.y; ++y)
                m_rows[size_t(y + z * size.y)] |= (brick->occupancy[size_t(z - low.z)] >> ((y - low.y) * 8) & 0xff)
                                                  << low.x;
    });
    findOccupiedBox(size);
    findSolidBox(size);
}

void RasterSource::findOccupiedBox(glm::ivec3 size) {
    m_used = {size, glm::ivec3(0)};
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y) {
            const uint64_t row = m_rows[size_t(y + z * size.y)];
            if (!row) continue;
            m_used.low = glm::min(m_used.low, glm::ivec3(std::countr_zero(row), y, z));
            m_used.high = glm::max(m_used.high, glm::ivec3(64 - std::countl_zero(row), y + 1, z + 1));
        }
}

/// Finds a large solid box: erodes the shape until nothing is left and grows a box around a voxel that vanished last.
void RasterSource::findSolidBox(glm::ivec3 size) {
    m_solidBox = {};
    if (m_used.empty()) return;
    std::vector<uint64_t> rows = m_rows, next;
    while (erode(rows, size, next)) rows.swap(next);
    const size_t first =
        size_t(std::find_if(rows.begin(), rows.end(), [](uint64_t row) { return row != 0; }) - rows.begin());
    m_solidBox.low = {std::countr_zero(rows[first]), int(first) % size.y, int(first) / size.y};
    m_solidBox.high = m_solidBox.low + 1;
    for (bool grows = true; grows;) {
        grows = false;
        for (int side = 0; side < 6; ++side) {
            const int axis = side >> 1;
            CellBox layer = m_solidBox;
            (side & 1 ? layer.low : layer.high)[axis] = side & 1 ? m_solidBox.high[axis] : m_solidBox.low[axis];
            (side & 1 ? layer.high : layer.low)[axis] += side & 1 ? 1 : -1;
            if (layer.low[axis] < m_used.low[axis] || layer.high[axis] > m_used.high[axis] ||
                !isSolid(m_rows.data(), m_height, layer))
                continue;
            (side & 1 ? m_solidBox.high : m_solidBox.low)[axis] += side & 1 ? 1 : -1;
            grows = true;
        }
    }
}

void ShapeRaster::clear() {
    m_brickSlots.clear();
    m_words.clear();
}

const ShadowWords* ShapeRaster::find(glm::ivec3 brick) const {
    const glm::ivec3 at = brick - m_lowBrick;
    for (int a = 0; a < 3; ++a)
        if (at[a] < 0 || at[a] >= m_bricks[a]) return nullptr;
    const uint8_t place = m_brickSlots[size_t(at.x + m_bricks.x * (at.y + m_bricks.y * at.z))];
    return place ? &m_words[place - 1u] : nullptr;
}

ShadowWords& ShapeRaster::wordsAt(size_t index) {
    uint8_t& place = m_brickSlots[index];
    if (!place) {
        m_words.emplace_back();
        place = uint8_t(m_words.size());
    }
    return m_words[place - 1u];
}

bool ShapeRaster::make(const RasterSource& source, const ShadowCellTransform& cellTransform, const CellBox& bounds) {
    clear();
    const glm::ivec3 size = bounds.high - bounds.low;
    if (std::max({size.x, size.y, size.z}) > kMaxCells) return false;
    const CellBox bricks = shadowBricksOf(bounds);
    m_lowBrick = bricks.low;
    m_bricks = bricks.high - bricks.low;
    m_brickSlots.reserve(kMaxBricks);
    m_brickSlots.assign(size_t(m_bricks.x) * size_t(m_bricks.y) * size_t(m_bricks.z), 0);
    m_words.reserve(std::min(m_brickSlots.size(), kFewBricks));

    const glm::ivec3 count = size * cellTransform.samples,
                     low = bounds.low - m_lowBrick * kSide;  // cells from the lowest brick's corner
    const RowSampler sampler(source, cellTransform, count.x);
    const int bitInWord = low.x & 3, yBase = low.y & ~3;
    Slab slab;
    FixedPoint plane = cellTransform.sample(bounds.low);
    for (int z = 0, zCell = low.z; zCell < low.z + size.z; ++zCell) {
        for (const int end = z + cellTransform.samples; z < end; ++z, plane = plane + cellTransform.step[2]) {
            uint64_t* rows = &slab.layers[size_t(zCell & 3)][size_t(low.y - yBase)];
            sampler.forEachRow(plane, count.y, [&](int y, uint64_t bits) {
                rows[cellTransform.samples == 1 ? y : y / cellTransform.samples] |= bits << bitInWord;
            });
        }
        if ((zCell & 3) != 3 && zCell + 1 < low.z + size.z) continue;
        std::array<uint64_t, 20> words;
        for (int y = yBase; y < low.y + size.y; y += 4) {
            if (!slab.takeWords(y - yBase, words, low.x >> 2 & 3)) continue;
            for (int x = 0; x < m_bricks.x; ++x) {
                const uint64_t* four = &words[size_t(4 * x)];
                if (!(four[0] | four[1] | four[2] | four[3])) continue;
                ShadowWords& to = wordsAt(size_t(x + m_bricks.x * ((y >> 4) + m_bricks.y * (zCell >> 4))));
                std::copy_n(four, 4, &to[size_t((y & 12) + (zCell >> 2 & 3) * 16)]);
            }
        }
    }
    return true;
}

}  // namespace rubble
