#pragma once
#include <array>
#include <concepts>
#include <span>
#include <type_traits>

#include "runtime/world/level/level.h"

namespace rubble {

// The one list of what a level holds. An archive is called with a name and a value for each field; the baked format,
// the metadata of .vdb files, the hash of a level and its check are archives, so none can forget a field that another
// has. A grid's voxels are no field: archives see its size here and its bricks apart.

template <class T, class Named>
concept Is = std::same_as<std::remove_const_t<T>, Named>;

inline constexpr std::array<const char*, 5> kLightKindNames = {"sphere", "cone", "capsule", "area", "screen"};
inline constexpr std::array<const char*, 5> kHardnessNames = {"soft", "medium", "hard", "unbreakable", "unphysical"};
inline constexpr std::array<const char*, 7> kJointKindNames = {"ball",  "hinge", "prismatic", "cone",
                                                               "fixed", "rope",  "wheel"};
inline constexpr std::array<const char*, 3> kMotorModeNames = {"off", "speed", "position"};
inline std::span<const char* const> enumNames(JointKind) {
    return kJointKindNames;
}
inline std::span<const char* const> enumNames(MotorMode) {
    return kMotorModeNames;
}
inline std::span<const char* const> enumNames(LightKind) {
    return kLightKindNames;
}
inline constexpr std::array<const char*, 3> kTriggerKindNames = {"sphere", "box", "polygon"};
inline std::span<const char* const> enumNames(TriggerKind) {
    return kTriggerKindNames;
}
inline std::span<const char* const> enumNames(Hardness) {
    return kHardnessNames;
}

template <class A>
void fields(A& a, Is<Pose> auto& pose) {
    a("position", pose.position);
    a("rotation", pose.rotation);
}
template <class A>
void fields(A& a, Is<CellBox> auto& box) {
    a("low", box.low);
    a("high", box.high);
}
template <class A>
void fields(A& a, Is<PaletteEntry> auto& entry) {
    a("red", entry.red);
    a("green", entry.green);
    a("blue", entry.blue);
    a("opacity", entry.opacity);
    a("roughness", entry.roughness);
    a("metallic", entry.metallic);
    a("reflectivity", entry.reflectivity);
    a("material", entry.material);
    a("emission", entry.emission);
    a("light_group", entry.lightGroup);
}
template <class A>
void fields(A& a, Is<Material> auto& material) {
    a("name", material.name);
    a("hardness", material.hardness);
    a("density", material.density);
    a("tensile_strength", material.tensileStrength);
    a("compressive_strength", material.compressiveStrength);
    a("shear_strength", material.shearStrength);
    a("friction", material.friction);
    a("restitution", material.restitution);
    a("heat_capacity", material.heatCapacity);
    a("ignition_temperature", material.ignitionTemperature);
    a("burn_time", material.burnTime);
    a("fragments", material.fragments);
    a("sledge", material.sledge);
    a("torch", material.torch);
    a("gun", material.gun);
    a("explosive", material.explosive);
}
template <class A>
void fields(A& a, Is<LevelShape> auto& shape) {
    a("name", shape.name);
    a("local", shape.local);
    a("voxel_size", shape.voxelSize);
    a("size", shape.grid);
    a("palette", shape.palette);
    a("anchors", shape.anchors);
    a("tags", shape.tags);
    a("hidden", shape.hidden);
    a("paint_colors", shape.paintColors);
    a("strength", shape.strength);
    a("bears_load", shape.loadBearing);
    a("collision_layer", shape.collisionLayer);
    a("collision_mask", shape.collisionMask);
}
template <class A>
void fields(A& a, Is<LevelBody> auto& body) {
    a("name", body.name);
    a("pose", body.pose);
    a("static", body.isStatic);
    a("velocity", body.velocity);
    a("angular_velocity", body.angularVelocity);
    a("shapes", body.shapes);
    a("tags", body.tags);
}
template <class A>
void fields(A& a, Is<LightImage> auto& picture) {
    a("width", picture.width);
    a("texels", picture.texels);
}
/// Of a light, with what names its shape and its group: names in a level, handles in a save.
template <class A>
void lightFields(A& a, Is<Light> auto& light, auto& shape, auto& group) {
    a("name", light.name);
    a("kind", light.kind);
    a("shape", shape);
    a("group", group);
    a("local", light.local);
    a("color", light.color);
    a("radius", light.radius);
    a("reach", light.reach);
    a("cone_inner", light.coneInner);
    a("cone_outer", light.coneOuter);
    a("width", light.width);
    a("height", light.height);
    a("two_sided", light.twoSided);
    a("picture", light.image);
    a("enabled", light.enabled);
}
template <class A>
void fields(A& a, Is<LevelLight> auto& light) {
    lightFields(a, light.light, light.shapeName, light.groupName);
}
template <class A>
void fields(A& a, Is<LightGroup> auto& group) {
    a("name", group.name);
    a("threshold", group.threshold);
    a("initial_voxels", group.initialVoxels);
    a("removed_voxels", group.removedVoxels);
    a("out", group.out);
    a("supply_shape", group.supplyShape);
    a("supply_cell", group.supplyCell);
    a("flicker_steps", group.flickerSteps);
    a("dying_since", group.failingSince);
    a("dark", group.dark);
    if constexpr (requires { A::kIsBinary; }) a("supply", group.supply);
}
template <class A>
void fields(A& a, Is<Environment> auto& environment) {
    a("sun_direction", environment.sunDirection);
    a("sun_color", environment.sunColor);
    a("sun_angle", environment.sunAngle);
    a("sky_color", environment.skyColor);
    a("horizon_color", environment.horizonColor);
    a("ground_color", environment.groundColor);
    a("fog_color", environment.fogColor);
    a("fog_distance", environment.fogDistance);
    a("fog_density", environment.fogDensity);
    a("fog_base", environment.fogBase);
    a("fog_height", environment.fogHeight);
    a("fog_forward", environment.fogForward);
    a("fog_tint", environment.fogTint);
    a("clouds", environment.clouds);
    a("stars", environment.stars);
    a("exposure", environment.exposure);
    a("wetness", environment.wetness);
    a("gravity", environment.gravity);
}
template <class A>
void fields(A& a, Is<GroundPoint> auto& point) {
    a("x", point.x);
    a("z", point.z);
}
template <class A>
void fields(A& a, Is<WaterWaves> auto& waves) {
    a("height", waves.height);
    a("length", waves.length);
    a("speed", waves.speed);
    a("direction", waves.direction);
}
template <class A>
void fields(A& a, Is<Water> auto& water) {
    a("name", water.name);
    a("outline", water.outline);
    a("surface", water.surface);
    a("depth", water.depth);
    a("density", water.density);
    a("linear_drag", water.linearDrag);
    a("angular_drag", water.angularDrag);
    a("flow", water.flow);
    a("color", water.color);
    a("clarity", water.clarity);
    a("waves", water.waves);
}
template <class A>
void fields(A& a, Is<Trigger> auto& trigger) {
    a("name", trigger.name);
    a("kind", trigger.kind);
    a("pose", trigger.pose);
    a("radius", trigger.radius);
    a("half_size", trigger.halfSize);
    a("outline", trigger.outline);
    a("height", trigger.height);
    a("layers", trigger.layers);
    a("tags", trigger.tags);
    if constexpr (requires { A::kIsBinary; }) a("inside", trigger.inside);
}
template <class A>
void fields(A& a, Is<Character> auto& character) {
    a("name", character.name);
    a("radius", character.radius);
    a("height", character.height);
    a("crouched_height", character.crouchedHeight);
    a("step_height", character.stepHeight);
    a("steepest", character.steepest);
    a("mass", character.mass);
    a("walk_speed", character.walkSpeed);
    a("crouch_speed", character.crouchSpeed);
    a("jump_speed", character.jumpSpeed);
    a("swim_speed", character.swimSpeed);
    a("push_force", character.pushForce);
    a("collision_layer", character.collisionLayer);
    a("collision_mask", character.collisionMask);
    a("wish", character.wish);
    a("wants_jump", character.wantsJump);
    a("wants_crouch", character.wantsCrouch);
    a("position", character.position);
    a("velocity", character.velocity);
    a("grounded", character.grounded);
    a("crouched", character.crouched);
    a("swimming", character.swimming);
    if constexpr (requires { A::kIsBinary; }) a("ground", character.ground);
}
template <class A>
void fields(A& a, Is<JointEnd> auto& end) {
    if constexpr (requires { A::kIsBinary; }) a("shape", end.shape);
    a("frame", end.frame);
    a("cell", end.cell);
    a("radius", end.radius);
    a("loose", end.isFree);
}
template <class A>
void fields(A& a, Is<JointLimits> auto& limits) {
    a("on", limits.on);
    a("low", limits.low);
    a("high", limits.high);
}
template <class A>
void fields(A& a, Is<JointMotor> auto& motor) {
    a("mode", motor.mode);
    a("target", motor.target);
    a("most_force", motor.maxForce);
}
template <class A>
void fields(A& a, Is<JointSpring> auto& spring) {
    a("hertz", spring.hertz);
    a("damping_ratio", spring.dampingRatio);
}
template <class A>
void fields(A& a, Is<WheelSettings> auto& wheel) {
    a("drive_torque", wheel.driveTorque);
    a("top_spin", wheel.topSpin);
    a("brake_torque", wheel.brakeTorque);
    a("steer_angle", wheel.steerAngle);
    a("steer_rate", wheel.steerRate);
}
template <class A>
void fields(A& a, Is<RopeSettings> auto& rope) {
    a("length", rope.length);
    a("slack", rope.slack);
    a("points", rope.points);
    a("radius", rope.radius);
    a("mass_per_metre", rope.massPerMetre);
    a("stretch", rope.stretch);
    a("strength", rope.strength);
    a("red", rope.color[0]);
    a("green", rope.color[1]);
    a("blue", rope.color[2]);
}
template <class A>
void fields(A& a, Is<RopePoint> auto& point) {
    a("position", point.position);
    a("velocity", point.velocity);
}
template <class A>
void fields(A& a, Is<Joint> auto& joint) {
    a("name", joint.name);
    a("kind", joint.kind);
    a("first", joint.ends[0]);
    a("second", joint.ends[1]);
    a("collides", joint.collides);
    a("limits", joint.limits);
    a("motor", joint.motor);
    a("spring", joint.spring);
    a("friction", joint.friction);
    a("most_force", joint.maxForce);
    a("break_force", joint.breakForce);
    a("break_torque", joint.breakTorque);
    a("steer", joint.steer);
    a("wheel", joint.wheel);
    a("hand", joint.hand);
    a("rope", joint.rope);
    a("points", joint.points);
}
template <class A>
void fields(A& a, Is<LevelJoint> auto& joint) {
    a("first_shape", joint.shapeNames[0]);
    a("second_shape", joint.shapeNames[1]);
    a("joint", joint.joint);
}
using NamedPose = std::pair<std::string, Pose>;
template <class A>
void fields(A& a, Is<NamedPose> auto& location) {
    a("name", location.first);
    a("pose", location.second);
}
template <class A>
void fields(A& a, Is<Level> auto& level) {
    a("name", level.name);
    a("materials", level.materials.materials);
    a("environment", level.environment);
    a("light_groups", level.lightGroups);
    a("auto_light_groups", level.autoLightGroups);
    a("lights", level.lights);
    a("locations", level.locations);
    a("bodies", level.bodies);
    a("waters", level.waters);
    a("triggers", level.triggers);
    a("characters", level.characters);
    a("joints", level.joints);
}

}  // namespace rubble
