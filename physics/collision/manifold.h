#pragma once
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "physics/collision/voxel_contacts.h"

namespace rubble {

struct CollisionObject;

/// A contact with what the solver knows about it.
struct ManifoldPoint : ContactPoint {
    float normalImpulse = 0.0f;       ///< of a substep, N s
    glm::vec3 frictionImpulse{0.0f};  ///< of a substep, world
    float totalImpulse = 0.0f;        ///< along the normal over the last step, N s
    float approach = 0.0f;            ///< m/s along the normal before the last solve
    glm::vec3 anchorInFirst{
        0.0f};  ///< where the first is touched, in its frame: this and the next as found, see cacheContacts()
    glm::vec3 normalInSecond{0.0f};
    float cachedSeparation = 0.0f;
};

inline constexpr int kMaxManifoldPoints = 8;

/// The contacts of two bodies that are kept: for each direction, in which they touch, the deepest and those that span
/// the widest area with it.
struct Manifold {
    uint32_t first = 0, second = 0;  ///< numbers of the collision objects
    std::pair<CollisionObject*, CollisionObject*> objects;
    glm::dvec3 origin{0.0};  ///< of the first's frame, world: where positions count from
    float allowedPenetration =
        0.0f;  ///< metres that the first may be inside the second, which stands still: see updateAllowedPenetration()
    int count = 0;
    std::array<ManifoldPoint, kMaxManifoldPoints> points;

    std::span<ManifoldPoint> all() { return {points.data(), size_t(count)}; }
    std::span<const ManifoldPoint> all() const { return {points.data(), size_t(count)}; }
};

/// What was deep inside the static world when the two were first looked at (the foot of a tree that came loose) is held
/// where it is, not lifted out: nothing pays for the height that would give a heavy body. What of it has come out does
/// not get in again. before: what was allowed in the last step; infinite if the two are new to each other.
void updateAllowedPenetration(Manifold& manifold, float before);
/// As the solver sees a point's separation: what may stay inside isConstrained. up: against gravity; zero: nothing is
/// lifted.
float effectiveSeparation(const Manifold& manifold, const ManifoldPoint& point, const glm::vec3& up);

/// Keeps at most kMaxManifoldPoints of the contacts, whose order it changes, and isSoft those that `before` (may be
/// null) had too their impulses back.
void reduceContacts(std::vector<ContactPoint>& contacts, const Manifold* before, Manifold& out);

}  // namespace rubble
