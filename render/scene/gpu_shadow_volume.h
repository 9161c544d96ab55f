#pragma once
#include <glm/vec4.hpp>
#include <vector>

#include "render/gl/program.h"
#include "render/scene/skip_distances.h"
#include "render/scene/staged_buffer.h"
#include "runtime/core/index_allocator.h"
#include "runtime/shadow/shadow_volume.h"

namespace rubble {

/// The world's shadow volume on the GPU: a dense directory of bricks (16^3 cells) over its extent, 16 bytes per brick,
/// and the texels of each brick that holds something. Sends only what a patch changed. Layouts: lib/shadow_trace.glsl.
/// [render-thread]
class GpuShadowVolume {
public:
    static constexpr int kSectorBricks = 4;  ///< side of a sector; the directory's box is whole sectors
    /// What the directory can span: 2 x 2 km, 32 m high, or as many bricks in another shape. What lies beyond casts no
    /// shadow.
    static constexpr int64_t kMaxBricks = int64_t(1) << 25;

    /// Applies the bricks of a publication. replacesAll: removes all bricks before.
    void apply(const std::vector<ShadowPatch>& patches, bool replacesAll);
    /// Sends what changed. Returns the bytes sent.
    uint64_t upload();
    /// Sets the samplers of lib/shadow_trace.glsl. The program must be in use.
    void bind(const Program& program) const;

    /// Low corner of the directory's box, in sectors of the world.
    glm::ivec3 sectorLow() const { return m_low; }
    /// Size of the directory's box, in sectors.
    glm::ivec3 sectorCount() const { return m_count; }
    /// Low corner of a box around all cells that are or have been occupied, in cells from the directory's low corner.
    /// Rays end where they leave it.
    glm::ivec3 occupiedLow() const { return m_occupiedLow * kWordCells - m_low * kSectorBricks * kShadowBrickCells; }
    /// Its high corner, excluded.
    glm::ivec3 occupiedHigh() const { return m_occupiedHigh * kWordCells - m_low * kSectorBricks * kShadowBrickCells; }
    /// GPU memory.
    uint64_t bytes() const { return m_directory.texture().bytes() + m_texels.bytes(); }

private:
    static constexpr int kWordCells = 4, kBrickWords = kShadowBrickCells / kWordCells;
    using Entry = glm::uvec4;
    static bool isEmpty(const Entry& entry) { return (entry.x & 15) != 0; }
    void growTo(const std::vector<ShadowPatch>& patches);
    void put(const ShadowPatch& patch);
    void growOccupied(const ShadowPatch& patch);
    void updateSkips();
    uint64_t uploadTexels();
    bool holds(glm::ivec3 brick) const;
    glm::ivec3 bricks() const { return m_count * kSectorBricks; }

    glm::ivec3 m_low{0}, m_count{0};                 ///< in sectors
    glm::ivec3 m_occupiedLow{0}, m_occupiedHigh{0};  ///< in words of the world
    SkipDistances m_skips;
    StagedBuffer<Entry> m_directory{GL_RGBA32UI, "shadow directory"};
    BufferTexture m_texels{GL_RG32UI};
    IndexAllocator m_slots;
    struct Waiting {
        uint32_t slot;
        ShadowBrickRef content;
    };
    std::vector<Waiting> m_waiting;  ///< texels to upload; they are not kept afterwards
    bool m_fullLogged = false;
};

}  // namespace rubble
