#pragma once
#include "render/frame/frame_context.h"
#include "render/scene/body_tiles.h"

namespace rubble {

/// Panes of glass: finds those in front of the G-buffer's surfaces, and later draws them over the radiance of what is
/// behind them. Only for scenes with glass. lib/gbuffer.glsl says what its targets hold.
class GlassPass {
public:
    /// Builds its programs. If one fails, shaders.errors() says why and it is not drawn.
    explicit GlassPass(ShaderLibrary& shaders);
    /// Fills GlassTint, GlassSurface and GlassDepth. tiles: of this frame's G-buffer.
    void draw(const FrameContext& frame, const BodyTiles& tiles) const;
    /// Fills PaneLight, which the water pass goes on with. False: there are no panes in view, and nothing is drawn.
    bool drawLight(const FrameContext& frame, const BodyTiles& tiles) const;
    /// Blends the panes over Radiance: refraction, tint and reflections. tiles: of this frame's G-buffer. hasLight:
    /// PaneLight holds their light.
    void drawOver(const FrameContext& frame, const BodyTiles& tiles, bool hasLight) const;

private:
    void drawMask(const FrameContext& frame, const BodyTiles& tiles) const;
    template <class SetUniforms>
    void drawPanes(const FrameContext& frame, const BodyTiles& tiles, const Program& program, Target into,
                   SetUniforms&& setUniforms) const;

    const Program& m_mask;
    const Program& m_program;
    const Program& m_light;
    const Program& m_over;
};

}  // namespace rubble
