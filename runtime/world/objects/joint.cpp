#include "runtime/world/objects/joint.h"

#include <utility>

#include "runtime/core/hash.h"
#include "runtime/core/range_check.h"
#include "runtime/core/ranges.h"

namespace rubble {
namespace {

uint64_t hashPose(const Pose& pose, uint64_t seed) {
    return hashBytes(&pose.rotation, sizeof pose.rotation, hashBytes(&pose.position, sizeof pose.position, seed));
}

/// About the angles that a hinge or cone can have.
std::string jointAngleError(const Joint& joint) {
    RangeCheck check;
    if (joint.kind == JointKind::Hinge && joint.limits.on)
        check.number("lower_limit", joint.limits.low, ranges::kHingeAngle)
            .number("upper_limit", joint.limits.high, ranges::kHingeAngle);
    if (joint.kind == JointKind::Cone) check.number("upper_limit", joint.limits.high, ranges::kConeLimit);
    return check.include(jointMotorError(joint.kind, joint.motor)).error();
}

}  // namespace

std::string jointMotorError(JointKind kind, const JointMotor& motor) {
    if (kind != JointKind::Hinge || motor.mode != MotorMode::Position) return "";
    return RangeCheck().number("motor_target", motor.target, ranges::kHingeAngle).error();
}

std::string jointError(const Joint& joint) {
    RangeCheck check;
    for (const JointEnd& end : joint.ends)
        check.vector("the position of an end", end.frame.position, ranges::kPlace)
            .rotation("the rotation of an end", end.frame.rotation)
            .number("anchor_radius", end.radius, ranges::kAnchorRadius);
    check.text("name", joint.name)
        .number("kind", double(joint.kind), {0.0, double(JointKind::Wheel)})
        .number("lower_limit", joint.limits.low, ranges::kJointTarget)
        .number("upper_limit", joint.limits.high, {joint.limits.low, ranges::kJointTarget.high})
        .number("motor", double(joint.motor.mode), {0.0, double(MotorMode::Position)})
        .number("motor_target", joint.motor.target, ranges::kJointTarget)
        .number("steer", joint.steer, ranges::kSteer)
        .number("steer_target", joint.steerTarget, ranges::kSteer)
        .number("max_spin", joint.wheel.maxSpin, ranges::kWheelSpin)
        .number("max_steer_angle", joint.wheel.steerAngle, ranges::kSteerAngle)
        .number("steer_rate", joint.wheel.steerRate, ranges::kSteerRate)
        .number("rope_radius", joint.rope.radius, ranges::kRopeRadius)
        .number("rope_mass", joint.rope.massPerMetre, ranges::kRopeMass)
        .vector("velocity", joint.velocity, ranges::kVelocity)
        .vector("angular_velocity", joint.angularVelocity, ranges::kVelocity);
    const std::pair<const char*, double> numbers[] = {{"motor_max_force", joint.motor.maxForce},
                                                      {"spring_hertz", joint.spring.hertz},
                                                      {"spring_damping_ratio", joint.spring.dampingRatio},
                                                      {"friction", joint.friction},
                                                      {"max_force", joint.maxForce},
                                                      {"max_torque", joint.maxTorque},
                                                      {"break_force", joint.breakForce},
                                                      {"break_torque", joint.breakTorque},
                                                      {"rope_length", joint.rope.length},
                                                      {"rope_slack", joint.rope.slack},
                                                      {"rope_stretch", joint.rope.stretch},
                                                      {"rope_strength", joint.rope.strength},
                                                      {"drive_torque", joint.wheel.driveTorque},
                                                      {"brake_torque", joint.wheel.brakeTorque}};
    for (const auto& [name, number] : numbers) check.number(name, number, ranges::kJointNumber);
    check.include(jointAngleError(joint));
    if (joint.kind != JointKind::Rope) return check.require(joint.points.empty(), "only ropes have points").error();
    const bool isAutomatic = joint.rope.points == 0 && joint.points.empty();
    check.number("rope_points", isAutomatic ? ranges::kRopePoints.low : joint.rope.points, ranges::kRopePoints)
        .require(joint.points.empty() || joint.points.size() == joint.rope.points,
                 "a rope has another number of points than it says");
    for (const RopePoint& point : joint.points)
        check.vector("a point of a rope", point.position, ranges::kPlace)
            .vector("the velocity of a rope's point", point.velocity, ranges::kJointTarget);
    return check.error();
}

std::string jointEndsError(const Joint& joint) {
    const auto& [first, second] = joint.ends;
    if (joint.hand && (joint.kind == JointKind::Rope || !first.shape || second.shape))
        return "a grab is no rope, and holds a shape by its first end and the world by its second";
    if (joint.drives && !joint.hand) return "only grabs hold velocities";
    if (joint.kind == JointKind::Rope) return "";
    if (!first.shape && !second.shape) return "neither end is on a shape";
    return first.isFree || second.isFree ? "only the ends of ropes hang free" : "";
}

uint64_t hashJoint(const Joint& joint, uint64_t seed) {
    uint64_t hash = hashValue(
        uint64_t(joint.kind) << 40 | uint64_t(joint.drives) << 33 | uint64_t(joint.collides) << 32 | joint.hand, seed);
    for (const JointEnd& end : joint.ends) {
        hash = hashValue(uint64_t(end.isFree) << 33 | uint64_t(bool(end.shape)) << 32 | end.shape.slot(), hash);
        hash = hashValue(end.radius, hashBytes(&end.cell, sizeof end.cell, hashPose(end.frame, hash)));
    }
    for (const double value :
         {joint.limits.low, joint.limits.high, joint.motor.target, joint.motor.maxForce, joint.spring.hertz,
          joint.spring.dampingRatio, joint.friction, joint.maxForce, joint.maxTorque, joint.breakForce,
          joint.breakTorque, joint.steer, joint.steerTarget, joint.rope.length, joint.rope.radius,
          joint.rope.massPerMetre, joint.rope.stretch, joint.rope.strength, joint.rope.slack})
        hash = hashValue(value, hash);
    static_assert(sizeof(WheelSettings) == 5 * sizeof(double), "hashed as bytes");
    hash = hashBytes(&joint.wheel, sizeof joint.wheel, hash);
    for (const glm::dvec3& velocity : {joint.velocity, joint.angularVelocity})
        hash = hashBytes(&velocity, sizeof velocity, hash);
    return hashValue(uint64_t(joint.rope.points) << 16 | uint64_t(joint.limits.on) << 8 | uint64_t(joint.motor.mode),
                     hash);
}

uint64_t hashRopePoints(const Joint& joint, uint64_t seed) {
    return joint.points.empty() ? seed : hashBytes(joint.points.data(), joint.points.size() * sizeof(RopePoint), seed);
}

}  // namespace rubble
