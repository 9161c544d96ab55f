#include "runtime/world/history/world_delta.h"

#include <algorithm>

namespace rubble {
namespace {

/// Puts the values of `target` into their slots; returns what was there.
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

/// Lists what was in the slots and is gone, and what is in them now.
template <class Map, class Handle, class T>
void journalSlots(const SlotValues<Handle, T>& before, const Map& now, std::vector<Handle>& out) {
    for (const auto& [slot, was] : before) {
        const Handle is = now.handleAt(slot);
        if (was.first && was.first != is) out.push_back(was.first);
        if (is) out.push_back(is);
    }
}

/// Of two states of one body. Its name and tags never change; what makes it broken is in the journal of its shapes.
bool sameState(const Body& a, const Body& b) {
    return a.pose == b.pose && a.velocity == b.velocity && a.angularVelocity == b.angularVelocity &&
           a.asleep == b.asleep && a.waitsToWake == b.waitsToWake && a.settled == b.settled &&
           a.isStatic == b.isStatic && a.shapes == b.shapes && a.restingSince == b.restingSince &&
           a.gravityScale == b.gravityScale && a.linearDamping == b.linearDamping &&
           a.angularDamping == b.angularDamping;
}

/// Whether entries of two palettes are of other materials.
bool haveOtherMaterials(const PaletteRef& a, const PaletteRef& b) {
    return a != b &&
           !std::equal(a->begin(), a->end(), b->begin(),
                       [](const PaletteEntry& one, const PaletteEntry& two) { return one.material == two.material; });
}

/// Whether two bricks, null if empty, have other voxels or materials: paint alone makes no other mass and no collider.
bool areOfOtherMaterials(const Brick* a, const Brick* b, const Palette& palette) {
    if ((a ? a->occupancy : BrickBits{}) != (b ? b->occupancy : BrickBits{})) return true;
    bool areOther = false;
    if (a && b)
        forEachVoxel(a->occupancy, [&](int voxel) {
            areOther = areOther || palette[a->at(voxel)].material != palette[b->at(voxel)].material;
        });
    return areOther;
}

void journalBricks(ShapeHandle handle, const Shape& was, const Shape& is, FrameChanges& changes) {
    bool isCarved =
        changes.materialsChanged || was.density != is.density || haveOtherMaterials(was.palette, is.palette);
    is.grid.forEachUnshared(was.grid, [&](glm::ivec3 position) {
        isCarved = isCarved || areOfOtherMaterials(was.grid.brickAt(position), is.grid.brickAt(position), *is.palette);
        changes.bricks.push_back({handle, position, is.grid.shareBrick(position)});
    });
    if (isCarved) changes.carved.push_back(handle);
    if (was.palette != is.palette || was.paintColors != is.paintColors || was.emission != is.emission)
        changes.palettes.push_back(handle);
    if (was.collisionLayer != is.collisionLayer || was.collisionMask != is.collisionMask ||
        was.collisionShape != is.collisionShape || was.strength != is.strength || was.density != is.density ||
        was.loadBearing != is.loadBearing || was.anchors != is.anchors)
        changes.filters.push_back(handle);
}

/// Whether a shape has the voxels that it had, with the same looks, weight and collisions.
bool haveEqualVoxels(const Shape& was, const Shape& is) {
    bool areEqual = was.body == is.body && was.local == is.local && was.grid.size() == is.grid.size() &&
                    was.voxelSize == is.voxelSize && was.palette == is.palette && was.paintColors == is.paintColors &&
                    was.emission == is.emission && was.density == is.density &&
                    was.collisionLayer == is.collisionLayer && was.collisionMask == is.collisionMask &&
                    was.collisionShape == is.collisionShape;
    if (areEqual) is.grid.forEachUnshared(was.grid, [&](glm::ivec3) { areEqual = false; });
    return areEqual;
}

/// Whether a body is static now and was free, or the other way round: it is another one to physics.
bool isOfOtherKind(const std::pair<BodyHandle, std::optional<Body>>& was, const WorldData& world) {
    const Body* now = was.second ? world.bodies.find(was.first) : nullptr;
    return now && now->isStatic != was.second->isStatic;
}

/// Whether a static body has another place now, or a body is of another kind: its shapes are other ones to physics,
/// shadow volume and renderer.
bool isMovedStatic(const WorldDelta& before, const WorldData& world, BodyHandle body) {
    const auto was = before.bodies.find(body.slot());
    if (was == before.bodies.end() || was->second.first != body) return false;
    const Body* now = world.bodies.find(body);
    return now && (isOfOtherKind(was->second, world) || (now->isStatic && now->pose != was->second.second->pose));
}

void journalShape(ShapeHandle was, const std::optional<Shape>& before, ShapeHandle is, const Shape* now, bool isMoved,
                  FrameChanges& changes) {
    if (was == is && now && !isMoved && before->body == now->body && before->local == now->local &&
        before->voxelSize == now->voxelSize && before->grid.size() == now->grid.size())
        return journalBricks(is, *before, *now, changes);
    if (was) changes.shapesDestroyed.push_back(was);
    if (is) changes.shapesCreated.push_back(is);
    if (was == is && now && !changes.materialsChanged && haveEqualVoxels(*before, *now))
        changes.relocated.push_back(is);
}

/// Joints that changed, and those that hold on to a shape that changed.
void journalJoints(const WorldDelta& before, WorldData& world, FrameChanges& changes) {
    for (const auto& [slot, was] : before.joints)
        if (was.first) world.jointIndex.remove(was.first, *was.second);
    for (const auto& [slot, was] : before.joints) {
        const JointHandle is = world.joints.handleAt(slot);
        if (is) world.jointIndex.add(is, world.joints.at(is));
        if (was.first && was.first != is) changes.jointsBroken.push_back({was.first, JointBreak::Removed, {}});
        if (is) (was.first == is ? changes.jointsChanged : changes.jointsCreated).push_back(is);
    }
    for (const auto& [slot, was] : before.shapes) {
        const ShapeHandle is = world.shapes.handleAt(slot);
        if (!is) continue;
        for (const JointHandle joint : world.jointIndex.of(is))
            if (!before.joints.contains(joint.slot())) changes.jointsChanged.push_back(joint);
    }
}

void journalBodiesAndShapes(const WorldDelta& before, WorldData& world, FrameChanges& changes) {
    for (const auto& [slot, was] : before.shapes) {
        const ShapeHandle is = world.shapes.handleAt(slot);
        if (was.first && was.first != is) world.removeShapeBounds(was.first);
        if (is) world.updateShapeBounds(is);
    }
    for (const auto& [slot, was] : before.bodies) {
        const BodyHandle is = world.bodies.handleAt(slot);
        const bool isOther = was.first != is || isOfOtherKind(was, world);
        if (was.first && isOther) changes.bodiesDestroyed.push_back(was.first);
        if (is && isOther) changes.bodiesCreated.push_back(is);
        if (is && was.first == is && !sameState(*was.second, world.bodies.at(is))) changes.teleported.push_back(is);
        if (is && was.first == is && was.second->shapes != world.bodies.at(is).shapes) changes.lostShapes.push_back(is);
        world.updateDebris(was.first);
        if (!is) continue;
        world.updateDebris(is);
        for (const ShapeHandle shape : world.bodies.at(is).shapes) world.updateShapeBounds(shape);
    }
    for (const auto& [slot, was] : before.shapes) {
        const ShapeHandle is = world.shapes.handleAt(slot);
        const Shape* now = world.shapes.find(is);
        journalShape(was.first, was.second, is, now, now && isMovedStatic(before, world, now->body), changes);
    }
}

/// Where a switch has changed, all that shines with the group is listed.
void journalSwitch(LightGroupHandle group, const WorldData& world, FrameChanges& changes) {
    world.lights.forEach([&](LightHandle light, const Light& each) {
        if (each.group == group) changes.lights.push_back(light);
    });
    world.shapes.forEach([&](ShapeHandle shape, const Shape& each) {
        const Palette& palette = *each.palette;
        if (std::any_of(palette.begin(), palette.end(),
                        [&](const PaletteEntry& entry) { return entry.lightGroup == group.slot() + 1; }))
            changes.palettes.push_back(shape);
    });
}

void journalGroups(const WorldDelta& before, WorldData& world, FrameChanges& changes) {
    for (const auto& [slot, was] : before.groups) {
        const LightGroupHandle is = world.groups.handleAt(slot);
        world.flickeringGroups -= uint32_t(was.second && was.second->failingSince != 0);
        if (was.first && was.first != is) changes.groups.push_back(was.first);
        if (!is) continue;
        changes.groups.push_back(is);
        if (was.second && was.second->off != world.groups.at(is).off) journalSwitch(is, world, changes);
        world.flickeringGroups += uint32_t(world.groups.at(is).failingSince != 0);
        if (world.groups.at(is).out && !(was.second && was.second->out)) changes.groupsOut.push_back(is);
    }
}

/// Bodies that are in a trigger now and were not, or the other way round. Both lists are in slot order.
void journalInside(TriggerHandle trigger, std::span<const BodyHandle> before, std::span<const BodyHandle> now,
                   FrameChanges& changes) {
    const auto slotOf = [](std::span<const BodyHandle> bodies) { return bodies.empty() ? ~0u : bodies[0].slot(); };
    while (!before.empty() || !now.empty()) {
        const uint32_t left = slotOf(before), entered = slotOf(now);
        const bool stays = left == entered && before[0] == now[0];
        if (left <= entered) {
            if (!stays) changes.triggerEvents.push_back({trigger, before[0], false});
            before = before.subspan(1);
        }
        if (entered <= left) {
            if (!stays) changes.triggerEvents.push_back({trigger, now[0], true});
            now = now.subspan(1);
        }
    }
}

void journalTriggers(const WorldDelta& before, WorldData& world, FrameChanges& changes) {
    for (const auto& [slot, was] : before.triggers) {
        world.triggerBounds.remove(slot);
        if (const TriggerHandle is = world.triggers.handleAt(slot))
            world.triggerBounds.update(slot, world.triggers.at(is).bounds());
    }
    journalSlots(before.triggers, world.triggers, changes.triggers);
    for (const auto& [slot, was] : before.triggers) {
        const TriggerHandle is = world.triggers.handleAt(slot);
        if (was.first && was.first != is) journalInside(was.first, was.second->inside, {}, changes);
        if (is)  // one that comes back is entered, as a new one is
            journalInside(is, is == was.first ? was.second->inside : std::vector<BodyHandle>{},
                          world.triggers.at(is).inside, changes);
    }
}

void journalNotes(const WorldDelta& before, WorldData& world, FrameChanges& changes) {
    for (const auto& [slot, was] : before.notes)
        if (was.first) world.noteOf.erase(bitsOf(was.second->object));
    for (const auto& [slot, was] : before.notes)
        if (const NoteHandle is = world.notes.handleAt(slot)) world.noteOf[bitsOf(world.notes.at(is).object)] = is;
    journalSlots(before.notes, world.notes, changes.notes);
}

}  // namespace

bool WorldDelta::empty() const {
    bool isEmpty = !numbersChanged;
    forEachWorldValue([&](const auto& value) { isEmpty = isEmpty && !value; }, *this);
    forEachKind([&](const auto& values) { isEmpty = isEmpty && values.empty(); }, *this);
    return isEmpty;
}

WorldDelta swapObjects(WorldData& world, WorldDelta target, FrameChanges& changes) {
    WorldDelta before;
    before.imported = std::exchange(world.imported, target.imported);
    before.removed = std::exchange(world.removed, target.removed);
    before.made = std::exchange(world.made, target.made);
    before.footprint = std::exchange(world.footprint, target.footprint);
    before.fire = std::exchange(world.fire, std::move(target.fire));
    changes.firesChanged = before.fire.isActive() || world.fire.isActive();
    if (target.environment) {
        before.environment = world.swapEnvironment(*target.environment);
        changes.environmentChanged = true;
    }
    if (target.materials) {
        before.materials = std::exchange(world.materials, std::move(*target.materials));
        world.wire = world.materials.find("wire");
        changes.materialsChanged = true;
    }
    if (target.settings) {
        target.settings->undoMarks = world.settings.undoMarks;
        before.settings = std::exchange(world.settings, *target.settings);
        changes.settingsChanged = true;
    }
    if (target.scripts) {
        before.scripts = std::exchange(world.scripts, std::move(*target.scripts));
        changes.scriptsChanged = true;
    }
    before.freeSlots = freeSlotsOf(world);
    forEachKind([](auto& map, auto& wanted, auto& was) { was = swapSlots(map, std::move(wanted)); }, world, target,
                before);
    forEachKind([](auto& map, const auto& free) { map.setFreeSlots(free); }, world, target.freeSlots);
    journalBodiesAndShapes(before, world, changes);
    journalJoints(before, world, changes);
    journalSlots(before.lights, world.lights, changes.lights);
    journalGroups(before, world, changes);
    journalSlots(before.waters, world.waters, changes.waters);
    journalTriggers(before, world, changes);
    journalSlots(before.characters, world.characters, changes.characters);
    journalNotes(before, world, changes);
    if (before.settings) world.bodies.forEach([&](BodyHandle body, const Body&) { world.updateDebris(body); });
    return before;
}

void dropMotion(SlotValues<BodyHandle, Body>& before, const WorldData& world) {
    std::erase_if(before, [&](const auto& entry) {
        const auto& [handle, was] = entry.second;
        const Body* is = world.bodies.find(handle);
        return is && !was->isStatic && !is->isStatic && was->shapes == is->shapes && was->name == is->name &&
               was->tags == is->tags && was->broken == is->broken && was->createdStep == is->createdStep &&
               was->gravityScale == is->gravityScale && was->linearDamping == is->linearDamping &&
               was->angularDamping == is->angularDamping;
    });
}

}  // namespace rubble
