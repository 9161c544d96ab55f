#pragma once
#include <vector>

#include "render/frame/frame_context.h"

namespace rubble {

/// Draws particles over the radiance: solid ones first, then soft and glowing ones, each sorted back to front. In the
/// alpha of Radiance it leaves the share of the background that still shows, so that temporal anti-aliasing trusts its
/// history less there.
class ParticlesPass {
public:
    /// Builds its programs and the noise texture. If a program fails, shaders.errors() says why and it is not drawn.
    explicit ParticlesPass(ShaderLibrary& shaders);
    /// Blends over Radiance. alpha: 0 to 1 between the last two steps.
    void draw(const FrameContext& frame, float alpha);

private:
    /// One instance as the vertex shader reads it.
    struct Instance {
        glm::vec4 place;   ///< xyz from the render origin, w radius
        glm::vec4 color;   ///< rgb linear, a opacity
        glm::vec4 motion;  ///< xyz velocity, w kind
        glm::vec4 state;   ///< x age as a share of its life, yzw random numbers of its own in [0, 1)
        glm::vec4 image;   ///< x radians by which it has turned, y seconds of motion by which it is longer
    };
    void sortInstances(const FrameContext& frame, float alpha);
    void setLights(const FrameContext& frame, const Program& program) const;
    void drawRange(const FrameContext& frame, const Program& program, size_t first, size_t last) const;

    const Program &m_solids, &m_soft;
    Texture m_noise;
    GlName<BufferKind> m_buffer = GlName<BufferKind>::make();
    VertexArray m_vertexArray = VertexArray::make();
    std::vector<std::pair<float, int>> m_solidOrder, m_softOrder;  ///< -depth, index
    std::vector<Instance> m_instances;                             ///< solid ones first
};

}  // namespace rubble
