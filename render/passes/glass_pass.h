#pragma once
#include <vector>

#include "render/frame_context.h"

namespace rubble {

/// Draws the panes before the G-buffer's surfaces into glassTint and glassSurface; lib/gbuffer.glsl says what they hold.
/// Only for scenes with glass.
class GlassPass {
public:
    explicit GlassPass(ShaderLibrary& shaders);
    /// order: the bodies in view, nearest first (GBufferPass::order).
    void draw(const FrameContext& frame, const std::vector<int>& order);

private:
    const Program& m_program;
    GlName<BufferKind> m_orderBuffer = GlName<BufferKind>::make();
    VertexArray m_vertexArray = VertexArray::make();
    std::vector<int> m_farthestFirst;
};

}  // namespace rubble
