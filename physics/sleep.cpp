#include <cmath>

#include "physics/physics_impl.h"

namespace rubble {
namespace {

constexpr double kDisturbed = 0.02;         ///< metres a body moves before what touches it is woken
constexpr double kDisturbedAngle = 0.04;    ///< radians
constexpr btScalar kTouchDistance = 0.02f;  ///< metres between bounds that count as touching: Bullet's contact breaking threshold
constexpr double kSlow = 0.3;               ///< m/s: a touching body slower than this is on its way to rest
constexpr double kSlowDamping = 0.03;       ///< share of its speeds lost a step, and the same again for each second of being slow
constexpr double kMostPatience = 4.0;       ///< times the drift of the settings that is calm after seconds of being slow
constexpr double kWakeSpeed = 0.15;         ///< m/s that a hit must give a sleeping body to wake it
constexpr double kReviveSpeed = 0.6;        ///< the same for a settled one

}  // namespace

void PhysicsWorld::Impl::wake(DynamicBody& body) {
    if (!body.asleep() || body.quarantined()) return;
    bullet.removeResting(body.rigid());
    body.setAsleep(false);
    bullet.addRigidBody(&body.rigid());
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
    bullet.removeRigidBody(&body.rigid());
    body.setAsleep(true);
    bullet.addResting(body.rigid());
}

/// Bodies whose bounds touch these, in slot order.
void PhysicsWorld::Impl::wakeTouching(btVector3 low, btVector3 high) {
    const btVector3 around(kTouchDistance, kTouchDistance, kTouchDistance);
    found.clear();
    bullet.overlapping(low - around, high + around, found);
    std::sort(found.begin(), found.end(),
              [](const btCollisionObject* a, const btCollisionObject* b) { return a->getUserIndex() < b->getUserIndex(); });
    for (btCollisionObject* object : found)
        if (DynamicBody* body = dynamicOf(*object)) wakeOrWait(*body);
}

/// Wakes sleepers that are about to be hit, in time for the solve, and notes who touches anything.
void PhysicsWorld::Impl::noteContacts() {
    for (const uint32_t slot : awake) dynamics[slot]->touching = false;
    btDispatcher& dispatcher = *bullet.getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        if (manifold.getNumContacts() == 0) continue;
        DynamicBody* a = dynamicOf(*manifold.getBody0());
        DynamicBody* b = dynamicOf(*manifold.getBody1());
        if (a) a->touching = true;
        if (b) b->touching = true;
        if (!a || !b || a->asleep() == b->asleep()) continue;
        DynamicBody& sleeper = a->asleep() ? *a : *b;
        DynamicBody& hitter = a->asleep() ? *b : *a;
        std::vector<uint32_t>& touched = hitter.sleepersTouched;
        if (std::find(touched.begin(), touched.end(), sleeper.handle().slot()) == touched.end()) touched.push_back(sleeper.handle().slot());
        const double share = hitter.mass().mass / (hitter.mass().mass + sleeper.mass().mass);
        const double wakeSpeed = sleeper.settled ? kReviveSpeed : kWakeSpeed;
        if (ContactLog::approachSpeed(manifold) * share <= wakeSpeed || !mayWake(sleeper) || !sleeper.wakeInPlace()) continue;
        bullet.enlist(sleeper.rigid());
        joinAwake(sleeper);
    }
}

/// Puts bodies that were woken during a solve into Bullet's lists.
void PhysicsWorld::Impl::readdWoken() {
    for (const uint32_t slot : awake) {
        DynamicBody& body = *dynamics[slot];
        if (!body.readd) continue;
        body.readd = false;
        bullet.removeRigidBody(&body.rigid());
        bullet.addRigidBody(&body.rigid());
    }
}

/// Puts the calm to sleep.
void PhysicsWorld::Impl::settle() {
    const bool weightless = gravity == glm::vec3(0.0f);
    for (const uint32_t slot : awake) {
        DynamicBody& body = *dynamics[slot];
        btRigidBody& rigid = body.rigid();
        const double speed = std::max(double(rigid.getLinearVelocity().length()), double(rigid.getAngularVelocity().length()) * body.reach());
        body.slowSeconds = body.touching && speed < kSlow ? body.slowSeconds + kStep : 0.0;
        const double patience = std::min(1.0 + body.slowSeconds, kMostPatience);
        if (body.slowSeconds > 0.0) {
            const btScalar kept = btScalar(1.0 - kSlowDamping * patience);
            rigid.setLinearVelocity(rigid.getLinearVelocity() * kept);
            rigid.setAngularVelocity(rigid.getAngularVelocity() * kept);
        }
        const double allowed = settings.sleepTime * patience;
        const double calm =
            body.settling.calm(rigid.getWorldTransform(), settings.sleepVelocity * allowed, settings.sleepAngularVelocity * allowed, kStep);
        if (calm < settings.sleepTime || !(body.touching || weightless)) continue;
        sleep(body);
        ended.push_back(slot);
    }
    for (const uint32_t slot : ended) leaveAwake(*dynamics[slot]);
}

/// What moved wakes what it touched; the first time after it woke, all that its bounds touch: Bullet reports no contacts
/// between sleepers. Those woken join `awake` at their place, so the walk finds its own again.
void PhysicsWorld::Impl::disturb() {
    for (size_t i = 0; i < awake.size(); ++i) {
        const uint32_t slot = awake[i];
        DynamicBody& body = *dynamics[slot];
        const btTransform before = body.settling.disturbedAt();
        if (!body.settling.disturbed(body.rigid().getWorldTransform(), kDisturbed, kDisturbedAngle)) continue;
        if (body.freshlyAwake) {
            btVector3 low, high;
            body.rigid().getCollisionShape()->getAabb(before, low, high);
            wakeTouching(low, high);
        }
        body.freshlyAwake = false;
        std::sort(body.sleepersTouched.begin(), body.sleepersTouched.end());
        for (const uint32_t touched : body.sleepersTouched)
            if (DynamicBody* sleeper = dynamicAt(touched); sleeper && !sleeper->settled) wakeOrWait(*sleeper);
        body.sleepersTouched.clear();
        i = size_t(std::lower_bound(awake.begin(), awake.end(), slot) - awake.begin());
    }
}

}  // namespace rubble
