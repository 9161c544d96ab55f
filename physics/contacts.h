#pragma once
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>

#include <vector>

#include "runtime/world/world.h"

namespace rubble {

/// The hits of a step: approach is measured before the solver runs, impulses are read after it.
class ContactLog {
public:
    void beginStep() { m_hits.clear(); }
    /// Largest speed, m/s, at which the two bodies of a manifold near each other along a contact normal.
    static double approachSpeed(const btPersistentManifold& manifold);

    void beforeSolve(btDispatcher& dispatcher);
    /// Adds up the impulses of contacts that approached faster than minSpeed, for each pair of bodies.
    void afterSolve(btDispatcher& dispatcher, double minSpeed);
    /// Those above the threshold. handles: by body slot; origin: world position of Bullet's zero.
    void impacts(double threshold, const std::vector<BodyHandle>& handles, glm::dvec3 origin, std::vector<Impact>& out) const;

private:
    struct Hit {
        int body, other;              ///< slots; body > other
        glm::dvec3 position, normal;  ///< weighted by impulse
        double impulse;
    };
    std::vector<double> m_approach;  ///< by manifold, of this substep
    std::vector<Hit> m_hits;
};

}  // namespace rubble
