#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "render/frame/shader_constants.h"
#include "render/gl/program.h"

namespace rubble {

/// The shapes that are drawn elsewhere than the shadow volume has them, as it holds the newest step and they are drawn
/// between two: rays that start beside them are moved along (lib/moving_bodies.glsl). [render-thread]
class MovingBodies {
public:
    static constexpr size_t kMaxBodies = shared::kMaxMovingBodies;

    /// A box in its own axes, from the render origin.
    struct Box {
        glm::vec3 center{0.0f}, halfSize{0.0f};
        glm::quat rotation{1, 0, 0, 0};
    };

    /// No body moves.
    void clear() { m_bodies.clear(); }
    /// A shape whose box is drawn at one place and is at another one in the shadow volume. The kMaxBodies that matter
    /// most are kept.
    void add(const Box& drawn, const Box& inShadows);
    /// Sets the uniforms of lib/moving_bodies.glsl. The program must be in use.
    void bind(const Program& program) const;

private:
    struct Body {
        glm::vec4 texels[shared::kVectorsPerMovingBody];
        float weight;  ///< by how much it moves, times its size
    };
    std::vector<Body> m_bodies;
};

}  // namespace rubble
