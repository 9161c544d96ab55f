#include <cmath>

#include "physics/physics_impl.h"

namespace rubble {
namespace {

constexpr double kWakeDistance = 0.02;   ///< metres a body moves before what isConstrained it is woken
constexpr double kWakeAngle = 0.04;      ///< radians
constexpr double kTouchDistance = 0.02;  ///< metres between bounds that count as touching
constexpr double kSlowSpeed = 0.3;       ///< m/s: a touching body slower than this is on its displacement to rest
constexpr double kMaxPatience = 4.0;  ///< times the drift of the settings that is restTime after seconds of being slow
constexpr double kWakeSpeed = 0.15;   ///< m/s that a hit must give a sleeping body to wake it
constexpr double kSettledWakeSpeed = 0.6;  ///< the same for a settled one

}  // namespace

void PhysicsWorld::Impl::wake(DynamicBody& body) {
    if (!body.asleep() || body.quarantined()) return;
    body.wantsSleep = false;
    broadphase.remove(body.object);
    body.setAsleep(false);
    broadphase.add(body.object, true);
    joinAwake(body);
}

void PhysicsWorld::Impl::wakeOrWait(DynamicBody& body) {
    if (!body.asleep() || body.quarantined()) return;
    if (mayWake(body))
        wake(body);
    else
        insertSorted(waiting, body.handle().slot());
}

void PhysicsWorld::Impl::wakeWaiting() {
    size_t done = 0;
    for (; done < waiting.size() && awakeDebris < awakeDebrisLimit; ++done)
        if (DynamicBody* body = dynamicAt(waiting[done])) wake(*body);
    waiting.erase(waiting.begin(), waiting.begin() + std::ptrdiff_t(done));
}

void PhysicsWorld::Impl::joinAwake(const DynamicBody& body) {
    awakeDebris += insertSorted(awake, body.handle().slot()) && body.isDebris;
}

void PhysicsWorld::Impl::leaveAwake(const DynamicBody& body) {
    awakeDebris -= eraseSorted(awake, body.handle().slot()) && body.isDebris;
}

void PhysicsWorld::Impl::sleep(DynamicBody& body) {
    body.setAsleep(true);
    broadphase.remove(body.object);
    broadphase.add(body.object, false);
}

/// Bodies whose bounds touch these, in slot order.
void PhysicsWorld::Impl::wakeTouching(glm::dvec3 low, glm::dvec3 high) {
    found.clear();
    broadphase.find(low - kTouchDistance, high + kTouchDistance, found);
    std::sort(found.begin(), found.end(),
              [](const CollisionObject* a, const CollisionObject* b) { return a->number < b->number; });
    for (CollisionObject* object : found)
        if (object->dynamic) wakeOrWait(*object->dynamic);
}

/// Wakes sleepers that are about to be hit, in time for the solve; true if there were any.
bool PhysicsWorld::Impl::wakeHit() {
    bool any = false;
    for (const Manifold* manifold : narrowphase.manifolds()) {
        DynamicBody *a = manifold->objects.first->dynamic, *b = manifold->objects.second->dynamic;
        if (!a || !b || a->asleep() == b->asleep()) continue;
        DynamicBody& sleeper = a->asleep() ? *a : *b;
        const DynamicBody& hitter = a->asleep() ? *b : *a;
        if (sleeper.quarantined() || !mayWake(sleeper)) continue;
        const double share = hitter.mass().mass / (hitter.mass().mass + sleeper.mass().mass);
        if (approachSpeed(*manifold, settings.stepSeconds) * share <=
            (sleeper.settled ? kSettledWakeSpeed : kWakeSpeed))
            continue;
        wake(sleeper);
        any = true;
    }
    return any;
}

/// Notes who isConstrained anything, and which sleepers.
void PhysicsWorld::Impl::recordContacts() {
    for (const uint32_t slot : awake) dynamics[slot]->touching = false;
    for (const Manifold* manifold : narrowphase.manifolds()) {
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

/// Puts the restTime to sleep.
void PhysicsWorld::Impl::putToSleep() {
    const bool weightless = gravity == glm::dvec3(0.0);
    for (const uint32_t slot : awake) {
        DynamicBody& body = *dynamics[slot];
        SolverBody& motion = body.motion;
        const double speed =
            std::max(glm::length(motion.velocity), glm::length(motion.angularVelocity) * body.minHalfExtent());
        body.slowSeconds = body.touching && speed < kSlowSpeed ? body.slowSeconds + settings.stepSeconds : 0.0;
        const double patience = std::min(1.0 + body.slowSeconds, kMaxPatience);
        if (body.slowSeconds > 0.0) {
            const double kept = 1.0 - settings.slowDamping * patience;
            motion.velocity *= kept;
            motion.angularVelocity *= kept;
        }
        const double allowed = settings.sleepTime * patience;
        const double restTime = body.sleepTimer.restTime(body.pose(), settings.sleepVelocity * allowed,
                                                         settings.sleepAngularVelocity * allowed, settings.stepSeconds);
        const bool isJointed = !joints.of(slot).empty();
        body.wantsSleep = restTime >= settings.sleepTime && (body.touching || body.inWater || weightless || isJointed);
        if (!body.wantsSleep || isJointed) continue;
        sleep(body);
        ended.push_back(slot);
    }
    if (!activeJoints.empty()) putJointedToSleep();
    for (const uint32_t slot : ended) leaveAwake(*dynamics[slot]);
}

/// What moved wakes what it touched; the first time after it woke, all that its bounds touch: there are no contacts
/// between sleepers. Those woken join `awake` at their place, so the walk finds its own again.
void PhysicsWorld::Impl::wakeTouched() {
    for (size_t i = 0; i < awake.size(); ++i) {
        const uint32_t slot = awake[i];
        DynamicBody& body = *dynamics[slot];
        if (!body.sleepTimer.hasMoved(body.pose(), kWakeDistance, kWakeAngle)) continue;
        if (body.newlyAwake) wakeTouching(body.object.low, body.object.high);
        body.newlyAwake = false;
        std::sort(body.sleepersTouched.begin(), body.sleepersTouched.end());
        for (const uint32_t touched : body.sleepersTouched)
            if (DynamicBody* sleeper = dynamicAt(touched); sleeper && !sleeper->settled) wakeOrWait(*sleeper);
        body.sleepersTouched.clear();
        i = size_t(std::lower_bound(awake.begin(), awake.end(), slot) - awake.begin());
    }
}

}  // namespace rubble
