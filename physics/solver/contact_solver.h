#pragma once
#include <span>
#include <vector>

#include "physics/solver/constraint_coloring.h"
#include "physics/solver/contact_kernels.h"
#include "physics/solver/contact_setup.h"
#include "physics/solver/joint_solver.h"
#include "physics/solver/lane_packing.h"
#include "physics/solver/restitution.h"
#include "physics/solver/steady_bodies.h"
#include "runtime/core/pose.h"

namespace rubble {

struct SolverSettings {
    int substeps = 6;
    int iterations = 1;              ///< over all contacts, in each half of a substep
    double seconds = 1.0 / 60.0;     ///< of all substeps together
    double contactHertz = 90.0;      ///< stiffness of contacts, at most a quarter of the rate of substeps
    double dampingRatio = 5.0;       ///< of contacts
    double loadBearingRatio = 30.0;  ///< of masses above which a light body under a heavy one gets stiffer contacts
    int loadBearingPasses = 8;       ///< more over the contacts of such bodies; 0: none is stiffer
    double torsionRadius = 0.0;      ///< metres: the arm of a lone contact point's friction against spin
    double maxPushSpeed = 1.5;       ///< m/s at which overlaps are pushed apart
    double slop = 0.0002;            ///< metres that contacts may overlap, so that they last
    bool hitsConserve = true;        ///< what is hit in the step keeps its angular momentum as it rotates
    double minReboundSpeed = 0.25;   ///< m/s: what would part more slowly after a hit does not bounce
    const ParallelFor* parallelFor = nullptr;  ///< null: one thread; results do not depend on it
};

/// Solves contacts and joints and moves the bodies through a step. The same input gives the same bits, on any number of
/// threads. See contact_solver.cpp for the method.
class ContactSolver {
public:
    /// Moves the bodies by settings.seconds. bodies[0] is the world, which does not move. bodyOf: for each manifold,
    /// the indices in `bodies` of its first and second. gravity: m/s2. The impulses in manifolds and joints are the
    /// warm start, and are replaced by the result.
    void solve(std::span<SolverBody> bodies, std::span<Manifold* const> manifolds,
               std::span<const std::pair<int, int>> bodyOf, glm::dvec3 gravity, const SolverSettings& settings,
               std::span<JointConstraint* const> joints = {});

    /// The poses of a body through the last solve, at equal times, without the first; none: on a straight line.
    std::span<const Pose> pathOf(int body) const { return m_paths[size_t(body)]; }

private:
    void prepare(std::span<SolverBody> bodies, std::span<Manifold* const> manifolds,
                 std::span<const std::pair<int, int>> bodyOf, const SolverSettings& settings);
    void followHits(std::span<SolverBody> bodies, const SolverSettings& settings);
    void packGroups(std::span<const SolverBody> bodies, std::span<const std::pair<int, int>> bodyOf);
    void substep(std::span<SolverBody> bodies, glm::dvec3 gravity, const SolverSettings& settings, bool isFirst);
    void iterate(std::span<const SolverBody> bodies, const SolverSettings& settings, ContactPass pass);
    bool isDeep(const PairConstraints& pair);
    void move(std::span<SolverBody> bodies, double seconds);
    static void moveConstrained(SolverBody& body, SolverState& state, const glm::dquat& start, double seconds);
    static void moveFreely(SolverBody& body, const glm::dvec3& gravity, double seconds, std::vector<Pose>& path);
    void storeImpulses(const PairGroup& group);
    ContactArrays arrays() {
        return {m_set.states.data(), m_set.groups.data(), m_set.contacts.data(), m_set.starts.data()};
    }

    ContactSet m_set;
    JointSolver m_joints;
    ConstraintColoring m_coloring;  ///< its tasks are ranges of m_set.groups
    LanePacking m_packing;
    WarmStartFilter m_warmStartFilter;
    Restitution m_restitution;
    SteadyBodies m_steadyBodies;
    const ParallelFor* m_parallelFor = nullptr;
    LoadBearing m_loadBearing;
    std::vector<glm::dquat> m_start;         ///< rotations at the start of the step
    std::vector<std::vector<Pose>> m_paths;  ///< by body; see pathOf()
    std::vector<uint32_t> m_stiffGroups;     ///< of load-bearing bodies
    ContactSoftness m_softness;
    float m_torsionRadius = 0.0f;  ///< metres
    glm::vec3 m_up{0.0f};          ///< unit vector against gravity; zero: there is none
    const ContactKernels* m_kernels = &contactKernels();
};

}  // namespace rubble
