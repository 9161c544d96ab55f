#pragma once
#include <optional>

#include "render/frame/frame_context.h"
#include "render/scene/body_tiles.h"
#include "render/scene/detail_maps.h"

namespace rubble {

/// Draws all bodies into albedo, normal, material, motion and depth; lib/gbuffer.glsl says what they hold. One draw
/// whatever the number of bodies: each pixel walks through those of its tile, nearest first, and stops where the next
/// one's box is farther.
class GBufferPass {
public:
    static constexpr int kMaxDraws = 1;
    static constexpr float kSkyDepth = 65000.0f;  ///< as in lib/gbuffer.glsl

    explicit GBufferPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame);
    /// Binds the G-buffer's targets to the samplers of lib/gbuffer.glsl, for a later pass whose program is in use.
    static void bind(const Program& program, const TargetPool& targets);
    /// What the last frame drew, and where.
    const BodyTiles& tiles() const { return m_tiles; }
    uint64_t bytes() const { return m_details ? m_details->texture().bytes() : 0; }
    /// Faces have grain: it is asked for, and there is a material that has some.
    static bool hasDetail(const FrameContext& frame);

private:
    const Program& m_program;
    BodyTiles m_tiles;
    std::optional<DetailMaps> m_details;
};

}  // namespace rubble
