#pragma once
#include <algorithm>
#include <memory>
#include <unordered_map>
#include <vector>

#include "render/gl/texture.h"
#include "render/scene/paint_atlas.h"
#include "runtime/core/index_allocator.h"
#include "runtime/voxel/brick.h"

namespace rubble {

/// The bricks of all shapes on the GPU, each once however many shapes share it: occupancy as eight words of 4x4x4
/// cells, and a palette index per voxel. Paint is kept apart, because few bricks have any. Layouts: lib/bodies.glsl.
class BrickAtlas {
public:
    /// The slot of a brick, which the next upload() sends if it is new. Each call needs a release().
    uint32_t acquire(const BrickRef& brick);
    /// Ends one acquire().
    void release(const Brick* brick);
    /// Which of a brick's eight words hold anything: bit x + 2 y + 4 z.
    static uint32_t occupiedWords(const Brick& brick);

    /// Whether a brick has a slot.
    bool has(const Brick* brick) const { return m_entries.count(brick) > 0; }
    /// Sends new bricks in the order acquired, at most budgetBytes of them, and all new paint. Returns the bytes
    /// sent.
    uint64_t upload(uint64_t budgetBytes = ~uint64_t(0));
    static constexpr uint64_t kBrickBytes = 64 + kBrickVoxels;  ///< occupancy and indices
    /// Number of bricks that were ever new.
    uint64_t queued() const { return m_queued; }
    /// How many of those have been sent, or were released before.
    uint64_t sent() const { return m_queued - m_pending.size(); }
    /// How many slots the GL has room for, once it had not enough; what is beyond is not sent.
    uint32_t room() const {
        return m_full ? uint32_t(std::min(m_words.bytes() / kWordBytes, m_indices.bytes() / kIndexBytes)) : ~0u;
    }
    /// Number of bricks held.
    int bricks() const { return int(m_slots.used()); }
    /// GPU memory.
    uint64_t bytes() const { return m_words.bytes() + m_indices.bytes() + (m_paint ? m_paint->bytes() : 0); }
    /// The paint layer; null until a brick with paint has come.
    PaintAtlas* paint() { return m_paint.get(); }
    /// The same.
    const PaintAtlas* paint() const { return m_paint.get(); }
    /// The paint layer, which is made if there is none.
    PaintAtlas& ensurePaint();
    /// Occupancy, 8 texels per slot.
    const BufferTexture& words() const { return m_words; }
    /// Palette indices, 128 texels per slot.
    const BufferTexture& indices() const { return m_indices; }

private:
    static constexpr uint64_t kWordBytes = 64, kIndexBytes = kBrickVoxels;  ///< of a brick
    uint64_t uploadBricks(uint64_t budgetBytes);
    void send(const std::vector<uint32_t>& slots);
    struct Entry {
        BrickRef brick;  ///< kept alive, so that its address stays unique
        uint32_t slot;
        uint32_t references;
    };
    std::unordered_map<const Brick*, Entry> m_entries;
    std::vector<const Brick*> m_bySlot;
    std::vector<uint32_t> m_pending;  ///< slots to upload, in the order acquired
    uint64_t m_queued = 0;
    IndexAllocator m_slots;
    BufferTexture m_words{GL_RG32UI};   ///< 8 texels a brick
    BufferTexture m_indices{GL_R32UI};  ///< 128 texels a brick
    std::unique_ptr<PaintAtlas> m_paint;
    bool m_full = false;
};

}  // namespace rubble
