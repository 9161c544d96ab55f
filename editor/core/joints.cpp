#include "editor/core/joints.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <string>
#include <vector>

#include "editor/core/rotation.h"

namespace editor {

bool hasFrame(const rubble::World& world, rubble_joint joint) {
    constexpr double kStraight = 1e-6;
    const rubble_joint_properties now = world.get_joint_properties(joint);
    return now.kind != RUBBLE_JOINT_ROPE && std::abs(now.steer_angle) < kStraight;
}

bool isLimitedInMetres(uint32_t kind) {
    return kind == RUBBLE_JOINT_PRISMATIC || kind == RUBBLE_JOINT_WHEEL;
}

std::optional<glm::dquat> wheelFrame(glm::dvec3 axis, glm::dvec3 up) {
    const glm::dvec3 forward = glm::cross(axis, up);
    if (glm::length(forward) < 1e-6 * glm::length(axis) || glm::length(axis) == 0.0) return std::nullopt;
    const glm::dvec3 x = glm::normalize(axis), z = glm::normalize(forward);
    return glm::quat_cast(glm::dmat3(x, glm::cross(z, x), z));
}

rubble_joint_settings settingsOf(const rubble::World& world, rubble_joint joint) {
    const rubble_joint_state state = world.get_joint_state(joint);
    const rubble_joint_properties now = world.get_joint_properties(joint);
    rubble_joint_settings settings{};
    settings.kind = now.kind;
    std::copy_n(state.shapes, 2, settings.shapes);
    put(settings.position, vectorOf(now.kind == RUBBLE_JOINT_WHEEL ? state.second_anchor : state.first_anchor));
    put(settings.rotation, quaternionOf(now.rotation));
    settings.anchor_radius = now.anchor_radius;
    settings.flags = now.flags;
    settings.motor = now.motor;
    settings.motor_target = now.motor_target, settings.motor_max_force = now.motor_max_force;
    settings.lower_limit = now.lower_limit, settings.upper_limit = now.upper_limit;
    settings.spring_hertz = now.spring_hertz, settings.spring_damping_ratio = now.spring_damping_ratio;
    settings.friction = now.friction;
    settings.break_force = now.break_force, settings.break_torque = now.break_torque;
    settings.drive_torque = now.drive_torque, settings.brake_torque = now.brake_torque;
    settings.max_spin = now.max_spin;
    settings.max_steer_angle = now.max_steer_angle, settings.steer_rate = now.steer_rate;
    const bool isMetres = isLimitedInMetres(now.kind);
    if (now.kind != RUBBLE_JOINT_HINGE && !isMetres) return settings;
    const double most = isMetres ? 1e6 : glm::pi<double>();
    const auto fromHere = [&](double value) { return std::clamp(value - now.movement, -most, most); };
    if (now.flags & RUBBLE_JOINT_LIMITED)
        settings.lower_limit = fromHere(now.lower_limit), settings.upper_limit = fromHere(now.upper_limit);
    if (now.motor == RUBBLE_MOTOR_POSITION && now.kind != RUBBLE_JOINT_WHEEL)
        settings.motor_target = fromHere(now.motor_target);
    return settings;
}

JointCopy copyOf(const rubble::World& world, rubble_joint joint) {
    return {settingsOf(world, joint), world.get_name(joint), world.get_tags(joint)};
}

void nameJoint(rubble::World& world, rubble_joint joint, const JointCopy& copy) {
    if (!copy.name.empty() && copy.name.front()) world.set_name(joint, copy.name.data());
    setTags(world, joint, copy.tags);
}

void setTags(rubble::World& world, uint64_t object, const std::vector<char>& tags) {
    for (auto begin = tags.begin(); begin != tags.end();) {
        const auto end = std::find(begin, tags.end(), '\0');
        const std::string tag(begin, end);
        const size_t equals = tag.find('=');
        world.set_tag(object, tag.substr(0, equals).c_str(), equals == tag.npos ? "" : tag.substr(equals + 1).c_str());
        begin = end == tags.end() ? end : end + 1;
    }
}

rubble_joint remakeJoint(rubble::World& world, rubble_joint joint, const rubble_joint_settings& settings) {
    const JointCopy copy = copyOf(world, joint);
    world.remove_joint(joint);
    const rubble_joint made = world.create_joint(settings);
    nameJoint(world, made, copy);
    return made;
}

}  // namespace editor
