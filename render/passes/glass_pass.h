#pragma once
#include "render/frame/frame_context.h"
#include "render/scene/body_tiles.h"

namespace rubble {

/// Draws the panes before the G-buffer's surfaces into glassTint and glassSurface (lib/gbuffer.glsl says what they
/// hold), and later over the picture of what is behind them. Only for scenes with glass.
class GlassPass {
public:
    explicit GlassPass(ShaderLibrary& shaders);
    /// tiles: of this frame's G-buffer.
    void draw(const FrameContext& frame, const BodyTiles& tiles) const;
    /// Panes over the picture "radiance".
    void drawOver(const FrameContext& frame, const BodyTiles& tiles) const;

private:
    /// Marks the pixels that the G-buffer saw through glass.
    void drawMask(const FrameContext& frame, const BodyTiles& tiles) const;

    const Program& m_mask;
    const Program& m_program;
    const Program& m_over;
};

}  // namespace rubble
