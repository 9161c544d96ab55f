#include "render/scene/shadow_mirror.h"

#include <bit>
#include <glm/common.hpp>

namespace rubble {
namespace {

constexpr uint32_t kNone = ~0u;
int childOf(glm::ivec3 brick) {
    return (brick.x & 3) + (brick.y & 3) * 4 + (brick.z & 3) * 16;
}

}  // namespace

size_t ShadowMirror::indexOf(glm::ivec3 sector) const {
    const glm::ivec3 at = sector - m_low;
    return (size_t(at.z) * size_t(m_count.y) + size_t(at.y)) * size_t(m_count.x) + size_t(at.x);
}

void ShadowMirror::apply(const std::vector<ShadowPatch>& patches, bool replacesAll) {
    if (replacesAll) {
        m_low = m_count = glm::ivec3(0);
        m_sectors.resize(0);
        m_tableSlots = m_brickSlots = {};
    }
    for (const ShadowPatch& patch : patches) put(patch);
}

void ShadowMirror::growTo(glm::ivec3 sector) {
    const glm::ivec3 low = m_count.x ? glm::min(m_low, sector) : sector;
    const glm::ivec3 high = m_count.x ? glm::max(m_low + m_count, sector + 1) : sector + 1;
    if (low == m_low && high == m_low + m_count) return;
    std::vector<Sector> old(m_sectors.size());
    for (size_t i = 0; i < old.size(); ++i) old[i] = m_sectors[i];
    const glm::ivec3 oldLow = m_low, oldCount = m_count;
    m_low = low;
    m_count = high - low;
    const size_t size = size_t(m_count.x) * size_t(m_count.y) * size_t(m_count.z);
    m_sectors.resize(size);
    for (size_t i = 0; i < size; ++i) m_sectors.change(i) = Sector{};
    for (size_t i = 0; i < old.size(); ++i) {
        const int n = int(i);
        const glm::ivec3 at(n % oldCount.x, n / oldCount.x % oldCount.y, n / oldCount.x / oldCount.y);
        m_sectors.change(indexOf(oldLow + at)) = old[i];
    }
}

void ShadowMirror::put(const ShadowPatch& patch) {
    const glm::ivec3 sector = patch.brick >> 2;
    const bool inside = glm::all(glm::greaterThanEqual(sector, m_low)) && glm::all(glm::lessThan(sector, m_low + m_count));
    if (!inside) {
        if (!patch.content) return;
        growTo(sector);
    }
    const size_t index = indexOf(sector);
    const int child = childOf(patch.brick);
    if (m_sectors[index].table == kNone) {
        if (!patch.content) return;
        Sector& added = m_sectors.change(index);
        added.table = m_tableSlots.take();
        m_tables.resize(std::max<size_t>(m_tables.size(), m_tableSlots.end()));
        m_tables.change(added.table) = Table{};
    }
    Sector& at = m_sectors.change(index);
    Child& entry = m_tables.change(at.table).children[child];
    uint32_t& mask = at.mask[child >> 5];
    const uint32_t bit = 1u << (child & 31);
    if (patch.content) {
        if (entry.slot == kNone) entry.slot = m_brickSlots.take();
        m_bricks.resize(std::max<size_t>(m_bricks.size(), m_brickSlots.end()));
        m_bricks.change(entry.slot) = *patch.content;
        const uint64_t words = patch.content->occupiedWords();
        entry.mask[0] = uint32_t(words);
        entry.mask[1] = uint32_t(words >> 32);
        mask |= bit;
        return;
    }
    if (entry.slot != kNone) m_brickSlots.give(entry.slot);
    entry = Child{};
    mask &= ~bit;
    if (at.mask[0] | at.mask[1]) return;
    m_tableSlots.give(at.table);
    at = Sector{};
}

uint64_t ShadowMirror::upload() {
    return m_sectors.upload() + m_tables.upload() + m_bricks.upload();
}

void ShadowMirror::bind(const Program& program) const {
    program.set("uShadowSectors", m_sectors.texture());
    program.set("uShadowTables", m_tables.texture());
    program.set("uShadowBricks", m_bricks.texture());
}

}  // namespace rubble
