#include <algorithm>

#include "physics/physics_impl.h"

// How physics follows World: it creates, changes and destroys what the journal of a step names, in an order that does
// not depend on the journal's.

namespace rubble {
namespace {

bool isStatic(const World& world, ShapeHandle handle) {
    const Shape* shape = world.shapes().find(handle);
    return shape && world.bodies().at(shape->body).isStatic;
}

/// A static shape whose grid got another box stays until replaceStatic() compares the two.
void destroyRemoved(PhysicsBodies& bodies, const FrameChanges& changes, const World& world) {
    for (const ShapeHandle handle : changes.shapesDestroyed)
        if (!isStatic(world, handle)) bodies.removeStatic(handle.slot());
    for (const BodyHandle handle : changes.bodiesDestroyed) bodies.destroyDynamic(handle);
}

/// Also takes over the cuts of shapes that stand no longer, for what touched them there.
void updateStatics(PhysicsBodies& bodies, const FrameChanges& changes, const World& world) {
    for (const ShapeHandle handle : changes.shapesCreated)
        if (isStatic(world, handle)) bodies.replaceStatic(world, handle);
    for (const ShapeHandle handle : changes.carved)
        if (world.shapes().find(handle)) bodies.updateStatic(world, handle, changes);
}

/// Updates each changed body once, in slot order. One with other shapes is created from World again.
void updateDynamics(PhysicsBodies& bodies, const FrameChanges& changes, const World& world) {
    struct Changed {
        BodyHandle body;
        bool keepsShapes;
    };
    std::vector<Changed> changed;
    const auto add = [&](BodyHandle handle, bool keepsShapes) {
        const Body* body = world.bodies().find(handle);
        if (body && !body->isStatic) changed.push_back({handle, keepsShapes});
    };
    const auto addOwner = [&](ShapeHandle handle, bool keepsShapes) {
        if (const Shape* shape = world.shapes().find(handle)) add(shape->body, keepsShapes);
    };
    for (const BodyHandle handle : changes.bodiesCreated) add(handle, false);
    for (const BodyHandle handle : changes.teleported) add(handle, true);
    for (const ShapeHandle handle : changes.carved) addOwner(handle, true);
    for (const ShapeHandle handle : changes.shapesCreated) addOwner(handle, false);
    for (const ShapeHandle handle : changes.shapesDestroyed)
        if (handle.slot() < bodies.owners().size()) add(bodies.owners()[handle.slot()], false);
    std::sort(changed.begin(), changed.end(), [](const Changed& a, const Changed& b) {
        return a.body.slot() != b.body.slot() ? a.body.slot() < b.body.slot() : a.keepsShapes < b.keepsShapes;
    });
    changed.erase(std::unique(changed.begin(), changed.end(),
                              [](const Changed& a, const Changed& b) { return a.body == b.body; }),
                  changed.end());
    for (const auto& [handle, keepsShapes] : changed) bodies.updateDynamic(world, handle, changes, keepsShapes);
}

/// Takes over changed waters and wakes the bodies in them: they may fall or float now.
void updateWaters(PhysicsBodies& bodies, WaterVolumes& waters, const FrameChanges& changes, const World& world) {
    for (const WaterHandle handle : changes.waters) {
        const std::optional<WorldBox> box =
            waters.set(handle.slot(), world.waters().find(world.waters().handleAt(handle.slot())));
        if (box) bodies.wakeTouching(box->low, box->high);
    }
}

/// After an undo or redo: what is known of the steps before is of another past. That of joints forgets PhysicsJoints.
void forgetMotion(PhysicsBodies& bodies, ContactDetection& contacts, const World& world) {
    contacts.forget();
    for (const BodyHandle handle : bodies.handles())
        if (DynamicBody* body = bodies.find(handle); body && !body->quarantined()) body->forgetMotion(world);
}

/// Puts those to sleep again that the changes have woken, or let wait to wake, though World says that they sleep: all
/// where it only undid or redid, else those that it has placed or put to sleep itself.
void keepAsleep(PhysicsBodies& bodies, const FrameChanges& changes, const World& world) {
    const auto keep = [&](BodyHandle handle) {
        const Body* kept = world.bodies().find(handle);
        DynamicBody* body = bodies.find(handle);
        if (!kept || !kept->asleep || !body || body->quarantined()) return;
        if (!kept->waitsToWake) bodies.budget().forget(*body);
        if (body->asleep()) return;
        bodies.putToSleep(*body);
        body->settled = kept->settled;
    };
    for (const auto* list : {&changes.bodiesCreated, &changes.teleported})
        for (const BodyHandle handle : *list) keep(handle);
    if (changes.keepsSleep)
        for (const BodyHandle handle : bodies.handles()) keep(handle);
    bodies.removeEnded();
}

}  // namespace

void PhysicsWorld::Impl::setGravity(const World& world) {
    if (glm::dvec3(world.environment().gravity) == gravity) return;
    gravity = world.environment().gravity;
    for (uint32_t slot = 0; slot < bodies.handles().size(); ++slot)
        if (DynamicBody* body = bodies.dynamicAt(slot)) bodies.wakeOrWait(*body);
}

void PhysicsWorld::Impl::load(const World& world) {
    const WorldBox& level = world.data().bounds;  // not of the bodies: they move, and a save must change nothing
    bodies.broadphase().setOrigin(glm::round((level.low + level.high) * 0.5));
    bodies.limits().setOrigin(bodies.broadphase().origin());
    setGravity(world);
    characters.load(world, bodies);
    world.waters().forEach([&](WaterHandle handle, const Water& water) { waters.set(handle.slot(), &water); });
    world.bodies().forEach([&](BodyHandle handle, const Body&) { bodies.load(world, handle); });
    world.joints().forEach([&](JointHandle handle, const Joint&) { joints.create(world, handle, bodies); });
}

void PhysicsWorld::Impl::applyChanges(const FrameChanges& changes, const World& world) {
    setGravity(world);
    if (!changes.empty()) {
        destroyRemoved(bodies, changes, world);
        updateStatics(bodies, changes, world);
        updateDynamics(bodies, changes, world);
        for (const ShapeHandle handle : changes.filters)
            if (world.shapes().find(handle)) bodies.updateFilter(world, handle);
        updateWaters(bodies, waters, changes, world);
        if (!changes.characters.empty()) characters.load(world, bodies);
        for (const BodyHandle handle : changes.woken)
            if (DynamicBody* body = bodies.find(handle); body && !world.bodies().at(handle).asleep) bodies.wake(*body);
    }
    if (changes.isRestored) forgetMotion(bodies, contacts, world);
    joints.apply(changes, world, bodies);
    keepAsleep(bodies, changes, world);
}

void PhysicsWorld::Impl::applyImpulses(const FrameChanges& changes) {
    for (const ImpulseApplied& applied : changes.impulses) {
        DynamicBody* body = bodies.find(applied.body);
        if (!body || body->quarantined()) continue;
        bodies.wake(*body);
        body->applyImpulse(applied.impulse, applied.position);
    }
    bodies.quarantineInvalid();
}

}  // namespace rubble
