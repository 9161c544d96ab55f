#include "physics/physics_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "physics/bullet_math.h"
#include "physics/bullet_world.h"
#include "physics/contacts.h"
#include "physics/dynamic_body.h"
#include "physics/static_shape.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr double kStep = 1.0 / 60.0;
constexpr double kDisturbed = 0.02;         ///< metres a body moves before what touches it is woken
constexpr double kDisturbedAngle = 0.04;    ///< radians
constexpr btScalar kTouchDistance = 0.02f;  ///< metres between bounds that count as touching: Bullet's contact breaking threshold
constexpr double kSlow = 0.3;               ///< m/s: a touching body slower than this is on its way to rest
constexpr double kSlowDamping = 0.03;       ///< share of its speeds lost a step, and the same again for each second of being slow
constexpr double kMostPatience = 4.0;       ///< times the drift of the settings that is calm after seconds of being slow
constexpr double kWakeSpeed = 0.15;         ///< m/s that a hit must give a sleeping body to wake it

}  // namespace

struct PhysicsWorld::Impl {
    explicit Impl(const PhysicsSettings& given) : settings(given), bullet(given.solverIterations) {
        bullet.beforeSolve = [this] {
            noteContacts();
            contacts.beforeSolve(*bullet.getDispatcher());
        };
        bullet.afterSolve = [this] {
            contacts.afterSolve(*bullet.getDispatcher(), settings.impactSpeed);
            brakeFast();
        };
    }
    ~Impl() { clear(); }

    void clear();
    void loadAll(const World& world);
    void setGravity(const World& world);
    void forget(const FrameChanges& changes);
    void refreshStatic(const FrameChanges& changes, const World& world);
    void refreshDynamic(const FrameChanges& changes, const World& world);
    void applyImpulses(const FrameChanges& changes);

    void createStatic(const World& world, ShapeHandle handle);
    void createDynamic(const World& world, BodyHandle handle, bool asleep);
    void destroyDynamic(uint32_t slot);

    DynamicBody* dynamicAt(uint32_t slot) const { return slot < dynamics.size() ? dynamics[slot].get() : nullptr; }
    DynamicBody* dynamicOf(const btCollisionObject& object) const { return dynamicAt(uint32_t(object.getUserIndex())); }
    void wake(DynamicBody& body);
    void sleep(DynamicBody& body);
    void wakeTouching(btVector3 low, btVector3 high);
    void noteContacts();
    void readdWoken();
    void quarantineBroken();
    void brakeFast();
    void releaseFast();
    void settle();
    void disturb();
    void report();

    PhysicsSettings settings;
    BulletWorld bullet;
    ContactLog contacts;
    glm::dvec3 origin{0.0};  ///< world position of Bullet's zero
    glm::vec3 gravity{0.0f};
    std::vector<std::unique_ptr<DynamicBody>> dynamics;  ///< by body slot
    std::vector<std::unique_ptr<StaticShape>> statics;   ///< by shape slot
    std::vector<BodyHandle> shapeBody;                   ///< by shape slot
    std::vector<BodyHandle> handles;                     ///< by body slot
    std::vector<uint32_t> awake;                         ///< body slots, ascending
    std::vector<uint32_t> ended;                         ///< fell asleep or were quarantined in this step
    std::vector<btCollisionObject*> found;               ///< of the last query
    std::vector<std::pair<uint32_t, btVector3>> braked;  ///< body slot and the velocity it gets back after the substep
    std::vector<BodyPose> poses;
    std::vector<Impact> impacts;
    bool contactsKnown = false;
};

namespace {

template <class T>
T& slotOf(std::vector<T>& table, uint32_t slot) {
    if (table.size() <= slot) table.resize(slot + 1);
    return table[slot];
}

void insertSorted(std::vector<uint32_t>& list, uint32_t slot) {
    const auto at = std::lower_bound(list.begin(), list.end(), slot);
    if (at == list.end() || *at != slot) list.insert(at, slot);
}

void eraseSorted(std::vector<uint32_t>& list, uint32_t slot) {
    const auto at = std::lower_bound(list.begin(), list.end(), slot);
    if (at != list.end() && *at == slot) list.erase(at);
}

}  // namespace

// ---- what the journal says ----

void PhysicsWorld::Impl::clear() {
    for (uint32_t slot = 0; slot < dynamics.size(); ++slot)
        if (dynamics[slot]) destroyDynamic(slot);
    statics.clear();
    shapeBody.clear();
    handles.clear();
    awake.clear();
    poses.clear();
    impacts.clear();
}

void PhysicsWorld::Impl::setGravity(const World& world) {
    if (world.environment().gravity == gravity) return;
    gravity = world.environment().gravity;
    bullet.setGravity(toBullet(glm::dvec3(gravity)));
    for (const auto& body : dynamics)
        if (body) wake(*body);
}

void PhysicsWorld::Impl::loadAll(const World& world) {
    clear();
    glm::dvec3 low(0.0), high(0.0);
    bool first = true;
    world.bodies().forEach([&](BodyHandle, const Body& body) {
        const glm::dvec3 p = body.pose.position;
        if (!(glm::length(p) < 1e12)) return;
        low = first ? p : glm::min(low, p);
        high = first ? p : glm::max(high, p);
        first = false;
    });
    origin = glm::round((low + high) * 0.5);
    setGravity(world);
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (!body.isStatic) return createDynamic(world, handle, body.asleep);
        for (const ShapeHandle shape : body.shapes) createStatic(world, shape);
    });
}

void PhysicsWorld::Impl::createStatic(const World& world, ShapeHandle handle) {
    const Shape& shape = world.shapes().at(handle);
    slotOf(handles, shape.body.slot()) = shape.body;
    slotOf(shapeBody, handle.slot()) = shape.body;
    auto& place = slotOf(statics, handle.slot());
    place.reset();
    place = std::make_unique<StaticShape>(bullet, shape, world.shapeToWorld(handle), world.materials(), origin);
}

void PhysicsWorld::Impl::createDynamic(const World& world, BodyHandle handle, bool asleep) {
    const uint32_t slot = handle.slot();
    slotOf(handles, slot) = handle;
    for (const ShapeHandle shape : world.bodies().at(handle).shapes) slotOf(shapeBody, shape.slot()) = handle;
    auto& place = slotOf(dynamics, slot);
    place = std::make_unique<DynamicBody>(world, handle, origin);
    if (place->boxCount() == 0 || !place->finite()) {
        logWarning(fmt::format("physics: body {} '{}' has no solid voxels, or a pose or velocity that is no finite number: it is left out", slot,
                               world.bodies().at(handle).name));
        place->setAsleep(true);
        place->quarantine();
        return;
    }
    place->setAsleep(asleep);
    bullet.addRigidBody(&place->rigid());
    if (!asleep) insertSorted(awake, slot);
}

void PhysicsWorld::Impl::destroyDynamic(uint32_t slot) {
    if (!dynamics[slot]->quarantined()) bullet.removeRigidBody(&dynamics[slot]->rigid());
    dynamics[slot].reset();
    eraseSorted(awake, slot);
}

void PhysicsWorld::Impl::forget(const FrameChanges& changes) {
    for (const ShapeHandle handle : changes.shapesDestroyed)
        if (handle.slot() < statics.size()) statics[handle.slot()].reset();
    for (const BodyHandle handle : changes.bodiesDestroyed) {
        DynamicBody* body = dynamicAt(handle.slot());
        if (!body || body->handle() != handle) continue;
        btVector3 low, high;
        body->rigid().getAabb(low, high);
        const bool wasThere = !body->quarantined();
        destroyDynamic(handle.slot());
        if (wasThere) wakeTouching(low, high);
    }
}

void PhysicsWorld::Impl::refreshStatic(const FrameChanges& changes, const World& world) {
    for (const ShapeHandle handle : changes.carved) {
        const Shape* shape = world.shapes().find(handle);
        if (!shape || !world.bodies().at(shape->body).isStatic || handle.slot() >= statics.size() || !statics[handle.slot()]) continue;
        std::vector<glm::ivec3> bricks;
        for (const BrickChange& change : changes.bricks)
            if (change.shape == handle) bricks.push_back(change.brick);
        StaticShape& known = *statics[handle.slot()];
        known.rebuild(*shape, world.materials(), bricks);
        for (const glm::ivec3& brick : bricks) {
            btVector3 low, high;
            known.brickBounds(brick, low, high);
            wakeTouching(low, high);
        }
    }
    for (const ShapeHandle handle : changes.shapesCreated) {
        const Shape* shape = world.shapes().find(handle);
        if (shape && world.bodies().at(shape->body).isStatic) createStatic(world, handle);
    }
}

void PhysicsWorld::Impl::refreshDynamic(const FrameChanges& changes, const World& world) {
    std::vector<BodyHandle> touched = changes.bodiesCreated;
    const auto addOwner = [&](ShapeHandle handle) {
        if (const Shape* shape = world.shapes().find(handle)) touched.push_back(shape->body);
    };
    for (const ShapeHandle handle : changes.carved) addOwner(handle);
    for (const ShapeHandle handle : changes.shapesCreated) addOwner(handle);
    for (const ShapeHandle handle : changes.shapesDestroyed)
        if (handle.slot() < shapeBody.size()) touched.push_back(shapeBody[handle.slot()]);
    std::sort(touched.begin(), touched.end(), [](BodyHandle a, BodyHandle b) { return a.slot() < b.slot(); });
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());

    for (const BodyHandle handle : touched) {
        const Body* body = world.bodies().find(handle);
        if (!body || body->isStatic) continue;
        const bool known = dynamicAt(handle.slot()) != nullptr;
        if (known) {  // out, made anew about its new centre, and back in
            btVector3 low, high;
            dynamics[handle.slot()]->rigid().getAabb(low, high);
            const bool wasThere = !dynamics[handle.slot()]->quarantined();
            destroyDynamic(handle.slot());
            if (wasThere) wakeTouching(low, high);
        }
        for (const ShapeHandle shape : body->shapes)  // a static body that came loose
            if (shape.slot() < statics.size()) statics[shape.slot()].reset();
        createDynamic(world, handle, body->asleep && !known);
    }
}

void PhysicsWorld::Impl::applyImpulses(const FrameChanges& changes) {
    for (const ImpulseApplied& applied : changes.impulses) {
        DynamicBody* body = dynamicAt(applied.body.slot());
        if (!body || body->handle() != applied.body || body->quarantined()) continue;
        wake(*body);
        body->slowSeconds = 0.0;
        btRigidBody& rigid = body->rigid();
        rigid.applyImpulse(toBullet(applied.impulse), toBullet(applied.position - origin) - rigid.getCenterOfMassPosition());
    }
    quarantineBroken();
}

// ---- sleep ----

void PhysicsWorld::Impl::wake(DynamicBody& body) {
    if (!body.asleep() || body.quarantined()) return;
    bullet.removeRigidBody(&body.rigid());
    body.setAsleep(false);
    bullet.addRigidBody(&body.rigid());
    insertSorted(awake, body.handle().slot());
}

void PhysicsWorld::Impl::sleep(DynamicBody& body) {
    bullet.removeRigidBody(&body.rigid());
    body.setAsleep(true);
    bullet.addRigidBody(&body.rigid());
}

/// Bodies whose bounds touch these, in slot order.
void PhysicsWorld::Impl::wakeTouching(btVector3 low, btVector3 high) {
    const btVector3 around(kTouchDistance, kTouchDistance, kTouchDistance);
    found.clear();
    bullet.overlapping(low - around, high + around, found);
    std::sort(found.begin(), found.end(),
              [](const btCollisionObject* a, const btCollisionObject* b) { return a->getUserIndex() < b->getUserIndex(); });
    for (btCollisionObject* object : found)
        if (DynamicBody* body = dynamicOf(*object)) wake(*body);
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
        if (ContactLog::approachSpeed(manifold) * share > kWakeSpeed && sleeper.wakeInPlace()) insertSorted(awake, sleeper.handle().slot());
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
    for (const uint32_t slot : ended) eraseSorted(awake, slot);
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
            if (DynamicBody* sleeper = dynamicAt(touched)) wake(*sleeper);
        body.sleepersTouched.clear();
        i = size_t(std::lower_bound(awake.begin(), awake.end(), slot) - awake.begin());
    }
}

// ---- a step ----

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
    for (const uint32_t slot : ended) eraseSorted(awake, slot);
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

void PhysicsWorld::apply(const FrameChanges& changes, const World& world) {
    if (changes.levelReplaced) {
        m_impl->loadAll(world);
    } else {
        m_impl->setGravity(world);
        if (changes.empty()) return;
        m_impl->forget(changes);
        m_impl->refreshStatic(changes, world);
        m_impl->refreshDynamic(changes, world);
    }
    m_impl->applyImpulses(changes);
}

void PhysicsWorld::step() {
    Impl& impl = *m_impl;
    impl.poses.clear();
    impl.impacts.clear();
    impl.contacts.beginStep();
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
