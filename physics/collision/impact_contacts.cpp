#include "physics/collision/impact_contacts.h"

#include <array>

#include "physics/bodies/dynamic_body.h"
#include "physics/collision/time_of_impact.h"

namespace rubble {
namespace {

/// Where the object will be at the end of the step if nothing stops it.
Pose endPose(const CollisionObject& object, double seconds) {
    if (!object.dynamic || object.dynamic->asleep()) return object.pose;
    SolverBody body = object.dynamic->motion;
    rotateBody(body, seconds);
    return {body.position + body.velocity * seconds, body.rotation};
}

/// The object as it is when the two meet.
struct Placed {
    const CollisionObject& object;
    Pose pose;
    std::vector<CellTransform> cells;
    Placed(const CollisionObject& from, const Pose& at) : object(from), pose(at) {
        for (const auto& part : from.collider.parts) cells.push_back(part->cellsAt(pose.rotation));
    }
    Motion motion() const { return {.pose = pose, .cellTransforms = cells}; }
    /// Where a point of it is now, if it is at `point` then.
    glm::dvec3 before(const glm::dvec3& point) const { return object.pose.transformPoint(pose.inversePoint(point)); }
};

}  // namespace

void findImpactContacts(const CollisionObject& first, const CollisionObject& second,
                        const NarrowphaseSettings& settings, const glm::vec3& axis, std::vector<ContactPoint>& out,
                        const StaticNeighbours& neighbours) {
    const std::array<Pose, 2> firstPath{first.pose, endPose(first, settings.seconds)},
        secondPath{second.pose, endPose(second, settings.seconds)};
    const double fraction = timeOfImpact(first.collider, {firstPath}, second.collider, {secondPath}, axis);
    if (fraction > 1.0) return;
    const Placed a(first, SweptPose{firstPath}.at(fraction)), b(second, SweptPose{secondPath}.at(fraction));
    const size_t from = out.size();
    ContactSearch searchThen;
    findContacts(first.collider, a.motion(), second.collider, b.motion(), settings, searchThen, out, neighbours);
    for (size_t i = from; i < out.size(); ++i) {
        ContactPoint& contact = out[i];
        const glm::dvec3 middle = a.pose.position + glm::dvec3(contact.position), normal(contact.normal),
                         half = normal * (0.5 * double(contact.separation));
        const glm::dvec3 onFirst = a.before(middle + half), onSecond = b.before(middle - half);
        const double apart = glm::dot(onFirst - onSecond, normal);
        const bool isOfSecond = contact.feature & 1;
        const glm::dvec3 position = isOfSecond ? onSecond + normal * (0.5 * apart) : onFirst - normal * (0.5 * apart);
        contact.position = glm::vec3(position - first.pose.position);
        contact.separation = float(apart);
    }
}

}  // namespace rubble
