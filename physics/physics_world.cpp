#include "physics/physics_world.h"

#include <fmt/format.h>

#include "physics/physics_impl.h"
#include "runtime/core/log.h"

namespace rubble {

/// Continuous collision against what stands still: a body that would fly through it in this substep stops just inside it,
/// and meets it with its full velocity in the next. A ray from the centre stands for the body.
void PhysicsWorld::Impl::brakeFast() {
    const double seconds = kStep / settings.substeps;
    for (const uint32_t slot : awake) {
        DynamicBody& body = *dynamics[slot];
        const btVector3 velocity = body.rigid().getLinearVelocity();
        const double way = double(velocity.length()) * seconds;
        if (way < 0.5 * body.reach() || !body.finite()) continue;
        const btVector3 from = body.rigid().getCenterOfMassPosition();
        const btVector3 to = from + velocity.normalized() * btScalar(way + body.reach());
        btCollisionWorld::ClosestRayResultCallback ray(from, to);
        ray.m_collisionFilterMask = btBroadphaseProxy::StaticFilter;
        bullet.rayTest(from, to, ray);
        if (!ray.hasHit()) continue;
        const double free = double(ray.m_closestHitFraction) * (way + body.reach()) - 0.9 * body.reach();
        if (free >= way) continue;
        braked.emplace_back(slot, velocity);
        body.rigid().setLinearVelocity(velocity * btScalar(std::max(free, 0.0) / way));
    }
}

void PhysicsWorld::Impl::releaseFast() {
    for (const auto& [slot, velocity] : braked) dynamics[slot]->rigid().setLinearVelocity(velocity);
    braked.clear();
}

void PhysicsWorld::Impl::quarantineBroken() {
    for (size_t i = 0; i < awake.size(); ++i) {
        const uint32_t slot = awake[i];
        DynamicBody& body = *dynamics[slot];
        if (body.finite()) continue;
        logWarning(fmt::format("physics: body {} got a pose or velocity that is no finite number: it is frozen where it last was", slot));
        bullet.removeRigidBody(&body.rigid());
        body.restore(origin);
        body.setAsleep(true);
        body.quarantine();
        ended.push_back(slot);
    }
    for (const uint32_t slot : ended) leaveAwake(*dynamics[slot]);
}

void PhysicsWorld::Impl::report() {
    std::sort(ended.begin(), ended.end());
    auto next = ended.begin();
    const auto add = [&](uint32_t slot) {
        if (dynamics[slot] && dynamics[slot]->refresh(origin)) poses.push_back(dynamics[slot]->state());
    };
    for (const uint32_t slot : awake) {
        for (; next != ended.end() && *next < slot; ++next) add(*next);
        if (next != ended.end() && *next == slot) ++next;  // slept and woke in one step
        add(slot);
    }
    for (; next != ended.end(); ++next) add(*next);
    ended.clear();
}

PhysicsWorld::PhysicsWorld(const PhysicsSettings& settings) : m_impl(std::make_unique<Impl>(settings)) {}
PhysicsWorld::~PhysicsWorld() = default;

void PhysicsWorld::apply(const FrameChanges& changes, const World& world, bool anew) {
    anew = anew || changes.levelReplaced;
    if (anew) m_impl = std::make_unique<Impl>(PhysicsSettings(m_impl->settings));  // not cleared: Bullet's pools and trees remember
    Impl& impl = *m_impl;
    impl.awakeDebrisLimit = 0;  // what World says is awake comes first; the others wait for the step
    if (anew)
        impl.loadAll(world);
    else
        impl.setGravity(world);
    if (!anew && !changes.empty()) {
        impl.forget(changes);
        impl.refreshStatic(changes, world);
        impl.refreshDynamic(changes, world);
    }
    impl.applyImpulses(changes);
    for (const BodyHandle handle : changes.settled)
        if (DynamicBody* body = impl.dynamicAt(handle.slot()); body && body->handle() == handle) body->settled = body->asleep();
    impl.awakeDebrisLimit = world.settings().debris.awakeBodies;
}

void PhysicsWorld::step() {
    Impl& impl = *m_impl;
    impl.poses.clear();
    impl.impacts.clear();
    impl.contacts.beginStep();
    impl.wakeWaiting();
    if (!impl.awake.empty()) {
        for (int i = 0; i < impl.settings.substeps; ++i) {
            impl.readdWoken();
            impl.bullet.substep(btScalar(kStep / impl.settings.substeps));
            impl.releaseFast();
            impl.quarantineBroken();
        }
        impl.readdWoken();
        impl.settle();
        impl.disturb();
        impl.contacts.impacts(impl.settings.impactThreshold, impl.handles, impl.origin, impl.impacts);
    }
    impl.report();
}

std::span<const BodyPose> PhysicsWorld::poses() const {
    return m_impl->poses;
}
std::span<const Impact> PhysicsWorld::impacts() const {
    return m_impl->impacts;
}

PhysicsFigures PhysicsWorld::figures() const {
    PhysicsFigures figures;
    figures.awake = int(m_impl->awake.size());
    for (const auto& body : m_impl->dynamics)
        if (body) {
            ++figures.bodies;
            figures.colliderBoxes += body->boxCount();
        }
    for (const auto& shape : m_impl->statics)
        if (shape) figures.colliderBoxes += shape->boxCount();
    btDispatcher& dispatcher = *m_impl->bullet.getDispatcher();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) figures.contacts += dispatcher.getManifoldByIndexInternal(i)->getNumContacts();
    return figures;
}

}  // namespace rubble
