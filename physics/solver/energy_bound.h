#pragma once
#include <span>
#include <utility>
#include <vector>

#include "physics/bodies/solver_body.h"
#include "physics/solver/joint_solver.h"
#include "runtime/core/union_find.h"

namespace rubble {

/// Keeps contacts and joints from creating energy. Contacts may dissipate energy or pass it on, and joints add what
/// their motors and springs do (JointConstraint::work). So an island of bodies that touch or are joined must not end a
/// step with more kinetic and potential energy than it had before, and was given. Where a cut has left bodies inside
/// each other, or a rope is too long for its path, the solver adds energy all the same. What is taken back, and from
/// what, says energy_bound.cpp.
class EnergyBound {
public:
    /// Call before the solve. bodies[0] is the world. gravity: m/s2. substep: seconds.
    void record(std::span<const SolverBody> bodies, const glm::dvec3& gravity, double substep);
    /// Call after the solve. pairs: indices of bodies in contact.
    void enforce(std::span<SolverBody> bodies, std::span<const std::pair<int, int>> pairs,
                 std::span<JointConstraint* const> joints);
    /// Gives islands that do not touch the world the angular momentum back that they lost when bodies were put back
    /// after enforce(). before: the bodies as they were.
    void keepMomentum(std::span<const SolverBody> before, std::span<SolverBody> bodies);

private:
    struct Island {
        double gain = 0.0;           ///< joules, of all its bodies, less the work of its joints
        double positiveGains = 0.0;  ///< joules, of the bodies that gained
        double kinetic = 0.0;        ///< joules, of all its bodies
        /// Joules: SolverBody::regainable of its bodies; below 0 by at most `advance`: gained, and to be lost.
        double regainable = 0.0, advance = 0.0;
        double weight = 0.0;  ///< newtons, of all its bodies
        int joints = 0, bodies = 0;
        bool isDriven = false;  ///< by a motor
        bool touchesWorld = false;
        bool changed = false;  ///< one of its bodies was put back
    };
    using Members = std::span<const std::pair<uint32_t, uint32_t>>;  ///< root and body
    struct RigidMotion;
    void findIslands(std::span<const SolverBody> bodies, std::span<const std::pair<int, int>> pairs,
                     std::span<JointConstraint* const> joints);
    void updateRegainable(std::span<SolverBody> bodies);
    void takeFromGainers(std::span<SolverBody> bodies);
    static void takeFromInnerMotion(std::span<SolverBody> bodies, const Island& island, Members members);
    template <class Meant, class F>
    void forEachIsland(size_t bodies, Meant&& isMeant, F&& f);
    struct Before {
        double kinetic = 0.0;                     ///< joules
        glm::dvec3 position{0.0}, velocity{0.0};  ///< world
    };

    glm::dvec3 m_gravity{0.0};      ///< m/s2
    double m_lag = 0.0;             ///< s, half a substep
    std::vector<Before> m_before;   ///< by body
    std::vector<double> m_gains;    ///< joules, by body
    std::vector<Island> m_islands;  ///< by the island's root body
    UnionFind<> m_sets;
    std::vector<std::pair<uint32_t, uint32_t>> m_members;
};

}  // namespace rubble
