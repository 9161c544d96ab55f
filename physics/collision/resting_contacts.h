#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "physics/collision/contact_cache.h"
#include "physics/collision/manifold.h"

namespace rubble {

/// The impulses of contacts between which nothing is awake any more. What wakes goes on with them: without, a pile that
/// wakes would sag until the solver has found them again. A scene that is loaded has none.
class RestingContacts {
public:
    /// Keeps the impulses of those manifolds of a step of which both objects are asleep or static by now.
    void keep(std::span<Manifold* const> manifolds);
    /// Sets what was kept of a pair: the features, normals and impulses of its points, and its allowed penetration.
    /// False if there is nothing, or the two have moved against each other since. [any thread]
    bool find(const CollisionObject& first, const CollisionObject& second, LoneManifold& out) const;
    /// Forgets what was kept of the pairs of which this is the first object.
    void forget(const CollisionObject& first);
    /// Forgets all.
    void clear() { m_pairs.clear(); }

private:
    struct Point {
        uint64_t feature;
        glm::vec3 normal, frictionImpulse;
        float normalImpulse;
    };
    struct Pair {
        uint32_t second = 0;  ///< number of the object
        RelativePose pose;
        float allowedPenetration = 0.0f, torsionImpulse = 0.0f;
        std::vector<Point> points;

        /// Orders pairs by `second`, for a search.
        static bool isBefore(const Pair& pair, uint32_t number) { return pair.second < number; }
    };
    std::vector<std::vector<Pair>> m_pairs;  ///< by the first's slot, each sorted by `second`
};

}  // namespace rubble
