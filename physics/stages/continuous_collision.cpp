#include "physics/stages/continuous_collision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "physics/collision/time_of_impact.h"
#include "runtime/core/rotated_box.h"

// The solver keeps bodies apart along the path that they were about to take: contacts are searched along it, before the
// solve. A hit sends a body elsewhere, where nothing was searched, and many hits at once are not solved to the end. So
// what has moved far, and not as it was about to, is swept once more, from where it was to where it is now (Catto,
// "Continuous Collision", GDC 2013). A body that entered something is put back to that moment and loses the rest of the
// step. What it is joined to stops with it, and so does what would have come to where it stands: the wall of a box that
// flies would pass the cube in it. Stops are taken in the order of time, so that each is found once.

namespace rubble {
namespace {

constexpr double kMinDisplacement = 1.0;  ///< voxels that a body moves in a step in which it may be swept
constexpr double kFarDisplacement = 2.0;  ///< voxels that a body moves in a step in which it is always swept
constexpr double kMaxDeviation = 1.0;     ///< voxels from its expected path from which it is swept
/// Voxels from where it would be by itself, from which a body is swept against what it may be in, or have inside.
constexpr double kMinDeparture = 0.25;
constexpr double kMaxBend = 0.1;          ///< voxels from the line between its ends that a path counts as straight
constexpr double kMaxEnergyError = 1e-3;  ///< share of the energy up to which a body counts as turning freely
constexpr double kNoStop = 2.0;           ///< a fraction of the step
constexpr double kNoProgress = 0.1;       ///< share of its step up to which a body counts as held where it was
/// Steps in a row for which a body may be held. After them it is in a jam of things that move and cannot give way: it
/// goes on for some steps, and they overlap, or a crumb under a wheel would stop a car.
constexpr int kMaxHeld = 2, kFreeSteps = 30;
/// Steps in a row without progress after which a body passes what may be in it, as a crumb between chassis and ground.
/// What is in a box does not leave it by that: it is swept against the box as well, and passes only if it is stuck too.
constexpr int kMaxStuckSteps = 4;
/// Voxels by which a body that is stopped overlaps what it met: the next step sees the overlap as a contact, and does
/// not stop the body there again.
constexpr double kOverlap = 0.02;

/// An upper bound of how far a point of the body moves between two poses, metres.
double displacement(const Pose& from, const Pose& to, double radius) {
    return glm::length(to.position - from.position) + radius * largestAngle(from.rotation, to.rotation);
}
/// The round surface that a body of one part is touched as; null: it is touched as voxels.
const RoundSurface* roundOf(const DynamicBody& body) {
    const auto& parts = body.object.collider.parts;
    return parts.size() == 1 ? parts[0]->round() : nullptr;
}
/// The shortest rotation from one unit vector to another; none between opposite ones.
glm::dquat shortestArc(const glm::dvec3& from, const glm::dvec3& to) {
    const double cosine = glm::dot(from, to);
    if (cosine < -0.999) return {1.0, 0.0, 0.0, 0.0};
    return glm::normalize(glm::dquat(1.0 + cosine, glm::cross(from, to)));
}
/// Where a round body ends without the spin about its axis, which does not move its surface.
Pose endWithoutSpin(const DynamicBody& body, const RoundSurface& round) {
    const Pose &from = body.stepPath.front(), &to = body.stepPath.back();
    const glm::dvec3 axis = body.object.collider.parts[0]->frame().rotation * glm::dvec3(round.direction());
    if (axis == glm::dvec3(0.0)) return {to.position, from.rotation};  // a sphere
    return {to.position, shortestArc(from.rotation * axis, to.rotation * axis) * from.rotation};
}
/// The ends of the body's path if it is almost straight, else all of it.
SweptPose simplified(const DynamicBody& body, std::array<Pose, 2>& ends) {
    const SweptPose whole{body.stepPath};
    ends = {body.stepPath.front(), body.stepPath.back()};
    if (const RoundSurface* round = roundOf(body)) return ends[1] = endWithoutSpin(body, *round), SweptPose{ends};
    const double tolerance = kMaxBend * body.object.smallestVoxel;
    for (size_t i = 1; i + 1 < body.stepPath.size(); ++i) {
        const Pose straight = SweptPose{ends}.at(double(i) / double(body.stepPath.size() - 1));
        if (displacement(straight, body.stepPath[i], body.object.radius) > tolerance) return whole;
    }
    return {ends};
}
/// An upper bound of how far a point of the body leaves the lines between the poses of a path, metres.
double sagittaOf(const SweptPose& path, double radius) {
    double angle = 0.0;
    for (size_t i = 0; i + 1 < path.poses.size(); ++i)
        angle = std::max(angle, largestAngle(path.poses[i].rotation, path.poses[i + 1].rotation));
    return radius * std::min(0.125 * angle * angle, 1.0);
}
/// Whether an object is a body that is awake.
bool isMoving(const CollisionObject& object) {
    return object.dynamic && !object.dynamic->asleep();
}
/// The path of an object in this step.
SweptPose pathOf(const CollisionObject& object, std::array<Pose, 2>& ends) {
    if (isMoving(object)) return simplified(*object.dynamic, ends);
    ends.fill(object.pose);
    return {ends};
}
double displacementOf(const DynamicBody& body) {
    double sum = 0.0;
    if (const RoundSurface* round = roundOf(body))
        return displacement(body.stepPath.front(), endWithoutSpin(body, *round), body.object.radius);
    for (size_t i = 0; i + 1 < body.stepPath.size(); ++i)
        sum += displacement(body.stepPath[i], body.stepPath[i + 1], body.object.radius);
    return sum;
}

/// An upper bound of how far a point of the body is from where the search for contacts expected it in the step, metres:
/// on a straight line, of which it may have gone a part.
double deviationOf(const DynamicBody& body, double seconds) {
    const SolverBody& start = body.stepStart;
    const Pose &from = body.stepPath.front(), &to = body.stepPath.back();
    const double radius = body.object.radius;
    const glm::dvec3 expected = start.velocity * seconds, went = to.position - from.position,
                     expectedTurn = start.angularVelocity * seconds;
    const glm::dquat turn = to.rotation * glm::conjugate(from.rotation);
    const glm::dvec3 turned = 2.0 * (turn.w < 0.0 ? -1.0 : 1.0) * glm::dvec3(turn.x, turn.y, turn.z);
    const double length2 = glm::dot(expected, expected) + radius * radius * glm::dot(expectedTurn, expectedTurn);
    const double part =
        length2 > 0.0
            ? std::clamp((glm::dot(went, expected) + radius * radius * glm::dot(turned, expectedTurn)) / length2, 0.0,
                         1.0)
            : 0.0;
    // A chord is not the arc.
    const double sagitta = 0.5 * radius * glm::dot(expectedTurn, expectedTurn);
    return glm::length(went - expected * part) + radius * glm::length(turned - expectedTurn * part) + sagitta;
}

/// Puts a body's rotation back. What has turned freely since had the same angular momentum and the same energy. If
/// these two do not agree, something has hit it since: then the angular velocity turns with the body, which keeps the
/// energy.
void turnBack(SolverBody& body, const glm::dquat& rotation) {
    const glm::dvec3 momentum = angularMomentum(body),
                     turned = rotation * glm::conjugate(body.rotation) * body.angularVelocity;
    const double energy = glm::dot(momentum, body.angularVelocity);
    body.rotation = rotation;
    if (!body.conservesMomentum) return;
    body.angularVelocity = worldInverseInertia(body) * momentum;
    const double now = glm::dot(momentum, body.angularVelocity);
    if (std::abs(now - energy) > kMaxEnergyError * energy) body.angularVelocity = turned;
}

/// Whether something may be inside of the body.
bool hasGaps(const CollisionObject& object) {
    const auto& parts = object.collider.parts;
    return parts.size() > 1 || (!parts[0]->round() && (!parts[0]->whole() || parts[0]->whole()->widestGap > 0));
}

/// An upper bound of how far a point of the body is from where it would be now if nothing had acted, metres.
double departureOf(const DynamicBody& body, double seconds) {
    const Pose &from = body.stepPath.front(), &to = body.stepPath.back();
    const glm::dquat turn = to.rotation * glm::conjugate(from.rotation);
    const glm::dvec3 turned = 2.0 * (turn.w < 0.0 ? -1.0 : 1.0) * glm::dvec3(turn.x, turn.y, turn.z);
    return glm::length(to.position - from.position - body.stepStart.velocity * seconds) +
           body.object.radius * glm::length(turned - body.stepStart.angularVelocity * seconds);
}

/// Whether the body may have met what the search for contacts did not see, or has passed what it saw.
bool needsSweep(const DynamicBody& body, double seconds) {
    const double voxel = body.object.smallestVoxel, moved = displacementOf(body);
    // What flies in a box does not know that the box stops.
    if (hasGaps(body.object) && departureOf(body, seconds) > kMaxDeviation * voxel) return true;
    if (moved <= kMinDisplacement * voxel) return false;
    if (roundOf(body)) return moved > kFarDisplacement * voxel;
    return moved > kFarDisplacement * voxel || body.isPenetrating || deviationOf(body, seconds) > kMaxDeviation * voxel;
}

/// Whether the body may have met what it is in, or what is in it, as one of the two was sent elsewhere. anyGaps:
/// whether anything may have something inside.
bool needsInnerSweep(const DynamicBody& body, bool anyGaps, double seconds) {
    return anyGaps && departureOf(body, seconds) > kMinDeparture * body.object.smallestVoxel;
}

/// World bounds of an object on a path.
WorldBox boundsOf(const CollisionObject& object, const SweptPose& path) {
    WorldBox box{glm::dvec3(1e300), glm::dvec3(-1e300)};
    glm::dvec3 low, high;
    object.collider.bounds(low, high);
    for (const Pose& pose : path.poses) {
        const glm::dvec3 middle = pose.transformPoint((low + high) * 0.5),
                         extent = rotatedHalfExtent(glm::mat3_cast(pose.rotation), (high - low) * 0.5);
        box.low = glm::min(box.low, middle - extent), box.high = glm::max(box.high, middle + extent);
    }
    const double arc = sagittaOf(path, object.radius);
    return {box.low - arc, box.high + arc};
}

/// The part of a path between two fractions of the step, in as many poses.
void takePart(const SweptPose& path, double from, double to, std::vector<Pose>& part) {
    part.clear();
    for (size_t i = 0; i < path.poses.size(); ++i)
        part.push_back(path.at(from + (to - from) * double(i) / double(path.poses.size() - 1)));
}

/// Whether the body has been held for so long that what moves does not hold it now.
bool isFree(const DynamicBody& body) {
    return body.held >= kMaxHeld && body.held < kMaxHeld + kFreeSteps;
}

/// Whether what moves does not hold the body now; isInside: what may be in it, or it in that.
bool passes(const DynamicBody& body, bool isInside) {
    return isInside ? body.stuckSteps >= kMaxStuckSteps : isFree(body);
}

/// An upper bound of how far a point of one has moved relative to the other in the step, metres.
double relativeDisplacement(const DynamicBody& body, const CollisionObject& other) {
    const Pose &from = body.stepPath.front(), &to = body.stepPath.back();
    const double turned = body.object.radius * largestAngle(from.rotation, to.rotation);
    if (!isMoving(other)) return glm::length(to.position - from.position) + turned;
    const Pose &otherFrom = other.dynamic->stepPath.front(), &otherTo = other.dynamic->stepPath.back();
    return glm::length(to.position - from.position - (otherTo.position - otherFrom.position)) + turned +
           other.radius * largestAngle(otherFrom.rotation, otherTo.rotation);
}

}  // namespace

/// The body's pairs with what overlaps a box and it may meet.
void ContinuousCollision::findPairs(const DynamicBody& body, const WorldBox& box, PhysicsBodies& bodies,
                                    const JointTable& joints) {
    const CollisionObject& own = body.object;
    m_found.clear();
    bodies.broadphase().find(box.low, box.high, m_found);
    m_pairs.clear();
    for (CollisionObject* other : m_found)
        if (other != &own && other->filter.meets(own.filter))
            m_pairs.push_back(own.number < other->number ? ObjectPair(&own.dynamic->object, other)
                                                         : ObjectPair(other, &own.dynamic->object));
    if (!joints.empty()) joints.removeNonColliding(m_pairs);
}

/// Where a body first enters something on its path; above 1: it does not.
double ContinuousCollision::fractionOf(const Swept& swept, PhysicsBodies& bodies, const JointTable& joints) {
    const DynamicBody& body = bodies.at(swept.slot);
    std::array<Pose, 2> ends, still;
    const SweptPose path = simplified(body, ends);
    findPairs(body, boundsOf(body.object, path), bodies, joints);
    double fraction = kNoStop;
    for (const auto& [first, second] : m_pairs) {
        const CollisionObject& other = first == &body.object ? *second : *first;
        if (swept.innerOnly && !isMoving(other)) continue;
        const bool isInside = mayBeInside(body.object, other);
        if ((swept.innerOnly && !isInside) || (isMoving(other) && passes(body, isInside))) continue;
        // A body that is put back is in the way of what follows it, which would then be deep in it.
        if (!mayPass(body.object, other, relativeDisplacement(body, other))) continue;
        fraction = std::min(fraction, timeOfImpact(body.object.collider, path, other.collider, pathOf(other, still)));
    }
    return fraction;
}

/// Stops a body no later than at a fraction of the step.
void ContinuousCollision::stopAt(const DynamicBody& body, double fraction) {
    double& known = m_fractions[size_t(body.solverIndex)];
    if (fraction > 1.0 || known <= fraction) return;
    known = fraction;
    m_queue.push_back({fraction, body.handle().slot()});
    std::push_heap(m_queue.begin(), m_queue.end(), std::greater());
}

/// Bodies that are joined stop together, or their joints would pull them through.
void ContinuousCollision::stopJointed(const DynamicBody& body, const PhysicsBodies& bodies, const JointTable& joints) {
    for (const uint32_t joint : joints.of(body.handle().slot()))
        for (const BodyHandle handle : joints.at(joint)->bodies)
            if (const DynamicBody* other = handle ? bodies.find(handle) : nullptr; other && !other->asleep())
                stopAt(*other, m_fractions[size_t(body.solverIndex)]);
}

/// Stops what would come, in the rest of the step, to where a body stops.
void ContinuousCollision::stopFollowers(const DynamicBody& body, PhysicsBodies& bodies, const JointTable& joints) {
    const double from = m_fractions[size_t(body.solverIndex)];
    const std::array<Pose, 2> still{SweptPose{body.stepPath}.at(from), SweptPose{body.stepPath}.at(from)};
    findPairs(body, boundsOf(body.object, {still}), bodies, joints);
    for (const auto& [first, second] : m_pairs) {
        const CollisionObject& other = first == &body.object ? *second : *first;
        if (!isMoving(other) || !other.dynamic->finite()) continue;
        if (passes(*other.dynamic, mayBeInside(other, body.object))) continue;
        const double to = std::min(m_fractions[size_t(other.dynamic->solverIndex)], 1.0);
        if (to <= from) continue;
        std::array<Pose, 2> ends;
        takePart(simplified(*other.dynamic, ends), from, to, m_rest);
        if (!mayPass(body.object, other, displacement(m_rest.front(), m_rest.back(), other.radius))) continue;
        const double hit = timeOfImpact(other.collider, {m_rest}, body.object.collider, {still});
        if (hit <= 1.0) stopAt(*other.dynamic, from + hit * (to - from));
    }
}

/// Puts a body back to where it was at a fraction of the step.
void ContinuousCollision::putBack(DynamicBody& body, double fraction, const glm::dvec3& gravity) const {
    const Pose pose = SweptPose{body.stepPath}.at(fraction);
    SolverBody& motion = body.motion;
    // The height that it did not fall is not in its speed.
    const double speed2 = glm::dot(motion.velocity, motion.velocity),
                 fallen = 2.0 * body.gravityScale * glm::dot(gravity, motion.position - pose.position);
    if (fallen > 0.0 && speed2 > 0.0) motion.velocity *= std::sqrt(std::max(0.0, speed2 - fallen) / speed2);
    motion.position = pose.position;
    turnBack(motion, pose.rotation);
    body.setPose();
}

/// The bodies to be swept, and the bounds of where they have been: they are not where they were expected.
void ContinuousCollision::findSwept(PhysicsBodies& bodies, double seconds) {
    const std::vector<uint32_t>& awake = bodies.awake();
    const bool anyGaps =
        std::any_of(awake.begin(), awake.end(), [&](uint32_t slot) { return hasGaps(bodies.at(slot).object); });
    m_swept.clear();
    for (const uint32_t slot : awake) {
        DynamicBody& body = bodies.at(slot);
        const bool isSwept = body.finite() && needsSweep(body, seconds);
        if (isSwept || (body.finite() && needsInnerSweep(body, anyGaps, seconds)))
            m_swept.push_back({slot, !isSwept});
        else
            body.held = body.stuckSteps = 0;
    }
    for (const Swept& swept : m_swept) {
        std::array<Pose, 2> ends;
        CollisionObject& object = bodies.at(swept.slot).object;
        const WorldBox box = boundsOf(object, simplified(*object.dynamic, ends));
        object.low = glm::min(object.low, box.low), object.high = glm::max(object.high, box.high);
        bodies.broadphase().move(object);
    }
}

bool ContinuousCollision::stop(PhysicsBodies& bodies, const JointTable& joints, const PhysicsSettings& settings,
                               const glm::dvec3& gravity) {
    if (!settings.continuous) return false;
    findSwept(bodies, settings.stepSeconds);
    if (m_swept.empty()) return false;
    m_fractions.assign(bodies.awake().size() + 1, kNoStop);
    for (const Swept& swept : m_swept) stopAt(bodies.at(swept.slot), fractionOf(swept, bodies, joints));
    while (!m_queue.empty()) {
        const Stop next = m_queue.front();
        std::pop_heap(m_queue.begin(), m_queue.end(), std::greater());
        m_queue.pop_back();
        const DynamicBody& body = bodies.at(next.slot);
        if (m_fractions[size_t(body.solverIndex)] != next.fraction) continue;  // it stops before
        if (!joints.empty()) stopJointed(body, bodies, joints);
        stopFollowers(body, bodies, joints);
    }
    bool any = false;
    for (const uint32_t slot : bodies.awake()) {
        DynamicBody& body = bodies.at(slot);
        const double hit = m_fractions[size_t(body.solverIndex)];
        body.stuckSteps = hit < kNoProgress ? body.stuckSteps + 1 : 0;
        if (hit > 1.0 && body.held == 0) continue;
        body.held = isFree(body) || (body.held < kMaxHeld && hit < kNoProgress) ? body.held + 1 : 0;
        const double fraction = hit + kOverlap * body.object.smallestVoxel / displacementOf(body);
        if (!(fraction < 1.0)) continue;
        putBack(body, fraction, gravity);
        any = true;
    }
    return any;
}

}  // namespace rubble
