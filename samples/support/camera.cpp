#include "samples/support/camera.h"

#include <algorithm>

#include "render/renderer.h"

namespace rubble {

constexpr double kMaxPitch = 1.5;  // radians

void Camera::turn(const PlayerInput& input) {
    yaw -= input.turnRight;
    pitch = std::clamp(pitch + input.turnUp, -kMaxPitch, kMaxPitch);
}

glm::dvec3 Camera::flight(const PlayerInput& input) const {
    return rotation() * glm::dvec3(input.right, 0, -input.forward) + glm::dvec3(0.0, input.up, 0.0);
}

View Camera::view(glm::ivec2 size, unsigned framebuffer) const {
    View view;
    view.position = position;
    view.rotation = rotation();
    view.verticalFov = verticalFov;
    view.size = size;
    view.framebuffer = framebuffer;
    return view;
}

}  // namespace rubble
