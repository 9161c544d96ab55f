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

void PhysicsWorld::Impl::setGravity(const World& world) {
    if (glm::dvec3(world.environment().gravity) == gravity) return;
    gravity = world.environment().gravity;
    for (const auto& body : dynamics)
        if (body) wakeOrWait(*body);
}

void PhysicsWorld::Impl::loadAll(const World& world) {
    glm::dvec3 low(0.0), high(0.0);
    bool first = true;
    world.bodies().forEach([&](BodyHandle, const Body& body) {
        const glm::dvec3 p = body.pose.position;
        if (!(glm::length(p) < 1e12)) return;
        low = first ? p : glm::min(low, p);
        high = first ? p : glm::max(high, p);
        first = false;
    });
    broadphase.setOrigin(glm::round((low + high) * 0.5));
    setGravity(world);
    world.characters().forEach(
        [&](CharacterHandle handle, const Character& character) { characters.emplace_back(handle, character); });
    world.waters().forEach([&](WaterHandle handle, const Water& water) { waters.set(handle.slot(), &water); });
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (!body.isStatic) return createDynamic(world, handle, body.asleep);
        for (const ShapeHandle shape : body.shapes) createStatic(world, shape);
    });
    world.joints().forEach([&](JointHandle handle, const Joint&) { createJoint(world, handle); });
}

void PhysicsWorld::Impl::createStatic(const World& world, ShapeHandle handle) {
    const Shape& shape = world.shapes().at(handle);
    destroyStatic(handle.slot());
    slotOf(handles, shape.body.slot()) = shape.body;
    slotOf(shapeBody, handle.slot()) = shape.body;
    auto object = std::make_unique<CollisionObject>();
    object->collider.parts.push_back(std::make_unique<VoxelPart>(shape, Pose{}, world.materials()));
    if (object->collider.empty()) return;
    object->setPose(world.shapeToWorld(handle));
    object->body = shape.body.slot();
    object->number = kStaticObject | handle.slot();
    broadphase.add(*object, false);
    slotOf(statics, handle.slot()) = std::move(object);
}

void PhysicsWorld::Impl::destroyStatic(uint32_t slot) {
    if (slot >= statics.size() || !statics[slot]) return;
    broadphase.remove(*statics[slot]);
    statics[slot].reset();
}

void PhysicsWorld::Impl::createDynamic(const World& world, BodyHandle handle, bool asleep) {
    const uint32_t slot = handle.slot();
    slotOf(handles, slot) = handle;
    for (const ShapeHandle shape : world.bodies().at(handle).shapes) slotOf(shapeBody, shape.slot()) = handle;
    auto& place = slotOf(dynamics, slot);
    place = std::make_unique<DynamicBody>(world, handle);
    if (enter(world, *place, asleep)) return;
    logWarning(
        fmt::format("physics: body {} '{}' has no solid voxels, is too far away, or has a pose or velocity that is no "
                    "number: it is left out",
                    slot, world.bodies().at(handle).name));
    place->setAsleep(true);
    place->quarantine();
}

/// Puts a body among the others; false if it cannot be there.
bool PhysicsWorld::Impl::enter(const World& world, DynamicBody& body, bool asleep) {
    if (body.object.collider.empty() || !body.finite() || isOutOfRange(body)) return false;
    clamp(body);
    body.setAsleep(asleep);
    body.isDebris = world.debris().contains(body.handle());
    body.settled = asleep && world.bodies().at(body.handle()).settled;
    broadphase.add(body.object, !asleep);
    if (!asleep) joinAwake(body);
    return true;
}

void PhysicsWorld::Impl::destroyDynamic(uint32_t slot) {
    DynamicBody& body = *dynamics[slot];
    broadphase.remove(body.object);
    leaveAwake(body);
    dynamics[slot].reset();
}

void PhysicsWorld::Impl::forget(const FrameChanges& changes) {
    for (const ShapeHandle handle : changes.shapesDestroyed) destroyStatic(handle.slot());
    for (const BodyHandle handle : changes.bodiesDestroyed) {
        DynamicBody* body = dynamicAt(handle.slot());
        if (!body || body->handle() != handle) continue;
        const glm::dvec3 low = body->object.low, high = body->object.high;
        const bool wasThere = !body->quarantined();
        destroyDynamic(handle.slot());
        if (wasThere) wakeTouching(low, high);
    }
}

void PhysicsWorld::Impl::refreshStatic(const FrameChanges& changes, const World& world) {
    for (const ShapeHandle handle : changes.carved) {
        const Shape* shape = world.shapes().find(handle);
        if (!shape || !world.bodies().at(shape->body).isStatic || handle.slot() >= statics.size() ||
            !statics[handle.slot()])
            continue;
        std::vector<glm::ivec3> bricks;
        changedBricks(changes, handle, bricks);
        CollisionObject& object = *statics[handle.slot()];
        object.collider.parts[0]->update(*shape, bricks, world.materials());
        broadphase.touch(object);
        const glm::dmat3 axes = glm::mat3_cast(object.pose.rotation);
        const double half = 0.5 * kBrickSize * shape->voxelSize;
        const glm::dvec3 extent = (glm::abs(axes[0]) + glm::abs(axes[1]) + glm::abs(axes[2])) * half;
        for (const glm::ivec3& brick : bricks) {
            const glm::dvec3 center = object.pose.transformPoint((glm::dvec3(brick) * 2.0 + 1.0) * half);
            wakeTouching(center - extent, center + extent);
        }
        if (object.collider.empty()) destroyStatic(handle.slot());
    }
    for (const ShapeHandle handle : changes.shapesCreated) {
        const Shape* shape = world.shapes().find(handle);
        if (shape && world.bodies().at(shape->body).isStatic) createStatic(world, handle);
    }
}

void PhysicsWorld::Impl::refreshDynamic(const FrameChanges& changes, const World& world) {
    struct Touched {
        BodyHandle body;
        bool onlyCarved;
    };
    std::vector<Touched> touched;
    for (const BodyHandle handle : changes.bodiesCreated) touched.push_back({handle, false});
    for (const BodyHandle handle : changes.teleported) touched.push_back({handle, false});
    const auto addOwner = [&](ShapeHandle handle, bool onlyCarved) {
        if (const Shape* shape = world.shapes().find(handle)) touched.push_back({shape->body, onlyCarved});
    };
    for (const ShapeHandle handle : changes.carved) addOwner(handle, true);
    for (const ShapeHandle handle : changes.shapesCreated) addOwner(handle, false);
    for (const ShapeHandle handle : changes.shapesDestroyed)
        if (handle.slot() < shapeBody.size()) touched.push_back({shapeBody[handle.slot()], false});
    std::sort(touched.begin(), touched.end(), [](const Touched& a, const Touched& b) {
        return a.body.slot() != b.body.slot() ? a.body.slot() < b.body.slot() : a.onlyCarved < b.onlyCarved;
    });
    touched.erase(std::unique(touched.begin(), touched.end(),
                              [](const Touched& a, const Touched& b) { return a.body.slot() == b.body.slot(); }),
                  touched.end());

    for (const auto& [handle, onlyCarved] : touched) {
        const Body* body = world.bodies().find(handle);
        if (!body || body->isStatic) continue;
        DynamicBody* known = dynamicAt(handle.slot());
        if (known) {  // out, of another shape about its new centre, and back in
            const glm::dvec3 low = known->object.low, high = known->object.high;
            const bool wasThere = !known->quarantined();
            broadphase.remove(known->object);
            leaveAwake(*known);
            if (wasThere) wakeTouching(low, high);
            if (onlyCarved && known->updateShape(world, changes) && enter(world, *known, false)) continue;
            dynamics[handle.slot()].reset();
        }
        for (const ShapeHandle shape : body->shapes)  // a static body that came loose
            destroyStatic(shape.slot());
        const bool isPlaced =
            std::find(changes.teleported.begin(), changes.teleported.end(), handle) != changes.teleported.end();
        createDynamic(world, handle, body->asleep && (!known || isPlaced));
    }
}

/// What may touch now, or no longer, is looked at anew.
void PhysicsWorld::Impl::refreshFilters(const FrameChanges& changes, const World& world) {
    for (const ShapeHandle handle : changes.filters) {
        const Shape* shape = world.shapes().find(handle);
        if (!shape) continue;
        DynamicBody* dynamic = dynamicAt(shape->body.slot());
        CollisionObject* object = handle.slot() < statics.size() ? statics[handle.slot()].get() : nullptr;
        const CollisionFilter filter{shape->collisionLayer, shape->collisionMask};
        if (object) object->collider.parts[0]->setFilter(filter);
        if (!object && dynamic) dynamic->setFilter(handle, filter), object = &dynamic->object;
        if (!object) continue;
        object->setPose(object->pose);
        broadphase.touch(*object);
        wakeTouching(object->low, object->high);
    }
}

/// What floated on water that is gone falls, what lies where water is now may float.
void PhysicsWorld::Impl::refreshWaters(const FrameChanges& changes, const World& world) {
    for (const WaterHandle handle : changes.waters) {
        const std::optional<WorldBox> box =
            waters.set(handle.slot(), world.waters().find(world.waters().handleAt(handle.slot())));
        if (box) wakeTouching(box->low, box->high);
    }
}

void PhysicsWorld::Impl::refreshCharacters(const FrameChanges& changes, const World& world) {
    if (changes.characters.empty() && !changes.levelReplaced) return;
    characters.clear();
    world.characters().forEach(
        [&](CharacterHandle handle, const Character& character) { characters.emplace_back(handle, character); });
}

void PhysicsWorld::Impl::applyImpulses(const FrameChanges& changes) {
    for (const ImpulseApplied& applied : changes.impulses) {
        DynamicBody* body = dynamicAt(applied.body.slot());
        if (!body || body->handle() != applied.body || body->quarantined()) continue;
        wake(*body);
        body->slowSeconds = 0.0;
        body->applyImpulse(applied.impulse, applied.position);
    }
    quarantineBroken();
}

}  // namespace rubble
