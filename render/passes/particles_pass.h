#pragma once
#include <vector>

#include "render/frame/frame_context.h"

namespace rubble {

/// Draws what hangs and flies in the air over the radiance: crumbs and splinters, then all that is soft or glows, each
/// farthest first. In the alpha of `radiance` it leaves the share of what is behind that still shows, so that the
/// temporal pass trusts its past less there. Made when the first particle is drawn.
class ParticlesPass {
public:
    explicit ParticlesPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame, float alpha);

private:
    /// One instance as the vertex shader reads it.
    struct Instance {
        glm::vec4 place;   ///< xyz from the render origin, w radius
        glm::vec4 color;   ///< rgb linear, a opacity
        glm::vec4 motion;  ///< xyz velocity, w kind
        glm::vec4 state;   ///< x age, yzw numbers of its own in [0, 1)
    };
    void sortInstances(const FrameContext& frame, float alpha);
    void setLights(const FrameContext& frame, const Program& program) const;
    void drawRange(const FrameContext& frame, const Program& program, size_t first, size_t last) const;

    const Program &m_solids, &m_soft;
    Texture m_noise;
    GlName<BufferKind> m_buffer = GlName<BufferKind>::make();
    VertexArray m_vertexArray = VertexArray::make();
    std::vector<std::pair<float, int>> m_solidOrder, m_softOrder;  ///< -depth and number
    std::vector<Instance> m_instances;
};

}  // namespace rubble
