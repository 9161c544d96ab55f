#include "physics/collision/impacts.h"

#include <algorithm>
#include <tuple>

#include "physics/bodies/dynamic_body.h"

namespace rubble {
namespace {

/// The velocity of an object at a point before the last solve, world, m/s.
glm::dvec3 velocityBeforeSolve(const CollisionObject& object, const glm::dvec3& point) {
    if (!object.dynamic || object.dynamic->asleep()) return glm::dvec3(0.0);
    const SolverBody& motion = object.dynamic->stepStart;
    return motion.velocity + glm::cross(motion.angularVelocity, point - motion.position);
}

/// The fastest at which two bodies came to hit each other in the last solve, m/s. What a motor or a weight presses into
/// a soft contact closes there too, but hits nothing.
double hitSpeed(const Manifold& manifold) {
    double speed = 0.0;
    for (const ManifoldPoint& point : manifold.all())
        if (point.totalImpulse > 0.0f && !point.isPressed) speed = std::max(speed, double(point.approach));
    return speed;
}

}  // namespace

glm::dvec3 approachVelocity(const Manifold& manifold, double seconds) {
    double fastest = 0.0;
    glm::dvec3 away(0.0);
    for (const ManifoldPoint& point : manifold.all()) {
        const glm::dvec3 position = manifold.origin + glm::dvec3(point.position), normal(point.normal);
        const glm::dvec3 relative =
            velocityAt(*manifold.objects.first, position) - velocityAt(*manifold.objects.second, position);
        const double speed = -glm::dot(relative, normal);
        if (speed * seconds > double(point.separation) && speed > fastest) fastest = speed, away = normal * speed;
    }
    return away;
}

Pose poseBeforeSolve(const CollisionObject& object) {
    const DynamicBody* body = object.dynamic;
    if (!body || body->asleep()) return object.pose;
    return {body->stepStart.position, body->stepStart.rotation};
}

MeetingPoint meetingPoint(const Manifold& manifold, const ManifoldPoint& point) {
    const CollisionObject &first = *manifold.objects.first, &second = *manifold.objects.second;
    const glm::dvec3 middle = manifold.origin + glm::dvec3(point.position),
                     half = glm::dvec3(point.normal) * (0.5 * double(point.separation));
    MeetingPoint met{.onFirst = middle + half, .onSecond = middle - half};
    // The corner or edge that touches is a point of its own body; on the other it is elsewhere when the two meet.
    if (point.separation > 0.0f && point.approach > 0.0f) {
        const glm::dvec3 way = (velocityBeforeSolve(first, met.onFirst) - velocityBeforeSolve(second, met.onSecond)) *
                               (double(point.separation) / double(point.approach));
        if (point.feature & 1)
            met.onFirst = met.onSecond - way;
        else
            met.onSecond = met.onFirst + way;
    }
    met.now = second.pose.transformPoint(poseBeforeSolve(second).inversePoint(met.onSecond));
    return met;
}

void findImpacts(std::span<Manifold* const> manifolds, double minSpeed, double threshold,
                 const std::vector<BodyHandle>& handles, std::vector<Impact>& out) {
    struct Hit {
        uint32_t body, other;         ///< slots; body > other unless other is static
        glm::dvec3 position, normal;  ///< weighted by impulse
        double impulse, speed;
    };
    std::vector<Hit> hits;
    hits.reserve(16);
    for (const Manifold* manifold : manifolds) {
        if (!(double(manifold->approach) > minSpeed)) continue;
        const double approach = hitSpeed(*manifold);
        if (!(approach > minSpeed)) continue;
        double total = 0.0;
        glm::dvec3 position(0.0), normal(0.0);
        for (const ManifoldPoint& point : manifold->all()) {
            if (!(point.totalImpulse > 0.0f)) continue;
            total += double(point.totalImpulse);
            position += meetingPoint(*manifold, point).now * double(point.totalImpulse);
            normal += glm::dvec3(point.normal) * double(point.totalImpulse);
        }
        hits.push_back(
            {manifold->objects.first->body, manifold->objects.second->body, position, normal, total, approach});
    }
    std::stable_sort(hits.begin(), hits.end(),
                     [](const Hit& a, const Hit& b) { return std::tie(a.body, a.other) < std::tie(b.body, b.other); });
    for (size_t i = 0; i < hits.size();) {  // the shapes of one static body make one impact
        Hit sum = hits[i++];
        for (; i < hits.size() && hits[i].body == sum.body && hits[i].other == sum.other; ++i)
            sum.position += hits[i].position, sum.normal += hits[i].normal, sum.impulse += hits[i].impulse,
                sum.speed = std::max(sum.speed, hits[i].speed);
        if (sum.impulse < threshold) continue;
        const double length = glm::length(sum.normal);
        out.push_back({handles[sum.body], sum.other == kNoBody ? BodyHandle{} : handles[sum.other],
                       sum.position / sum.impulse, length > 0.0 ? sum.normal / length : glm::dvec3(0.0, 1.0, 0.0),
                       sum.impulse, sum.speed});
    }
}

}  // namespace rubble
