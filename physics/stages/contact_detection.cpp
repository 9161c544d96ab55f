#include "physics/stages/contact_detection.h"

#include <algorithm>

#include "physics/collision/impacts.h"
#include "physics/solver/blockwise.h"
#include "physics/stages/loads.h"

namespace rubble {
namespace {

constexpr double kWakeSpeed = 0.15;        ///< m/s that a hit must give a sleeping body to wake it
constexpr double kPassedOnSpeed = 0.08;    ///< the same of a hit that something which it has woken passes on
constexpr double kSettledWakeSpeed = 0.6;  ///< the same for a settled one

bool mayTouchSleepers(const DynamicBody& body) {
    return body.newlyAwake || !body.sleepersTouched.empty();
}

}  // namespace

/// What is woken has contacts of its own, so the search goes on until nothing more wakes.
void ContactDetection::find(PhysicsBodies& bodies, const PhysicsJoints& joints, const PhysicsSettings& settings,
                            glm::dvec3 gravity) {
    const NarrowphaseSettings narrow{.margin = settings.contactMargin,
                                     .seconds = settings.stepSeconds,
                                     .sweepThreshold = settings.continuous ? settings.sweepThreshold : 1e300};
    m_narrowphase.begin();
    for (const uint32_t slot : m_pushed) m_pushes[slot] = {};
    m_pushed.clear();
    m_leftOut = 0;
    for (const uint32_t slot : bodies.awake()) bodies.at(slot).pairsFound = false;
    // The solve ends with a pass that lets nothing come nearer than it may in one more substep.
    const double reach = settings.stepSeconds + settings.stepSeconds / settings.substeps;
    const auto wakeMore = [&] {
        const bool any = wakeHit(bodies, reach);
        if (any) joints.wakeJointed(bodies);
        return Loads::wakeBorne(bodies, m_narrowphase.manifolds(), gravity) || any;
    };
    for (bool more = true, isFirst = true; more; more = wakeMore(), isFirst = false) {
        m_moving.clear();
        for (const uint32_t slot : bodies.awake()) {
            DynamicBody& body = bodies.at(slot);
            if (!body.pairsFound) m_moving.push_back(&body.object);
        }
        forEachBlockwise(settings.parallelFor ? &settings.parallelFor : nullptr, m_moving.size(), [&](size_t i) {
            DynamicBody& body = *m_moving[i]->dynamic;
            if (!(body.object.pose == body.pose())) body.setPose();
            body.object.turn = body.object.radius * glm::length(body.motion.angularVelocity) * settings.stepSeconds;
            bodies.broadphase().setBounds(body.object, body.motion.velocity * settings.stepSeconds,
                                          settings.contactMargin + body.object.turn);
        });
        for (CollisionObject* object : m_moving) bodies.broadphase().move(*object);
        m_pairs.clear();
        m_leftOut += bodies.broadphase().findPairs(m_moving, m_pairs);
        if (!joints.table().empty()) joints.table().removeNonColliding(m_pairs);
        const size_t found = m_pairs.size();
        m_crowds.thin(m_pairs);
        m_leftOut += found - m_pairs.size();
        for (CollisionObject* object : m_moving) object->dynamic->pairsFound = true;
        m_narrowphase.collide(m_pairs, narrow, settings.parallelFor ? settings.parallelFor : ParallelFor(serialFor));
        if (isFirst) notePushes(reach);
    }
}

/// The velocity, away from the hitter, at which it reaches the other within the time: its own, or what it gets from the
/// hit that has woken it. A hit goes through all that touches, or what sleeps would bear it like a wall.
glm::dvec3 ContactDetection::pushOf(const Manifold& manifold, const DynamicBody& hitter, double seconds) const {
    const double side = manifold.objects.second->dynamic == &hitter ? 1.0 : -1.0;  // of normals, from the hitter on
    glm::dvec3 push = approachVelocity(manifold, seconds) * side;
    const Push* const pushed = pushOn(hitter);
    if (!pushed) return push;
    for (const ManifoldPoint& point : manifold.all()) {
        const glm::dvec3 away = glm::dvec3(point.normal) * side;
        const double speed = glm::dot(pushed->velocity, away);
        if (speed * seconds > double(point.separation) && speed > glm::length(push)) push = away * speed;
    }
    return push;
}

/// Notes what hits give to bodies that are awake and touch sleeping ones, or may do so as they have just woken.
void ContactDetection::notePushes(double seconds) {
    for (const Manifold* manifold : m_narrowphase.manifolds()) {
        const DynamicBody *a = manifold->objects.first->dynamic, *b = manifold->objects.second->dynamic;
        if (!a || !b || a->asleep() || b->asleep()) continue;
        if (!mayTouchSleepers(*a) && !mayTouchSleepers(*b)) continue;
        const glm::dvec3 approach = approachVelocity(*manifold, seconds);
        if (approach == glm::dvec3(0.0)) continue;
        notePush(*a, a->motion.velocity, approach, *manifold, b->mass().mass);
        notePush(*b, b->motion.velocity, -approach, *manifold, a->mass().mass);
    }
}

/// Notes that a body of a velocity is pushed by what comes at it with another mass and a velocity relative to its own.
void ContactDetection::notePush(const DynamicBody& body, glm::dvec3 velocity, glm::dvec3 push, const Manifold& manifold,
                                double mass) {
    float restitution = 0.0f;
    for (const ManifoldPoint& point : manifold.all()) restitution = std::max(restitution, point.restitution);
    const double together = mass + body.mass().mass;
    const Push pushed{velocity + push * (mass / together * (1.0 + double(restitution))), together};
    const uint32_t slot = body.handle().slot();
    if (const Push* known = pushOn(body); known && glm::length(pushed.velocity) <= glm::length(known->velocity)) return;
    if (!pushOn(body)) m_pushed.push_back(slot);
    if (m_pushes.size() <= slot) m_pushes.resize(slot + 1);
    m_pushes[slot] = pushed;
}

const ContactDetection::Push* ContactDetection::pushOn(const DynamicBody& body) const {
    const uint32_t slot = body.handle().slot();
    return slot < m_pushes.size() && m_pushes[slot].mass > 0.0 ? &m_pushes[slot] : nullptr;
}

/// Wakes sleeping bodies that are about to be hit, in time for the solve; true if there were any.
bool ContactDetection::wakeHit(PhysicsBodies& bodies, double seconds) {
    bool any = false;
    for (const Manifold* manifold : m_narrowphase.manifolds()) {
        DynamicBody *a = manifold->objects.first->dynamic, *b = manifold->objects.second->dynamic;
        if (!a || !b || a->asleep() == b->asleep()) continue;
        DynamicBody& sleeper = a->asleep() ? *a : *b;
        const DynamicBody& hitter = a->asleep() ? *b : *a;
        if (sleeper.quarantined()) continue;
        const Push* const passedOn = pushOn(hitter);
        const double mass = passedOn ? passedOn->mass : hitter.mass().mass;
        const double share = mass / (mass + sleeper.mass().mass);
        const double wakeSpeed = sleeper.settled ? kSettledWakeSpeed : passedOn ? kPassedOnSpeed : kWakeSpeed;
        const glm::dvec3 push = pushOf(*manifold, hitter, seconds);
        if (glm::length(push) * share <= wakeSpeed || !bodies.wakeOrWait(sleeper, false)) continue;
        notePush(sleeper, glm::dvec3(0.0), push, *manifold, mass);
        any = true;
    }
    return any;
}

void ContactDetection::recordTouching(PhysicsBodies& bodies) const {
    for (const uint32_t slot : bodies.awake()) bodies.at(slot).touching = bodies.at(slot).wakesLoad = false;
    for (const Manifold* manifold : m_narrowphase.manifolds()) {
        manifold->objects.first->isNew = manifold->objects.second->isNew = false;
        DynamicBody *a = manifold->objects.first->dynamic, *b = manifold->objects.second->dynamic;
        if (a) a->touching = true;
        if (b) b->touching = true;
        if (!a || !b || a->asleep() == b->asleep()) continue;
        DynamicBody &sleeper = a->asleep() ? *a : *b, &mover = a->asleep() ? *b : *a;
        if (sleeper.settled) continue;
        std::vector<uint32_t>& touched = mover.sleepersTouched;
        const uint32_t slot = sleeper.handle().slot();
        if (std::find(touched.begin(), touched.end(), slot) == touched.end()) touched.push_back(slot);
    }
}

}  // namespace rubble
