#pragma once
#include <array>
#include <string>
#include <tuple>
#include <utility>

#include "runtime/core/fields.h"
#include "runtime/world/level/level.h"

// What a level holds (see fields.h). The voxels of a grid are no field: archives see its size here and store its bricks
// apart.
namespace rubble {

template <>
inline constexpr std::array<const char*, 5> kEnumNames<LightKind> = {"sphere", "cone", "capsule", "area", "screen"};
template <>
inline constexpr std::array<const char*, 5> kEnumNames<Hardness> = {"soft", "medium", "hard", "unbreakable",
                                                                    "unphysical"};
template <>
inline constexpr std::array<const char*, 7> kEnumNames<JointKind> = {"ball",  "hinge", "prismatic", "cone",
                                                                     "fixed", "rope",  "wheel"};
template <>
inline constexpr std::array<const char*, 3> kEnumNames<MotorMode> = {"off", "speed", "position"};
template <>
inline constexpr std::array<const char*, 5> kEnumNames<CollisionShape> = {"voxels", "sphere", "cylinder_x",
                                                                          "cylinder_y", "cylinder_z"};
template <>
inline constexpr std::array<const char*, 3> kEnumNames<TriggerKind> = {"sphere", "box", "polygon"};

template <>
inline constexpr std::array<const char*, 5> kEnumNames<TaggedKind> = {"light", "light_group", "water", "character",
                                                                      "joint"};

template <>
inline constexpr auto kFields<Pose> = std::tuple{
    Field{"position", &Pose::position},
    Field{"rotation", &Pose::rotation},
};
template <>
inline constexpr auto kFields<CellBox> = std::tuple{
    Field{"low", &CellBox::low},
    Field{"high", &CellBox::high},
};
template <>
inline constexpr auto kFields<WorldBox> = std::tuple{
    Field{"low", &WorldBox::low},
    Field{"high", &WorldBox::high},
};
template <>
inline constexpr auto kFields<PaletteEntry> = std::tuple{
    Field{"red", &PaletteEntry::red},
    Field{"green", &PaletteEntry::green},
    Field{"blue", &PaletteEntry::blue},
    Field{"opacity", &PaletteEntry::opacity},
    Field{"roughness", &PaletteEntry::roughness},
    Field{"metallic", &PaletteEntry::metallic},
    Field{"reflectivity", &PaletteEntry::reflectivity},
    Field{"material", &PaletteEntry::material},
    Field{"emission", &PaletteEntry::emission},
    Field{"light_group", &PaletteEntry::lightGroup},
};
template <>
inline constexpr auto kFields<Material> = std::tuple{
    Field{"name", &Material::name},
    Field{"hardness", &Material::hardness},
    Field{"density", &Material::density},
    Field{"tensile_strength", &Material::tensileStrength},
    Field{"compressive_strength", &Material::compressiveStrength},
    Field{"shear_strength", &Material::shearStrength},
    Field{"friction", &Material::friction},
    Field{"restitution", &Material::restitution},
    Field{"heat_capacity", &Material::heatCapacity},
    Field{"ignition_temperature", &Material::ignitionTemperature},
    Field{"burn_time", &Material::burnTime},
    Field{"fragments", &Material::fragments},
    Field{"sledge", &Material::sledge},
    Field{"torch", &Material::torch},
    Field{"gun", &Material::gun},
    Field{"explosive", &Material::explosive},
};
template <>
inline constexpr auto kFields<LevelShape> = std::tuple{
    Field{"name", &LevelShape::name},
    Field{"local", &LevelShape::local},
    Field{"voxel_size", &LevelShape::voxelSize},
    Field{"size", &LevelShape::grid},
    Field{"palette", &LevelShape::palette},
    Field{"anchors", &LevelShape::anchors},
    Field{"tags", &LevelShape::tags},
    Field{"hidden", &LevelShape::hidden},
    Field{"paint_colors", &LevelShape::paintColors},
    Field{"strength", &LevelShape::strength},
    Field{"bears_load", &LevelShape::loadBearing},
    Field{"collision_layer", &LevelShape::collisionLayer},
    Field{"collision_mask", &LevelShape::collisionMask},
    Field{"collision_shape", &LevelShape::collisionShape},
    Field{"density", &LevelShape::density},
    Field{"emission", &LevelShape::emission},
};
template <>
inline constexpr auto kFields<LevelBody> = std::tuple{
    Field{"name", &LevelBody::name},
    Field{"pose", &LevelBody::pose},
    Field{"static", &LevelBody::isStatic},
    Field{"velocity", &LevelBody::velocity},
    Field{"angular_velocity", &LevelBody::angularVelocity},
    Field{"shapes", &LevelBody::shapes},
    Field{"tags", &LevelBody::tags},
    Field{"gravity_scale", &LevelBody::gravityScale},
    Field{"linear_damping", &LevelBody::linearDamping},
    Field{"angular_damping", &LevelBody::angularDamping},
};
template <>
inline constexpr auto kFields<LightImage> = std::tuple{
    Field{"width", &LightImage::width},
    Field{"texels", &LightImage::texels},
};
/// The table of a light. of(&Light::x): where x is in the stored type; `shape` and `group`: its members that say what
/// the light is fixed to, which are names in a level and handles in a saved game.
template <class Of, class Shape, class Group>
constexpr auto lightTable(Of of, Shape shape, Group group) {
    return std::tuple{
        Field{"name", of(&Light::name)},
        Field{"kind", of(&Light::kind)},
        Field{"shape", shape},
        Field{"group", group},
        Field{"local", of(&Light::local)},
        Field{"color", of(&Light::color)},
        Field{"radius", of(&Light::radius)},
        Field{"reach", of(&Light::reach)},
        Field{"cone_inner", of(&Light::coneInner)},
        Field{"cone_outer", of(&Light::coneOuter)},
        Field{"width", of(&Light::width)},
        Field{"height", of(&Light::height)},
        Field{"two_sided", of(&Light::twoSided)},
        Field{"image", of(&Light::image)},
        Field{"enabled", of(&Light::enabled)},
    };
}
template <>
inline constexpr auto kFields<LevelLight> = lightTable([](auto member) { return memberOf(&LevelLight::light, member); },
                                                       &LevelLight::shapeName, &LevelLight::groupName);
template <>
inline constexpr auto kFields<LightGroup> = std::tuple{
    Field{"name", &LightGroup::name},
    Field{"threshold", &LightGroup::threshold},
    Field{"initial_voxels", &LightGroup::initialVoxels},
    Field{"removed_voxels", &LightGroup::removedVoxels},
    Field{"out", &LightGroup::out},
    Field{"off", &LightGroup::off},
    Field{"supply_shape", &LightGroup::supplyShape},
    Field{"supply_cell", &LightGroup::supplyCell},
    Field{"flicker_steps", &LightGroup::flickerSteps},
    Field{"dying_since", &LightGroup::failingSince},
    Field{"dark", &LightGroup::dark},
    BinaryField{"supply", &LightGroup::supply},
};
template <>
inline constexpr auto kFields<Environment> = std::tuple{
    Field{"sun_direction", &Environment::sunDirection},
    Field{"sun_color", &Environment::sunColor},
    Field{"sun_angle", &Environment::sunAngle},
    Field{"sky_color", &Environment::skyColor},
    Field{"horizon_color", &Environment::horizonColor},
    Field{"ground_color", &Environment::groundColor},
    Field{"fog_color", &Environment::fogColor},
    Field{"fog_distance", &Environment::fogDistance},
    Field{"fog_density", &Environment::fogDensity},
    Field{"fog_base", &Environment::fogBase},
    Field{"fog_height", &Environment::fogHeight},
    Field{"fog_forward", &Environment::fogForward},
    Field{"fog_tint", &Environment::fogTint},
    Field{"clouds", &Environment::clouds},
    Field{"stars", &Environment::stars},
    Field{"exposure", &Environment::exposure},
    Field{"wetness", &Environment::wetness},
    Field{"gravity", &Environment::gravity},
};
template <>
inline constexpr auto kFields<GroundPoint> = std::tuple{
    Field{"x", &GroundPoint::x},
    Field{"z", &GroundPoint::z},
};
template <>
inline constexpr auto kFields<WaterWaves> = std::tuple{
    Field{"height", &WaterWaves::height},
    Field{"length", &WaterWaves::length},
    Field{"speed", &WaterWaves::speed},
    Field{"direction", &WaterWaves::direction},
};
template <>
inline constexpr auto kFields<Water> = std::tuple{
    Field{"name", &Water::name},
    Field{"outline", &Water::outline},
    Field{"surface", &Water::surface},
    Field{"depth", &Water::depth},
    Field{"density", &Water::density},
    Field{"linear_drag", &Water::linearDrag},
    Field{"angular_drag", &Water::angularDrag},
    Field{"flow", &Water::flow},
    Field{"color", &Water::color},
    Field{"clarity", &Water::clarity},
    Field{"waves", &Water::waves},
};
template <>
inline constexpr auto kFields<Trigger> = std::tuple{
    Field{"name", &Trigger::name},          Field{"kind", &Trigger::kind},
    Field{"pose", &Trigger::pose},          Field{"radius", &Trigger::radius},
    Field{"half_size", &Trigger::halfSize}, Field{"outline", &Trigger::outline},
    Field{"height", &Trigger::height},      Field{"layers", &Trigger::layerMask},
    Field{"tags", &Trigger::tags},          BinaryField{"inside", &Trigger::inside},
};
template <>
inline constexpr auto kFields<Character> = std::tuple{
    Field{"name", &Character::name},
    Field{"radius", &Character::radius},
    Field{"height", &Character::height},
    Field{"crouched_height", &Character::crouchedHeight},
    Field{"step_height", &Character::stepHeight},
    Field{"steepest", &Character::maxSlope},
    Field{"mass", &Character::mass},
    Field{"walk_speed", &Character::walkSpeed},
    Field{"crouch_speed", &Character::crouchSpeed},
    Field{"jump_speed", &Character::jumpSpeed},
    Field{"swim_speed", &Character::swimSpeed},
    Field{"push_force", &Character::maxPushForce},
    Field{"collision_layer", &Character::collisionLayer},
    Field{"collision_mask", &Character::collisionMask},
    Field{"wish", &Character::wish},
    Field{"wants_jump", &Character::wantsJump},
    Field{"wants_crouch", &Character::wantsCrouch},
    Field{"position", &Character::position},
    Field{"velocity", &Character::velocity},
    BinaryField{"ground_velocity", &Character::groundVelocity},
    Field{"grounded", &Character::grounded},
    Field{"crouched", &Character::crouched},
    Field{"swimming", &Character::swimming},
    BinaryField{"ground", &Character::ground},
};
template <>
inline constexpr auto kFields<JointEnd> = std::tuple{
    BinaryField{"shape", &JointEnd::shape}, Field{"frame", &JointEnd::frame},  Field{"cell", &JointEnd::cell},
    Field{"radius", &JointEnd::radius},     Field{"loose", &JointEnd::isFree},
};
template <>
inline constexpr auto kFields<JointLimits> = std::tuple{
    Field{"on", &JointLimits::on},
    Field{"low", &JointLimits::low},
    Field{"high", &JointLimits::high},
};
template <>
inline constexpr auto kFields<JointMotor> = std::tuple{
    Field{"mode", &JointMotor::mode},
    Field{"target", &JointMotor::target},
    Field{"most_force", &JointMotor::maxForce},
};
template <>
inline constexpr auto kFields<JointSpring> = std::tuple{
    Field{"hertz", &JointSpring::hertz},
    Field{"damping_ratio", &JointSpring::dampingRatio},
};
template <>
inline constexpr auto kFields<WheelSettings> = std::tuple{
    Field{"drive_torque", &WheelSettings::driveTorque}, Field{"top_spin", &WheelSettings::maxSpin},
    Field{"brake_torque", &WheelSettings::brakeTorque}, Field{"steer_angle", &WheelSettings::steerAngle},
    Field{"steer_rate", &WheelSettings::steerRate},
};
template <>
inline constexpr auto kFields<RopeSettings> = std::tuple{
    Field{"length", &RopeSettings::length},
    Field{"slack", &RopeSettings::slack},
    Field{"points", &RopeSettings::points},
    Field{"radius", &RopeSettings::radius},
    Field{"mass_per_metre", &RopeSettings::massPerMetre},
    Field{"stretch", &RopeSettings::stretch},
    Field{"strength", &RopeSettings::strength},
    Field{"red", elementOf<0>(&RopeSettings::color)},
    Field{"green", elementOf<1>(&RopeSettings::color)},
    Field{"blue", elementOf<2>(&RopeSettings::color)},
};
template <>
inline constexpr auto kFields<RopePoint> = std::tuple{
    Field{"position", &RopePoint::position},
    Field{"velocity", &RopePoint::velocity},
};
template <>
inline constexpr auto kFields<Joint> = std::tuple{
    Field{"name", &Joint::name},
    Field{"kind", &Joint::kind},
    Field{"first", elementOf<0>(&Joint::ends)},
    Field{"second", elementOf<1>(&Joint::ends)},
    Field{"collides", &Joint::collides},
    Field{"limits", &Joint::limits},
    Field{"motor", &Joint::motor},
    Field{"spring", &Joint::spring},
    Field{"friction", &Joint::friction},
    Field{"most_force", &Joint::maxForce},
    Field{"most_torque", &Joint::maxTorque},
    Field{"break_force", &Joint::breakForce},
    Field{"break_torque", &Joint::breakTorque},
    Field{"steer", &Joint::steer},
    Field{"wheel", &Joint::wheel},
    Field{"hand", &Joint::hand},
    Field{"rope", &Joint::rope},
    Field{"points", &Joint::points},
    Field{"drives", &Joint::drives},
    Field{"velocity", &Joint::velocity},
    Field{"angular_velocity", &Joint::angularVelocity},
    Field{"steer_target", &Joint::steerTarget},
};
template <>
inline constexpr auto kFields<LevelJoint> = std::tuple{
    Field{"first_shape", elementOf<0>(&LevelJoint::shapeNames)},
    Field{"second_shape", elementOf<1>(&LevelJoint::shapeNames)},
    Field{"joint", &LevelJoint::joint},
};
template <>
inline constexpr auto kFields<LevelScript> = std::tuple{
    Field{"path", &LevelScript::path},
    Field{"parameters", &LevelScript::parameters},
};
template <>
inline constexpr auto kFields<LevelTags> = std::tuple{
    Field{"kind", &LevelTags::kind},
    Field{"number", &LevelTags::number},
    Field{"tags", &LevelTags::tags},
};
template <>
inline constexpr auto kFields<HostData> = std::tuple{
    Field{"name", &HostData::name},
    Field{"bytes", &HostData::bytes},
};
using NamedPose = std::pair<std::string, Pose>;
template <>
inline constexpr auto kFields<NamedPose> = std::tuple{
    Field{"name", &NamedPose::first},
    Field{"pose", &NamedPose::second},
};
template <>
inline constexpr auto kFields<Level> = std::tuple{
    Field{"name", &Level::name},
    Field{"materials", memberOf(&Level::materials, &MaterialTable::materials)},
    Field{"environment", &Level::environment},
    Field{"bounds", &Level::bounds},
    Field{"light_groups", &Level::lightGroups},
    Field{"auto_light_groups", &Level::autoLightGroups},
    Field{"lights", &Level::lights},
    Field{"locations", &Level::locations},
    Field{"bodies", &Level::bodies},
    Field{"waters", &Level::waters},
    Field{"triggers", &Level::triggers},
    Field{"characters", &Level::characters},
    Field{"joints", &Level::joints},
    Field{"scripts", &Level::scripts},
    Field{"tags", &Level::tags},
};

}  // namespace rubble
