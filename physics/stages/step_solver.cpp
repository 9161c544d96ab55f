#include "physics/stages/step_solver.h"

#include <algorithm>

namespace rubble {
namespace {

// Bodies below these keep their angular velocity in free rotation, with RotationRule::WhereNeeded:
constexpr double kMinInertiaRatio = 1.1;  ///< of the largest to the smallest principal moment
constexpr double kMinSpin = 0.3;          ///< rad/s

bool conservesMomentum(const SolverBody& body, RotationRule rule) {
    const glm::dvec3& i = body.inertia;
    const double inertiaRatio = std::max({i.x, i.y, i.z}) / std::min({i.x, i.y, i.z});
    return rule == RotationRule::Always || (rule == RotationRule::WhereNeeded && inertiaRatio > kMinInertiaRatio &&
                                            glm::length(body.angularVelocity) > kMinSpin);
}

int solverIndexOf(const CollisionObject& object) {
    return object.dynamic && !object.dynamic->asleep() ? object.dynamic->solverIndex : 0;
}

}  // namespace

void StepSolver::solve(PhysicsBodies& bodies, std::span<Manifold* const> manifolds, PhysicsJoints& joints,
                       glm::dvec3 gravity, const PhysicsSettings& settings) {
    m_bodies.assign(1, {});
    for (const uint32_t slot : bodies.awake()) {
        DynamicBody& body = bodies.at(slot);
        body.solverIndex = int(m_bodies.size());
        body.motion.conservesMomentum = conservesMomentum(body.motion, settings.rotation);
        m_bodies.push_back(body.motion);
    }
    m_bodyOf.clear();
    for (const Manifold* manifold : manifolds)
        m_bodyOf.emplace_back(solverIndexOf(*manifold->objects.first), solverIndexOf(*manifold->objects.second));
    const std::span<JointConstraint* const> activeJoints = joints.gather(bodies);
    m_energy.record(m_bodies);
    m_solver.solve(m_bodies, manifolds, m_bodyOf, gravity,
                   {.substeps = settings.substeps,
                    .iterations = settings.iterations,
                    .seconds = settings.stepSeconds,
                    .contactHertz = settings.contactHertz,
                    .loadBearingRatio = settings.loadBearingRatio,
                    .loadBearingPasses = settings.loadBearingPasses,
                    .parallelFor = settings.parallelFor ? &settings.parallelFor : nullptr},
                   activeJoints);
    m_energy.enforce(m_bodies, m_bodyOf, activeJoints, gravity);
    for (const uint32_t slot : bodies.awake()) {
        DynamicBody& body = bodies.at(slot);
        body.motion = m_bodies[size_t(body.solverIndex)];
        body.setPose();
    }
}

}  // namespace rubble
