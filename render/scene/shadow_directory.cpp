#include "render/scene/shadow_directory.h"

#include <bit>
#include <glm/common.hpp>
#include <utility>

namespace rubble {
namespace {

constexpr int kSectorWords = ShadowDirectory::kSectorCells / 4;

int64_t volume(glm::ivec3 size) {
    return int64_t(size.x) * size.y * size.z;
}

int ceilLog2(int n) {
    return std::bit_width(unsigned(n) - 1u);
}

/// A table's size that holds so many sectors.
glm::ivec3 tableSize(glm::ivec3 sectors) {
    return {1 << ceilLog2(sectors.x), 1 << ceilLog2(sectors.y), sectors.z};
}

int brickInSector(glm::ivec3 brick) {
    return (brick.x & 1) + 2 * (brick.y & 1) + 4 * (brick.z & 1);
}

/// How many bricks of a set come before one.
uint32_t bricksBefore(SectorBricks set, int brick) {
    return uint32_t(std::popcount(uint32_t(set) & ((1u << brick) - 1)));
}

glm::ivec3 sectorOf(glm::ivec3 brick) {
    return brick >> 1;
}

}  // namespace

glm::ivec3 ShadowDirectory::bits() const {
    return m_size.x ? glm::ivec3(ceilLog2(m_size.x), ceilLog2(m_size.y), ceilLog2(m_size.z)) : glm::ivec3(0);
}

void ShadowDirectory::clear() {
    m_low = m_size = glm::ivec3(0);
    m_skips.reset(glm::ivec3(0));
    m_sectorOf.clear();
    m_sectors.clear();
    m_freeSectors = {};
    m_blocks = {};
    m_changedSectors.clear();
    m_placed.clear();
    m_occupied.clear();
}

bool ShadowDirectory::holdsSector(glm::ivec3 sector) const {
    const glm::ivec3 at = sector - m_low;
    return glm::all(glm::greaterThanEqual(at, glm::ivec3(0))) && glm::all(glm::lessThan(at, m_size));
}

bool ShadowDirectory::holds(glm::ivec3 brick) const {
    return holdsSector(sectorOf(brick));
}

template <class Texel>
void ShadowDirectory::write(StagedBuffer<Texel>& texels, size_t at, Texel texel) {
    if (texels[at] == texel) return;
    texels.change(at) = texel;
    ++m_writtenTexels;
}

glm::uvec4 ShadowDirectory::tableTexel(uint32_t index) const {
    const Sector& sector = m_sectors[index];
    uint32_t before = 0;
    for (int i = 0; i < 8; ++i) before |= bricksBefore(sector.occupied, i) << 3 * i;
    return {uint32_t(sector.occupied) << 4, sector.block * 64, before, index * kPageTexels};
}

uint32_t ShadowDirectory::addSector(glm::ivec3 place) {
    const uint32_t index = m_freeSectors.allocate();
    if (index == m_sectors.size()) {
        m_sectors.emplace_back();
        m_pages.resize(m_sectors.size() * kPageTexels);
    }
    m_sectors[index].place = place;
    m_sectorOf[tableIndex(place)] = index;
    m_skips.set(place - m_low, true);
    return index;
}

void ShadowDirectory::set(glm::ivec3 brick, const ShadowBrickRef& content) {
    uint32_t index = sectorAt(sectorOf(brick));
    if (index == kNone) {
        if (!content) return;
        index = addSector(sectorOf(brick));
    }
    Sector& sector = m_sectors[index];
    const int number = brickInSector(brick);
    ShadowBrickRef& old = sector.bricks[size_t(number)];
    m_occupied.change(brick, old ? old->occupied : 0, content ? content->occupied : 0);
    if (!old != !content) {
        sector.occupied ^= SectorBricks(1 << number);
        sector.isPlaced = false;
        queueAround(sector.place);
    }
    old = content;
    if (!content || !sector.isPlaced) return;  // the rest follows with update()
    m_placed.push_back({sector.block + bricksBefore(sector.occupied, number), content});
    write(m_pages, index * kPageTexels + size_t(number), glm::uvec2(content->occupied, content->occupied >> 32));
}

void ShadowDirectory::queueAround(glm::ivec3 place) {
    for (int i = 0; i < 27; ++i) {
        const uint32_t index = sectorAt(place + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1);
        if (index == kNone || std::exchange(m_sectors[index].isQueued, true)) continue;
        m_changedSectors.push_back(index);
    }
}

void ShadowDirectory::removeEmptySectors() {
    for (const uint32_t index : m_changedSectors) {
        Sector& sector = m_sectors[index];
        if (sector.occupied) continue;
        const size_t at = tableIndex(sector.place);
        m_sectorOf[at] = kNone;
        m_skips.set(sector.place - m_low, false);
        if (m_skips.at(at))
            write(m_table, at, glm::uvec4(m_skips.at(at), 0, 0, 0));  // it came and went since the last update
        if (sector.blockSlots) m_blocks.free(sector.block, sector.blockSlots);
        sector = {};
        m_freeSectors.free(index);
    }
    std::erase_if(m_changedSectors, [&](uint32_t index) { return !m_sectors[index].occupied; });
}

/// Gives a sector's bricks a block.
void ShadowDirectory::place(Sector& sector) {
    const auto count = uint32_t(std::popcount(sector.occupied));
    if (count != sector.blockSlots) {
        if (sector.blockSlots) m_blocks.free(sector.block, sector.blockSlots);
        sector.block = m_blocks.allocate(count);
        sector.blockSlots = count;
    }
    uint32_t slot = sector.block;
    for (const ShadowBrickRef& brick : sector.bricks)
        if (brick) m_placed.push_back({slot++, brick});
    sector.isPlaced = true;
}

void ShadowDirectory::writePage(uint32_t index) {
    const Sector& sector = m_sectors[index];
    SectorSurroundings occupied;
    for (int i = 0; i < 27; ++i) {
        const uint32_t at = sectorAt(sector.place + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1);
        occupied[size_t(i)] = at == kNone ? SectorBricks(0) : m_sectors[at].occupied;
    }
    const std::array<uint32_t, 8> skips = pageSkips(occupied);
    for (size_t i = 0; i < 8; ++i) {
        const uint64_t words = sector.bricks[i] ? sector.bricks[i]->occupied : skips[i];
        write(m_pages, index * kPageTexels + i, glm::uvec2(words, words >> 32));
    }
}

void ShadowDirectory::removeBeyond(uint32_t slots) {
    for (size_t index = 0; index < m_sectors.size(); ++index) {
        const glm::ivec3 low = m_sectors[index].place * kSectorBricks;
        if (m_sectors[index].block + m_sectors[index].blockSlots <= slots) continue;
        for (int i = 0; i < 8; ++i) set(low + glm::ivec3(i & 1, i >> 1 & 1, i >> 2), nullptr);
    }
}

void ShadowDirectory::update() {
    removeEmptySectors();
    for (const size_t at : m_skips.update())
        if (m_skips.at(at)) write(m_table, at, glm::uvec4(m_skips.at(at), 0, 0, 0));
    shrink();
    for (const uint32_t index : m_changedSectors) {
        Sector& sector = m_sectors[index];
        if (!sector.isPlaced) place(sector);
        write(m_table, tableIndex(sector.place), tableTexel(index));
        writePage(index);
        sector.isQueued = false;
    }
    m_changedSectors.clear();
}

/// Replaces the table by one of another box. Pages and blocks stay where they are.
void ShadowDirectory::makeTable(glm::ivec3 low, glm::ivec3 size) {
    m_skips.move(low - m_low, size);
    m_low = low;
    m_size = size;
    const size_t count = size_t(volume(size));
    m_table.resize(count);
    m_sectorOf.assign(count, kNone);
    for (uint32_t i = 0; i < m_sectors.size(); ++i)
        if (m_sectors[i].occupied) m_sectorOf[tableIndex(m_sectors[i].place)] = i;
    for (size_t i = 0; i < count; ++i)
        m_table.change(i) = m_sectorOf[i] == kNone ? glm::uvec4(m_skips.at(i), 0, 0, 0) : tableTexel(m_sectorOf[i]);
    m_writtenTexels += count;
}

/// A table that grows does so by at least a quarter, so that a body that flies away does not need another one at each
/// sector.
void ShadowDirectory::reach(const std::vector<ShadowPatch>& patches) {
    glm::ivec3 low = m_low, high = m_low + m_size;
    bool isNew = m_size.x == 0;
    for (const ShadowPatch& patch : patches) {
        if (!patch.content) continue;
        const glm::ivec3 sector = sectorOf(patch.brick);
        const glm::ivec3 nextLow = isNew ? sector : glm::min(low, sector),
                         nextHigh = isNew ? sector + 1 : glm::max(high, sector + 1);
        if (volume(tableSize(nextHigh - nextLow)) > kMaxSectors) continue;
        low = nextLow;
        high = nextHigh;
        isNew = false;
    }
    if (low == m_low && high == m_low + m_size) return;
    if (m_size.x) {
        const glm::ivec3 margin = (m_size + 3) / 4;
        const glm::ivec3 wideLow = low - margin * glm::ivec3(glm::lessThan(low, m_low));
        const glm::ivec3 wideHigh = high + margin * glm::ivec3(glm::greaterThan(high, m_low + m_size));
        if (volume(tableSize(wideHigh - wideLow)) <= kMaxSectors) low = wideLow, high = wideHigh;
    }
    makeTable(low, tableSize(high - low));
}

/// Replaces a table that is several times as large as what is occupied.
void ShadowDirectory::shrink() {
    constexpr int64_t kRatio = 4, kSmall = 512;  // sectors
    const glm::ivec3 low = m_occupied.low() >> 3, high = (m_occupied.high() + (kSectorWords - 1)) >> 3;
    if (m_occupied.low() == m_occupied.high() || volume(m_size) <= kRatio * volume(tableSize(high - low)) + kSmall)
        return;
    makeTable(low, tableSize(high - low));
}

}  // namespace rubble
