#pragma once
#include <vector>

#include "render/gl/program.h"
#include "render/scene/shadow_directory.h"
#include "runtime/core/index_allocator.h"
#include "runtime/shadow/shadow_volume.h"

namespace rubble {

/// The world's shadow volume on the GPU: a directory of its bricks (16^3 cells), and the texels of each brick that
/// holds something. Sends only what a patch changed. Layouts: lib/shadow_trace.glsl. [render-thread]
class GpuShadowVolume {
public:
    /// Applies the bricks of a publication. replacesAll: removes all bricks before.
    void apply(const std::vector<ShadowPatch>& patches, bool replacesAll);
    /// Sends what changed. Returns the bytes sent.
    uint64_t upload();
    /// Sets the samplers of lib/shadow_trace.glsl. The program must be in use.
    void bind(const Program& program) const;

    /// Where bricks are found.
    const ShadowDirectory& directory() const { return m_directory; }
    /// GPU memory.
    uint64_t bytes() const { return m_directory.bytes() + m_texels.bytes(); }

private:
    void put(const ShadowPatch& patch);
    void remove(glm::ivec3 brick);
    void logSpan() const;
    void reserveTexels();
    uint64_t uploadTexels();

    ShadowDirectory m_directory;
    BufferTexture m_texels{GL_RG32UI};
    IndexAllocator m_slots;
    uint32_t m_maxSlots = ~0u;  ///< as many have room in m_texels; known once they have not
    struct Waiting {
        uint32_t slot;
        ShadowBrickRef content;
    };
    std::vector<Waiting> m_waiting;  ///< texels to upload; they are not kept afterwards
    bool m_isSpanLogged = false, m_isMemoryLogged = false;
};

}  // namespace rubble
