#include "runtime/world/history/world_delta.h"

#include <algorithm>

namespace rubble {
namespace {

/// Puts what `target` says into the slots; returns what was there.
template <class Map, class Handle, class T>
SlotValues<Handle, T> swapSlots(Map& map, SlotValues<Handle, T>&& target) {
    SlotValues<Handle, T> before;
    for (const auto& [slot, wanted] : target) {
        const Handle there = map.handleAt(slot);
        auto& was = before[slot];
        was.first = there;
        if (!there) continue;
        was.second = std::move(map.at(there));
        if (there != wanted.first) map.erase(there);
    }
    for (auto& [slot, wanted] : target) {
        if (!wanted.first) continue;
        if (T* value = map.find(wanted.first))
            *value = std::move(*wanted.second);
        else
            map.restore(wanted.first, std::move(*wanted.second));
    }
    return before;
}

/// What was in the slots, if it is no more, and what is.
template <class Map, class Handle, class T>
void journalSlots(const SlotValues<Handle, T>& before, const Map& now, std::vector<Handle>& out) {
    for (const auto& [slot, was] : before) {
        const Handle is = now.handleAt(slot);
        if (was.first && was.first != is) out.push_back(was.first);
        if (is) out.push_back(is);
    }
}

bool sameMotion(const Body& a, const Body& b) {
    return a.pose == b.pose && a.velocity == b.velocity && a.angularVelocity == b.angularVelocity &&
           a.asleep == b.asleep && a.settled == b.settled && a.isStatic == b.isStatic && a.shapes == b.shapes;
}

void journalBricks(ShapeHandle handle, const Shape& was, const Shape& is, FrameChanges& changes) {
    bool isCarved = false;
    is.grid.forEachUnshared(was.grid, [&](glm::ivec3 position) {
        const Brick *before = was.grid.brickAt(position), *now = is.grid.brickAt(position);
        isCarved = isCarved || (before ? before->occupancy : BrickBits{}) != (now ? now->occupancy : BrickBits{});
        changes.bricks.push_back({handle, position, is.grid.shareBrick(position)});
    });
    if (isCarved) changes.carved.push_back(handle);
    if (was.palette != is.palette || was.paintColors != is.paintColors) changes.palettes.push_back(handle);
    if (was.collisionLayer != is.collisionLayer || was.collisionMask != is.collisionMask)
        changes.filters.push_back(handle);
}

void journalShape(ShapeHandle was, const std::optional<Shape>& before, ShapeHandle is, const Shape* now,
                  FrameChanges& changes) {
    if (was == is && now && before->body == now->body && before->local == now->local &&
        before->voxelSize == now->voxelSize && before->grid.size() == now->grid.size())
        return journalBricks(is, *before, *now, changes);
    if (was) changes.shapesDestroyed.push_back(was);
    if (is) changes.shapesCreated.push_back(is);
}

}  // namespace

WorldDelta World::swap(WorldDelta target, FrameChanges& changes) {
    WorldDelta before;
    before.imported = std::exchange(m_imported, target.imported);
    before.removed = std::exchange(m_removed, target.removed);
    before.fire = std::exchange(m_fire, std::move(target.fire));
    changes.firesChanged = before.fire.isActive() || m_fire.isActive();
    if (target.environment) {
        before.environment = swapEnvironment(*target.environment);
        changes.environmentChanged = true;
    }
    before.freeBodies = m_bodies.freeSlots();
    before.freeShapes = m_shapes.freeSlots();
    before.freeLights = m_lights.freeSlots();
    before.freeWaters = m_waters.freeSlots();
    before.freeTriggers = m_triggers.freeSlots();
    before.freeCharacters = m_characters.freeSlots();
    before.bodies = swapSlots(m_bodies, std::move(target.bodies));
    before.shapes = swapSlots(m_shapes, std::move(target.shapes));
    before.lights = swapSlots(m_lights, std::move(target.lights));
    before.groups = swapSlots(m_groups, std::move(target.groups));
    before.waters = swapSlots(m_waters, std::move(target.waters));
    before.triggers = swapSlots(m_triggers, std::move(target.triggers));
    before.characters = swapSlots(m_characters, std::move(target.characters));
    before.freeJoints = m_joints.freeSlots();
    before.joints = swapSlots(m_joints, std::move(target.joints));
    m_joints.setFreeSlots(target.freeJoints);
    m_bodies.setFreeSlots(target.freeBodies);
    m_shapes.setFreeSlots(target.freeShapes);
    m_lights.setFreeSlots(target.freeLights);
    m_waters.setFreeSlots(target.freeWaters);
    m_triggers.setFreeSlots(target.freeTriggers);
    m_characters.setFreeSlots(target.freeCharacters);

    for (const auto& [slot, was] : before.shapes) {
        if (was.first && was.first != m_shapes.handleAt(slot)) removeShapeBounds(was.first);
        if (m_shapes.handleAt(slot)) updateShapeBounds(m_shapes.handleAt(slot));
    }
    for (const auto& [slot, was] : before.bodies) {
        const BodyHandle is = m_bodies.handleAt(slot);
        if (was.first && was.first != is) changes.bodiesDestroyed.push_back(was.first);
        if (is && was.first != is) changes.bodiesCreated.push_back(is);
        if (is && was.first == is && !sameMotion(*was.second, m_bodies.at(is))) changes.teleported.push_back(is);
        updateDebris(was.first);
        if (!is) continue;
        updateDebris(is);
        for (const ShapeHandle shape : m_bodies.at(is).shapes) updateShapeBounds(shape);
    }
    for (const auto& [slot, was] : before.shapes) {
        const ShapeHandle is = m_shapes.handleAt(slot);
        journalShape(was.first, was.second, is, m_shapes.find(is), changes);
    }
    journalJoints(before, changes);
    journalSlots(before.lights, m_lights, changes.lights);
    for (const auto& [slot, was] : before.groups) {
        const LightGroupHandle is = m_groups.handleAt(slot);
        if (!is) continue;
        changes.groups.push_back(is);
        m_flickeringGroups +=
            uint32_t(m_groups.at(is).failingSince != 0) - uint32_t(was.second && was.second->failingSince != 0);
        if (m_groups.at(is).out && !(was.second && was.second->out)) changes.groupsOut.push_back(is);
    }
    journalSlots(before.waters, m_waters, changes.waters);
    for (const auto& [slot, was] : before.triggers) {
        m_triggerBounds.remove(slot);
        if (const TriggerHandle is = m_triggers.handleAt(slot))
            m_triggerBounds.update(slot, m_triggers.at(is).bounds());
    }
    journalSlots(before.triggers, m_triggers, changes.triggers);
    journalSlots(before.characters, m_characters, changes.characters);
    return before;
}

FrameChanges World::applyDelta(std::optional<WorldDelta> delta) {
    FrameChanges changes;
    changes.step = ++m_step;
    changes.levelReplaced = std::exchange(m_levelReplaced, false);
    changes.unsettled = std::exchange(m_revived, {});
    if (delta) swap(std::move(*delta), changes);
    return changes;
}

}  // namespace rubble
