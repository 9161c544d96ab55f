#include "runtime/world/edits/edit_error.h"

#include <algorithm>
#include <glm/vector_relational.hpp>

#include "runtime/core/range_check.h"
#include "runtime/core/ranges.h"
#include "runtime/destruction/fragment_style.h"
#include "runtime/world/objects/object_errors.h"
#include "runtime/world/settings/settings_error.h"

namespace rubble {
namespace {

/// Names of the kinds, in the order of AnyEdit.
constexpr const char* kNames[] = {"carve",
                                  "explode",
                                  "paint",
                                  "apply_impulse",
                                  "set_settings",
                                  "undo",
                                  "heat",
                                  "extinguish",
                                  "remove_fires",
                                  "break_voxels",
                                  "split_shape",
                                  "merge_shape",
                                  "trim_shape",
                                  "resize_shape",
                                  "impact load",
                                  "set_collision_filter",
                                  "add_water",
                                  "remove_water",
                                  "add_trigger",
                                  "remove_trigger",
                                  "add_character",
                                  "remove_character",
                                  "move_character",
                                  "teleport_character",
                                  "add_joint",
                                  "remove_joint",
                                  "set_joint_motor",
                                  "detach_joint",
                                  "grab_body",
                                  "release_body",
                                  "drive_wheels",
                                  "set_environment",
                                  "set_light",
                                  "add_light",
                                  "remove_light",
                                  "set_bounds",
                                  "set_collision_shape",
                                  "set_body",
                                  "destroy_body",
                                  "write_voxels",
                                  "destroy_shape",
                                  "create_body",
                                  "create_shape",
                                  "set_name",
                                  "set_tag",
                                  "remove_tag",
                                  "set_user_value",
                                  "set_palette",
                                  "set_materials",
                                  "set_shape",
                                  "set_light_group",
                                  "create_light_group",
                                  "constrain_bodies",
                                  "set_level_scripts"};
static_assert(std::size(kNames) == std::variant_size_v<AnyEdit>);

/// About a number of an enum whose last is `last`.
template <class Enum>
RangeCheck checkEnum(const char* name, Enum value, Enum last) {
    return RangeCheck().number(name, double(value), {0.0, double(last)});
}

RangeCheck checkRadii(const std::array<double, 3>& radii) {
    RangeCheck check;
    for (const double radius : radii) check.number("radii", radius, ranges::kBrushRadius);
    return check.require(radii[0] >= radii[1] && radii[1] >= radii[2], "radii grow, expected soft >= medium >= hard");
}

/// Edits of handles and flags alone have nothing to check.
template <class T>
std::string errorOf(const T&) {
    return "";
}
std::string errorOf(const CarveEdit& edit) {
    RangeCheck check = checkEnum("brush", edit.kind, BrushKind::Capsule);
    check.include(checkEnum("tool", edit.tool, Tool::Explosive).error())
        .include(checkEnum("max_hardness", edit.maxHardness, Hardness::Unphysical).error())
        .vector("position", edit.position, ranges::kCoordinate);
    if (edit.kind == BrushKind::Box)
        return check.vector("half_size", edit.halfSize, ranges::kBrushRadius)
            .rotation("rotation", edit.rotation)
            .error();
    return check.vector("end", edit.end, ranges::kCoordinate).include(checkRadii(edit.radii).error()).error();
}
std::string errorOf(const BreakEdit& edit) {
    return checkEnum("tool", edit.tool, Tool::Explosive)
        .vector("position", edit.position, ranges::kCoordinate)
        .include(checkRadii(edit.radii).error())
        .error();
}
std::string errorOf(const ExplodeEdit& edit) {
    return RangeCheck()
        .vector("position", edit.position, ranges::kCoordinate)
        .number("size", edit.size, ranges::kExplosionSize)
        .number("impulse", edit.impulse, ranges::kBlast)
        .error();
}
std::string errorOf(const PaintEdit& edit) {
    return checkEnum("mode", edit.mode, PaintMode::Layer)
        .vector("position", edit.position, ranges::kCoordinate)
        .vector("end", edit.end, ranges::kCoordinate)
        .number("radius", edit.radius, ranges::kPaintRadius)
        .error();
}
std::string errorOf(const ImpulseEdit& edit) {
    return RangeCheck()
        .vector("position", edit.position, ranges::kCoordinate)
        .vector("impulse", edit.impulse, ranges::kImpulse)
        .error();
}
std::string errorOf(const ImpactLoadEdit& edit) {
    return RangeCheck()
        .vector("position", edit.position, ranges::kCoordinate)
        .vector("impulse", edit.impulse, ranges::kImpulse)
        .error();
}
std::string errorOf(const SettingsEdit& edit) {
    return settingsError(edit.settings);
}
std::string errorOf(const SetBoundsEdit& edit) {
    return boundsError(edit.bounds);
}
std::string errorOf(const SetCollisionShapeEdit& edit) {
    return checkEnum("kind", edit.kind, CollisionShape::CylinderZ).error();
}
std::string errorOf(const SetBodyEdit& edit) {
    RangeCheck check;
    if (edit.setsPose) check.pose("pose", edit.pose);
    if (edit.setsVelocity)
        check.vector("velocity", edit.velocity, ranges::kVelocity)
            .vector("angular_velocity", edit.angularVelocity, ranges::kVelocity);
    if (edit.setsGravityScale) check.number("gravity_scale", edit.gravityScale, ranges::kGravityScale);
    if (edit.setsDamping)
        check.number("linear_damping", edit.linearDamping, ranges::kDamping)
            .number("angular_damping", edit.angularDamping, ranges::kDamping);
    return check.error();
}
std::string errorOf(const WriteVoxelsEdit& edit) {
    RangeCheck check;
    uint64_t cells = 1;
    for (int a = 0; a < 3; ++a) {
        check.number("low", edit.box.low[a], {0, kMaxGridSize}).number("high", edit.box.high[a], {1, kMaxGridSize});
        cells *= uint64_t(std::max<int64_t>(0, int64_t(edit.box.high[a]) - edit.box.low[a]));
    }
    return check.require(cells && cells == edit.entries.size(), "expected a byte for each cell of a box")
        .require(edit.mask.empty() || edit.mask.size() == cells, "expected a mask of a byte for each cell of a box")
        .error();
}
std::string errorOf(const CreateBodyEdit& edit) {
    return objectError(edit.body);
}
/// About the paint of a grid: its colours are numbered from 1.
std::string paintError(const VoxelGrid& grid, const PaintColorsRef& colors) {
    const int count = colors ? colors->count : 0;
    int highest = 0;
    grid.forEachBrick(
        [&](glm::ivec3, const BrickRef& brick) { highest = std::max(highest, highestPaintColor(*brick)); });
    return RangeCheck().number("paint", highest, {0.0, double(count)}).error();
}
std::string errorOf(const CreateShapeEdit& edit) {
    const LevelShape& shape = edit.shape;
    RangeCheck check = checkEnum("source", edit.source, ShapeSource::Copy);
    const bool keepsSize = edit.source == ShapeSource::Copy && shape.voxelSize == 0.0f;
    check.text("name", shape.name)
        .include(shapeError(shape.local, keepsSize ? 1.0f : shape.voxelSize, shape.strength))
        .include(factorsError(shape.density, shape.emission))
        .include(checkEnum("collision_shape", shape.collisionShape, CollisionShape::CylinderZ).error())
        .include(paintError(shape.grid, shape.paintColors));
    if (shape.palette)
        for (const PaletteEntry& entry : *shape.palette)
            if (!isWithin(double(entry.emission), ranges::kEmission)) check.include(objectError(entry));
    for (const std::string& tag : shape.tags) check.text("a tag", tag);
    if (edit.source == ShapeSource::Copy) return check.error();
    const glm::ivec3 size = edit.source == ShapeSource::Grid ? shape.grid.size() : edit.size;
    for (int a = 0; a < 3; ++a) check.number("size", size[a], {1, kMaxGridSize});
    if (edit.source == ShapeSource::Grid || !check.error().empty()) return check.error();
    return check.number("cells", double(size.x) * double(size.y) * double(size.z), ranges::kSolidCells)
        .number("index", edit.entry, {1, 255})
        .error();
}
std::string errorOf(const HeatEdit& edit) {
    return RangeCheck()
        .vector("position", edit.position, ranges::kCoordinate)
        .number("radius", edit.radius, ranges::kHeatRadius)
        .number("joules", edit.joules, ranges::kHeat)
        .error();
}
std::string errorOf(const ExtinguishEdit& edit) {
    return RangeCheck()
        .vector("position", edit.position, ranges::kCoordinate)
        .number("radius", edit.radius, ranges::kHeatRadius)
        .number("wet_seconds", edit.wetSeconds, ranges::kWetSeconds)
        .error();
}
std::string errorOf(const RemoveFiresEdit& edit) {
    return RangeCheck()
        .vector("low", edit.low, ranges::kCoordinate)
        .vector("high", edit.high, ranges::kCoordinate)
        .error();
}
std::string errorOf(const AddWaterEdit& edit) {
    return objectError(edit.water);
}
std::string errorOf(const AddTriggerEdit& edit) {
    return objectError(edit.trigger);
}
std::string errorOf(const AddCharacterEdit& edit) {
    return objectError(edit.character);
}
std::string errorOf(const MoveCharacterEdit& edit) {
    return characterVelocityError("desired_velocity", edit.wish);
}
std::string errorOf(const TeleportCharacterEdit& edit) {
    return RangeCheck()
        .vector("position", edit.position, ranges::kCoordinate)
        .include(characterVelocityError("velocity", edit.velocity))
        .error();
}
std::string errorOf(const AddJointEdit& edit) {
    return objectError(edit.joint);
}
std::string errorOf(const RemoveJointEdit& edit) {
    return RangeCheck().vector("place", edit.place, ranges::kCoordinate).error();
}
std::string errorOf(const SetJointMotorEdit& edit) {
    return checkEnum("motor", edit.motor.mode, MotorMode::Position)
        .number("motor_target", edit.motor.target, ranges::kJointTarget)
        .number("motor_max_force", edit.motor.maxForce, ranges::kJointNumber)
        .number("friction", edit.friction, ranges::kJointNumber)
        .number("steer_angle", edit.steer, ranges::kSteer)
        .error();
}
std::string errorOf(const GrabEdit& edit) {
    return RangeCheck()
        .vector("point", edit.point, ranges::kCoordinate)
        .vector("target", edit.target, ranges::kCoordinate)
        .number("max_force", edit.maxForce, ranges::kForce)
        .number("spring_hertz", edit.hertz, ranges::kGrabHertz)
        .number("hand", edit.hand, ranges::kHand)
        .rotation("rotation", edit.rotation)
        .number("max_torque", edit.maxTorque, ranges::kForce)
        .vector("velocity", edit.velocity, ranges::kVelocity)
        .vector("angular_velocity", edit.angularVelocity, ranges::kVelocity)
        .error();
}
std::string errorOf(const ConstrainEdit& edit) {
    const BodyConstraint& constraint = edit.constraint;
    return RangeCheck()
        .vector("position", constraint.position, ranges::kCoordinate)
        .vector("direction", constraint.direction, ranges::kCoordinate)
        .number("speed", constraint.speed, ranges::kVelocity)
        .number("min_force", constraint.minForce, ranges::kConstraintForce)
        .number("max_force", constraint.maxForce, ranges::kConstraintForce)
        .require(constraint.direction != glm::dvec3(0.0), "direction is zero, expected any other length")
        .require(constraint.minForce <= constraint.maxForce, "min_force is above max_force")
        .error();
}
std::string errorOf(const ReleaseEdit& edit) {
    return RangeCheck()
        .vector("impulse", edit.impulse, ranges::kImpulse)
        .number("hand", edit.hand, ranges::kHand)
        .error();
}
std::string errorOf(const DriveEdit& edit) {
    return RangeCheck()
        .number("throttle", edit.throttle, ranges::kLever)
        .number("steer", edit.steer, ranges::kLever)
        .number("brake", edit.brake, ranges::kPedal)
        .error();
}
std::string errorOf(const SetNameEdit& edit) {
    return nameError("name", edit.name);
}
std::string errorOf(const SetTagEdit& edit) {
    const std::string error = tagError(edit.tag);
    return error.empty() ? nameError("value", edit.value) : error;
}
std::string errorOf(const RemoveTagEdit& edit) {
    return tagError(edit.tag);
}
std::string errorOf(const SetScriptsEdit& edit) {
    RangeCheck check;
    check.number("count", double(edit.scripts.size()), ranges::kScripts);
    for (const LevelScript& script : edit.scripts)
        check.include(nameError("path", script.path))
            .require(!script.path.empty(), "path: expected one of at least one byte")
            .text("parameters", script.parameters)
            .number("bytes of parameters", double(script.parameters.size()), ranges::kParameterBytes);
    return check.error();
}
std::string errorOf(const SetPaletteEdit& edit) {
    RangeCheck check;
    check.number("first", edit.first, {1, 255})
        .number("count", double(edit.entries.size()), {1.0, 256.0 - edit.first})
        .require(std::all_of(edit.entries.begin(), edit.entries.end(),
                             [](const PaletteEntry& entry) { return objectError(entry).empty(); }),
                 "emission: expected 0 to 1e6 of each entry");
    return check.error();
}
std::string errorOf(const SetMaterialsEdit& edit) {
    RangeCheck check;
    check.number("first", edit.first, {1, 255})
        .number("count", double(edit.materials.size()), {1.0, 256.0 - edit.first});
    for (const Material& material : edit.materials)
        check.include(nameError("name", material.name))
            .require(!material.name.empty(), "name: expected one of at least one byte")
            .include(checkEnum("hardness", material.hardness, Hardness::Unphysical).error())
            .include(objectError(material))
            .require(fragmentStyle(material.fragments).name == material.fragments,
                     "fragments: expected chunk, bond, splinter, pane, tear, crumble or none");
    return check.error();
}
std::string errorOf(const SetShapeEdit& edit) {
    RangeCheck check;
    check.number("strength", double(edit.strength), ranges::kStrength)
        .include(factorsError(edit.density, edit.emission))
        .number("anchor_count", double(edit.anchors.size()), ranges::kAnchors);
    constexpr NumberRange kCell{-kMaxGridSize, 2.0 * kMaxGridSize};
    for (const CellBox& anchor : edit.anchors)
        check.vector("anchors", anchor.low, kCell)
            .vector("anchors", anchor.high, kCell)
            .require(glm::all(glm::lessThan(anchor.low, anchor.high)), "anchors: expected boxes of at least one cell");
    return check.error();
}
std::string errorOf(const CreateLightGroupEdit& edit) {
    return objectError(edit.group);
}
std::string errorOf(const SetLightGroupEdit& edit) {
    RangeCheck check;
    check.number("threshold", double(edit.threshold), ranges::kThreshold);
    if (edit.setsSupply) check.vector("supply_cell", edit.supplyCell, {-double(kMaxGridSize), double(kMaxGridSize)});
    return check.error();
}
std::string errorOf(const SetEnvironmentEdit& edit) {
    return environmentError(edit.environment);
}
std::string errorOf(const SetLightEdit& edit) {
    return objectError(edit.values);
}
std::string errorOf(const AddLightEdit& edit) {
    return objectError(edit.light);
}

}  // namespace

std::string editError(const Edit& edit) {
    return std::visit([](const auto& each) { return errorOf(each); }, static_cast<const AnyEdit&>(edit));
}

const char* editName(const Edit& edit) {
    return kNames[edit.index()];
}

}  // namespace rubble
