#pragma once
#include <optional>
#include <span>
#include <vector>

#include "render/gl/program.h"
#include "runtime/frame/frame_snapshot.h"

namespace rubble {

/// What dust and smoke take from the sun: a small map as the sun sees it, with how much gas lies along each of its rays
/// and how far along. From there come the shadow on the ground and the dark side of a cloud. Made with the first gas.
/// [render-thread]
class SmokeShadow {
public:
    /// Draws the map anew. `origin`: world position that the GPU's coordinates are relative to.
    void update(std::span<const SnapshotParticle> particles, glm::vec3 sunDirection, glm::dvec3 origin);
    /// Sets the uniforms of lib/smoke_shadow.glsl. The program must be in use.
    void bind(const Program& program) const;
    uint64_t bytes() const { return m_map ? m_map->bytes() : 0; }

private:
    struct Puff {
        glm::vec3 place;  ///< right, up, toward the sun; metres
        float radius, thickness;
    };
    void listPuffs(std::span<const SnapshotParticle> particles, glm::dvec3 origin);
    void fitMap();
    void splat(const Puff& puff);

    std::optional<Texture> m_map;
    std::vector<Puff> m_puffs;  ///< none: the sun is clear
    std::vector<glm::vec4> m_texels;
    glm::vec3 m_right{1, 0, 0}, m_up{0, 1, 0}, m_sun{0, 0, 1};
    glm::vec2 m_corner{0.0f};  ///< of the map, along right and up
    float m_cell = 1.0f;       ///< metres a texel
};

}  // namespace rubble
