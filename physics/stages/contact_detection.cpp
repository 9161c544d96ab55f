#include "physics/stages/contact_detection.h"

#include <algorithm>

#include "physics/collision/impacts.h"

namespace rubble {
namespace {

constexpr double kWakeSpeed = 0.15;        ///< m/s that a hit must give a sleeping body to wake it
constexpr double kSettledWakeSpeed = 0.6;  ///< the same for a settled one
/// Velocity after an elastic hit, in units of the velocity that the two would share if they stuck together.
constexpr double kElastic = 2.0;

/// An upper bound of the squared speed of any point of a body, m2/s2.
double maxSpeedSquared(const DynamicBody& body) {
    const glm::dvec3 &v = body.motion.velocity, &w = body.motion.angularVelocity;
    return 2.0 * (glm::dot(v, v) + glm::dot(w, w) * body.object.radius * body.object.radius);
}
/// Whether a hit between bodies whose squared speeds add up to this may move one by more than half its thickness in a
/// step. A quick test, without roots.
bool needsSecondarySweep(double speedsSquared, double minHalfExtent, double seconds) {
    return 2.0 * kElastic * kElastic * speedsSquared * seconds * seconds > minHalfExtent * minHalfExtent;
}

double broadphaseMargin(const CollisionObject& object, const SolverBody& motion, const PhysicsSettings& settings) {
    return settings.contactMargin + object.radius * glm::length(motion.angularVelocity) * settings.stepSeconds;
}

}  // namespace

/// What is woken has contacts of its own, so the search goes on until nothing more wakes.
void ContactDetection::find(PhysicsBodies& bodies, const JointTable& joints, const PhysicsSettings& settings) {
    const NarrowphaseSettings narrow{.margin = settings.contactMargin,
                                     .seconds = settings.stepSeconds,
                                     .sweepThreshold = settings.continuous ? settings.sweepThreshold : 1e300};
    m_narrowphase.begin();
    for (const uint32_t slot : bodies.awake()) bodies.at(slot).pairsFound = false;
    for (bool more = true; more; more = wakeHit(bodies, settings.stepSeconds)) {
        m_moving.clear();
        for (const uint32_t slot : bodies.awake()) {
            DynamicBody& body = bodies.at(slot);
            if (body.pairsFound) continue;
            body.setPose();
            bodies.broadphase().move(body.object, body.motion.velocity * settings.stepSeconds,
                                     broadphaseMargin(body.object, body.motion, settings));
            m_moving.push_back(&body.object);
        }
        m_pairs.clear();
        bodies.broadphase().findPairs(
            m_moving, [](const CollisionObject& o) { return o.dynamic->pairsFound; }, m_pairs);
        if (!joints.empty()) joints.removeNonColliding(m_pairs);
        for (CollisionObject* object : m_moving) object->dynamic->pairsFound = true;
        m_narrowphase.collide(m_pairs, narrow, settings.parallelFor ? settings.parallelFor : ParallelFor(serialFor));
    }
    if (settings.continuous) sweepSecondary(bodies, joints, settings, narrow);
}

/// Continuous collision of bodies that are hit. A body hit by a fast one may be far away by the end of the step, where
/// it was not swept. So it is swept once more, with the velocity that an elastic hit would give it, against what does
/// not move.
void ContactDetection::sweepSecondary(PhysicsBodies& bodies, const JointTable& joints, const PhysicsSettings& settings,
                                      const NarrowphaseSettings& narrow) {
    const double seconds = settings.stepSeconds;
    double fastest = 0.0, thinnest = 1e9;
    for (const uint32_t slot : bodies.awake()) {
        fastest = std::max(fastest, maxSpeedSquared(bodies.at(slot)));
        thinnest = std::min(thinnest, bodies.at(slot).minHalfExtent());
    }
    if (!needsSecondarySweep(2.0 * fastest, thinnest, seconds)) return;
    m_moving.clear();
    for (const Manifold* manifold : m_narrowphase.manifolds()) {
        DynamicBody *a = manifold->objects.first->dynamic, *b = manifold->objects.second->dynamic;
        if (!a || !b || a->asleep() || b->asleep()) continue;
        if (!needsSecondarySweep(maxSpeedSquared(*a) + maxSpeedSquared(*b),
                                 std::min(a->minHalfExtent(), b->minHalfExtent()), seconds))
            continue;
        const glm::dvec3 away = approachVelocity(*manifold, seconds);
        const double all = a->mass().mass + b->mass().mass;
        const glm::dvec3 gainA = away * (kElastic * b->mass().mass / all),
                         gainB = away * (-kElastic * a->mass().mass / all);
        for (const auto& [body, gain] : {std::pair(a, gainA), std::pair(b, gainB)}) {
            if (glm::length(gain) * seconds <= body->minHalfExtent()) continue;
            if (body->secondaryVelocity == glm::dvec3(0.0)) m_moving.push_back(&body->object);
            body->secondaryVelocity += gain;
        }
    }
    if (m_moving.empty()) return;
    for (CollisionObject* object : m_moving) {
        const SolverBody& motion = object->dynamic->motion;
        bodies.broadphase().move(*object, (motion.velocity + object->dynamic->secondaryVelocity) * seconds,
                                 broadphaseMargin(*object, motion, settings));
    }
    m_pairs.clear();
    bodies.broadphase().findPairs(
        m_moving, [](const CollisionObject&) { return true; }, m_pairs);
    if (!joints.empty()) joints.removeNonColliding(m_pairs);
    m_narrowphase.collideAgain(m_pairs, narrow);
    for (CollisionObject* object : m_moving) object->dynamic->secondaryVelocity = glm::dvec3(0.0);
}

/// Wakes sleeping bodies that are about to be hit, in time for the solve; true if there were any.
bool ContactDetection::wakeHit(PhysicsBodies& bodies, double stepSeconds) const {
    bool any = false;
    for (const Manifold* manifold : m_narrowphase.manifolds()) {
        DynamicBody *a = manifold->objects.first->dynamic, *b = manifold->objects.second->dynamic;
        if (!a || !b || a->asleep() == b->asleep()) continue;
        DynamicBody& sleeper = a->asleep() ? *a : *b;
        const DynamicBody& hitter = a->asleep() ? *b : *a;
        if (sleeper.quarantined() || !bodies.budget().mayWake(sleeper)) continue;
        const double share = hitter.mass().mass / (hitter.mass().mass + sleeper.mass().mass);
        const double wakeSpeed = sleeper.settled ? kSettledWakeSpeed : kWakeSpeed;
        if (approachSpeed(*manifold, stepSeconds) * share <= wakeSpeed) continue;
        bodies.wake(sleeper);
        any = true;
    }
    return any;
}

void ContactDetection::recordTouching(PhysicsBodies& bodies) const {
    for (const uint32_t slot : bodies.awake()) bodies.at(slot).touching = false;
    for (const Manifold* manifold : m_narrowphase.manifolds()) {
        manifold->objects.first->isNew = manifold->objects.second->isNew = false;
        DynamicBody *a = manifold->objects.first->dynamic, *b = manifold->objects.second->dynamic;
        if (a) a->touching = true;
        if (b) b->touching = true;
        if (!a || !b || a->asleep() == b->asleep()) continue;
        std::vector<uint32_t>& touched = (a->asleep() ? *b : *a).sleepersTouched;
        const uint32_t slot = (a->asleep() ? *a : *b).handle().slot();
        if (std::find(touched.begin(), touched.end(), slot) == touched.end()) touched.push_back(slot);
    }
}

}  // namespace rubble
