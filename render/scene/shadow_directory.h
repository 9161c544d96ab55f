#pragma once
#include <compare>
#include <glm/vec4.hpp>
#include <map>
#include <vector>

#include "render/scene/occupied_box.h"
#include "render/scene/page_skips.h"
#include "render/scene/sector_bulk.h"
#include "render/scene/skip_distances.h"
#include "render/scene/staged_buffer.h"
#include "runtime/core/index_allocator.h"
#include "runtime/shadow/shadow_volume.h"

namespace rubble {

/// Finds the shadow volume's bricks for rays. A brick has a texel: how far rays may skip, in bricks, or where the brick
/// is and which of its words are occupied. The texels are in two parts, through which a ray goes one after the other:
///   - the dense part has those of all bricks of a box, the bulk of the level's: a ray finds one by one fetch;
///   - the paged part, for what is elsewhere, has those of occupied sectors (4x4x4 bricks), a page each. A table has a
///     texel for each sector of a box: where its page is, or how far rays may skip, in sectors. Pages come and go with
///     the bricks, and the box follows what is occupied.
/// So memory and work follow the bricks that change. Where the table cannot span all, what is farthest from the middle
/// of most bricks is not in it: rays do not meet it. Which bricks these are follows from all bricks, not from the order
/// in which they came, and they get their place as soon as there is room. Layout: lib/shadow_trace.glsl.
/// [render-thread]
class ShadowDirectory {
public:
    static constexpr int kSectorBricks = 4;  ///< side of a sector
    static constexpr int kWordCells = 4, kSectorCells = kSectorBricks * kShadowBrickCells;
    /// The dense part has at most a sector, 1 KB, for so many bricks that it holds, 0.5 KB each: half of their memory.
    static constexpr int64_t kBricksPerDenseSector = 4;
    static constexpr int64_t kSmallDense = 64;  ///< sectors that it has in any case
    /// What the table can span: 2 x 2 km, 32 m high, or as many sectors in another shape.
    static constexpr int64_t kMaxSectors = int64_t(1) << 19;

    /// A brick that holds something.
    struct Brick {
        uint32_t slot = 0;      ///< of its texels, 64 each
        uint64_t occupied = 0;  ///< which of its words hold cells; 0: there is no such brick
    };

    /// Removes all bricks.
    void clear();
    /// Makes room for all patches with content, as far as the table spans. If most bricks are in the paged part then,
    /// as at first, the dense part is made again for the bulk of them.
    void reach(const std::vector<ShadowPatch>& patches);
    /// Whether there is room for a brick.
    bool holds(glm::ivec3 brick) const;
    /// The brick at a place, also if there is no room for it.
    Brick find(glm::ivec3 brick) const;
    /// Puts a brick at a place; where there is no room it waits for it. occupied == 0 removes it.
    void set(glm::ivec3 brick, const Brick& content);
    /// Brings table and pages up to date. Call it after changes, before rays.
    void update();
    /// Sends what changed. Returns the bytes sent.
    uint64_t upload() { return m_table.upload() + m_texels.upload(); }
    /// Calls f(brick, Brick) for all bricks.
    template <class F>
    void forEach(F&& f) const {
        for (const Page& page : m_pages)
            for (int i = 0; i < 64; ++i)
                if (page.occupied >> i & 1) {
                    const glm::ivec3 brick = page.sector * kSectorBricks + glm::ivec3(i & 3, i >> 2 & 3, i >> 4);
                    f(brick, find(brick));
                }
        for (const auto& [place, content] : m_beyond) f(place.brick(), content);
    }

    /// The paged part's table: a texel a sector, x fastest.
    const BufferTexture& table() const { return m_table.texture(); }
    /// A texel a brick: those of the dense part, x fastest, then 64 a page.
    const BufferTexture& texels() const { return m_texels.texture(); }
    /// GPU memory of both.
    uint64_t bytes() const { return table().bytes() + texels().bytes(); }

    /// Where a part is.
    struct Part {
        glm::ivec3 low{0}, size{0};  ///< its box, in sectors of the world
        OccupiedBox occupied;        ///< all occupied words in it
        int64_t bricks = 0;          ///< that hold something
        /// Low corner of the box of all occupied words, in cells from the low corner. Rays end where they leave it.
        glm::ivec3 occupiedLow() const { return occupied.low() * kWordCells - low * kSectorCells; }
        /// Its high corner, excluded.
        glm::ivec3 occupiedHigh() const { return occupied.high() * kWordCells - low * kSectorCells; }
        /// Whether its box holds a sector.
        bool holds(glm::ivec3 sector) const;
        size_t indexOf(glm::ivec3 sector) const;  ///< x fastest
    };
    /// The box whose bricks all have a texel.
    const Part& dense() const { return m_dense; }
    /// The table's box.
    const Part& paged() const { return m_paged; }
    /// How many bricks have no room. Rays do not meet them.
    int64_t beyond() const { return int64_t(m_beyond.size()); }
    /// The sector in the middle of most bricks, as it was when room was last given again.
    glm::ivec3 middle() const { return m_middle; }
    /// How many texels were written since it was made: work that tests count.
    uint64_t writtenTexels() const { return m_writtenTexels; }

private:
    static constexpr uint32_t kPageTexels = 64, kNone = ~0u;
    /// A sector that has texels.
    struct Page {
        glm::ivec3 sector{0};
        SectorBricks occupied = 0;
        uint8_t stale = 0;  ///< the octants whose skips must be computed: then it is in m_changedPages
    };
    bool isDense(uint32_t page) const { return page < m_densePages; }
    size_t texelOf(uint32_t page, int brick) const;
    uint32_t pageAt(glm::ivec3 sector) const;
    template <class Texel>
    void write(StagedBuffer<Texel>& texels, size_t at, Texel texel);
    /// Where a brick is that has no room. The nearest to the middle is the first.
    struct Place {
        double squaredDistance;  ///< of its sector from m_middle, in sectors
        int z, y, x;
        glm::ivec3 brick() const { return {x, y, z}; }  ///< the brick itself
        auto operator<=>(const Place&) const = default;
    };
    Place placeOf(glm::ivec3 brick) const;
    std::vector<SectorBricksCount> countBricks(const std::vector<ShadowPatch>& patches) const;
    bool reachDensely(const std::vector<ShadowPatch>& patches);
    void makeDense(const SectorBox& sectors);
    void moveMiddle(glm::ivec3 middle);
    void chooseTable(const std::vector<ShadowPatch>& patches);
    void leaveTable(const SectorBox& kept);
    void readmit();
    void makeTable(const SectorBox& box);
    void shrink();
    uint32_t addPage(glm::ivec3 sector);
    void removeEmptyPages();
    void queue(uint32_t page, uint8_t octants);
    void queueAround(glm::ivec3 sector);
    void writeSkips(uint32_t page);

    Part m_dense, m_paged;
    SkipDistances m_skips;           ///< of the paged part's sectors
    std::vector<uint32_t> m_pageOf;  ///< for each sector of the table its page, or kNone
    std::vector<Page> m_pages;       ///< the sectors of the dense part, x fastest; then pages in use and free ones
    uint32_t m_densePages = 0;
    IndexAllocator m_freePages;  ///< of those behind the dense part
    glm::ivec3 m_middle{0};
    std::map<Place, Brick> m_beyond;  ///< bricks that have no room
    int64_t m_scattered = 0;          ///< so many bricks had no bulk; 0: the last ones had
    StagedBuffer<uint32_t> m_table{GL_R32UI, "shadow directory"};
    StagedBuffer<glm::uvec4> m_texels{GL_RGBA32UI, "shadow directory's bricks"};
    std::vector<uint32_t> m_changedPages;
    uint64_t m_writtenTexels = 0;
};

}  // namespace rubble
