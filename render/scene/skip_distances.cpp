#include "render/scene/skip_distances.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <tuple>
#include <utility>

#include "runtime/core/assertion.h"

namespace rubble {
namespace {

constexpr int kBlock = 32;              ///< sectors: changes within a block of this side are swept as one box
constexpr int64_t kSmallBox = 1 << 18;  ///< sectors: all changes within a box of this volume are swept as one box

constexpr uint32_t kAllEmpty = ~0u;  ///< the greatest distance in all octants

int64_t volume(glm::ivec3 size) {
    return int64_t(size.x) * size.y * size.z;
}

}  // namespace

void SkipDistances::reset(glm::ivec3 size) {
    m_size = size;
    m_skips.assign(size_t(volume(size + 2)), kAllEmpty);
    m_isChanged.assign(size_t(volume(size)), false);
    m_touched.clear();
}

/// The distances of sectors that stay do not change, as what is outside the box is empty. Of the new ones, those ahead
/// of them see nothing but emptiness; those behind are solved axis by axis, so that what is ahead of each is known.
void SkipDistances::move(glm::ivec3 low, glm::ivec3 size) {
    RUBBLE_ASSERT(m_touched.empty() && "update() has not run");
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
        for (const size_t index : std::exchange(next.m_changed, {})) next.m_isChanged[index] = false;
    }
    *this = std::move(next);
}

/// Copies what two boxes have in common: a box of this one, which begins at sector `low` of the other.
void SkipDistances::copyRows(const SkipDistances& from, glm::ivec3 low, const Box& kept) {
    const auto count = size_t(kept.high.x - kept.low.x);
    for (int z = kept.low.z; z < kept.high.z; ++z)
        for (int y = kept.low.y; y < kept.high.y; ++y) {
            const glm::ivec3 row(kept.low.x, y, z);
            std::copy_n(&from.m_skips[from.paddedIndexOf(row + low)], count, &m_skips[paddedIndexOf(row)]);
        }
}

void SkipDistances::set(glm::ivec3 sector, bool occupied) {
    uint32_t& skips = m_skips[paddedIndexOf(sector)];
    if ((skips == 0) == occupied) return;
    skips = occupied ? 0 : kAllEmpty;
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
    const ptrdiff_t x = step.x, y = step.y * ptrdiff_t(m_size.x + 2),
                    z = step.z * ptrdiff_t(m_size.x + 2) * (m_size.y + 2);
    const int shift = 4 * octant;
    const auto sideOf = [&](const uint32_t* at) { return *at >> shift & 15u; };
    for (int k = 0; k < count.z; ++k)
        for (int j = 0; j < count.y; ++j) {
            const glm::ivec3 sector = first - step * glm::ivec3(0, j, k);
            uint32_t* at = &m_skips[paddedIndexOf(sector)];
            size_t index = indexOf(sector);
            // Of the seven cubes one on, three begin beside this sector and four one step along x: their minimum is the
            // last step's, because this row is walked along x.
            const auto beside = [&](const uint32_t* from) {
                return std::min(std::min(sideOf(from + y), sideOf(from + z)), sideOf(from + y + z));
            };
            uint32_t behind = std::min(sideOf(at + x), beside(at + x));
            for (int i = 0; i < count.x; ++i, at -= x, index -= size_t(x)) {
                const uint32_t columns = beside(at),
                               value = *at ? std::min(std::min(behind, columns) + 1, uint32_t(kMaxDistance)) : 0;
                behind = std::min(value, columns);
                if (sideOf(at) == value) continue;
                *at = (*at & ~(15u << shift)) | value << shift;
                markChanged(index);
            }
        }
}

void SkipDistances::markChanged(size_t index) {
    if (m_isChanged[index]) return;
    m_isChanged[index] = true;
    m_changed.push_back(index);
}

const std::vector<size_t>& SkipDistances::update() {
    m_changed.clear();
    for (const glm::ivec3 sector : m_touched) markChanged(indexOf(sector));
    for (const Box& box : dirtyBoxes())
        for (int octant = 0; octant < 8; ++octant) solve(boxBehind(box, octant), octant);
    m_touched.clear();
    for (const size_t index : m_changed) m_isChanged[index] = false;
    return m_changed;
}

}  // namespace rubble
