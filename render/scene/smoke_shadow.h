#pragma once
#include <span>
#include <vector>

#include "render/gl/program.h"
#include "runtime/frame/frame_snapshot.h"

namespace rubble {

/// Sunlight through dust and smoke: a small map along the sun's rays of the first three moments of depth (optical
/// depth, and its mean and mean square distance along the ray). From these the shader estimates how much gas lies
/// between a point and the sun: the shadow on the ground and the dark side of a cloud. Made with the first gas.
/// [render-thread]
class SmokeShadow {
public:
    /// Rebuilds the map. origin: the point of the world that GPU coordinates are relative to.
    void update(std::span<const SnapshotParticle> particles, glm::vec3 sunDirection, glm::dvec3 origin);
    /// Sets the uniforms of lib/smoke_shadow.glsl. The program must be in use.
    void bind(const Program& program) const;
    /// GPU memory.
    uint64_t bytes() const { return m_map.bytes(); }

private:
    struct Puff {
        glm::vec3 position;  ///< right, up, toward the sun; metres
        float radius, thickness;
    };
    void listPuffs(std::span<const SnapshotParticle> particles, glm::dvec3 origin);
    void fitMap();
    void splat(const Puff& puff);

    Texture m_map;              ///< from the first gas on
    std::vector<Puff> m_puffs;  ///< empty: the sun is clear
    std::vector<glm::vec4> m_texels;
    glm::vec3 m_right{1, 0, 0}, m_up{0, 1, 0}, m_sun{0, 0, 1};
    glm::vec2 m_corner{0.0f};  ///< of the map, along right and up
    float m_cell = 1.0f;       ///< metres per texel
};

}  // namespace rubble
