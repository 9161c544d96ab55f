#pragma once
#include <type_traits>

#include "runtime/assets/level_fields.h"
#include "runtime/world/state/world_state.h"

namespace rubble {

// What saves and recordings hold beside what levels do, as fields (see level_fields.h). A shape's voxels and their
// moments are no fields.

inline constexpr std::array<const char*, 3> kBrushKindNames = {"sphere", "box", "capsule"};
inline constexpr std::array<const char*, 3> kPaintModeNames = {"default", "blend", "layer"};
inline constexpr std::array<const char*, 3> kHistoryActionNames = {"mark", "undo", "redo"};
inline constexpr std::array<const char*, 5> kToolNames = {"any", "sledge", "torch", "gun", "explosive"};
inline std::span<const char* const> enumNames(Tool) {
    return kToolNames;
}
inline constexpr std::array<const char*, 4> kJointBreakNames = {"voxel gone", "force", "removed", "cut"};
inline std::span<const char* const> enumNames(JointBreak) {
    return kJointBreakNames;
}
inline std::span<const char* const> enumNames(BrushKind) {
    return kBrushKindNames;
}
inline std::span<const char* const> enumNames(PaintMode) {
    return kPaintModeNames;
}
inline std::span<const char* const> enumNames(HistoryAction) {
    return kHistoryActionNames;
}

template <class A>
void fields(A& a, Is<Body> auto& body) {
    a("name", body.name);
    a("pose", body.pose);
    a("velocity", body.velocity);
    a("angular_velocity", body.angularVelocity);
    a("static", body.isStatic);
    a("asleep", body.asleep);
    a("shapes", body.shapes);
    a("tags", body.tags);
    a("settled", body.settled);
    a("broken", body.broken);
    a("born", body.createdStep);
    a("resting_since", body.restingSince);
}
template <class A>
void fields(A& a, Is<Shape> auto& shape) {
    a("name", shape.name);
    a("body", shape.body);
    a("local", shape.local);
    a("voxel_size", shape.voxelSize);
    a("grid", shape.grid);
    a("palette", shape.palette);
    a("paint_colors", shape.paintColors);
    a("anchors", shape.anchors);
    a("tags", shape.tags);
    a("piece", shape.isPiece);
    a("nothing_loose", shape.knownConnected);
    a("bears_load", shape.loadBearing);
    a("strength", shape.strength);
    a("collision_layer", shape.collisionLayer);
    a("collision_mask", shape.collisionMask);
}
template <class A>
void fields(A& a, Is<Light> auto& light) {
    lightFields(a, light, light.shape, light.group);
}

template <class A>
void fields(A& a, Is<HotBrick> auto& hot) {
    a("brick", hot.brick);
    a("heat", hot.heat);
    a("burned", hot.burned);
    a("burning_for", hot.burningFor);
    a("wet", hot.wet);
    a("charred", hot.charred);
}
template <class A>
void fields(A& a, Is<HeatField> auto& field) {
    a("shape", field.shape);
    a("bricks", field.bricks);
}

template <class A>
void fields(A& a, Is<DebrisSettings> auto& settings) {
    a("awake_bodies", settings.awakeBodies);
    a("bodies", settings.bodies);
    a("voxels", settings.voxels);
    a("largest_piece", settings.largestPiece);
    a("settle_steps", settings.settleSteps);
    a("fragments_a_break", settings.fragmentsPerBreak);
}
template <class A>
void fields(A& a, Is<StressSettings> auto& settings) {
    a("on", settings.on);
    a("strength_scale", settings.strengthScale);
    a("work_a_step", settings.workPerStep);
    a("cracks_a_step", settings.cracksPerStep);
    a("contact_time", settings.contactTime);
    a("least_blow", settings.minImpulse);
    a("smallest_struck", settings.minStruckVoxels);
    a("largest_shape", settings.largestShape);
}
template <class A>
void fields(A& a, Is<SplitSettings> auto& settings) {
    a("parts_a_step", settings.partsPerStep);
}
template <class A>
void fields(A& a, Is<PaintSettings> auto& settings) {
    a("mode", settings.mode);
}
template <class A>
void fields(A& a, Is<FireSettings> auto& settings) {
    a("enabled", settings.enabled);
    a("max_fires", settings.maxFires);
    a("max_hot", settings.maxHot);
    a("max_lights", settings.maxLights);
    a("spread", settings.spread);
    a("burn_time", settings.burnTime);
}
template <class A>
void fields(A& a, Is<WorldSettings> auto& settings) {
    a("min_piece_voxels", settings.minPieceVoxels);
    a("impact_threshold", settings.impactThreshold);
    a("impact_speed", settings.impactSpeed);
    a("impact_radius", settings.impactRadius);
    a("impact_radius_limit", settings.impactRadiusLimit);
    a("impacts_a_step", settings.impactsPerStep);
    a("undo_marks", settings.undoMarks);
    a("debris", settings.debris);
    a("load", settings.stress);
    a("paint", settings.paint);
    a("fire", settings.fire);
    a("split", settings.split);
}

template <class A>
void fields(A& a, Is<CarveEdit> auto& edit) {
    a("kind", edit.kind);
    a("position", edit.position);
    a("end", edit.end);
    a("half_size", edit.halfSize);
    a("rotation", edit.rotation);
    a("radii", edit.radii);
    a("hardness_limit", edit.hardnessLimit);
    a("shape", edit.shape);
    a("tool", edit.tool);
}
template <class A>
void fields(A& a, Is<BreakEdit> auto& edit) {
    a("position", edit.position);
    a("radii", edit.radii);
    a("tool", edit.tool);
    a("seed", edit.seed);
    a("shape", edit.shape);
}
template <class A>
void fields(A& a, Is<ExplodeEdit> auto& edit) {
    a("position", edit.position);
    a("size", edit.size);
    a("impulse", edit.impulse);
}
template <class A>
void fields(A& a, Is<PaintEdit> auto& edit) {
    a("position", edit.position);
    a("radius", edit.radius);
    a("color", edit.color);
    a("strength", edit.strength);
    a("probability", edit.probability);
    a("seed", edit.seed);
    a("falloff", edit.falloff);
    a("mode", edit.mode);
    a("kind", edit.kind);
    a("end", edit.end);
    a("shape", edit.shape);
}
template <class A>
void fields(A& a, Is<ImpactLoadEdit> auto& edit) {
    a("shape", edit.shape);
    a("position", edit.position);
    a("impulse", edit.impulse);
}
template <class A>
void fields(A& a, Is<ImpulseEdit> auto& edit) {
    a("body", edit.body);
    a("position", edit.position);
    a("impulse", edit.impulse);
}
template <class A>
void fields(A& a, Is<SettingsEdit> auto& edit) {
    a("settings", edit.settings);
}
template <class A>
void fields(A& a, Is<HistoryEdit> auto& edit) {
    a("action", edit.action);
}

template <class A>
void fields(A& a, Is<HeatEdit> auto& edit) {
    a("position", edit.position);
    a("radius", edit.radius);
    a("joules", edit.joules);
    a("ignite", edit.ignite);
    a("shape", edit.shape);
}
template <class A>
void fields(A& a, Is<ExtinguishEdit> auto& edit) {
    a("position", edit.position);
    a("radius", edit.radius);
    a("wet_seconds", edit.wetSeconds);
}
template <class A>
void fields(A& a, Is<RemoveFiresEdit> auto& edit) {
    a("low", edit.low);
    a("high", edit.high);
}
template <class A>
void fields(A& a, Is<SplitShapeEdit> auto& edit) {
    a("shape", edit.shape);
    a("remove_residual", edit.removeResidual);
    a("residual_voxels", edit.residualVoxels);
}
template <class A>
void fields(A& a, Is<MergeShapeEdit> auto& edit) {
    a("shape", edit.shape);
    a("into", edit.into);
}
template <class A>
void fields(A& a, Is<TrimShapeEdit> auto& edit) {
    a("shape", edit.shape);
}
template <class A>
void fields(A& a, Is<ResizeShapeEdit> auto& edit) {
    a("shape", edit.shape);
    a("box", edit.box);
}
template <class A>
void fields(A& a, Is<SetCollisionEdit> auto& edit) {
    a("shape", edit.shape);
    a("layer", edit.layer);
    a("mask", edit.mask);
}
template <class A>
void fields(A& a, Is<AddWaterEdit> auto& edit) {
    a("water", edit.water);
}
template <class A>
void fields(A& a, Is<RemoveWaterEdit> auto& edit) {
    a("water", edit.water);
}
template <class A>
void fields(A& a, Is<AddTriggerEdit> auto& edit) {
    a("trigger", edit.trigger);
}
template <class A>
void fields(A& a, Is<RemoveTriggerEdit> auto& edit) {
    a("trigger", edit.trigger);
}
template <class A>
void fields(A& a, Is<AddCharacterEdit> auto& edit) {
    a("character", edit.character);
}
template <class A>
void fields(A& a, Is<RemoveCharacterEdit> auto& edit) {
    a("character", edit.character);
}
template <class A>
void fields(A& a, Is<MoveCharacterEdit> auto& edit) {
    a("character", edit.character);
    a("wish", edit.wish);
    a("jump", edit.jump);
    a("crouch", edit.crouch);
}
template <class A>
void fields(A& a, Is<PlaceCharacterEdit> auto& edit) {
    a("character", edit.character);
    a("position", edit.position);
    a("velocity", edit.velocity);
}

template <class A>
void fields(A& a, Is<AddJointEdit> auto& edit) {
    a("joint", edit.joint);
}
template <class A>
void fields(A& a, Is<RemoveJointEdit> auto& edit) {
    a("joint", edit.joint);
    a("reason", edit.reason);
    a("place", edit.place);
}
template <class A>
void fields(A& a, Is<SetJointMotorEdit> auto& edit) {
    a("joint", edit.joint);
    a("motor", edit.motor);
    a("friction", edit.friction);
    a("steer", edit.steer);
}
template <class A>
void fields(A& a, Is<DriveEdit> auto& edit) {
    a("body", edit.body);
    a("throttle", edit.throttle);
    a("steer", edit.steer);
    a("brake", edit.brake);
}
template <class A>
void fields(A& a, Is<SetEnvironmentEdit> auto& edit) {
    a("environment", edit.environment);
}
template <class A>
void fields(A& a, Is<AddLightEdit> auto& edit) {
    a("light", edit.light);
}
template <class A>
void fields(A& a, Is<SetLightEdit> auto& edit) {
    a("light", edit.light);
    a("values", edit.values);
}
template <class A>
void fields(A& a, Is<RemoveLightEdit> auto& edit) {
    a("light", edit.light);
}
template <class A>
void fields(A& a, Is<DetachJointEdit> auto& edit) {
    a("joint", edit.joint);
    a("shape", edit.shape);
}
template <class A>
void fields(A& a, Is<GrabEdit> auto& edit) {
    a("body", edit.body);
    a("point", edit.point);
    a("target", edit.target);
    a("most_force", edit.maxForce);
    a("hertz", edit.hertz);
    a("hand", edit.hand);
}
template <class A>
void fields(A& a, Is<ReleaseEdit> auto& edit) {
    a("impulse", edit.impulse);
    a("hand", edit.hand);
}

template <class A>
void fields(A& a, Is<Edit> auto& edit) {
    using Kinds = std::conditional_t<std::is_const_v<std::remove_reference_t<decltype(edit)>>, const AnyEdit, AnyEdit>;
    a("kind", static_cast<Kinds&>(edit));
}

}  // namespace rubble
