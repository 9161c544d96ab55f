#include "physics/stages/physics_bodies.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr double kTouchDistance = 0.02;  ///< metres between bounds up to which bodies count as touching

template <class T>
T& slotOf(std::vector<T>& table, uint32_t slot) {
    if (table.size() <= slot) table.resize(slot + 1);
    return table[slot];
}

}  // namespace

void PhysicsBodies::createStatic(const World& world, ShapeHandle handle) {
    const Shape& shape = world.shapes().at(handle);
    destroyStatic(handle.slot());
    slotOf(m_handles, shape.body.slot()) = shape.body;
    slotOf(m_owners, handle.slot()) = shape.body;
    auto object = std::make_unique<CollisionObject>();
    object->collider.parts.push_back(std::make_unique<ColliderPart>(shape, Pose{}, world.materials()));
    if (object->collider.empty()) return;
    object->setPose(shapeToWorld(world, handle));
    object->body = shape.body.slot();
    object->number = kStaticObject | handle.slot();
    m_broadphase.add(*object, false);
    slotOf(m_statics, handle.slot()) = std::move(object);
}

void PhysicsBodies::destroyStatic(uint32_t shapeSlot) {
    if (shapeSlot >= m_statics.size() || !m_statics[shapeSlot]) return;
    m_broadphase.remove(*m_statics[shapeSlot]);
    m_statics[shapeSlot].reset();
}

void PhysicsBodies::updateStatic(const World& world, ShapeHandle handle, const FrameChanges& changes) {
    const Shape& shape = world.shapes().at(handle);
    if (handle.slot() >= m_statics.size() || !m_statics[handle.slot()]) return;
    std::vector<glm::ivec3> bricks;
    changedBricks(changes, handle, bricks);
    CollisionObject& object = *m_statics[handle.slot()];
    object.collider.parts[0]->update(shape, bricks, world.materials());
    m_broadphase.touch(object);
    const glm::dmat3 axes = glm::mat3_cast(object.pose.rotation);
    const double half = 0.5 * kBrickSize * shape.voxelSize;
    const glm::dvec3 extent = (glm::abs(axes[0]) + glm::abs(axes[1]) + glm::abs(axes[2])) * half;
    for (const glm::ivec3& brick : bricks) {
        const glm::dvec3 center = object.pose.transformPoint((glm::dvec3(brick) * 2.0 + 1.0) * half);
        wakeTouching(center - extent, center + extent);
    }
    if (object.collider.empty()) destroyStatic(handle.slot());
}

void PhysicsBodies::createDynamic(const World& world, BodyHandle handle, bool asleep) {
    const uint32_t slot = handle.slot();
    slotOf(m_handles, slot) = handle;
    for (const ShapeHandle shape : world.bodies().at(handle).shapes) slotOf(m_owners, shape.slot()) = handle;
    std::unique_ptr<DynamicBody>& body = slotOf(m_dynamics, slot);
    body = std::make_unique<DynamicBody>(world, handle);
    if (insert(world, *body, asleep)) return;
    logWarning(
        fmt::format("physics: body {} '{}' is not simulated. Expected solid voxels, and a pose and velocity that are "
                    "finite and within 1,000 km of the middle of the level",
                    slot, world.bodies().at(handle).name));
    body->setAsleep(true);
    body->quarantine();
}

/// Puts a body into the broadphase and among the awake; false if its numbers are invalid or it has no voxels.
bool PhysicsBodies::insert(const World& world, DynamicBody& body, bool asleep) {
    if (body.object.collider.empty() || !body.finite() || m_limits.isOutOfRange(body, m_broadphase.origin()))
        return false;
    m_limits.clamp(body);
    body.setAsleep(asleep);
    body.isDebris = world.data().debris.contains(body.handle());
    body.settled = asleep && world.bodies().at(body.handle()).settled;
    m_broadphase.add(body.object, !asleep);
    if (!asleep) m_awake.add(body);
    return true;
}

void PhysicsBodies::destroyDynamic(BodyHandle handle) {
    DynamicBody* body = find(handle);
    if (!body) return;
    const glm::dvec3 low = body->object.low, high = body->object.high;
    const bool wasThere = !body->quarantined();
    m_broadphase.remove(body->object);
    m_awake.remove(*body);
    std::erase(m_ended, handle.slot());
    m_dynamics[handle.slot()].reset();
    if (wasThere) wakeTouching(low, high);
}

void PhysicsBodies::updateDynamic(const World& world, BodyHandle handle, const FrameChanges& changes, bool onlyCarved) {
    const Body& body = world.bodies().at(handle);
    DynamicBody* known = dynamicAt(handle.slot());
    if (known) {  // taken out, and put back with another shape and centre of mass
        const glm::dvec3 low = known->object.low, high = known->object.high;
        const bool wasThere = !known->quarantined();
        m_broadphase.remove(known->object);
        m_awake.remove(*known);
        std::erase(m_ended, handle.slot());
        if (wasThere) wakeTouching(low, high);
        if (onlyCarved && known->updateShape(world, changes) && insert(world, *known, false)) return;
        m_dynamics[handle.slot()].reset();
    }
    for (const ShapeHandle shape : body.shapes) destroyStatic(shape.slot());  // it may have been static until now
    const bool isTeleported =
        std::find(changes.teleported.begin(), changes.teleported.end(), handle) != changes.teleported.end();
    createDynamic(world, handle, body.asleep && (!known || isTeleported));
}

void PhysicsBodies::updateFilter(const World& world, ShapeHandle handle) {
    const Shape& shape = world.shapes().at(handle);
    DynamicBody* dynamic = dynamicAt(shape.body.slot());
    CollisionObject* object = handle.slot() < m_statics.size() ? m_statics[handle.slot()].get() : nullptr;
    const CollisionFilter filter{shape.collisionLayer, shape.collisionMask};
    if (object) object->collider.parts[0]->setFilter(filter);
    if (!object && dynamic) dynamic->setFilter(handle, filter), object = &dynamic->object;
    if (!object) return;
    object->setPose(object->pose);
    m_broadphase.touch(*object);
    wakeTouching(object->low, object->high);
}

DynamicBody* PhysicsBodies::find(BodyHandle handle) const {
    DynamicBody* body = handle ? dynamicAt(handle.slot()) : nullptr;
    return body && body->handle() == handle ? body : nullptr;
}

const std::vector<CollisionObject*>& PhysicsBodies::objectsIn(glm::dvec3 low, glm::dvec3 high) {
    m_found.clear();
    m_broadphase.find(low, high, m_found);
    std::sort(m_found.begin(), m_found.end(),
              [](const CollisionObject* a, const CollisionObject* b) { return a->number < b->number; });
    return m_found;
}

void PhysicsBodies::wake(DynamicBody& body) {
    if (!body.asleep() || body.quarantined()) return;
    body.wantsSleep = false;
    m_broadphase.remove(body.object);
    body.setAsleep(false);
    m_broadphase.add(body.object, true);
    m_awake.add(body);
}

void PhysicsBodies::wakeOrWait(DynamicBody& body) {
    if (!body.asleep() || body.quarantined()) return;
    if (m_awake.mayWake(body))
        wake(body);
    else
        m_awake.wait(body.handle().slot());
}

void PhysicsBodies::wakeWaiting() {
    m_awake.wakeWaiting([&](uint32_t slot) {
        if (DynamicBody* body = dynamicAt(slot)) wake(*body);
    });
}

void PhysicsBodies::wakeTouching(glm::dvec3 low, glm::dvec3 high) {
    for (CollisionObject* object : objectsIn(low - kTouchDistance, high + kTouchDistance))
        if (object->dynamic) wakeOrWait(*object->dynamic);
}

void PhysicsBodies::putToSleep(DynamicBody& body) {
    body.setAsleep(true);
    m_broadphase.remove(body.object);
    m_broadphase.add(body.object, false);
    m_ended.push_back(body.handle().slot());
}

void PhysicsBodies::removeEnded() {
    for (const uint32_t slot : m_ended) m_awake.remove(*m_dynamics[slot]);
}

void PhysicsBodies::quarantineInvalid() {
    for (const uint32_t slot : awake()) {
        DynamicBody& body = at(slot);
        if (body.finite() && !m_limits.isOutOfRange(body, m_broadphase.origin())) {
            m_limits.clamp(body);
            continue;
        }
        if (!body.finite())
            logWarning(
                fmt::format("physics: the pose or velocity of body {} is not finite; it is frozen where it "
                            "last was. Look for an impulse, velocity or force that is NaN or infinite",
                            slot));
        m_broadphase.remove(body.object);
        body.restore();
        body.setAsleep(true);
        body.quarantine();
        m_ended.push_back(slot);
    }
    removeEnded();
}

void PhysicsBodies::reportPoses(std::vector<BodyPose>& out) {
    std::sort(m_ended.begin(), m_ended.end());
    auto next = m_ended.begin();
    const auto add = [&](uint32_t slot) {
        if (m_dynamics[slot] && m_dynamics[slot]->refresh()) out.push_back(m_dynamics[slot]->state());
    };
    for (const uint32_t slot : awake()) {
        for (; next != m_ended.end() && *next < slot; ++next) add(*next);
        if (next != m_ended.end() && *next == slot) ++next;  // it fell asleep and woke in one step
        add(slot);
    }
    for (; next != m_ended.end(); ++next) add(*next);
    m_ended.clear();
}

}  // namespace rubble
