#include "render/scene/shadow_directory.h"

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

namespace rubble {
namespace {

constexpr int kSectorWords = 16;

int64_t volume(glm::ivec3 size) {
    return int64_t(size.x) * size.y * size.z;
}

/// The index of a place in an array of this size, x fastest.
size_t indexIn(glm::ivec3 at, glm::ivec3 size) {
    return (size_t(at.z) * size_t(size.y) + size_t(at.y)) * size_t(size.x) + size_t(at.x);
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

/// A box of sectors; empty at first.
struct ShadowDirectory::Sectors {
    glm::ivec3 low{0}, high{0};
    void include(glm::ivec3 first, glm::ivec3 end) {
        const bool isEmpty = low == high;
        low = isEmpty ? first : glm::min(low, first);
        high = isEmpty ? end : glm::max(high, end);
    }
    void include(const OccupiedBox& words) {
        if (words.low() != words.high()) include(words.low() >> 4, (words.high() + (kSectorWords - 1)) >> 4);
    }
};

bool ShadowDirectory::Part::holds(glm::ivec3 sector) const {
    const glm::ivec3 at = sector - low;
    return glm::all(glm::greaterThanEqual(at, glm::ivec3(0))) && glm::all(glm::lessThan(at, size));
}

size_t ShadowDirectory::Part::indexOf(glm::ivec3 sector) const {
    return indexIn(sector - low, size);
}

void ShadowDirectory::clear() {
    m_dense = m_paged = {};
    m_skips.reset(glm::ivec3(0));
    m_pageOf.clear();
    m_pages.clear();
    m_densePages = 0;
    m_freePages = {};
    m_changedPages.clear();
}

bool ShadowDirectory::holds(glm::ivec3 brick) const {
    return m_dense.holds(brick >> 2) || m_paged.holds(brick >> 2);
}

uint32_t ShadowDirectory::pageAt(glm::ivec3 sector) const {
    if (m_dense.holds(sector)) return uint32_t(m_dense.indexOf(sector));
    return m_paged.holds(sector) ? m_pageOf[m_paged.indexOf(sector)] : kNone;
}

size_t ShadowDirectory::texelOf(uint32_t page, int brick) const {
    if (!isDense(page)) return page * kPageTexels + size_t(brick);
    const glm::ivec3 in(brick & 3, brick >> 2 & 3, brick >> 4);
    return indexIn((m_pages[page].sector - m_dense.low) * kSectorBricks + in, m_dense.size * kSectorBricks);
}

ShadowDirectory::Brick ShadowDirectory::find(glm::ivec3 brick) const {
    const uint32_t page = pageAt(brick >> 2);
    if (page == kNone || !(m_pages[page].occupied >> brickInSector(brick) & 1)) return {};
    const glm::uvec4 texel = m_texels[texelOf(page, brickInSector(brick))];
    return {texel.x / 64, texel.y | uint64_t(texel.z) << 32};
}

template <class Texel>
void ShadowDirectory::write(StagedBuffer<Texel>& texels, size_t at, Texel texel) {
    if (texels[at] == texel) return;
    texels.change(at) = texel;
    ++m_writtenTexels;
}

uint32_t ShadowDirectory::addPage(glm::ivec3 sector) {
    const uint32_t page = m_densePages + m_freePages.allocate();
    if (page == m_pages.size()) {
        m_pages.emplace_back();
        m_texels.resize(m_pages.size() * kPageTexels);
    }
    m_pages[page].sector = sector;
    const size_t index = m_paged.indexOf(sector);
    m_pageOf[index] = page;
    m_skips.set(sector - m_paged.low, true);
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
    Part& part = isDense(page) ? m_dense : m_paged;
    part.occupied.change(brick, before.occupied, content.occupied);
    if (!before.occupied != !content.occupied) {
        m_pages[page].occupied ^= SectorBricks(1) << brickInSector(brick);
        part.bricks += content.occupied ? 1 : -1;
        queueAround(sector);
    }
    if (!content.occupied) return;  // its texels follow with update()
    write(m_texels, texelOf(page, brickInSector(brick)),
          glm::uvec4(content.slot * 64, content.occupied, content.occupied >> 32, 0));
}

void ShadowDirectory::queue(uint32_t page, uint8_t octants) {
    if (!m_pages[page].stale) m_changedPages.push_back(page);
    m_pages[page].stale |= octants;
}

/// Queues the sectors whose rays may skip to a sector: those around it in its part.
void ShadowDirectory::queueAround(glm::ivec3 sector) {
    const bool isDenseSector = m_dense.holds(sector);
    for (int i = 0; i < 27; ++i) {
        const glm::ivec3 away(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        const uint32_t page = pageAt(sector + away);
        if (page != kNone && isDense(page) == isDenseSector) queue(page, octantsTowards(-away));
    }
}

void ShadowDirectory::removeEmptyPages() {
    for (const uint32_t index : m_changedPages) {
        Page& page = m_pages[index];
        if (page.occupied || isDense(index)) continue;
        const size_t at = m_paged.indexOf(page.sector);
        m_pageOf[at] = kNone;
        m_skips.set(page.sector - m_paged.low, false);
        if (m_skips.at(at)) write(m_table, at, m_skips.at(at));  // it came and went since the last update
        m_freePages.free(index - m_densePages);
        page.stale = 0;
    }
    std::erase_if(m_changedPages, [&](uint32_t page) { return !m_pages[page].stale; });
}

void ShadowDirectory::writeSkips(uint32_t index) {
    Page& page = m_pages[index];
    SectorSurroundings occupied;
    for (int i = 0; i < 27; ++i) {
        const uint32_t at = pageAt(page.sector + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1);
        occupied[size_t(i)] = at == kNone || isDense(at) != isDense(index) ? 0 : m_pages[at].occupied;
    }
    std::array<BrickSkips, kPageTexels> skips;
    for (int i = 0; i < int(kPageTexels); ++i) {
        const glm::uvec4 texel = m_texels[texelOf(index, i)];
        skips[size_t(i)] = {texel.y, texel.z, texel.w};
    }
    updatePageSkips(occupied, std::exchange(page.stale, uint8_t(0)), skips);
    for (int i = 0; i < int(kPageTexels); ++i) {
        const BrickSkips& of = skips[size_t(i)];
        if (!(page.occupied >> i & 1)) write(m_texels, texelOf(index, i), glm::uvec4(1, of[0], of[1], of[2]));
    }
}

void ShadowDirectory::update() {
    removeEmptyPages();
    for (const size_t index : m_skips.update())
        if (m_skips.at(index)) write(m_table, index, m_skips.at(index));
    shrink();
    for (const uint32_t page : m_changedPages) writeSkips(page);
    m_changedPages.clear();
}

/// Replaces the table by one of another box. The pages stay where they are.
void ShadowDirectory::makeTable(glm::ivec3 low, glm::ivec3 size) {
    m_skips.move(low - m_paged.low, size);
    m_paged.low = low;
    m_paged.size = size;
    const size_t count = size_t(volume(size));
    m_table.resize(count);
    m_pageOf.assign(count, kNone);
    for (uint32_t i = m_densePages; i < m_pages.size(); ++i)
        if (m_pages[i].occupied) m_pageOf[m_paged.indexOf(m_pages[i].sector)] = i;
    for (size_t i = 0; i < count; ++i)  // all of it: what is new holds nothing yet
        m_table.change(i) = m_pageOf[i] == kNone ? m_skips.at(i) : m_pageOf[i] * kPageTexels;
    m_writtenTexels += count;
}

/// Makes another dense part, for sectors that hold all bricks. Nothing is left for the paged part.
void ShadowDirectory::makeDense(const Sectors& sectors) {
    std::vector<std::pair<glm::ivec3, Brick>> bricks;
    forEach([&](glm::ivec3 brick, const Brick& content) { bricks.emplace_back(brick, content); });
    clear();
    const glm::ivec3 size = sectors.high - sectors.low;
    m_dense.low = sectors.low;
    m_dense.size = size;
    m_densePages = uint32_t(volume(size));
    m_pages.resize(m_densePages);
    m_texels.resize(m_densePages * kPageTexels);
    for (uint32_t i = 0; i < m_densePages; ++i) {
        m_pages[i].sector =
            sectors.low + glm::ivec3(int(i) % size.x, int(i) / size.x % size.y, int(i) / size.x / size.y);
        queue(i, 0xff);
    }
    for (const auto& [brick, content] : bricks) set(brick, content);
}

/// A table grows by an eighth more than it must, so that a body that flies away does not need another one at each
/// sector.
void ShadowDirectory::reach(const std::vector<ShadowPatch>& patches) {
    if (reachDensely(patches)) return;
    const glm::ivec3 end = m_paged.low + m_paged.size;
    Sectors table{m_paged.low, end};
    for (const ShadowPatch& patch : patches) {
        const glm::ivec3 sector = patch.brick >> 2;
        if (!patch.content || m_dense.holds(sector)) continue;
        Sectors next = table;
        next.include(sector, sector + 1);
        if (volume(next.high - next.low) <= kMaxSectors) table = next;
    }
    if (table.low == m_paged.low && table.high == end) return;
    if (m_paged.size.x) {
        const glm::ivec3 margin = m_paged.size / 8;
        const glm::ivec3 wideLow = table.low - margin * glm::ivec3(glm::lessThan(table.low, m_paged.low));
        const glm::ivec3 wideHigh = table.high + margin * glm::ivec3(glm::greaterThan(table.high, end));
        if (volume(wideHigh - wideLow) <= kMaxSectors) table = {wideLow, wideHigh};
    }
    makeTable(table.low, table.high - table.low);
}

/// If most bricks are outside of the dense part, makes another one for all, unless it would be large for them.
bool ShadowDirectory::reachDensely(const std::vector<ShadowPatch>& patches) {
    int64_t outside = m_paged.bricks;
    Sectors all;
    all.include(m_dense.occupied);
    all.include(m_paged.occupied);
    for (const ShadowPatch& patch : patches) {
        if (!patch.content || m_dense.holds(patch.brick >> 2) || find(patch.brick).occupied) continue;
        ++outside;
        all.include(patch.brick >> 2, (patch.brick >> 2) + 1);
    }
    const int64_t size = volume(all.high - all.low), bricks = m_dense.bricks + outside;
    if (outside <= m_dense.bricks || size > std::max(kSmallDense, bricks / kBricksPerDenseSector)) return false;
    makeDense(all);
    return true;
}

/// Replaces a table that is several times as large as what is occupied.
void ShadowDirectory::shrink() {
    constexpr int64_t kRatio = 4, kSmall = 64;  // sectors
    Sectors needed;
    needed.include(m_paged.occupied);
    const glm::ivec3 size = needed.high - needed.low;
    if (volume(m_paged.size) > kRatio * volume(size) + kSmall) makeTable(needed.low, size);
}

}  // namespace rubble
