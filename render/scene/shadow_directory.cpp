#include "render/scene/shadow_directory.h"

#include <bit>
#include <glm/common.hpp>
#include <utility>

namespace rubble {
namespace {

constexpr int kSectorWords = 16;

/// The sectors that words are in.
SectorBox occupiedSectors(const OccupiedBox& words) {
    if (words.low() == words.high()) return {};
    return {words.low() >> 4, (words.high() + (kSectorWords - 1)) >> 4};
}

/// The index of a place in an array of this size, x fastest.
size_t indexIn(glm::ivec3 at, glm::ivec3 size) {
    return (size_t(at.z) * size_t(size.y) + size_t(at.y)) * size_t(size.x) + size_t(at.x);
}

/// The inverse of brickInSector().
glm::ivec3 brickAt(glm::ivec3 sector, int index) {
    return sector * ShadowDirectory::kSectorBricks + glm::ivec3(index & 3, index >> 2 & 3, index >> 4);
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
    m_beyond.clear();
    m_scattered = 0;
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
    if (!holds(brick)) {
        const auto found = m_beyond.find(placeOf(brick));
        return found == m_beyond.end() ? Brick{} : found->second;
    }
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
    if (!holds(brick)) {
        m_beyond.erase(placeOf(brick));
        if (content.occupied) m_beyond.emplace(placeOf(brick), content);
        return;
    }
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
    readmit();
    for (const size_t index : m_skips.update())
        if (m_skips.at(index)) write(m_table, index, m_skips.at(index));
    shrink();
    for (const uint32_t page : m_changedPages) writeSkips(page);
    m_changedPages.clear();
}

/// Replaces the table by one of another box, which must hold all its bricks, and takes in what waits for room there.
/// The pages stay where they are.
void ShadowDirectory::makeTable(const SectorBox& box) {
    m_skips.move(box.low - m_paged.low, box.size());
    m_paged.low = box.low;
    m_paged.size = box.size();
    const size_t count = size_t(box.volume());
    m_table.resize(count);
    m_pageOf.assign(count, kNone);
    for (uint32_t i = m_densePages; i < m_pages.size(); ++i)
        if (m_pages[i].occupied) m_pageOf[m_paged.indexOf(m_pages[i].sector)] = i;
    for (size_t i = 0; i < count; ++i)  // all of it: what is new holds nothing yet
        m_table.change(i) = m_pageOf[i] == kNone ? m_skips.at(i) : m_pageOf[i] * kPageTexels;
    m_writtenTexels += count;
    std::map<Place, Brick> waiting = std::exchange(m_beyond, {});
    for (const auto& [place, content] : waiting) set(place.brick(), content);
}

/// Makes another dense part, for these sectors. Nothing is in the paged part then: what is elsewhere waits for room.
void ShadowDirectory::makeDense(const SectorBox& sectors) {
    std::vector<std::pair<glm::ivec3, Brick>> bricks;
    forEach([&](glm::ivec3 brick, const Brick& content) { bricks.emplace_back(brick, content); });
    clear();
    const glm::ivec3 size = sectors.size();
    m_dense.low = sectors.low;
    m_dense.size = size;
    m_densePages = uint32_t(sectors.volume());
    m_pages.resize(m_densePages);
    m_texels.resize(m_densePages * kPageTexels);
    for (uint32_t i = 0; i < m_densePages; ++i) {
        m_pages[i].sector =
            sectors.low + glm::ivec3(int(i) % size.x, int(i) / size.x % size.y, int(i) / size.x / size.y);
        queue(i, 0xff);
    }
    for (const auto& [brick, content] : bricks) set(brick, content);
}

ShadowDirectory::Place ShadowDirectory::placeOf(glm::ivec3 brick) const {
    return {squaredDistance(brick >> 2, m_middle), brick.z, brick.y, brick.x};
}

/// All bricks, and those of patches that are new, by sectors.
std::vector<SectorBricksCount> ShadowDirectory::countBricks(const std::vector<ShadowPatch>& patches) const {
    std::vector<SectorBricksCount> out;
    for (const Page& page : m_pages)
        if (page.occupied) out.push_back({page.sector, std::popcount(page.occupied)});
    for (const auto& [place, content] : m_beyond) out.push_back({place.brick() >> 2, 1});
    for (const ShadowPatch& patch : patches)
        if (patch.content && !find(patch.brick).occupied) out.push_back({patch.brick >> 2, 1});
    return out;
}

/// A table grows by an eighth more than it must, so that a body that flies away does not need another one at each
/// sector.
void ShadowDirectory::reach(const std::vector<ShadowPatch>& patches) {
    if (reachDensely(patches)) return chooseTable(patches);
    const SectorBox before{m_paged.low, m_paged.low + m_paged.size};
    SectorBox table = before;
    for (const ShadowPatch& patch : patches) {
        if (!patch.content || holds(patch.brick)) continue;
        const bool isFarther = !m_beyond.empty() && m_beyond.begin()->first < placeOf(patch.brick);
        if (!isFarther) table.include(patch.brick >> 2);
    }
    if (table.low == before.low && table.high == before.high) return;
    if (table.volume() > double(kMaxSectors)) return chooseTable(patches);
    if (m_paged.size.x && m_beyond.empty()) {
        const glm::ivec3 margin = m_paged.size / 8;
        const SectorBox wide{table.low - margin * glm::ivec3(glm::lessThan(table.low, before.low)),
                             table.high + margin * glm::ivec3(glm::greaterThan(table.high, before.high))};
        if (wide.volume() <= double(kMaxSectors)) table = wide;
    }
    makeTable(table);
}

/// If most bricks are outside of the dense part, makes another one for the bulk of all, if they have one. Bricks that
/// had none are looked at again when they are twice or half as many. Returns whether it looked at them: what has room
/// in the table must be chosen then.
bool ShadowDirectory::reachDensely(const std::vector<ShadowPatch>& patches) {
    int64_t outside = m_paged.bricks + beyond();
    for (const ShadowPatch& patch : patches)
        if (patch.content && !m_dense.holds(patch.brick >> 2) && !find(patch.brick).occupied) ++outside;
    const int64_t bricks = m_dense.bricks + outside;
    if (outside <= m_dense.bricks || (bricks < 2 * m_scattered && 2 * bricks > m_scattered)) return false;
    std::vector<SectorBricksCount> sectors = countBricks(patches);
    moveMiddle(middleOf(sectors));
    sortByDistance(sectors, m_middle);
    const SectorBox bulk = bulkOf(sectors, kBricksPerDenseSector, kSmallDense);
    const bool hasBulk = bulk.low != bulk.high;
    if (hasBulk) makeDense(bulk);
    m_scattered = hasBulk ? 0 : bricks;
    return true;
}

/// Sorts the bricks that wait by their distance from another middle.
void ShadowDirectory::moveMiddle(glm::ivec3 middle) {
    m_middle = middle;
    std::map<Place, Brick> waiting = std::exchange(m_beyond, {});
    for (const auto& [place, content] : waiting) m_beyond.emplace(placeOf(place.brick()), content);
}

/// Makes the table for as many of the nearest bricks as it can span, of all that are not in the dense part.
void ShadowDirectory::chooseTable(const std::vector<ShadowPatch>& patches) {
    std::vector<SectorBricksCount> sectors = countBricks(patches);
    std::erase_if(sectors, [&](const SectorBricksCount& each) { return m_dense.holds(each.sector); });
    sortByDistance(sectors, m_middle);
    const SectorBox box = boxOfNearest(sectors, kMaxSectors);
    leaveTable(box);
    makeTable(box);
}

/// Bricks of the table outside of a box wait for room from now on.
void ShadowDirectory::leaveTable(const SectorBox& kept) {
    std::vector<std::pair<glm::ivec3, Brick>> leaving;
    const Part next{kept.low, kept.size(), {}, 0};
    for (uint32_t i = m_densePages; i < m_pages.size(); ++i)
        for (int at = 0; at < int(kPageTexels) && !next.holds(m_pages[i].sector); ++at)
            if (m_pages[i].occupied >> at & 1) {
                const glm::ivec3 brick = brickAt(m_pages[i].sector, at);
                leaving.emplace_back(brick, find(brick));
            }
    for (const auto& [brick, content] : leaving) {
        set(brick, {});
        m_beyond.emplace(placeOf(brick), content);
    }
    removeEmptyPages();
    m_skips.update();  // their texels follow with the next table
}

/// Takes in what waits, nearest first, if the table can span it now.
void ShadowDirectory::readmit() {
    if (m_beyond.empty()) return;
    SectorBox needed = occupiedSectors(m_paged.occupied);
    needed.include(m_beyond.begin()->first.brick() >> 2);
    if (needed.volume() <= double(kMaxSectors)) chooseTable({});
}

/// Replaces a table that is several times as large as what is occupied.
void ShadowDirectory::shrink() {
    constexpr double kRatio = 4.0, kSmall = 64.0;  // sectors
    const SectorBox table{m_paged.low, m_paged.low + m_paged.size}, needed = occupiedSectors(m_paged.occupied);
    if (table.volume() > kRatio * needed.volume() + kSmall) makeTable(needed);
}

}  // namespace rubble
