#pragma once
#include <optional>

#include "render/frame/frame_context.h"
#include "render/frame/shader_constants.h"
#include "render/scene/body_tiles.h"
#include "render/scene/detail_maps.h"

namespace rubble {

/// Draws all bodies into the G-buffer; lib/gbuffer.glsl says what its targets hold. One draw for any number of bodies:
/// each pixel walks its ray through the bodies of its tile, nearest first, and stops at a hit that is nearer than the
/// next body's box.
class GBufferPass {
public:
    static constexpr int kMaxDraws = 1;  ///< of bodies, whatever their number
    static constexpr float kSkyDepth = shared::kSkyDepth;

    /// Builds its program. If that fails, shaders.errors() says why and draw() only clears its targets.
    explicit GBufferPass(ShaderLibrary& shaders);
    /// Fills the G-buffer, and GlassMask in scenes with glass.
    void draw(const FrameContext& frame);
    /// Binds the G-buffer to the samplers of lib/gbuffer.glsl, for a later pass whose program is in use.
    static void bind(const Program& program, const TargetPool& targets);
    /// The tiles of the frame that was drawn last.
    const BodyTiles& tiles() const { return m_tiles; }
    /// Forgets what it holds for a scene, before it draws another one.
    void startScene() {
        m_tiles.clear();
        m_details.reset();
    }
    /// GPU memory of the detail maps.
    uint64_t bytes() const { return m_details ? m_details->texture().bytes() : 0; }
    /// Whether faces have detail: the settings want it, and a palette has a material with a detail map.
    static bool hasDetail(const FrameContext& frame);

private:
    const Program& m_program;
    BodyTiles m_tiles;
    std::optional<DetailMaps> m_details;  ///< from the first frame on that needs them
    Texture m_noDetails = DetailMaps::none();
};

}  // namespace rubble
