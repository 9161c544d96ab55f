#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "runtime/script/binding/calls.h"
#include "samples/sandbox/shell/fields.h"
#include "samples/sandbox/shell/functions.h"

namespace sandbox {
namespace {

using namespace rubble::script;

constexpr std::pair<const char*, uint32_t> kKinds[] = {
    {"ball", RUBBLE_JOINT_BALL}, {"hinge", RUBBLE_JOINT_HINGE}, {"prismatic", RUBBLE_JOINT_PRISMATIC},
    {"cone", RUBBLE_JOINT_CONE}, {"fixed", RUBBLE_JOINT_FIXED}, {"wheel", RUBBLE_JOINT_WHEEL}};

struct JointField {
    const char* name;
    double rubble_joint_settings::*value;
};
constexpr JointField kFields[] = {
    {"reach", &rubble_joint_settings::anchor_radius},
    {"min", &rubble_joint_settings::lower_limit},
    {"max", &rubble_joint_settings::upper_limit},
    {"hertz", &rubble_joint_settings::spring_hertz},
    {"damping", &rubble_joint_settings::spring_damping_ratio},
    {"friction", &rubble_joint_settings::friction},
    {"breakForce", &rubble_joint_settings::break_force},
    {"breakTorque", &rubble_joint_settings::break_torque},
    {"drive", &rubble_joint_settings::drive_torque},
    {"brake", &rubble_joint_settings::brake_torque},
    {"maxSpin", &rubble_joint_settings::max_spin},
    {"steer", &rubble_joint_settings::max_steer_angle},
    {"steerRate", &rubble_joint_settings::steer_rate},
};

/// A number of a table; what is left out is `otherwise`.
double fieldOr(lua_State* L, int table, const char* name, double otherwise) {
    if (!lua_istable(L, table)) return otherwise;
    lua_getfield(L, table, name);
    const double value = numberOr(L, lua_gettop(L), name, otherwise);
    lua_pop(L, 1);
    return value;
}

bool isTrue(lua_State* L, int table, const char* name) {
    if (!lua_istable(L, table)) return false;
    lua_getfield(L, table, name);
    const bool value = lua_toboolean(L, -1);
    lua_pop(L, 1);
    return value;
}

int createJoint(lua_State* L) {
    auto joint = sized<rubble_joint_settings>();
    const std::string name = textAt(L, 1, "kind");
    const auto kind =
        std::find_if(std::begin(kKinds), std::end(kKinds), [&](const auto& row) { return name == row.first; });
    if (kind == std::end(kKinds)) refuseArgument(L, 1, "kind", "ball, hinge, prismatic, cone, fixed or wheel");
    joint.kind = kind->second;
    joint.shapes[0] = handleAt(L, 2, "shapeA");
    joint.shapes[1] = handleAt(L, 3, "shapeB");
    const Placement place = placementAt(L, 4, "transform");
    copy(joint.position, place.position);
    copy(joint.rotation, place.rotation);
    std::vector<const char*> keys = {"collides"};
    for (const JointField& field : kFields) keys.push_back(field.name);
    if (!lua_isnoneornil(L, 5)) requireKeys(L, 5, "options", keys);
    for (const JointField& field : kFields) joint.*field.value = fieldOr(L, 5, field.name, 0.0);
    if (joint.lower_limit < joint.upper_limit) joint.flags |= RUBBLE_JOINT_LIMITED;
    if (isTrue(L, 5, "collides")) joint.flags |= RUBBLE_JOINT_COLLIDES;
    return pushJoint(L, joint);
}

int driveWheels(lua_State* L) {
    auto drive = sized<rubble_drive>();
    drive.body = handleAt(L, 1, "body");
    drive.throttle = clampedAt(L, 2, "throttle", -1.0, 1.0);
    drive.steer = clampedAt(L, 3, "steer", -1.0, 1.0);
    drive.brake = clampedAt(L, 4, "brake", 0.0, 1.0);
    isDone(L, apiOf(L).drive_wheels(worldOf(L), &drive));
    return 0;
}

int createLight(lua_State* L) {
    static constexpr const char* kKeys[] = {"angle", "reach", "radius", "off"};
    if (!lua_isnoneornil(L, 4)) requireKeys(L, 4, "options", kKeys);
    auto light = sized<rubble_light_settings>();
    light.shape = handleAt(L, 1, "shape");
    const Placement place = placementAt(L, 2, "transform");
    copy(light.position, place.position);
    copy(light.rotation, place.rotation);
    copy(light.color, vectorAt(L, 3, "color"));
    light.kind = fieldOr(L, 4, "angle", 0.0) > 0.0 ? RUBBLE_LIGHT_CONE : RUBBLE_LIGHT_SPHERE;
    light.cone_outer = fieldOr(L, 4, "angle", 0.0);
    light.cone_inner = 0.6 * light.cone_outer;
    light.radius = fieldOr(L, 4, "radius", 0.05);
    light.reach = fieldOr(L, 4, "reach", 20.0);
    if (!isTrue(L, 4, "off")) light.flags = RUBBLE_LIGHT_ENABLED;
    rubble_light made = 0;
    isDone(L, apiOf(L).create_light(worldOf(L), &light, &made));
    if (made) ScriptContext::of(L).shared.pending.created[made] = RUBBLE_KIND_LIGHT;
    pushHandle(L, made);
    return 1;
}

int createWater(lua_State* L) {
    requireTable(L, 1, "outline");
    std::vector<double> outline;
    const int count = int(std::min<lua_Unsigned>(lua_rawlen(L, 1), 1000));
    for (int i = 1; i <= count; ++i) {
        lua_geti(L, 1, i);
        const Vector corner = vectorAt(L, lua_gettop(L), "outline");
        outline.insert(outline.end(), {corner[0], corner[2]});
        lua_pop(L, 1);
    }
    auto water = sized<rubble_water_settings>();
    water.outline = outline.data(), water.outline_count = uint32_t(outline.size() / 2);
    water.surface_height = numberAt(L, 2, "surface");
    water.depth = numberAt(L, 3, "depth");
    isDone(L, apiOf(L).add_water(worldOf(L), &water));
    return 0;
}

int setCollisionShape(lua_State* L) {
    constexpr const char* kNames[] = {"voxels", "sphere", "cylinder x", "cylinder y", "cylinder z"};
    auto collision = sized<rubble_collision_shape>();
    collision.shape = handleAt(L, 1, "shape");
    const std::string name = textAt(L, 2, "kind");
    const auto found = std::find(std::begin(kNames), std::end(kNames), name);
    if (found == std::end(kNames)) refuseArgument(L, 2, "kind", "voxels, sphere, cylinder x, cylinder y or cylinder z");
    collision.kind = uint32_t(found - std::begin(kNames));
    isDone(L, apiOf(L).set_collision_shape(worldOf(L), &collision));
    return 0;
}

int getStateHash(lua_State* L) {
    uint64_t hash = 0;
    isDone(L, apiOf(L).get_state_hash(worldOf(L), &hash));
    pushHandle(L, hash);
    return 1;
}

int getStepTime(lua_State* L) {
    auto stats = sized<rubble_step_stats>();
    isDone(L, apiOf(L).get_step_stats(worldOf(L), &stats));
    lua_pushnumber(L, stats.edits_ms + stats.physics_ms + stats.poses_ms + stats.impacts_ms);
    return 1;
}

constexpr ScriptFunction kFunctions[] = {
    {"CreateJoint(kind, shapeA, shapeB, transform, options) -> joint",
     "A joint; its axis is the x axis of the transform. Options: min, max, hertz, damping, friction, breakForce, "
     "breakTorque, reach, collides; of a wheel drive, brake, maxSpin, steer, steerRate.",
     createJoint, 0,
     "anchor_radius reach, brake_torque brake, drive_torque drive, lower_limit min, max_steer_angle steer, position "
     "transform, rotation transform, spring_damping_ratio damping, spring_hertz hertz, upper_limit max"},
    {"DriveWheels(body, throttle, steer, brake)", "Drives the wheels of a chassis: -1 to 1, -1 (right) to 1, 0 to 1.",
     driveWheels},
    {"CreateLight(shape, transform, color, options) -> light",
     "A light on a shape, in its space; color in W/sr. Options: angle (half of a cone's, radians), reach, radius, off.",
     createLight, 0, "cone_inner angle, cone_outer angle"},
    {"CreateWater(outline, surface, depth)", "Water within corners {x, y, z}.", createWater, 0,
     "surface_height surface"},
    {"SetCollisionShape(shape, kind)", "\"voxels\", \"sphere\", \"cylinder x\", \"cylinder y\" or \"cylinder z\".",
     setCollisionShape},
    {"GetStateHash() -> number", "A hash of the world: equal worlds have equal hashes.", getStateHash},
    {"GetStepTime() -> ms", "What the last step took.", getStepTime},
};

}  // namespace

std::span<const ScriptFunction> vehicleFunctions() {
    return kFunctions;
}

}  // namespace sandbox
