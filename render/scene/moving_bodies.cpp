#include "render/scene/moving_bodies.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <span>

namespace rubble {
namespace {

constexpr float kMinMove = 0.005f;  ///< metres: less than a tenth of a shadow cell is not seen

/// The axis of a small turn, as long as its angle.
glm::vec3 turnOf(glm::quat q) {
    return glm::vec3(q.x, q.y, q.z) * (q.w < 0.0f ? -2.0f : 2.0f);
}

}  // namespace

void MovingBodies::add(const Box& drawn, const Box& inShadows) {
    const glm::vec3 move = inShadows.center - drawn.center,
                    turn = turnOf(inShadows.rotation * glm::conjugate(drawn.rotation));
    const float radius = glm::length(drawn.halfSize), metres = glm::length(move) + glm::length(turn) * radius;
    if (metres < kMinMove) return;
    Body body{{}, metres * radius};
    // Twice as far as the body moves: places before it keep their order.
    body.texels[0] = glm::vec4(drawn.center, 2.0f * metres);
    const glm::mat3 axes = glm::mat3_cast(drawn.rotation);
    for (int i = 0; i < 3; ++i) body.texels[1 + i] = glm::vec4(axes[i], drawn.halfSize[i]);
    body.texels[4] = glm::vec4(move, 0.0f);
    body.texels[5] = glm::vec4(turn, 0.0f);
    if (m_bodies.size() < kMaxBodies) {
        m_bodies.push_back(body);
        return;
    }
    Body& least = *std::min_element(m_bodies.begin(), m_bodies.end(),
                                    [](const Body& a, const Body& b) { return a.weight < b.weight; });
    if (least.weight < body.weight) least = body;
}

void MovingBodies::bind(const Program& program) const {
    std::vector<glm::vec4> texels;
    for (const Body& body : m_bodies) texels.insert(texels.end(), std::begin(body.texels), std::end(body.texels));
    program.set("uMovingVectors", int(texels.size()));
    if (!texels.empty()) program.set("uMovingBodies[0]", std::span<const glm::vec4>(texels));
}

}  // namespace rubble
