#pragma once
#include <memory>
#include <unordered_map>
#include <vector>

#include "render/gl/program.h"
#include "render/scene/mirrored_buffer.h"
#include "render/scene/slots.h"
#include "runtime/shadow/shadow_volume.h"

namespace rubble {

/// The world's shadow volume on the GPU: a dense directory of sectors (64^3 cells) over its extent, and for each sector that
/// holds something a table of 4x4x4 bricks. Sends only what a patch changed. Layouts: lib/shadow_trace.glsl.
class ShadowMirror {
public:
    static constexpr int kSectorBricks = 4;

    void apply(const std::vector<ShadowPatch>& patches, bool replacesAll);
    /// Returns the bytes sent.
    uint64_t upload();
    /// Sets the samplers of lib/shadow_trace.glsl. The program must be in use.
    void bind(const Program& program) const;

    /// The directory's box, in sectors of the world.
    glm::ivec3 sectorLow() const { return m_low; }
    glm::ivec3 sectorCount() const { return m_count; }
    uint64_t bytes() const { return m_sectors.texture().bytes() + m_tables.texture().bytes() + m_bricks.texture().bytes(); }

private:
    struct Sector {
        uint32_t mask[2] = {0, 0};  ///< which of its bricks hold something
        uint32_t table = ~0u;
        uint32_t unused = 0;
    };
    struct Child {
        uint32_t slot = ~0u;  ///< in m_bricks
        uint32_t unused = 0;
        uint32_t mask[2] = {0, 0};  ///< which of its words hold something
    };
    struct Table {
        Child children[64];
    };
    void put(const ShadowPatch& patch);
    void growTo(glm::ivec3 sector);
    size_t indexOf(glm::ivec3 sector) const;

    glm::ivec3 m_low{0}, m_count{0};
    MirroredBuffer<Sector> m_sectors{GL_RGBA32UI, "shadow sectors"};
    MirroredBuffer<Table> m_tables{GL_RGBA32UI, "shadow tables"};
    MirroredBuffer<ShadowBrick> m_bricks{GL_RG32UI, "shadow bricks"};
    Slots m_tableSlots, m_brickSlots;
};

}  // namespace rubble
