#include "physics/stages/step_solver.h"

#include <algorithm>

#include "physics/solver/blockwise.h"

namespace rubble {
namespace {

// With RotationRule::WhereNeeded, a body that touches something has its inertia updated within the step above these.
// Below them its angular velocity changes by what free rotation does in a step, half before and half after the solve.
constexpr double kMinInertiaRatio = 1.1;  ///< of the largest to the smallest principal moment
constexpr double kMinSpin = 0.3;          ///< rad/s
constexpr double kMaxTurn = 0.3;          ///< radians in a step up to which that will do
constexpr double kRestingSpin = 1e-4;     ///< rad/s that does not rotate a body noticeably within a minute

bool conservesMomentum(const SolverBody& body, bool touches, RotationRule rule) {
    const glm::dvec3& i = body.inertia;
    const double inertiaRatio = std::max({i.x, i.y, i.z}) / std::min({i.x, i.y, i.z});
    return rule == RotationRule::Always || (rule == RotationRule::WhereNeeded && inertiaRatio > kMinInertiaRatio &&
                                            (!touches || glm::length(body.angularVelocity) > kMinSpin));
}

glm::dvec3 slowSpinChange(const SolverBody& body, const PhysicsSettings& settings) {
    if (body.conservesMomentum || settings.rotation != RotationRule::WhereNeeded) return glm::dvec3(0.0);
    const double spin = glm::length(body.angularVelocity);
    if (spin < kRestingSpin || spin * settings.stepSeconds > kMaxTurn || hasEqualMoments(body)) return glm::dvec3(0.0);
    return freeSpinChange(body, settings.stepSeconds);
}

int solverIndexOf(const CollisionObject& object) {
    return object.dynamic && !object.dynamic->asleep() ? object.dynamic->solverIndex : 0;
}

}  // namespace

void StepSolver::solve(PhysicsBodies& bodies, std::span<Manifold* const> manifolds, PhysicsJoints& joints,
                       glm::dvec3 gravity, const PhysicsSettings& settings) {
    const ParallelFor* const parallelFor = settings.parallelFor ? &settings.parallelFor : nullptr;
    const size_t count = bodies.awake().size();
    m_bodies.assign(1, {});
    m_bodies.resize(1 + count);
    m_spinChanges.resize(1 + count);
    forEachBlockwise(parallelFor, count, [&](size_t i) {
        DynamicBody& body = bodies.at(bodies.awake()[i]);
        body.solverIndex = int(1 + i);
        body.isPenetrating = false;
        body.motion.conservesMomentum = conservesMomentum(body.motion, body.touching, settings.rotation);
        m_spinChanges[1 + i] = slowSpinChange(body.motion, settings);
        m_bodies[1 + i] = body.motion;
        m_bodies[1 + i].angularVelocity += 0.5 * m_spinChanges[1 + i];
    });
    m_bodyOf.clear();
    for (const Manifold* manifold : manifolds)
        m_bodyOf.emplace_back(solverIndexOf(*manifold->objects.first), solverIndexOf(*manifold->objects.second));
    const std::span<JointConstraint* const> activeJoints = joints.gather(bodies, settings.stepSeconds);
    m_energy.record(m_bodies, gravity, settings.stepSeconds / settings.substeps);
    m_solver.solve(m_bodies, manifolds, m_bodyOf, gravity,
                   {.substeps = settings.substeps,
                    .iterations = settings.iterations,
                    .seconds = settings.stepSeconds,
                    .contactHertz = settings.contactHertz,
                    .loadBearingRatio = settings.loadBearingRatio,
                    .loadBearingPasses = settings.loadBearingPasses,
                    .torsionRadius = settings.torsionRadius,
                    .hitsConserve = settings.rotation != RotationRule::Never,
                    .parallelFor = parallelFor},
                   activeJoints);
    for (const Manifold* manifold : manifolds) {
        if (!manifold->isPenetrating) continue;
        for (const CollisionObject* object : {manifold->objects.first, manifold->objects.second})
            if (object->dynamic) object->dynamic->isPenetrating = true;
    }
    m_energy.enforce(m_bodies, m_bodyOf, activeJoints);
    forEachBlockwise(parallelFor, count, [&](size_t i) {
        DynamicBody& body = bodies.at(bodies.awake()[i]);
        const std::span<const Pose> path = m_solver.pathOf(body.solverIndex);
        body.stepPath.clear();
        body.stepPath.reserve(std::max<size_t>(2, 1 + path.size()));
        body.stepPath.push_back(body.pose());
        body.stepPath.insert(body.stepPath.end(), path.begin(), path.end());
        body.stepStart = body.motion;
        SolverBody& solved = m_bodies[size_t(body.solverIndex)];
        const bool wasHit = solved.conservesMomentum && !body.motion.conservesMomentum;  // it rotated freely already
        solved.angularVelocity += (wasHit ? -0.5 : 0.5) * m_spinChanges[size_t(body.solverIndex)];
        body.motion = solved;
        if (path.empty()) body.stepPath.push_back(body.pose());
        body.setPose();
    });
}

void StepSolver::keepMomentum(PhysicsBodies& bodies) {
    m_after = m_bodies;
    for (const uint32_t slot : bodies.awake()) {
        const DynamicBody& body = bodies.at(slot);
        m_after[size_t(body.solverIndex)] = body.motion;
    }
    m_energy.keepMomentum(m_bodies, m_after);
    for (const uint32_t slot : bodies.awake()) {
        DynamicBody& body = bodies.at(slot);
        body.motion = m_after[size_t(body.solverIndex)];
    }
}

}  // namespace rubble
