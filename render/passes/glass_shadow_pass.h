#pragma once
#include <vector>

#include "render/frame/frame_context.h"
#include "render/scene/bodies.h"

namespace rubble {

/// The sun's light through glass: a map along the sun's rays, around the camera, with the product of the tints of all
/// panes that light reaches. Rays treat glass as empty; the composite pass multiplies the sun's light by this map.
/// Drawn again when glass, or something in line with it, has changed or the camera has moved on.
class GlassShadowPass {
public:
    /// Builds its program and makes the map. If that fails, shaders.errors() says why and draw() does nothing.
    explicit GlassShadowPass(ShaderLibrary& shaders);
    /// Draws the map, if it is not up to date.
    void draw(const FrameContext& frame);
    /// Sets the uniforms of lib/glass_shadow.glsl. pass: null if there is no glass in the sun. The program must be in
    /// use.
    static void bind(const Program& program, const GlassShadowPass* pass);

private:
    void clear();
    void fitMap(const FrameContext& frame);
    void listBodies(const FrameContext& frame);
    bool hasChangedAround(const FrameContext& frame) const;
    /// Whether a sphere around a place may cover texels of a body.
    bool overlaps(const Bodies::Instance& body, glm::vec3 place, float radius) const;
    /// For one axis of the map: a coordinate of a position in the map's uv is dot(xyz, position) + w.
    glm::vec4 toMap(glm::vec3 axis) const;

    const Program& m_program;
    Texture m_map;  ///< rgb tint, a depth along the sun's rays of the last pane
    Framebuffer m_framebuffer;
    GlName<BufferKind> m_orderBuffer = GlName<BufferKind>::make();
    VertexArray m_vertexArray = VertexArray::make();
    std::vector<int> m_bodies;  ///< instances with glass that it covers, since it was drawn
    glm::vec3 m_right{1, 0, 0}, m_up{0, 1, 0}, m_sun{0, 0, 1},
        m_center{0};                  ///< the map's frame, from the render origin
    uint64_t m_drawnChanges = ~0ull;  ///< Scene::glassChanges() when it was drawn
};

}  // namespace rubble
