#include "physics/stages/physics_bodies.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr size_t kMinWakes = 8;  ///< in a step, where settings allow so many: nothing waits for ever

template <class T>
T& slotOf(std::vector<T>& table, uint32_t slot) {
    if (table.size() <= slot) table.resize(slot + 1);
    return table[slot];
}

/// Whether the brick has a voxel where the grid, in which it begins at cell `at`, has none.
bool hasOthers(const Brick& brick, glm::ivec3 at, const VoxelGrid& grid) {
    if (const Brick* there = at % kBrickSize == glm::ivec3(0) ? grid.brickAt(at / kBrickSize) : nullptr;
        there && there->occupancy == brick.occupancy)
        return false;
    bool any = false;
    forEachVoxel(brick.occupancy, [&](int i) { any = any || grid.at(at + voxelInBrick(i)) == 0; });
    return any;
}

/// The bricks with voxels that another grid has not. offset: of the other's cell 0.
std::vector<glm::ivec3> bricksNotIn(const VoxelGrid& other, glm::ivec3 offset, const VoxelGrid& grid) {
    std::vector<glm::ivec3> bricks;
    grid.forEachBrick([&](glm::ivec3 brick, const BrickRef& content) {
        if (hasOthers(*content, brick * kBrickSize - offset, other)) bricks.push_back(brick);
    });
    return bricks;
}

}  // namespace

void PhysicsBodies::createStatic(const World& world, ShapeHandle handle) {
    const Shape& shape = world.shapes().at(handle);
    slotOf(m_handles, shape.body.slot()) = shape.body;
    slotOf(m_owners, handle.slot()) = shape.body;
    auto object = std::make_unique<CollisionObject>();
    object->collider.parts.push_back(std::make_unique<ColliderPart>(shape, Pose{}, world.materials()));
    object->setPose(shapeToWorld(world, handle));
    object->body = shape.body.slot();
    object->number = kStaticObject | handle.slot();
    if (!object->collider.empty()) m_broadphase.add(*object, false);
    slotOf(m_statics, handle.slot()) = std::move(object);
}

void PhysicsBodies::replaceStatic(const World& world, ShapeHandle handle) {
    const std::unique_ptr<CollisionObject> before = takeStatic(handle.slot());
    createStatic(world, handle);
    wakeAtChangedCells(before.get(), *m_statics[handle.slot()]);
}

/// Takes an object out of the broadphase; null: there is none.
std::unique_ptr<CollisionObject> PhysicsBodies::takeStatic(uint32_t shapeSlot) {
    if (shapeSlot >= m_statics.size() || !m_statics[shapeSlot]) return nullptr;
    m_broadphase.remove(*m_statics[shapeSlot]);
    return std::move(m_statics[shapeSlot]);
}

void PhysicsBodies::removeStatic(uint32_t shapeSlot) {
    const std::unique_ptr<CollisionObject> object = takeStatic(shapeSlot);
    if (object && !object->collider.empty()) wakeTouching(object->low, object->high);
}

/// Adds it to the broadphase again, because it may be larger after an undo or a merge.
void PhysicsBodies::updateStatic(const World& world, ShapeHandle handle, const FrameChanges& changes) {
    if (handle.slot() >= m_statics.size() || !m_statics[handle.slot()]) return;
    std::vector<glm::ivec3> bricks;
    changedBricks(changes, handle, bricks);
    CollisionObject& object = *m_statics[handle.slot()];
    m_broadphase.remove(object);
    object.collider.parts[0]->update(world.shapes().at(handle), bricks, world.materials());
    if (!object.collider.empty()) m_broadphase.add(object, false);
    if (bricks.empty()) return wakeTouching(object.low, object.high);  // it is of other materials
    wakeAtBricks(object, bricks);
}

void PhysicsBodies::wakeAtBricks(const CollisionObject& object, const std::vector<glm::ivec3>& bricks) {
    const glm::dvec3 half(0.5 * kBrickSize * object.collider.parts[0]->voxelSize());
    for (const glm::ivec3& brick : bricks) {
        const glm::dvec3 center = object.pose.transformPoint((glm::dvec3(brick) * 2.0 + 1.0) * half);
        const WorldBox box = boundsOfBox(center, half, object.pose.rotation);
        wakeTouching(box.low, box.high);
    }
}

/// Of two objects of one static shape; before: null: there was none. If their cells do not line up, all of both counts
/// as changed.
void PhysicsBodies::wakeAtChangedCells(const CollisionObject* before, const CollisionObject& now) {
    if (before && !before->collider.empty() && !now.collider.empty()) {
        const ColliderPart &was = *before->collider.parts[0], &is = *now.collider.parts[0];
        const glm::dvec3 cells = before->pose.inversePoint(now.pose.position) / was.voxelSize();
        const glm::dvec3 offset = glm::round(cells);
        if (before->pose.rotation == now.pose.rotation && was.voxelSize() == is.voxelSize() &&
            glm::length(cells - offset) < 1e-3 && glm::length(offset) < 3.0 * kMaxGridSize) {
            wakeAtBricks(*before, bricksNotIn(is.grid(), glm::ivec3(offset), was.grid()));
            return wakeAtBricks(now, bricksNotIn(was.grid(), -glm::ivec3(offset), is.grid()));
        }
    }
    for (const CollisionObject* object : {before, &now})
        if (object && !object->collider.empty()) wakeTouching(object->low, object->high);
}

/// Or replaces it. One whose numbers are invalid is quarantined, with a warning: one that is too far away, with that of
/// LimitMonitor.
void PhysicsBodies::createDynamic(const World& world, BodyHandle handle, bool asleep) {
    const uint32_t slot = handle.slot();
    slotOf(m_handles, slot) = handle;
    for (const ShapeHandle shape : world.bodies().at(handle).shapes) slotOf(m_owners, shape.slot()) = handle;
    std::unique_ptr<DynamicBody>& body = slotOf(m_dynamics, slot);
    body = std::make_unique<DynamicBody>(world, handle);
    if (insert(world, *body, asleep)) return;
    if (!world.bodies().at(handle).shapes.empty() && (body->object.collider.empty() || !body->finite()))
        logWarning(fmt::format(
            "physics: body {} '{}' is not simulated. Expected solid voxels, and a pose and velocity that are finite",
            slot, world.bodies().at(handle).name));
    body->setAsleep(true);
    body->quarantine();
}

void PhysicsBodies::load(const World& world, BodyHandle handle) {
    const Body& body = world.bodies().at(handle);
    if (body.isStatic) {
        for (const ShapeHandle shape : body.shapes) createStatic(world, shape);
        return;
    }
    createDynamic(world, handle, body.asleep);
    DynamicBody& made = at(handle.slot());
    made.isAsLoaded = true;
    made.wakesLoad = false;  // what it bears was asleep already
}

/// Puts a body into the broadphase and among the awake; false if its numbers are invalid or it has no voxels.
bool PhysicsBodies::insert(const World& world, DynamicBody& body, bool asleep) {
    if (body.object.collider.empty() || !body.finite() || m_limits.isOutOfRange(body)) return false;
    m_limits.clamp(body);
    body.setAsleep(asleep);
    body.isDebris = world.data().debris.contains(body.handle());
    body.settled = asleep && world.bodies().at(body.handle()).settled;
    m_broadphase.add(body.object, !asleep);
    if (!asleep) m_awake.add(body);
    if (asleep && world.bodies().at(body.handle()).waitsToWake) m_awake.wait(body);
    return true;
}

void PhysicsBodies::destroyDynamic(BodyHandle handle) {
    DynamicBody* body = find(handle);
    if (!body) return;
    const glm::dvec3 low = body->object.low, high = body->object.high;
    const bool wasThere = !body->quarantined();
    m_broadphase.remove(body->object);
    m_awake.remove(*body);
    m_awake.forget(*body);
    std::erase(m_ended, handle.slot());
    m_dynamics[handle.slot()].reset();
    if (wasThere) wakeTouching(low, high);
}

void PhysicsBodies::updateDynamic(const World& world, BodyHandle handle, const FrameChanges& changes,
                                  bool keepsShapes) {
    const Body& body = world.bodies().at(handle);
    DynamicBody* known = dynamicAt(handle.slot());
    if (known) {  // taken out, and put back with another shape and centre of mass
        const glm::dvec3 low = known->object.low, high = known->object.high;
        const bool wasThere = !known->quarantined();
        m_broadphase.remove(known->object);
        m_awake.remove(*known);
        m_awake.forget(*known);
        std::erase(m_ended, handle.slot());
        if (wasThere) wakeTouching(low, high);
    }
    const auto isTeleported = [&] {
        return std::find(changes.teleported.begin(), changes.teleported.end(), handle) != changes.teleported.end();
    };
    const bool asleep = body.asleep && (!known || isTeleported());
    const bool isPlaced = known && known->state().pose != body.pose;
    if (!(keepsShapes && known && known->update(world, changes) && insert(world, *known, asleep))) {
        for (const ShapeHandle shape : body.shapes) takeStatic(shape.slot());  // it may have been static until now
        createDynamic(world, handle, asleep);
    }
    DynamicBody& now = *dynamicAt(handle.slot());
    now.isPlaced = isPlaced;
    if (!now.asleep() || now.quarantined()) return;
    for (CollisionObject* object : objectsIn(now.object.low, now.object.high))  // what sleeps pushes nothing away
        if (object->dynamic && object->dynamic != &now) wakeOrWait(*object->dynamic);
}

void PhysicsBodies::updateFilter(const World& world, ShapeHandle handle) {
    const Shape& shape = world.shapes().at(handle);
    DynamicBody* dynamic = dynamicAt(shape.body.slot());
    CollisionObject* object = handle.slot() < m_statics.size() ? m_statics[handle.slot()].get() : nullptr;
    const CollisionFilter filter{shape.collisionLayer, shape.collisionMask};
    ColliderPart* part = object ? object->collider.parts[0].get() : dynamic ? dynamic->partOf(handle) : nullptr;
    if (part) part->setFilter(filter), part->setCollisionShape(shape.collisionShape);
    if (part && shape.collisionShape != CollisionShape::Voxels && !part->round())
        logWarning(
            fmt::format("set_collision_shape: shape \"{}\" is touched as voxels, not as something round: its voxels "
                        "leave more than one voxel to the round surface around them",
                        shape.name));
    if (!object && dynamic) object = &dynamic->object;
    if (!object || object->collider.empty()) return;
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
    body.setAsleep(false);
    m_broadphase.setMoving(body.object, true);
    m_awake.add(body);
}

bool PhysicsBodies::tryWake(DynamicBody& body) {
    if (!body.asleep() || body.quarantined()) return true;
    if (!m_awake.takePlace(body)) return false;
    wake(body);
    return true;
}

bool PhysicsBodies::wakeOrWait(DynamicBody& body, bool mayWait) {
    if (tryWake(body)) return true;
    if (mayWait && m_awake.wait(body)) m_nowWaiting.push_back(body.handle().slot());
    return false;
}

void PhysicsBodies::wakeWaiting(const PhysicsSettings& settings) {
    const size_t places = settings.awakeBodies - std::min<size_t>(settings.awakeBodies, awake().size());
    const size_t wakes = std::min<size_t>(settings.wakesPerStep, std::max(places, kMinWakes)), ofHits = wakes / 2;
    m_awake.setWakes(wakes - ofHits);
    m_awake.wakeWaiting([&](uint32_t slot) { return tryWake(at(slot)); });
    m_awake.setWakes(m_awake.wakes() + ofHits);
}

void PhysicsBodies::wakeTouching(glm::dvec3 low, glm::dvec3 high) {
    for (CollisionObject* object : objectsIn(low - kTouchDistance, high + kTouchDistance))
        if (DynamicBody* body = object->dynamic) {
            wakeOrWait(*body);
            if (!body->asleep()) body->restartRest();  // its support may have changed
        }
}

void PhysicsBodies::putToSleep(DynamicBody& body) {
    body.setAsleep(true);
    body.sleepLoad = {.isNoted = false};
    m_broadphase.setMoving(body.object, false);
    m_ended.push_back(body.handle().slot());
}

void PhysicsBodies::removeEnded() {
    for (const uint32_t slot : m_ended)
        if (m_dynamics[slot]->asleep()) m_awake.remove(*m_dynamics[slot]);  // else something has woken it since
}

void PhysicsBodies::quarantineInvalid() {
    std::vector<WorldBox> left;  // by bodies that are no longer there
    for (const uint32_t slot : awake()) {
        DynamicBody& body = at(slot);
        if (body.finite() && !m_limits.isOutOfRange(body)) {
            m_limits.clamp(body);
            continue;
        }
        if (!body.finite())
            logWarning(
                fmt::format("physics: the pose or velocity of body {} is not finite; it is frozen where it "
                            "last was. Look for an impulse, velocity or force that is NaN or infinite",
                            slot));
        m_broadphase.remove(body.object);
        left.push_back({body.object.low, body.object.high});
        body.restore();
        body.setAsleep(true);
        body.quarantine();
        m_ended.push_back(slot);
    }
    removeEnded();
    for (const WorldBox& box : left) wakeTouching(box.low, box.high);
}

void PhysicsBodies::reportPoses(std::vector<BodyPose>& out) {
    m_ended.insert(m_ended.end(), m_nowWaiting.begin(), m_nowWaiting.end());
    m_nowWaiting.clear();
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
    for (const uint32_t slot : m_ended)
        if (m_dynamics[slot]) m_dynamics[slot]->sleepLoad.isNoted = true;
    m_ended.clear();
}

}  // namespace rubble
