#pragma once
#include <glm/vec4.hpp>
#include <vector>

#include "render/gl/program.h"
#include "render/scene/index_allocator.h"
#include "render/scene/skip_distances.h"
#include "render/scene/staged_buffer.h"
#include "runtime/shadow/shadow_volume.h"

namespace rubble {

/// The world's shadow volume on the GPU: a directory of bricks (16^3 cells) over its extent, dense at 16 bytes a brick,
/// and the texels of each brick that holds something. Sends only what a patch changed. Layouts: lib/shadow_trace.glsl.
class GpuShadowVolume {
public:
    static constexpr int kSectorBricks = 4;  ///< the directory's box is whole sectors
    /// What the directory can span: 2 x 2 km, 32 m high, or the same in another shape. Beyond it nothing casts a
    /// shadow.
    static constexpr int64_t kMaxBricks = int64_t(1) << 25;

    void apply(const std::vector<ShadowPatch>& patches, bool replacesAll);
    /// Returns the bytes sent.
    uint64_t upload();
    /// Sets the samplers of lib/shadow_trace.glsl. The program must be in use.
    void bind(const Program& program) const;

    /// The directory's box, in sectors of the world.
    glm::ivec3 sectorLow() const { return m_low; }
    glm::ivec3 sectorCount() const { return m_count; }
    /// The box that holds all cells that are occupied or have been, in cells from the directory's low corner: rays end
    /// where they leave it.
    glm::ivec3 occupiedLow() const { return m_occupiedLow * kWordCells - m_low * kSectorBricks * kShadowBrickCells; }
    glm::ivec3 occupiedHigh() const { return m_occupiedHigh * kWordCells - m_low * kSectorBricks * kShadowBrickCells; }
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

    glm::ivec3 m_low{0}, m_count{0};                 ///< sectors
    glm::ivec3 m_occupiedLow{0}, m_occupiedHigh{0};  ///< words of the world
    SkipDistances m_skips;
    StagedBuffer<Entry> m_directory{GL_RGBA32UI, "shadow directory"};
    BufferTexture m_texels{GL_RG32UI};
    IndexAllocator m_slots;
    struct Waiting {
        uint32_t slot;
        ShadowBrickRef content;
    };
    std::vector<Waiting> m_waiting;  ///< to be uploaded: no texels are kept here
    bool m_fullLogged = false;
};

}  // namespace rubble
