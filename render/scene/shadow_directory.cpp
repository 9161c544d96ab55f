#include "render/scene/shadow_directory.h"

#include <glm/common.hpp>
#include <utility>

namespace rubble {
namespace {

constexpr int kSectorWords = 16;

int64_t volume(glm::ivec3 size) {
    return int64_t(size.x) * size.y * size.z;
}

int brickInSector(glm::ivec3 brick) {
    return (brick.x & 3) + 4 * (brick.y & 3) + 16 * (brick.z & 3);
}

/// The octants of directions that lead from a sector to one beside it, each a bit.
uint8_t octantsTowards(glm::ivec3 away) {
    uint8_t out = 0;
    for (int octant = 0; octant < 8; ++octant) {
        const glm::ivec3 ahead = 1 - 2 * (glm::ivec3(octant, octant >> 1, octant >> 2) & 1);
        out |= uint8_t(glm::all(glm::greaterThanEqual(ahead * away, glm::ivec3(0)))) << octant;
    }
    return out;
}

}  // namespace

void ShadowDirectory::clear() {
    m_low = m_size = glm::ivec3(0);
    m_skips.reset(glm::ivec3(0));
    m_pageOf.clear();
    m_pages.clear();
    m_freePages = {};
    m_changedPages.clear();
    m_occupied.clear();
}

bool ShadowDirectory::holdsSector(glm::ivec3 sector) const {
    const glm::ivec3 at = sector - m_low;
    return glm::all(glm::greaterThanEqual(at, glm::ivec3(0))) && glm::all(glm::lessThan(at, m_size));
}

bool ShadowDirectory::holds(glm::ivec3 brick) const {
    return holdsSector(brick >> 2);
}

uint32_t ShadowDirectory::texelOf(glm::ivec3 brick) const {
    return pageAt(brick >> 2) * kPageTexels + uint32_t(brickInSector(brick));
}

ShadowDirectory::Brick ShadowDirectory::find(glm::ivec3 brick) const {
    const uint32_t page = pageAt(brick >> 2);
    if (page == kNone || !(m_pages[page].occupied >> brickInSector(brick) & 1)) return {};
    const glm::uvec4 texel = m_pageTexels[texelOf(brick)];
    return {texel.x / 64, texel.y | uint64_t(texel.z) << 32};
}

template <class Texel>
void ShadowDirectory::write(StagedBuffer<Texel>& texels, size_t at, Texel texel) {
    if (texels[at] == texel) return;
    texels.change(at) = texel;
    ++m_writtenTexels;
}

uint32_t ShadowDirectory::addPage(glm::ivec3 sector) {
    const uint32_t page = m_freePages.allocate();
    if (page == m_pages.size()) {
        m_pages.emplace_back();
        m_pageTexels.resize(m_pages.size() * kPageTexels);
    }
    m_pages[page].sector = sector;
    const size_t index = sectorIndex(sector);
    m_pageOf[index] = page;
    m_skips.set(sector - m_low, true);
    write(m_table, index, page * kPageTexels);
    return page;
}

void ShadowDirectory::set(glm::ivec3 brick, const Brick& content) {
    const Brick before = find(brick);
    const glm::ivec3 sector = brick >> 2;
    uint32_t page = pageAt(sector);
    if (page == kNone) {
        if (!content.occupied) return;
        page = addPage(sector);
    }
    m_occupied.change(brick, before.occupied, content.occupied);
    if (!before.occupied != !content.occupied) {
        m_pages[page].occupied ^= SectorBricks(1) << brickInSector(brick);
        queueAround(sector);
    }
    if (!content.occupied) return;  // its texels follow with update()
    write(m_pageTexels, texelOf(brick), glm::uvec4(content.slot * 64, content.occupied, content.occupied >> 32, 0));
}

void ShadowDirectory::queueAround(glm::ivec3 sector) {
    for (int i = 0; i < 27; ++i) {
        const glm::ivec3 away(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        const uint32_t page = pageAt(sector + away);
        if (page == kNone) continue;
        if (!m_pages[page].stale) m_changedPages.push_back(page);
        m_pages[page].stale |= octantsTowards(-away);
    }
}

void ShadowDirectory::removeEmptyPages() {
    for (const uint32_t index : m_changedPages) {
        Page& page = m_pages[index];
        if (page.occupied) continue;
        const size_t at = sectorIndex(page.sector);
        m_pageOf[at] = kNone;
        m_skips.set(page.sector - m_low, false);
        if (m_skips.at(at)) write(m_table, at, m_skips.at(at));  // it came and went since the last update
        m_freePages.free(index);
        page.stale = 0;
    }
    std::erase_if(m_changedPages, [&](uint32_t page) { return !m_pages[page].occupied; });
}

void ShadowDirectory::writeSkips(Page& page) {
    SectorSurroundings occupied;
    for (int i = 0; i < 27; ++i) {
        const uint32_t at = pageAt(page.sector + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1);
        occupied[size_t(i)] = at == kNone ? 0 : m_pages[at].occupied;
    }
    const size_t first = pageAt(page.sector) * kPageTexels;
    std::array<BrickSkips, kPageTexels> skips;
    for (size_t i = 0; i < kPageTexels; ++i) {
        const glm::uvec4 texel = m_pageTexels[first + i];
        skips[i] = {texel.y, texel.z, texel.w};
    }
    updatePageSkips(occupied, std::exchange(page.stale, uint8_t(0)), skips);
    for (size_t i = 0; i < kPageTexels; ++i)
        if (!(page.occupied >> i & 1))
            write(m_pageTexels, first + i, glm::uvec4(1, skips[i][0], skips[i][1], skips[i][2]));
}

void ShadowDirectory::update() {
    removeEmptyPages();
    for (const size_t index : m_skips.update())
        if (m_skips.at(index)) write(m_table, index, m_skips.at(index));
    shrink();
    for (const uint32_t page : m_changedPages) {
        writeSkips(m_pages[page]);
    }
    m_changedPages.clear();
}

/// Replaces the table by one of another box. The pages stay where they are.
void ShadowDirectory::makeTable(glm::ivec3 low, glm::ivec3 size) {
    m_skips.move(low - m_low, size);
    m_low = low;
    m_size = size;
    const size_t count = size_t(volume(size));
    m_table.resize(count);
    m_pageOf.assign(count, kNone);
    for (uint32_t i = 0; i < m_pages.size(); ++i)
        if (m_pages[i].occupied) m_pageOf[sectorIndex(m_pages[i].sector)] = i;
    for (size_t i = 0; i < count; ++i)  // all of it: what is new holds nothing yet
        m_table.change(i) = m_pageOf[i] == kNone ? m_skips.at(i) : m_pageOf[i] * kPageTexels;
    m_writtenTexels += count;
}

/// A table grows by an eighth more than it must, so that a body that flies away does not need another one at each
/// sector.
void ShadowDirectory::reach(const std::vector<ShadowPatch>& patches) {
    glm::ivec3 low = m_low, high = m_low + m_size;
    bool isNew = m_size.x == 0;
    for (const ShadowPatch& patch : patches) {
        if (!patch.content) continue;
        const glm::ivec3 sector = patch.brick >> 2;
        const glm::ivec3 nextLow = isNew ? sector : glm::min(low, sector),
                         nextHigh = isNew ? sector + 1 : glm::max(high, sector + 1);
        if (volume(nextHigh - nextLow) > kMaxSectors) continue;
        low = nextLow;
        high = nextHigh;
        isNew = false;
    }
    if (low == m_low && high == m_low + m_size) return;
    if (m_size.x) {
        const glm::ivec3 margin = m_size / 8;
        const glm::ivec3 wideLow = low - margin * glm::ivec3(glm::lessThan(low, m_low));
        const glm::ivec3 wideHigh = high + margin * glm::ivec3(glm::greaterThan(high, m_low + m_size));
        if (volume(wideHigh - wideLow) <= kMaxSectors) low = wideLow, high = wideHigh;
    }
    makeTable(low, high - low);
}

/// Replaces a table that is several times as large as what is occupied.
void ShadowDirectory::shrink() {
    constexpr int64_t kRatio = 4, kSmall = 64;  // sectors
    const glm::ivec3 low = m_occupied.low() >> 4, high = (m_occupied.high() + (kSectorWords - 1)) >> 4;
    if (m_occupied.low() == m_occupied.high() || volume(m_size) <= kRatio * volume(high - low) + kSmall) return;
    makeTable(low, high - low);
}

}  // namespace rubble
