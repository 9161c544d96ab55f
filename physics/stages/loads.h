#pragma once
#include <span>
#include <vector>

#include "physics/collision/manifold.h"
#include "physics/stages/physics_bodies.h"

namespace rubble {

/// Wakes what a change of load reaches: a body sleeps in balance with what lies on it. See loads.cpp for the rules.
class Loads {
public:
    /// Before the solve: wakes the sleeping bodies that lie on one which has just woken, or whose support has just
    /// changed. True if there were any; they have no contacts yet.
    static bool wakeBorne(PhysicsBodies& bodies, std::span<Manifold* const> manifolds, glm::dvec3 gravity);
    /// After the solve: wakes sleeping bodies whose load has been another than when they fell asleep for some steps.
    /// substep: s.
    void wakeOverloaded(PhysicsBodies& bodies, std::span<Manifold* const> manifolds, glm::dvec3 gravity,
                        double substep);
    /// Notes the loads of the bodies that fell asleep in this step.
    static void record(std::span<Manifold* const> manifolds);

private:
    std::vector<DynamicBody*> m_touched;  ///< sleepers that something awake touches in this step
    uint64_t m_step = 1;
};

}  // namespace rubble
