#pragma once
#include <vector>

#include "render/frame/frame_context.h"

namespace rubble {

/// Draws all ropes into the G-buffer in one call, after the bodies: strips that face the camera and are shaded as
/// round.
class RopesPass {
public:
    /// Builds its program. If that fails, shaders.errors() says why and draw() does nothing.
    explicit RopesPass(ShaderLibrary& shaders);
    /// Adds to the G-buffer. alpha: 0 to 1 between the last two steps.
    void draw(const FrameContext& frame, float alpha);

private:
    /// A straight segment of a rope, as the vertex shader reads it.
    struct Instance {
        glm::vec4 from, to;          ///< xyz from the render origin, w metres along the rope
        glm::vec4 lastFrom, lastTo;  ///< where they were in the last frame; w of the first: radius
        glm::vec4 color;             ///< rgb sRGB
    };
    void fillInstances(const FrameContext& frame, float alpha);

    const Program& m_program;
    GlName<BufferKind> m_buffer = GlName<BufferKind>::make();
    VertexArray m_vertexArray = VertexArray::make();
    std::vector<Instance> m_instances;
    std::vector<glm::dvec3> m_places, m_lastPlaces;  ///< ends of all segments, world
};

}  // namespace rubble
