#include "runtime/world/objects/object_errors.h"

#include <glm/geometric.hpp>

#include "runtime/core/range_check.h"
#include "runtime/core/ranges.h"

namespace rubble {
namespace {

std::string outlineError(const GroundPolygon& outline, bool isNeeded) {
    RangeCheck check;
    check.number("the number of points of the outline", double(outline.size()),
                 {isNeeded ? ranges::kOutlinePoints.low : 0.0, ranges::kOutlinePoints.high});
    for (const GroundPoint& point : outline) check.vector("outline", {point.x, 0.0, point.z}, ranges::kCoordinate);
    return check.error();
}

}  // namespace

std::string objectError(const Material& m) {
    return RangeCheck()
        .number("density", m.density, ranges::kDensity)
        .number("tensile_strength", double(m.tensileStrength), ranges::kMaterialStrength)
        .number("compressive_strength", double(m.compressiveStrength), ranges::kMaterialStrength)
        .number("shear_strength", double(m.shearStrength), ranges::kMaterialStrength)
        .number("friction", double(m.friction), ranges::kFriction)
        .number("restitution", double(m.restitution), ranges::kRestitution)
        .number("heat_capacity", double(m.heatCapacity), ranges::kHeatCapacity)
        .number("ignition_temperature", double(m.ignitionTemperature), ranges::kTemperature)
        .number("burn_time", double(m.burnTime), ranges::kBurnTime)
        .error();
}

std::string objectError(const PaletteEntry& entry) {
    return RangeCheck().number("emission", double(entry.emission), ranges::kEmission).error();
}

std::string objectError(const Body& body) {
    RangeCheck check;
    check.text("name", body.name)
        .pose("pose", body.pose)
        .vector("velocity", body.velocity, ranges::kVelocity)
        .vector("angular_velocity", body.angularVelocity, ranges::kVelocity)
        .number("gravity_scale", body.gravityScale, ranges::kGravityScale)
        .number("linear_damping", body.linearDamping, ranges::kDamping)
        .number("angular_damping", body.angularDamping, ranges::kDamping);
    for (const std::string& tag : body.tags) check.text("a tag", tag);
    return check.error();
}

std::string shapeError(const Pose& local, float voxelSize, float strength) {
    return RangeCheck()
        .pose("local", local)
        .number("voxel_size", double(voxelSize), ranges::kVoxelSize)
        .number("strength", double(strength), ranges::kStrength)
        .error();
}

std::string factorsError(float density, float emission) {
    return RangeCheck()
        .number("density", double(density), ranges::kDensityFactor)
        .number("emission", double(emission), ranges::kEmissionFactor)
        .error();
}

std::string objectError(const Shape& shape) {
    RangeCheck check;
    check.text("name", shape.name)
        .include(shapeError(shape.local, shape.voxelSize, shape.strength))
        .include(factorsError(shape.density, shape.emission));
    for (const std::string& tag : shape.tags) check.text("a tag", tag);
    return check.error();
}

std::string objectError(const Light& light) {
    return lightError(light);
}

std::string objectError(const LightGroup& group) {
    return RangeCheck()
        .text("name", group.name)
        .text("supply_shape", group.supplyShape)
        .number("threshold", double(group.threshold), ranges::kThreshold)
        .error();
}

std::string objectError(const Water& water) {
    return RangeCheck()
        .text("name", water.name)
        .include(outlineError(water.outline, true))
        .number("surface_height", water.surface, ranges::kWaterSurface)
        .number("depth", water.depth, ranges::kWaterDepth)
        .number("density", water.density, ranges::kWaterDensity)
        .number("linear_drag", water.linearDrag, ranges::kWaterDrag)
        .number("angular_drag", water.angularDrag, ranges::kWaterDrag)
        .vector("flow", water.flow, ranges::kWaterFlow)
        .vector("color", water.color, ranges::kShare)
        .number("clarity", double(water.clarity), ranges::kClarity)
        .number("the height of the waves", double(water.waves.height), ranges::kWaves)
        .number("the length of the waves", double(water.waves.length), ranges::kWaves)
        .number("the speed of the waves", double(water.waves.speed), ranges::kWaveMotion)
        .number("the direction of the waves", double(water.waves.direction), ranges::kWaveMotion)
        .error();
}

std::string objectError(const Trigger& trigger) {
    RangeCheck check;
    check.number("kind", double(trigger.kind), {0.0, double(TriggerKind::Polygon)}).pose("pose", trigger.pose);
    check.number("radius", trigger.radius, ranges::kTriggerSize)
        .vector("half_size", trigger.halfSize, ranges::kTriggerSize)
        .number("height", trigger.height, ranges::kTriggerSize);
    check.include(outlineError(trigger.outline, trigger.kind == TriggerKind::Polygon)).text("name", trigger.name);
    for (const std::string& tag : trigger.tags) check.text("a tag", tag);
    return check.error();
}

std::string objectError(const WorldBox& box) {
    return RangeCheck()
        .vector("low", box.low, ranges::kPlace)
        .vector("high", box.high, ranges::kPlace)
        .require(box.low == box.high || glm::all(glm::lessThan(box.low, box.high)),
                 "low and high: expected low below high along each axis, or both equal")
        .error();
}

std::string characterVelocityError(const char* name, const glm::dvec3& velocity) {
    return RangeCheck().number(name, glm::length(velocity), {0.0, ranges::kMaxCharacterSpeed}).error();
}

std::string objectError(const Character& c) {
    return RangeCheck()
        .text("name", c.name)
        .number("radius", c.radius, ranges::kCharacterRadius)
        .number("height", c.height, {2.0 * c.radius, ranges::kMaxCharacterHeight})
        .number("crouched_height", c.crouchedHeight, {2.0 * c.radius, c.height})
        .number("step_height", c.stepHeight, {0.0, c.height})
        .number("max_slope", c.maxSlope, ranges::kSlope)
        .number("mass", c.mass, ranges::kCharacterMass)
        .number("walk_speed", c.walkSpeed, ranges::kCharacterSpeed)
        .number("crouch_speed", c.crouchSpeed, ranges::kCharacterSpeed)
        .number("jump_speed", c.jumpSpeed, ranges::kCharacterSpeed)
        .number("swim_speed", c.swimSpeed, ranges::kCharacterSpeed)
        .number("max_push_force", c.maxPushForce, ranges::kForce)
        .include(characterVelocityError("desired_velocity", c.wish))
        .vector("position", c.position, ranges::kPlace)
        .include(characterVelocityError("velocity", c.velocity))
        .include(characterVelocityError("ground_velocity", c.groundVelocity))
        .error();
}

std::string nameError(const char* what, std::string_view text) {
    const std::string error = RangeCheck().text(what, text).error();
    if (!error.empty() || text.size() <= size_t(ranges::kNameBytes.high)) return error;
    return std::string(what) + " has " + std::to_string(text.size()) + " bytes, expected at most " +
           std::to_string(size_t(ranges::kNameBytes.high));
}

std::string tagError(std::string_view tag) {
    return RangeCheck()
        .include(nameError("tag", tag))
        .require(!tag.empty() && tag.find('=') == tag.npos, "tag: expected a name of at least one byte, without \"=\"")
        .error();
}

std::string objectError(const Note& note) {
    RangeCheck check;
    check.include(nameError("name", note.name));
    for (const std::string& tag : note.tags) check.text("a tag", tag);  // of a level they may be any text
    return check.error();
}

std::string objectError(const Joint& joint) {
    return RangeCheck().text("name", joint.name).include(jointError(joint)).error();
}

}  // namespace rubble
