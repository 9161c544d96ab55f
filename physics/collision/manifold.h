#pragma once
#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "physics/collision/voxel_contacts.h"

namespace rubble {

struct CollisionObject;

/// A contact point and what the solver knows about it.
struct ManifoldPoint : ContactPoint {
    float normalImpulse = 0.0f;       ///< of the last substep, N s: the warm start
    glm::vec3 frictionImpulse{0.0f};  ///< of the last substep, N s, world axes
    glm::vec3 frictionInset{0.0f};    ///< from the point to where it has friction, metres, world axes
    float totalImpulse = 0.0f;        ///< along the normal, summed over the last step, N s
    float approach = 0.0f;            ///< closing speed before the last solve, m/s
    // The contact as it was found, for contact_cache.h:
    glm::vec3 anchorInFirst{0.0f};   ///< the point on the first body, in its frame
    glm::vec3 normalInSecond{0.0f};  ///< in the second's frame
    float cachedSeparation = 0.0f;
};

/// Whether a point, as the last step left it, bore a load that was no hit. What closes there from then on is pressed
/// into a soft contact: a force that is switched on does not hit.
bool pressesOn(const ManifoldPoint& point);

inline constexpr int kMaxManifoldPoints = 12;
/// How many points a manifold may have.
struct ManifoldLimits {
    int total;         ///< at most kMaxManifoldPoints, shared equally by the directions of their normals
    int perDirection;  ///< at least 4
};
/// Four points hold what rests. What hits with a corner of a wider polygon turns about the wrong point without it.
inline constexpr ManifoldLimits kRestingLimits{8, 4}, kHitLimits{kMaxManifoldPoints, 8};

/// What a manifold is about, besides its points.
struct ManifoldHead {
    uint32_t first = 0, second = 0;  ///< numbers of the collision objects
    std::pair<CollisionObject*, CollisionObject*> objects;
    glm::dvec3 origin{0.0};           ///< positions of points are relative to it: the first's frame origin, world
    float allowedPenetration = 0.0f;  ///< metres: see updateAllowedPenetration()
    float approach = 0.0f;            ///< m/s: the fastest at which a point closed before the last solve
    float torsionImpulse = 0.0f;      ///< of a lone point, about its normal, on the first; of the last substep, N m s
    int count = 0;
    bool isRound = false;        ///< one of the objects is touched as what is round
    bool isPenetrating = false;  ///< the last solve left a hit deep: see ContactSolver::solve()
};

/// The contacts of two objects that are solved. For each direction of normals, these are the deepest point and up to
/// three that span the widest area with it. The points are elsewhere: those of a step lie one after the other, since
/// most manifolds have two or three, and every stage of a step reads them all.
struct Manifold : ManifoldHead {
    ManifoldPoint* points = nullptr;  ///< `count` of them; while it is filled, kMaxManifoldPoints

    /// The points in use.
    std::span<ManifoldPoint> all() { return {points, size_t(count)}; }
    /// The points in use.
    std::span<const ManifoldPoint> all() const { return {points, size_t(count)}; }
    /// What the first object got from the second in the last substep, N s, world axes.
    glm::dvec3 impulseOfFirst() const {
        glm::vec3 sum(0.0f);
        for (const ManifoldPoint& p : all()) sum += p.normal * p.normalImpulse + p.frictionImpulse;
        return glm::dvec3(sum);
    }
    /// Becomes equal to another one, with its own points.
    void copyFrom(const Manifold& other) {
        static_cast<ManifoldHead&>(*this) = other;
        std::copy_n(other.points, count, points);
    }
};

/// A manifold that holds its points itself.
struct LoneManifold : Manifold {
    /// Without points.
    LoneManifold() { points = own.data(); }
    LoneManifold(const LoneManifold&) = delete;
    LoneManifold& operator=(const LoneManifold&) = delete;
    std::array<ManifoldPoint, kMaxManifoldPoints> own;
};

/// Sets how deep the first object may stay inside the second, which is static. What was deep inside the static world
/// when the two were first compared (the foot of a tree that came loose) is held where it is and not lifted out: to
/// lift a heavy body would create energy. The allowance only shrinks. before: its value in the last step; infinite for
/// a new pair.
void updateAllowedPenetration(Manifold& manifold, float before);
/// A point's separation as the solver shall see it: a penetration that is allowed counts as touching. up: unit vector
/// against gravity; zero: the allowance has no effect.
float effectiveSeparation(const Manifold& manifold, const ManifoldPoint& point, const glm::vec3& up);

/// Fills the manifold with as many of the contacts as the limits allow; changes their order. Points that `before` (may
/// be null) had too inherit its impulses.
void reduceContacts(std::vector<ContactPoint>& contacts, const Manifold* before, const ManifoldLimits& limits,
                    Manifold& out);

}  // namespace rubble
