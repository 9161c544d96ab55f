#include "runtime/world/objects/joint.h"

#include <cmath>

#include "runtime/core/hash.h"
#include "runtime/core/number_range.h"

namespace rubble {
namespace {

constexpr double kMaxNumber = 1e12;  ///< of all numbers of a joint

uint64_t hashPose(const Pose& pose, uint64_t seed) {
    return hashBytes(&pose.rotation, sizeof pose.rotation, hashBytes(&pose.position, sizeof pose.position, seed));
}

}  // namespace

std::string jointError(const Joint& joint) {
    for (const JointEnd& end : joint.ends) {
        const glm::dquat& q = end.frame.rotation;
        const double length2 = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
        if (!isWithin(end.frame.position, kMaxNumber)) return "the place of an end is no finite number";
        if (!isWithin(length2, 0.998, 1.002)) return "the rotation of an end is not of length 1";
        if (!isWithin(end.radius, 0.0, 100.0)) return "the radius of an end is not from 0 to 100 m";
    }
    if (!isWithin(joint.limits.low, -kMaxNumber, kMaxNumber) ||
        !isWithin(joint.limits.high, joint.limits.low, kMaxNumber))
        return "its lower limit is above its upper one";
    if (!isWithin(joint.motor.target, -kMaxNumber, kMaxNumber) || !isWithin(joint.steer, -kMaxNumber, kMaxNumber))
        return "its target is no finite number";
    for (const double value : {joint.motor.maxForce, joint.spring.hertz, joint.spring.dampingRatio, joint.friction,
                               joint.maxForce, joint.breakForce, joint.breakTorque, joint.rope.length, joint.rope.slack,
                               joint.rope.stretch, joint.rope.strength, joint.wheel.driveTorque, joint.wheel.maxSpin,
                               joint.wheel.brakeTorque, joint.wheel.steerAngle, joint.wheel.steerRate})
        if (!isWithin(value, 0.0, kMaxNumber)) return "a force, length or rate is not 0 or more";
    if (joint.kind != JointKind::Rope) return joint.points.empty() ? "" : "only ropes have points";
    if (joint.rope.points == 1 || joint.rope.points > kMaxRopePoints) return "a rope has 2 to 256 points";
    if (!joint.points.empty() && joint.points.size() != joint.rope.points)
        return "a rope has as many points as it says";
    if (!isWithin(joint.rope.radius, 1e-4, 10.0) || !isWithin(joint.rope.massPerMetre, 1e-4, 1e6))
        return "a rope has a radius and a mass";
    for (const RopePoint& point : joint.points)
        if (!isWithin(point.position, kMaxNumber) || !isWithin(point.velocity, kMaxNumber))
            return "a point of a rope is no finite number";
    return "";
}

std::string jointEndsError(const Joint& joint) {
    const auto& [first, second] = joint.ends;
    if (joint.hand && (joint.kind == JointKind::Rope || !first.shape || second.shape))
        return "a grab is no rope, and holds a shape by its first end and the world by its second";
    if (joint.kind == JointKind::Rope) return "";
    if (!first.shape && !second.shape) return "neither end is on a shape";
    return first.isFree || second.isFree ? "only the ends of ropes hang free" : "";
}

uint64_t hashJoint(const Joint& joint, uint64_t seed) {
    uint64_t hash = hashValue(uint64_t(joint.kind) << 40 | uint64_t(joint.collides) << 32 | joint.hand, seed);
    for (const JointEnd& end : joint.ends) {
        hash = hashValue(uint64_t(end.isFree) << 33 | uint64_t(bool(end.shape)) << 32 | end.shape.slot(), hash);
        hash = hashBytes(&end.cell, sizeof end.cell, hashPose(end.frame, hash));
    }
    for (const double value :
         {joint.limits.low, joint.limits.high, joint.motor.target, joint.motor.maxForce, joint.spring.hertz,
          joint.spring.dampingRatio, joint.friction, joint.maxForce, joint.breakForce, joint.breakTorque, joint.steer,
          joint.rope.length, joint.rope.radius, joint.rope.massPerMetre, joint.rope.stretch, joint.rope.strength})
        hash = hashValue(value, hash);
    static_assert(sizeof(WheelSettings) == 5 * sizeof(double), "hashed as bytes");
    hash = hashBytes(&joint.wheel, sizeof joint.wheel, hash);
    return hashValue(uint64_t(joint.rope.points) << 16 | uint64_t(joint.limits.on) << 8 | uint64_t(joint.motor.mode),
                     hash);
}

uint64_t hashRopePoints(const Joint& joint, uint64_t seed) {
    return joint.points.empty() ? seed : hashBytes(joint.points.data(), joint.points.size() * sizeof(RopePoint), seed);
}

}  // namespace rubble
