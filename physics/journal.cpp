#include <fmt/format.h>

#include "physics/physics_impl.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

template <class T>
T& slotOf(std::vector<T>& table, uint32_t slot) {
    if (table.size() <= slot) table.resize(slot + 1);
    return table[slot];
}

}  // namespace

void PhysicsWorld::Impl::clear() {
    for (uint32_t slot = 0; slot < dynamics.size(); ++slot)
        if (dynamics[slot]) destroyDynamic(slot);
    statics.clear();
    shapeBody.clear();
    handles.clear();
    awake.clear();
    waiting.clear();
    poses.clear();
    impacts.clear();
}

void PhysicsWorld::Impl::setGravity(const World& world) {
    if (world.environment().gravity == gravity) return;
    gravity = world.environment().gravity;
    bullet.setGravity(toBullet(glm::dvec3(gravity)));
    for (const auto& body : dynamics)
        if (body) wakeOrWait(*body);
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
    place->isDebris = world.debris().contains(handle);
    place->settled = asleep && world.bodies().at(handle).settled;
    if (asleep) return bullet.addResting(place->rigid());
    bullet.addRigidBody(&place->rigid());
    joinAwake(*place);
}

void PhysicsWorld::Impl::destroyDynamic(uint32_t slot) {
    DynamicBody& body = *dynamics[slot];
    if (!body.quarantined()) body.asleep() ? bullet.removeResting(body.rigid()) : bullet.removeRigidBody(&body.rigid());
    leaveAwake(body);
    dynamics[slot].reset();
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
    touched.insert(touched.end(), changes.placed.begin(), changes.placed.end());
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
        const bool isPlaced = std::find(changes.placed.begin(), changes.placed.end(), handle) != changes.placed.end();
        createDynamic(world, handle, body->asleep && (!known || isPlaced));
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

}  // namespace rubble
