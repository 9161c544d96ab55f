#pragma once
#include <vector>

#include "render/scene/occupied_box.h"
#include "render/scene/page_skips.h"
#include "render/scene/skip_distances.h"
#include "render/scene/staged_buffer.h"
#include "runtime/core/index_allocator.h"
#include "runtime/shadow/shadow_volume.h"

namespace rubble {

/// Finds the shadow volume's bricks for rays. A table has a texel for each sector (4x4x4 bricks) of a box. An empty
/// sector's texel says how far rays may skip, in sectors; an occupied one's where its page is. A page has a texel for
/// each of its bricks: how far rays may skip, in bricks, or where the brick is and which of its words are occupied.
/// Pages come and go with the bricks, and the box follows what is occupied, so memory and work follow the bricks that
/// change. Layout: lib/shadow_trace.glsl. [render-thread]
class ShadowDirectory {
public:
    static constexpr int kSectorBricks = 4;  ///< side of a sector
    /// What the table can span: 2 x 2 km, 32 m high, or as many sectors in another shape.
    static constexpr int64_t kMaxSectors = int64_t(1) << 19;

    /// A brick that holds something.
    struct Brick {
        uint32_t slot = 0;      ///< of its texels, 64 each
        uint64_t occupied = 0;  ///< which of its words hold cells; 0: there is no such brick
    };

    /// Removes all bricks.
    void clear();
    /// Makes the table hold the places of all patches with content, but for those with which it would span too much.
    void reach(const std::vector<ShadowPatch>& patches);
    /// Whether the table holds the brick's sector.
    bool holds(glm::ivec3 brick) const;
    /// The brick at a place that the table holds.
    Brick find(glm::ivec3 brick) const;
    /// Puts a brick at a place that the table holds. occupied == 0 removes it.
    void set(glm::ivec3 brick, const Brick& content);
    /// Brings table and pages up to date. Call it after changes, before rays.
    void update();
    /// Sends what changed. Returns the bytes sent.
    uint64_t upload() { return m_table.upload() + m_pageTexels.upload(); }
    /// Calls f(brick, Brick) for all bricks.
    template <class F>
    void forEach(F&& f) const {
        for (const Page& page : m_pages)
            for (int i = 0; i < 64; ++i)
                if (page.occupied >> i & 1) {
                    const glm::ivec3 brick = page.sector * kSectorBricks + glm::ivec3(i & 3, i >> 2 & 3, i >> 4);
                    f(brick, find(brick));
                }
    }

    /// A texel a sector, x fastest.
    const BufferTexture& table() const { return m_table.texture(); }
    /// 64 texels a page.
    const BufferTexture& pages() const { return m_pageTexels.texture(); }
    /// GPU memory of both.
    uint64_t bytes() const { return table().bytes() + pages().bytes(); }
    /// Low corner of the table's box, in sectors of the world.
    glm::ivec3 low() const { return m_low; }
    /// Its size, in sectors.
    glm::ivec3 size() const { return m_size; }
    /// The box of all occupied words.
    const OccupiedBox& occupied() const { return m_occupied; }
    /// How many texels were written since it was made: work that tests count.
    uint64_t writtenTexels() const { return m_writtenTexels; }

private:
    static constexpr uint32_t kPageTexels = 64, kNone = ~0u;
    struct Page {
        glm::ivec3 sector{0};
        SectorBricks occupied = 0;
        uint8_t stale = 0;  ///< the octants whose skips must be computed: then it is in m_changedPages
    };
    size_t sectorIndex(glm::ivec3 sector) const { return m_skips.indexOf(sector - m_low); }
    bool holdsSector(glm::ivec3 sector) const;
    uint32_t texelOf(glm::ivec3 brick) const;
    uint32_t pageAt(glm::ivec3 sector) const { return holdsSector(sector) ? m_pageOf[sectorIndex(sector)] : kNone; }
    template <class Texel>
    void write(StagedBuffer<Texel>& texels, size_t at, Texel texel);
    void makeTable(glm::ivec3 low, glm::ivec3 size);
    void shrink();
    uint32_t addPage(glm::ivec3 sector);
    void removeEmptyPages();
    void queueAround(glm::ivec3 sector);
    void writeSkips(Page& page);

    glm::ivec3 m_low{0}, m_size{0};  ///< in sectors
    SkipDistances m_skips;           ///< of sectors
    std::vector<uint32_t> m_pageOf;  ///< for each sector of the table its page, or kNone
    std::vector<Page> m_pages;       ///< those in use and free ones; page i has the texels from 64 i on
    IndexAllocator m_freePages;
    StagedBuffer<uint32_t> m_table{GL_R32UI, "shadow directory"};
    StagedBuffer<glm::uvec4> m_pageTexels{GL_RGBA32UI, "shadow directory's pages"};
    std::vector<uint32_t> m_changedPages;
    OccupiedBox m_occupied;
    uint64_t m_writtenTexels = 0;
};

}  // namespace rubble
