#pragma once
#include <array>
#include <vector>

#include "render/scene/occupied_box.h"
#include "render/scene/page_skips.h"
#include "render/scene/skip_distances.h"
#include "render/scene/staged_buffer.h"
#include "runtime/core/index_allocator.h"
#include "runtime/shadow/shadow_volume.h"

namespace rubble {

/// Finds the shadow volume's bricks for rays. A table has a texel for each sector (2x2x2 bricks) of a box. An empty
/// sector's texel says how far rays may skip, in sectors; an occupied one's which of its bricks are occupied, and where
/// its page and its block are. A page has a texel for each brick of its sector: how far rays may skip, in bricks, or
/// which of the brick's words are occupied. A block is the room for the texels of the sector's occupied bricks, one
/// after the other. Pages and blocks come and go with the bricks, and the box follows what is occupied, so memory and
/// work follow the bricks that change. Layout: lib/shadow_trace.glsl. [render-thread]
class ShadowDirectory {
public:
    static constexpr int kSectorBricks = 2;                                 ///< side of a sector
    static constexpr int kSectorCells = kSectorBricks * kShadowBrickCells;  ///< the same in cells
    /// What the table can span: 1 x 1 km, 50 m high, or as many sectors in another shape.
    static constexpr int64_t kMaxSectors = int64_t(1) << 22;

    /// A brick whose texels must be sent to a slot: 64 texels.
    struct Placed {
        uint32_t slot;
        ShadowBrickRef content;
    };

    /// Removes all bricks.
    void clear();
    /// Makes the table hold the places of all patches with content, but for those with which it would span too much.
    void reach(const std::vector<ShadowPatch>& patches);
    /// Whether the table holds the brick's sector.
    bool holds(glm::ivec3 brick) const;
    /// Puts a brick at a place that the table holds. Null removes it.
    void set(glm::ivec3 brick, const ShadowBrickRef& content);
    /// Brings table, pages and blocks up to date. Call it after changes, before rays.
    void update();
    /// Removes the bricks of all blocks that reach beyond this many slots. Call update() afterwards.
    void removeBeyond(uint32_t slots);
    /// How many slots the blocks take: one more than the highest in use.
    uint32_t slots() const { return m_blocks.end(); }
    /// Whether bricks wait to be sent.
    bool hasPlaced() const { return !m_placed.empty(); }
    /// The bricks to send since the last call. Of several for one slot the last one counts.
    std::vector<Placed> takePlaced() { return std::exchange(m_placed, {}); }
    /// Sends what changed of table and pages. Returns the bytes sent.
    uint64_t upload() { return m_table.upload() + m_pages.upload(); }

    /// A texel a sector, x fastest.
    const BufferTexture& table() const { return m_table.texture(); }
    /// 8 texels a page.
    const BufferTexture& pages() const { return m_pages.texture(); }
    /// GPU memory of both.
    uint64_t bytes() const { return table().bytes() + pages().bytes(); }
    /// Low corner of the table's box, in sectors of the world.
    glm::ivec3 low() const { return m_low; }
    /// Its size, in sectors. Those of x and y are powers of two, so that a sector's texel is found without a product.
    glm::ivec3 size() const { return m_size; }
    /// The binary logarithm of its size, of z that of the next power of two.
    glm::ivec3 bits() const;
    /// The box of all occupied words.
    const OccupiedBox& occupied() const { return m_occupied; }
    /// How many texels of table and pages were written since it was made: work that tests count.
    uint64_t writtenTexels() const { return m_writtenTexels; }

private:
    static constexpr uint32_t kPageTexels = 8, kNone = ~0u;
    struct Sector {
        glm::ivec3 place{0};
        SectorBricks occupied = 0;
        uint32_t block = 0, blockSlots = 0;       ///< its first slot and their number; 0: it has none
        bool isQueued = false, isPlaced = false;  ///< in m_changedSectors; its block suits `occupied`
        std::array<ShadowBrickRef, 8> bricks;
    };
    size_t tableIndex(glm::ivec3 sector) const { return m_skips.indexOf(sector - m_low); }
    bool holdsSector(glm::ivec3 sector) const;
    uint32_t sectorAt(glm::ivec3 place) const { return holdsSector(place) ? m_sectorOf[tableIndex(place)] : kNone; }
    uint32_t addSector(glm::ivec3 place);
    void queueAround(glm::ivec3 place);
    void removeEmptySectors();
    void place(Sector& sector);
    void writePage(uint32_t index);
    template <class Texel>
    void write(StagedBuffer<Texel>& texels, size_t at, Texel texel);
    glm::uvec4 tableTexel(uint32_t index) const;
    void makeTable(glm::ivec3 low, glm::ivec3 size);
    void shrink();

    glm::ivec3 m_low{0}, m_size{0};    ///< in sectors
    SkipDistances m_skips;             ///< of sectors
    std::vector<uint32_t> m_sectorOf;  ///< for each texel of the table its sector in m_sectors, or kNone
    std::vector<Sector> m_sectors;     ///< those in use and free ones; a sector's page has its number
    IndexAllocator m_freeSectors;
    RangeAllocator m_blocks;  ///< in slots
    StagedBuffer<glm::uvec4> m_table{GL_RGBA32UI, "shadow directory"};
    StagedBuffer<glm::uvec2> m_pages{GL_RG32UI, "shadow directory's pages"};
    std::vector<uint32_t> m_changedSectors;
    std::vector<Placed> m_placed;
    OccupiedBox m_occupied;
    uint64_t m_writtenTexels = 0;
};

}  // namespace rubble
