#include "samples/sandbox/player.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr double kEyeHeight = 1.7;    // metres above the ground
constexpr double kStepHeight = 0.45;  // what walking climbs
constexpr double kBodyRadius = 0.3;
constexpr double kWalkSpeed = 4.0, kFlySpeed = 8.0, kFastFactor = 3.0;  // m/s
constexpr double kJumpSpeed = 4.5;
constexpr double kSteepest = 1.5;  // radians of pitch

}  // namespace

void Player::place(const Pose& eye) {
    m_camera.position = eye.position;
    m_camera.lookAt(eye.position + eye.rotation * glm::dvec3(0, 0, -1));
    m_fallSpeed = 0.0;
}

void Player::move(const PlayerInput& input, const World& world, double seconds) {
    m_camera.yaw -= input.turnRight;
    m_camera.pitch = std::clamp(m_camera.pitch + input.turnUp, -kSteepest, kSteepest);
    const glm::dquat heading = m_walks ? glm::angleAxis(m_camera.yaw, glm::dvec3(0, 1, 0)) : m_camera.rotation();
    glm::dvec3 step = heading * glm::dvec3(input.right, 0, -input.forward);
    if (!m_walks) step.y += input.up;
    step *= (m_walks ? kWalkSpeed : kFlySpeed) * (input.fast ? kFastFactor : 1.0) * seconds;
    if (m_walks)
        walk(step, input.up > 0.0, world, seconds);
    else
        m_camera.position += step;
}

void Player::walk(glm::dvec3 step, bool jump, const World& world, double seconds) {
    glm::dvec3& eye = m_camera.position;
    const glm::dvec3 knee = eye - glm::dvec3(0, kEyeHeight - kStepHeight, 0);
    const double distance = glm::length(step);
    if (distance > 0.0 && !world.raycast(knee, step, distance + kBodyRadius).hit && !world.raycast(eye, step, distance + kBodyRadius).hit)
        eye += step;
    m_fallSpeed += 9.81 * seconds;
    const WorldHit ground = world.raycast(eye, {0, -1, 0}, kEyeHeight + m_fallSpeed * seconds);
    if (ground.hit) {
        eye.y = ground.position.y + kEyeHeight;
        m_fallSpeed = jump ? -kJumpSpeed : 0.0;
    } else {
        eye.y -= m_fallSpeed * seconds;
    }
}

}  // namespace rubble
