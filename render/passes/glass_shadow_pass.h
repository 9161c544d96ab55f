#pragma once
#include <vector>

#include "render/frame/frame_context.h"

namespace rubble {

/// What the sun's light becomes in glass: a map as the sun sees it, of the tints of all panes that it reaches, around
/// the camera. Light passes take glass for nothing; composite looks here what colour the sun has where it arrives.
/// Drawn anew when glass has changed or the camera has gone on; made with the first glass in sunlight.
class GlassShadowPass {
public:
    explicit GlassShadowPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame);
    /// Sets the uniforms of lib/glass_shadow.glsl. The program must be in use.
    void bind(const Program& program) const;

private:
    void fitMap(const FrameContext& frame);
    void listBodies(const FrameContext& frame);

    const Program& m_program;
    Texture m_map;
    Framebuffer m_framebuffer;
    GlName<BufferKind> m_orderBuffer = GlName<BufferKind>::make();
    VertexArray m_vertexArray = VertexArray::make();
    std::vector<int> m_bodies;
    glm::vec3 m_right{1, 0, 0}, m_up{0, 1, 0}, m_sun{0, 0, 1}, m_center{0};  ///< of the map, from the render origin
    uint64_t m_drawn = ~0ull;                                                ///< Scene::glassChanges() at that time
};

}  // namespace rubble
