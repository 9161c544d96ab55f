#pragma once
#include <span>
#include <utility>
#include <vector>

#include "physics/solver/contact_solver.h"
#include "physics/solver/energy_bound.h"
#include "physics/stages/physics_bodies.h"
#include "physics/stages/physics_joints.h"
#include "physics/stages/physics_settings.h"

namespace rubble {

/// Hands the awake bodies with their contacts and joints to the solver, and moves them.
class StepSolver {
public:
    /// gravity: m/s2. The bodies get their new poses and velocities, manifolds and joints their impulses.
    void solve(PhysicsBodies& bodies, std::span<Manifold* const> manifolds, PhysicsJoints& joints, glm::dvec3 gravity,
               const PhysicsSettings& settings);
    /// Call if bodies were put back since: what of them touches nothing that stands still keeps its momentum.
    void keepMomentum(PhysicsBodies& bodies);
    /// The number of bodies in the last solve; body 0 is the world.
    size_t bodyCount() const { return m_bodies.size(); }

private:
    ContactSolver m_solver;
    EnergyBound m_energy;
    std::vector<SolverBody> m_bodies, m_after;
    std::vector<glm::dvec3> m_spinChanges;      ///< rad/s, of slow bodies in the step, by body
    std::vector<std::pair<int, int>> m_bodyOf;  ///< indices in m_bodies, by manifold
};

}  // namespace rubble
