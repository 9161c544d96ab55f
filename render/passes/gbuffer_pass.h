#pragma once
#include <vector>

#include "render/frame_context.h"

namespace rubble {

/// Draws all bodies, nearest first, into albedo, normal, material, motion and depth; lib/gbuffer.glsl says what they hold.
/// At most kMaxDraws draws whatever the number of bodies; between two of them the linear depth is copied, so that a box
/// behind what is drawn costs one comparison a pixel.
class GBufferPass {
public:
    static constexpr int kMaxDraws = 15;  ///< and one for glass: 16

    explicit GBufferPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame);
    /// Binds the G-buffer's targets to the samplers of lib/gbuffer.glsl, for a later pass whose program is in use.
    static void bind(const Program& program, const TargetPool& targets);
    /// Bodies of the last frame that the camera can see, nearest first: a vertex array with one instance number each.
    const std::vector<int>& order() const { return m_order; }

private:
    void sortBodies(const FrameContext& frame);
    void drawBatch(const FrameContext& frame, int first, int count) const;

    const Program& m_program;
    GlName<BufferKind> m_orderBuffer = GlName<BufferKind>::make();
    VertexArray m_vertexArray = VertexArray::make();
    std::vector<int> m_order;
    std::vector<std::pair<float, int>> m_sorted;
};

}  // namespace rubble
