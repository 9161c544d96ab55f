#include "physics/collision/resting_contacts.h"

#include <algorithm>

#include "physics/bodies/dynamic_body.h"

namespace rubble {
namespace {

constexpr double kMaxMotion = 0.001;  ///< metres by which two may have moved against each other

bool isAwake(const CollisionObject& object) {
    return object.dynamic && !object.dynamic->asleep();
}

}  // namespace

void RestingContacts::keep(std::span<Manifold* const> manifolds) {
    for (const Manifold* manifold : manifolds) {
        const auto [first, second] = manifold->objects;
        if (isAwake(*first) || isAwake(*second)) continue;
        if (m_pairs.size() <= first->number) m_pairs.resize(first->number + 1);
        std::vector<Pair>& pairs = m_pairs[first->number];
        auto at = std::lower_bound(pairs.begin(), pairs.end(), second->number, Pair::isBefore);
        if (at == pairs.end() || at->second != second->number) at = pairs.insert(at, Pair{second->number});
        at->pose = relativePose(first->pose, second->pose);
        at->allowedPenetration = manifold->allowedPenetration;
        at->torsionImpulse = manifold->torsionImpulse;
        at->points.clear();
        at->points.reserve(size_t(manifold->count));
        for (const ManifoldPoint& point : manifold->all())
            at->points.push_back({point.feature, point.normal, point.frictionImpulse, point.normalImpulse});
    }
}

bool RestingContacts::find(const CollisionObject& first, const CollisionObject& second, LoneManifold& out) const {
    if (first.number >= m_pairs.size()) return false;
    const std::vector<Pair>& pairs = m_pairs[first.number];
    const auto at = std::lower_bound(pairs.begin(), pairs.end(), second.number, Pair::isBefore);
    if (at == pairs.end() || at->second != second.number ||
        maxPointDisplacement(at->pose, relativePose(first.pose, second.pose), first.radius) > kMaxMotion)
        return false;
    out.count = 0;
    out.allowedPenetration = at->allowedPenetration;
    out.torsionImpulse = at->torsionImpulse;
    for (const Point& kept : at->points) {
        ManifoldPoint& point = out.points[out.count++];
        point.feature = kept.feature;
        point.normal = kept.normal;
        point.normalImpulse = kept.normalImpulse;
        point.frictionImpulse = kept.frictionImpulse;
    }
    return true;
}

void RestingContacts::forget(const CollisionObject& first) {
    if (first.number < m_pairs.size()) m_pairs[first.number].clear();
}

}  // namespace rubble
