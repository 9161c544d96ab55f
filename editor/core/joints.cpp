#include "editor/core/joints.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <string>
#include <vector>

#include "editor/core/rotation.h"

namespace editor {

bool hasFrame(const rubble::World& world, rubble_joint joint) {
    const uint32_t kind = world.get_joint_state(joint).kind;
    return kind != RUBBLE_JOINT_ROPE && kind != RUBBLE_JOINT_WHEEL;
}

rubble_joint_settings settingsOf(const rubble::World& world, rubble_joint joint) {
    const rubble_joint_state state = world.get_joint_state(joint);
    const rubble_joint_properties now = world.get_joint_properties(joint);
    rubble_joint_settings settings{};
    settings.kind = now.kind;
    std::copy_n(state.shapes, 2, settings.shapes);
    put(settings.position, vectorOf(state.first_anchor));
    put(settings.rotation, quaternionOf(now.rotation));
    settings.anchor_radius = now.anchor_radius;
    settings.flags = now.flags;
    settings.motor = now.motor;
    settings.motor_target = now.motor_target, settings.motor_max_force = now.motor_max_force;
    settings.lower_limit = now.lower_limit, settings.upper_limit = now.upper_limit;
    settings.spring_hertz = now.spring_hertz, settings.spring_damping_ratio = now.spring_damping_ratio;
    settings.friction = now.friction;
    settings.break_force = now.break_force, settings.break_torque = now.break_torque;
    if (now.kind != RUBBLE_JOINT_HINGE && now.kind != RUBBLE_JOINT_PRISMATIC) return settings;
    const double most = now.kind == RUBBLE_JOINT_HINGE ? glm::pi<double>() : 1e6;
    const auto fromHere = [&](double value) { return std::clamp(value - now.movement, -most, most); };
    if (now.flags & RUBBLE_JOINT_LIMITED)
        settings.lower_limit = fromHere(now.lower_limit), settings.upper_limit = fromHere(now.upper_limit);
    if (now.motor == RUBBLE_MOTOR_POSITION) settings.motor_target = fromHere(now.motor_target);
    return settings;
}

rubble_joint remakeJoint(rubble::World& world, rubble_joint joint, const rubble_joint_settings& settings) {
    const std::vector<char> name = world.get_name(joint), tags = world.get_tags(joint);
    world.remove_joint(joint);
    const rubble_joint made = world.create_joint(settings);
    if (!name.empty() && name.front()) world.set_name(made, name.data());
    for (auto begin = tags.begin(); begin != tags.end();) {
        const auto end = std::find(begin, tags.end(), '\0');
        const std::string tag(begin, end);
        const size_t equals = tag.find('=');
        world.set_tag(made, tag.substr(0, equals).c_str(), equals == tag.npos ? "" : tag.substr(equals + 1).c_str());
        begin = end == tags.end() ? end : end + 1;
    }
    return made;
}

}  // namespace editor
