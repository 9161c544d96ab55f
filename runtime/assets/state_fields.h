#pragma once
#include <array>
#include <tuple>

#include "runtime/assets/level_fields.h"
#include "runtime/world/edits/edit.h"
#include "runtime/world/settings/settings_fields.h"
#include "runtime/world/state/world_state.h"

// What saved games and recordings hold beside what levels do (see fields.h). A shape's voxels and their mass properties
// are no fields.
namespace rubble {

template <>
inline constexpr std::array<const char*, 3> kEnumNames<BrushKind> = {"sphere", "box", "capsule"};
template <>
inline constexpr std::array<const char*, 3> kEnumNames<HistoryAction> = {"mark", "undo", "redo"};
template <>
inline constexpr std::array<const char*, 5> kEnumNames<Tool> = {"any", "sledge", "torch", "gun", "explosive"};
template <>
inline constexpr std::array<const char*, 3> kEnumNames<AnchorChange> = {"none", "boxes", "default"};
template <>
inline constexpr std::array<const char*, 4> kEnumNames<ShapeSource> = {"grid", "box", "sphere", "copy"};
template <>
inline constexpr std::array<const char*, 4> kEnumNames<JointBreak> = {"voxel gone", "force", "removed", "cut"};

template <>
inline constexpr auto kFields<Body> = std::tuple{
    Field{"name", &Body::name},
    Field{"pose", &Body::pose},
    Field{"velocity", &Body::velocity},
    Field{"angular_velocity", &Body::angularVelocity},
    Field{"is_static", &Body::isStatic},
    Field{"asleep", &Body::asleep},
    Field{"waits_to_wake", &Body::waitsToWake},
    Field{"shapes", &Body::shapes},
    Field{"tags", &Body::tags},
    Field{"settled", &Body::settled},
    Field{"broken", &Body::broken},
    Field{"created_step", &Body::createdStep},
    Field{"resting_since", &Body::restingSince},
    Field{"gravity_scale", &Body::gravityScale},
    Field{"linear_damping", &Body::linearDamping},
    Field{"angular_damping", &Body::angularDamping},
};
template <>
inline constexpr auto kFields<Shape> = std::tuple{
    Field{"name", &Shape::name},
    Field{"body", &Shape::body},
    Field{"local", &Shape::local},
    Field{"voxel_size", &Shape::voxelSize},
    Field{"grid", &Shape::grid},
    Field{"palette", &Shape::palette},
    Field{"paint_colors", &Shape::paintColors},
    Field{"anchors", &Shape::anchors},
    Field{"tags", &Shape::tags},
    Field{"is_piece", &Shape::isPiece},
    Field{"broken", &Shape::broken},
    Field{"known_connected", &Shape::knownConnected},
    Field{"load_bearing", &Shape::loadBearing},
    Field{"strength", &Shape::strength},
    Field{"collision_layer", &Shape::collisionLayer},
    Field{"collision_mask", &Shape::collisionMask},
    Field{"collision_shape", &Shape::collisionShape},
    Field{"density", &Shape::density},
    Field{"emission", &Shape::emission},
};
template <>
inline constexpr auto kFields<Light> = lightTable([](auto member) { return member; }, &Light::shape, &Light::group);

template <>
inline constexpr auto kFields<Note> = std::tuple{
    Field{"object", &Note::object},      Field{"sets_name", &Note::setsName}, Field{"name", &Note::name},
    Field{"sets_tags", &Note::setsTags}, Field{"tags", &Note::tags},          Field{"user_value", &Note::userValue},
    Field{"parent", &Note::parent},      Field{"root", &Note::root},
};

template <>
inline constexpr auto kFields<HotBrick> = std::tuple{
    Field{"brick", &HotBrick::brick},   Field{"heat", &HotBrick::heat},
    Field{"burned", &HotBrick::burned}, Field{"burning_for", &HotBrick::burningFor},
    Field{"wet", &HotBrick::wet},       Field{"charred", &HotBrick::charred},
};
template <>
inline constexpr auto kFields<HeatField> = std::tuple{
    Field{"shape", &HeatField::shape},
    Field{"bricks", &HeatField::bricks},
};

template <>
inline constexpr auto kFields<CarveEdit> = std::tuple{
    Field{"kind", &CarveEdit::kind},
    Field{"position", &CarveEdit::position},
    Field{"end", &CarveEdit::end},
    Field{"half_size", &CarveEdit::halfSize},
    Field{"rotation", &CarveEdit::rotation},
    Field{"radii", &CarveEdit::radii},
    Field{"hardness_limit", &CarveEdit::maxHardness},
    Field{"shape", &CarveEdit::shape},
    Field{"tool", &CarveEdit::tool},
};
template <>
inline constexpr auto kFields<BreakEdit> = std::tuple{
    Field{"position", &BreakEdit::position}, Field{"radii", &BreakEdit::radii}, Field{"tool", &BreakEdit::tool},
    Field{"seed", &BreakEdit::seed},         Field{"shape", &BreakEdit::shape},
};
template <>
inline constexpr auto kFields<ExplodeEdit> = std::tuple{
    Field{"position", &ExplodeEdit::position},
    Field{"size", &ExplodeEdit::size},
    Field{"impulse", &ExplodeEdit::impulse},
};
template <>
inline constexpr auto kFields<PaintEdit> = std::tuple{
    Field{"position", &PaintEdit::position},
    Field{"radius", &PaintEdit::radius},
    Field{"color", &PaintEdit::color},
    Field{"strength", &PaintEdit::strength},
    Field{"probability", &PaintEdit::probability},
    Field{"seed", &PaintEdit::seed},
    Field{"falloff", &PaintEdit::falloff},
    Field{"mode", &PaintEdit::mode},
    Field{"kind", &PaintEdit::kind},
    Field{"end", &PaintEdit::end},
    Field{"shape", &PaintEdit::shape},
};
template <>
inline constexpr auto kFields<ImpactLoadEdit> = std::tuple{
    Field{"shape", &ImpactLoadEdit::shape},
    Field{"position", &ImpactLoadEdit::position},
    Field{"impulse", &ImpactLoadEdit::impulse},
};
template <>
inline constexpr auto kFields<ImpulseEdit> = std::tuple{
    Field{"body", &ImpulseEdit::body},
    Field{"position", &ImpulseEdit::position},
    Field{"impulse", &ImpulseEdit::impulse},
};
template <>
inline constexpr auto kFields<SettingsEdit> = std::tuple{
    Field{"settings", &SettingsEdit::settings},
};
template <>
inline constexpr auto kFields<HistoryEdit> = std::tuple{
    Field{"action", &HistoryEdit::action},
};

template <>
inline constexpr auto kFields<HeatEdit> = std::tuple{
    Field{"position", &HeatEdit::position}, Field{"radius", &HeatEdit::radius}, Field{"joules", &HeatEdit::joules},
    Field{"ignite", &HeatEdit::ignite},     Field{"shape", &HeatEdit::shape},
};
template <>
inline constexpr auto kFields<ExtinguishEdit> = std::tuple{
    Field{"position", &ExtinguishEdit::position},
    Field{"radius", &ExtinguishEdit::radius},
    Field{"wet_seconds", &ExtinguishEdit::wetSeconds},
};
template <>
inline constexpr auto kFields<RemoveFiresEdit> = std::tuple{
    Field{"low", &RemoveFiresEdit::low},
    Field{"high", &RemoveFiresEdit::high},
};
template <>
inline constexpr auto kFields<SplitShapeEdit> = std::tuple{
    Field{"shape", &SplitShapeEdit::shape},
    Field{"remove_residual", &SplitShapeEdit::removeResidual},
    Field{"residual_voxels", &SplitShapeEdit::residualVoxels},
};
template <>
inline constexpr auto kFields<MergeShapeEdit> = std::tuple{
    Field{"shape", &MergeShapeEdit::shape},
    Field{"into", &MergeShapeEdit::into},
};
template <>
inline constexpr auto kFields<TrimShapeEdit> = std::tuple{
    Field{"shape", &TrimShapeEdit::shape},
};
template <>
inline constexpr auto kFields<ResizeShapeEdit> = std::tuple{
    Field{"shape", &ResizeShapeEdit::shape},
    Field{"box", &ResizeShapeEdit::box},
};
template <>
inline constexpr auto kFields<WriteVoxelsEdit> = std::tuple{
    Field{"shape", &WriteVoxelsEdit::shape},
    Field{"box", &WriteVoxelsEdit::box},
    Field{"entries", &WriteVoxelsEdit::entries},
    Field{"mask", &WriteVoxelsEdit::mask},
};
template <>
inline constexpr auto kFields<DestroyShapeEdit> = std::tuple{
    Field{"shape", &DestroyShapeEdit::shape},
};
template <>
inline constexpr auto kFields<SetBodyEdit> = std::tuple{
    Field{"body", &SetBodyEdit::body},
    Field{"sets_pose", &SetBodyEdit::setsPose},
    Field{"pose", &SetBodyEdit::pose},
    Field{"sets_velocity", &SetBodyEdit::setsVelocity},
    Field{"velocity", &SetBodyEdit::velocity},
    Field{"angular_velocity", &SetBodyEdit::angularVelocity},
    Field{"sets_sleep", &SetBodyEdit::setsSleep},
    Field{"asleep", &SetBodyEdit::asleep},
    Field{"sets_kind", &SetBodyEdit::setsKind},
    Field{"is_static", &SetBodyEdit::isStatic},
    Field{"sets_gravity_scale", &SetBodyEdit::setsGravityScale},
    Field{"gravity_scale", &SetBodyEdit::gravityScale},
    Field{"sets_damping", &SetBodyEdit::setsDamping},
    Field{"linear_damping", &SetBodyEdit::linearDamping},
    Field{"angular_damping", &SetBodyEdit::angularDamping},
};
template <>
inline constexpr auto kFields<DestroyBodyEdit> = std::tuple{
    Field{"body", &DestroyBodyEdit::body},
};
template <>
inline constexpr auto kFields<CreateBodyEdit> = std::tuple{
    Field{"body", &CreateBodyEdit::body},
};
template <>
inline constexpr auto kFields<CreateShapeEdit> = std::tuple{
    Field{"body", &CreateShapeEdit::body},     Field{"source", &CreateShapeEdit::source},
    Field{"size", &CreateShapeEdit::size},     Field{"entry", &CreateShapeEdit::entry},
    Field{"copied", &CreateShapeEdit::copied}, Field{"palette_of", &CreateShapeEdit::paletteOf},
    Field{"shape", &CreateShapeEdit::shape},
};
template <>
inline constexpr auto kFields<SetCollisionFilterEdit> = std::tuple{
    Field{"shape", &SetCollisionFilterEdit::shape},
    Field{"layer", &SetCollisionFilterEdit::layer},
    Field{"mask", &SetCollisionFilterEdit::mask},
};
template <>
inline constexpr auto kFields<SetCollisionShapeEdit> = std::tuple{
    Field{"shape", &SetCollisionShapeEdit::shape},
    Field{"kind", &SetCollisionShapeEdit::kind},
};
template <>
inline constexpr auto kFields<AddWaterEdit> = std::tuple{
    Field{"water", &AddWaterEdit::water},
};
template <>
inline constexpr auto kFields<RemoveWaterEdit> = std::tuple{
    Field{"water", &RemoveWaterEdit::water},
};
template <>
inline constexpr auto kFields<AddTriggerEdit> = std::tuple{
    Field{"trigger", &AddTriggerEdit::trigger},
};
template <>
inline constexpr auto kFields<RemoveTriggerEdit> = std::tuple{
    Field{"trigger", &RemoveTriggerEdit::trigger},
};
template <>
inline constexpr auto kFields<AddCharacterEdit> = std::tuple{
    Field{"character", &AddCharacterEdit::character},
};
template <>
inline constexpr auto kFields<RemoveCharacterEdit> = std::tuple{
    Field{"character", &RemoveCharacterEdit::character},
};
template <>
inline constexpr auto kFields<MoveCharacterEdit> = std::tuple{
    Field{"character", &MoveCharacterEdit::character},
    Field{"wish", &MoveCharacterEdit::wish},
    Field{"jump", &MoveCharacterEdit::jump},
    Field{"crouch", &MoveCharacterEdit::crouch},
};
template <>
inline constexpr auto kFields<TeleportCharacterEdit> = std::tuple{
    Field{"character", &TeleportCharacterEdit::character},
    Field{"position", &TeleportCharacterEdit::position},
    Field{"velocity", &TeleportCharacterEdit::velocity},
};

template <>
inline constexpr auto kFields<AddJointEdit> = std::tuple{
    Field{"joint", &AddJointEdit::joint},
    Field{"in_world", &AddJointEdit::inWorld},
};
template <>
inline constexpr auto kFields<RemoveJointEdit> = std::tuple{
    Field{"joint", &RemoveJointEdit::joint},
    Field{"reason", &RemoveJointEdit::reason},
    Field{"place", &RemoveJointEdit::place},
};
template <>
inline constexpr auto kFields<SetJointMotorEdit> = std::tuple{
    Field{"joint", &SetJointMotorEdit::joint},
    Field{"motor", &SetJointMotorEdit::motor},
    Field{"friction", &SetJointMotorEdit::friction},
    Field{"steer", &SetJointMotorEdit::steer},
};
template <>
inline constexpr auto kFields<DriveEdit> = std::tuple{
    Field{"body", &DriveEdit::body},
    Field{"throttle", &DriveEdit::throttle},
    Field{"steer", &DriveEdit::steer},
    Field{"brake", &DriveEdit::brake},
};
template <>
inline constexpr auto kFields<SetEnvironmentEdit> = std::tuple{
    Field{"environment", &SetEnvironmentEdit::environment},
};
template <>
inline constexpr auto kFields<AddLightEdit> = std::tuple{
    Field{"light", &AddLightEdit::light},
};
template <>
inline constexpr auto kFields<SetLightEdit> = std::tuple{
    Field{"light", &SetLightEdit::light},
    Field{"values", &SetLightEdit::values},
};
template <>
inline constexpr auto kFields<RemoveLightEdit> = std::tuple{
    Field{"light", &RemoveLightEdit::light},
};
template <>
inline constexpr auto kFields<SetBoundsEdit> = std::tuple{
    Field{"bounds", &SetBoundsEdit::bounds},
};
template <>
inline constexpr auto kFields<DetachJointEdit> = std::tuple{
    Field{"joint", &DetachJointEdit::joint},
    Field{"shape", &DetachJointEdit::shape},
};
template <>
inline constexpr auto kFields<GrabEdit> = std::tuple{
    Field{"body", &GrabEdit::body},
    Field{"point", &GrabEdit::point},
    Field{"target", &GrabEdit::target},
    Field{"max_force", &GrabEdit::maxForce},
    Field{"hertz", &GrabEdit::hertz},
    Field{"hand", &GrabEdit::hand},
    Field{"turns", &GrabEdit::turns},
    Field{"rotation", &GrabEdit::rotation},
    Field{"max_torque", &GrabEdit::maxTorque},
    Field{"drives", &GrabEdit::drives},
    Field{"velocity", &GrabEdit::velocity},
    Field{"angular_velocity", &GrabEdit::angularVelocity},
};
template <>
inline constexpr auto kFields<BodyConstraint> = std::tuple{
    Field{"body", &BodyConstraint::body},          Field{"other", &BodyConstraint::other},
    Field{"position", &BodyConstraint::position},  Field{"direction", &BodyConstraint::direction},
    Field{"speed", &BodyConstraint::speed},        Field{"turns", &BodyConstraint::turns},
    Field{"min_force", &BodyConstraint::minForce}, Field{"max_force", &BodyConstraint::maxForce},
};
template <>
inline constexpr auto kFields<ConstrainEdit> = std::tuple{
    Field{"constraint", &ConstrainEdit::constraint},
};
template <>
inline constexpr auto kFields<ReleaseEdit> = std::tuple{
    Field{"impulse", &ReleaseEdit::impulse},
    Field{"hand", &ReleaseEdit::hand},
};

template <>
inline constexpr auto kFields<SetNameEdit> = std::tuple{
    Field{"object", &SetNameEdit::object},
    Field{"name", &SetNameEdit::name},
};
template <>
inline constexpr auto kFields<SetTagEdit> = std::tuple{
    Field{"object", &SetTagEdit::object},
    Field{"tag", &SetTagEdit::tag},
    Field{"value", &SetTagEdit::value},
};
template <>
inline constexpr auto kFields<RemoveTagEdit> = std::tuple{
    Field{"object", &RemoveTagEdit::object},
    Field{"tag", &RemoveTagEdit::tag},
};
template <>
inline constexpr auto kFields<SetUserValueEdit> = std::tuple{
    Field{"object", &SetUserValueEdit::object},
    Field{"value", &SetUserValueEdit::value},
};

template <>
inline constexpr auto kFields<SetScriptsEdit> = std::tuple{
    Field{"scripts", &SetScriptsEdit::scripts},
    Field{"adds", &SetScriptsEdit::adds},
};

template <>
inline constexpr auto kFields<SetPaletteEdit> = std::tuple{
    Field{"shape", &SetPaletteEdit::shape},
    Field{"all", &SetPaletteEdit::all},
    Field{"first", &SetPaletteEdit::first},
    Field{"entries", &SetPaletteEdit::entries},
};

template <>
inline constexpr auto kFields<SetMaterialsEdit> = std::tuple{
    Field{"first", &SetMaterialsEdit::first},
    Field{"materials", &SetMaterialsEdit::materials},
};

template <>
inline constexpr auto kFields<SetShapeEdit> = std::tuple{
    Field{"shape", &SetShapeEdit::shape},
    Field{"sets_strength", &SetShapeEdit::setsStrength},
    Field{"strength", &SetShapeEdit::strength},
    Field{"sets_density", &SetShapeEdit::setsDensity},
    Field{"density", &SetShapeEdit::density},
    Field{"sets_emission", &SetShapeEdit::setsEmission},
    Field{"emission", &SetShapeEdit::emission},
    Field{"sets_load", &SetShapeEdit::setsLoad},
    Field{"load_bearing", &SetShapeEdit::loadBearing},
    Field{"anchor_change", &SetShapeEdit::anchorChange},
    Field{"anchors", &SetShapeEdit::anchors},
};
template <>
inline constexpr auto kFields<CreateLightGroupEdit> = std::tuple{
    Field{"group", &CreateLightGroupEdit::group},
};
template <>
inline constexpr auto kFields<SetLightGroupEdit> = std::tuple{
    Field{"group", &SetLightGroupEdit::group},
    Field{"switches", &SetLightGroupEdit::switches},
    Field{"on", &SetLightGroupEdit::on},
    Field{"sets_threshold", &SetLightGroupEdit::setsThreshold},
    Field{"threshold", &SetLightGroupEdit::threshold},
    Field{"sets_supply", &SetLightGroupEdit::setsSupply},
    Field{"supply", &SetLightGroupEdit::supply},
    Field{"supply_cell", &SetLightGroupEdit::supplyCell},
};

/// An edit as the variant that it is derived from.
struct AsVariant {
    AnyEdit& operator()(Edit& edit) const { return edit; }
    const AnyEdit& operator()(const Edit& edit) const { return edit; }
};
template <>
inline constexpr auto kFields<Edit> = std::tuple{Field{"kind", AsVariant{}}, Field{"made", &Edit::made}};

}  // namespace rubble
