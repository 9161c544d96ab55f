#pragma once
#include <glm/vec4.hpp>
#include <vector>

#include "render/gl/program.h"
#include "runtime/frame/frame_snapshot.h"

namespace rubble {

/// The outlines of all waters as shaders read them (passes/water.frag, outlineCrossings()): the sides in their order,
/// in boxes around runs of sides and groups of runs, so that a ray visits few of many sides. [render-thread]
class WaterOutlines {
public:
    /// Sends the outlines. origin: the point of the world that GPU coordinates are relative to. Returns the bytes sent.
    uint64_t update(const std::vector<Water>& waters, glm::dvec3 origin);
    /// Sets the uniforms for the water with this index. The program must be in use.
    void bind(const Program& program, size_t water) const;
    /// GPU memory.
    uint64_t bytes() const { return m_texture.bytes(); }

private:
    void findCovers(const std::vector<Water>& waters, glm::dvec3 origin);
    std::vector<int> m_ends;                       ///< behind the last texel, by water
    std::vector<std::vector<glm::vec4>> m_covers;  ///< uCovers of passes/water.frag, by water
    std::vector<glm::vec4> m_texels;
    BufferTexture m_texture{GL_RGBA32F};
    bool m_fullLogged = false;
};

}  // namespace rubble
