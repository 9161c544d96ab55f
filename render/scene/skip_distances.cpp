#include "render/scene/skip_distances.h"

#include <algorithm>
#include <cassert>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <tuple>
#include <utility>

namespace rubble {
namespace {

constexpr int kBlock = 32;              ///< sectors: changes within a block of this side are swept as one box
constexpr int64_t kSmallBox = 1 << 18;  ///< sectors: all changes within a box of this volume are swept as one box

int64_t volume(glm::ivec3 size) {
    return int64_t(size.x) * size.y * size.z;
}

}  // namespace

void SkipDistances::reset(glm::ivec3 size) {
    m_size = size;
    const size_t padded = size_t(volume(size + 2));
    m_occupied.assign(padded, 0);
    for (auto& sides : m_sides) sides.assign(padded, uint8_t(kMaxDistance));
    m_skips.assign(size_t(volume(size)), ~0u);
    m_isChanged.assign(m_skips.size(), 0);
    m_touched.clear();
}

/// The distances of sectors that stay do not change, as what is outside the box is empty. Of the new ones, those ahead
/// of them see nothing but emptiness; those behind are solved axis by axis, so that what is ahead of each is known.
void SkipDistances::move(glm::ivec3 low, glm::ivec3 size) {
    assert(m_touched.empty() && "update() has not run");
    SkipDistances next;
    next.reset(size);
    const Box kept{glm::max(-low, 0), glm::min(m_size - low, size)};
    if (glm::all(glm::lessThan(kept.low, kept.high))) {
        next.copyRows(*this, low, kept);
        for (int octant = 0; octant < 8; ++octant)
            for (int a = 0; a < 3; ++a) {
                Box behind{glm::ivec3(0), size};
                for (int b = a + 1; b < 3; ++b) behind.low[b] = kept.low[b], behind.high[b] = kept.high[b];
                (octant >> a & 1 ? behind.low : behind.high)[a] = (octant >> a & 1 ? kept.high : kept.low)[a];
                next.solve(behind, octant);
            }
        for (const size_t index : std::exchange(next.m_changed, {})) next.m_isChanged[index] = 0;
    }
    *this = std::move(next);
}

/// Copies what two boxes have in common: a box of this one, which begins at sector `low` of the other.
void SkipDistances::copyRows(const SkipDistances& from, glm::ivec3 low, const Box& kept) {
    const auto count = size_t(kept.high.x - kept.low.x);
    for (int z = kept.low.z; z < kept.high.z; ++z)
        for (int y = kept.low.y; y < kept.high.y; ++y) {
            const glm::ivec3 row(kept.low.x, y, z);
            const size_t to = paddedIndexOf(row), at = from.paddedIndexOf(row + low);
            std::copy_n(&from.m_occupied[at], count, &m_occupied[to]);
            for (size_t octant = 0; octant < 8; ++octant)
                std::copy_n(&from.m_sides[octant][at], count, &m_sides[octant][to]);
            std::copy_n(&from.m_skips[from.indexOf(row + low)], count, &m_skips[indexOf(row)]);
        }
}

void SkipDistances::set(glm::ivec3 sector, bool occupied) {
    uint8_t& known = m_occupied[paddedIndexOf(sector)];
    if (known == uint8_t(occupied)) return;
    known = occupied;
    m_touched.push_back(sector);
}

std::vector<SkipDistances::Box> SkipDistances::dirtyBoxes() {
    const auto boxOf = [&](size_t first, size_t end) {
        Box box{m_touched[first], m_touched[first] + 1};
        for (size_t i = first; i < end; ++i)
            box = {glm::min(box.low, m_touched[i]), glm::max(box.high, m_touched[i] + 1)};
        return box;
    };
    if (m_touched.empty()) return {};
    const Box all = boxOf(0, m_touched.size());
    if (volume(all.high - all.low) <= kSmallBox) return {all};
    const auto block = [](glm::ivec3 sector) {
        return std::tuple(sector.z / kBlock, sector.y / kBlock, sector.x / kBlock);
    };
    std::sort(m_touched.begin(), m_touched.end(), [&](glm::ivec3 a, glm::ivec3 b) { return block(a) < block(b); });
    std::vector<Box> boxes;
    int64_t swept = 0;
    for (size_t first = 0, end = 1; first < m_touched.size(); first = end++) {
        while (end < m_touched.size() && block(m_touched[end]) == block(m_touched[first])) ++end;
        boxes.push_back(boxOf(first, end));
        swept += volume(boxes.back().high - boxes.back().low + (kMaxDistance - 1));
    }
    return swept < volume(all.high - all.low + (kMaxDistance - 1)) ? boxes : std::vector<Box>{all};
}

/// A box of changed sectors and those behind it, whose distances may change with it.
SkipDistances::Box SkipDistances::boxBehind(Box dirty, int octant) const {
    for (int a = 0; a < 3; ++a) {
        if (octant >> a & 1)
            dirty.high[a] = std::min(m_size[a], dirty.high[a] + (kMaxDistance - 1));
        else
            dirty.low[a] = std::max(0, dirty.low[a] - (kMaxDistance - 1));
    }
    return dirty;
}

/// Solves the recurrence in a box for one octant, from far sectors to near ones. Those ahead of the box are up to date.
void SkipDistances::solve(const Box& box, int octant) {
    const glm::ivec3 low = box.low, high = box.high, step = 1 - 2 * (glm::ivec3(octant, octant >> 1, octant >> 2) & 1);
    const glm::ivec3 first(step.x > 0 ? high.x - 1 : low.x, step.y > 0 ? high.y - 1 : low.y,
                           step.z > 0 ? high.z - 1 : low.z);
    const glm::ivec3 count = high - low;
    std::vector<uint8_t>& sides = m_sides[size_t(octant)];
    const ptrdiff_t x = step.x, y = step.y * ptrdiff_t(m_size.x + 2),
                    z = step.z * ptrdiff_t(m_size.x + 2) * (m_size.y + 2);
    for (int k = 0; k < count.z; ++k)
        for (int j = 0; j < count.y; ++j) {
            const glm::ivec3 sector = first - step * glm::ivec3(0, j, k);
            const size_t row = paddedIndexOf(sector);
            uint8_t* side = &sides[row];
            const uint8_t* occupied = &m_occupied[row];
            size_t index = indexOf(sector);
            // Of the seven cubes one on, three begin beside this sector and four one step along x: their minimum is the
            // last step's, because this row is walked along x.
            const auto beside = [&](const uint8_t* at) { return std::min(std::min(at[y], at[z]), at[y + z]); };
            uint8_t behind = std::min(side[x], beside(side + x));
            for (int i = 0; i < count.x; ++i, side -= x, occupied -= x, index -= size_t(x)) {
                const uint8_t columns = beside(side);
                const uint8_t value =
                    *occupied ? uint8_t(0) : uint8_t(std::min(int(std::min(behind, columns)) + 1, kMaxDistance));
                behind = std::min(value, columns);
                if (*side == value) continue;
                *side = value;
                uint32_t& packed = m_skips[index];
                packed = (packed & ~(15u << (4 * octant))) | uint32_t(value) << (4 * octant);
                if (!m_isChanged[index]) m_changed.push_back(index);
                m_isChanged[index] = 1;
            }
        }
}

const std::vector<size_t>& SkipDistances::update() {
    m_changed.clear();
    for (const Box& box : dirtyBoxes())
        for (int octant = 0; octant < 8; ++octant) solve(boxBehind(box, octant), octant);
    m_touched.clear();
    for (const size_t index : m_changed) m_isChanged[index] = 0;
    return m_changed;
}

}  // namespace rubble
