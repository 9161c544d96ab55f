#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <rubble/rubble.hpp>
#include <vector>

namespace editor {

/// Where an object is, in the world.
struct Place {
    glm::dvec3 position{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
};

/// That of a body or of a light, or of the frame of a joint that hasFrame().
Place placeOf(const rubble::World& world, uint64_t object);
/// Puts it there, as an edit. Returns the handle that it has then: that of a joint is another one.
uint64_t setPlace(rubble::World& world, uint64_t object, const Place& place);

/// How far bodies may sink together until one of them rests on what is below, in metres; where nothing is, on height 0.
/// Negative: they are below that.
double depthBelow(const rubble::World& world, const std::vector<rubble_body>& bodies);

}  // namespace editor
