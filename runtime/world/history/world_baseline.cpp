#include "runtime/world/history/world_baseline.h"

#include <utility>

namespace rubble {
namespace {

/// Brings the slot of `handle` up to date in `last`; keeps what it held in `before`, unless that has the slot.
template <class Map, class Handle, class T>
void updateSlot(const Map& now, Map& last, Handle handle, SlotValues<Handle, T>& before) {
    if (!handle || before.contains(handle.slot())) return;
    const Handle was = last.handleAt(handle.slot()), is = now.handleAt(handle.slot());
    auto& entry = before[handle.slot()];
    entry.first = was;
    if (was) entry.second = std::move(last.at(was));
    if (was && was != is) last.erase(was);
    if (!is) return;
    if (was == is)
        last.at(is) = now.at(is);
    else
        last.restore(is, now.at(is));
}

/// Brings an object that physics moved up to date in `last`; keeps it as it was in `before`, unless that has the slot.
template <class Map, class Handle, class T>
void updateMoved(const Map& now, Map& last, Handle handle, SlotValues<Handle, T>& before) {
    T* was = last.find(handle);
    const T* is = now.find(handle);
    if (!was || !is) return;
    before.try_emplace(handle.slot(), handle, *was);
    *was = *is;
}

/// Calls f(shape) for each shape that the journal names, some more than once.
template <class F>
void forEachShapeIn(const FrameChanges& changes, F&& f) {
    for (const auto* list : {&changes.shapesDestroyed, &changes.shapesCreated, &changes.carved, &changes.palettes,
                             &changes.unanchored, &changes.filters})
        for (const ShapeHandle shape : *list) f(shape);
    for (const BrickChange& change : changes.bricks) f(change.shape);
    for (const ShapeSplit& split : changes.splits) f(split.parent);
}

}  // namespace

WorldBaseline::WorldBaseline(const WorldData& world) : m_last(world), m_freeSlots(freeSlotsOf(world)) {
    for (PendingSplit& pending : m_last.pendingSplits) pending = {pending.shape, {}, {}};
}

WorldDelta WorldBaseline::emptyDelta() const {
    WorldDelta delta;
    delta.imported = m_last.imported;
    delta.removed = m_last.removed;
    delta.made = m_last.made;
    delta.footprint = m_last.footprint;
    delta.fire = m_last.fire;
    for (const PendingSplit& pending : m_last.pendingSplits) delta.waiting.push_back(pending.shape);
    delta.freeSlots = m_freeSlots;
    return delta;
}

WorldDelta WorldBaseline::update(const WorldData& world, const FrameChanges& changes) {
    // Heat spreads and tests of what is connected go on in steps that the journal has nothing of.
    if (world.fire.isActive() || m_last.fire.isActive()) m_last.fire = world.fire;
    m_last.pendingSplits.clear();
    for (const PendingSplit& pending : world.pendingSplits) m_last.pendingSplits.push_back({pending.shape, {}, {}});
    WorldDelta before;
    before.footprintChanged =
        m_last.footprint.low != world.footprint.low || m_last.footprint.high != world.footprint.high;
    before.numbersChanged = m_last.imported != world.imported || m_last.removed != world.removed ||
                            m_last.made.low != world.made.low || m_last.made.high != world.made.high ||
                            before.footprintChanged;
    m_last.imported = world.imported;
    m_last.removed = world.removed;
    m_last.made = world.made;
    m_last.footprint = world.footprint;
    if (changes.empty()) return before;
    const auto body = [&](BodyHandle handle) { updateSlot(world.bodies, m_last.bodies, handle, before.bodies); };
    forEachShapeIn(changes, [&](ShapeHandle handle) {
        if (before.shapes.contains(handle.slot())) return;
        if (const Shape* was = m_last.shapes.find(m_last.shapes.handleAt(handle.slot()))) body(was->body);
        if (const Shape* is = world.shapes.find(world.shapes.handleAt(handle.slot()))) body(is->body);
        updateSlot(world.shapes, m_last.shapes, handle, before.shapes);
    });
    for (const auto* list : {&changes.bodiesDestroyed, &changes.bodiesCreated, &changes.teleported, &changes.settled,
                             &changes.unsettled, &changes.woken, &changes.broken})
        for (const BodyHandle handle : *list) body(handle);
    for (const ImpulseApplied& impulse : changes.impulses) body(impulse.body);
    for (const LightHandle handle : changes.lights) updateSlot(world.lights, m_last.lights, handle, before.lights);
    for (const LightGroupHandle handle : changes.groups) updateSlot(world.groups, m_last.groups, handle, before.groups);
    for (const WaterHandle handle : changes.waters) updateSlot(world.waters, m_last.waters, handle, before.waters);
    for (const TriggerHandle handle : changes.triggers)
        updateSlot(world.triggers, m_last.triggers, handle, before.triggers);
    for (const CharacterHandle handle : changes.characters)
        updateSlot(world.characters, m_last.characters, handle, before.characters);
    const auto joint = [&](JointHandle handle) { updateSlot(world.joints, m_last.joints, handle, before.joints); };
    for (const auto* list : {&changes.jointsCreated, &changes.jointsChanged})
        for (const JointHandle handle : *list) joint(handle);
    for (const JointMoved& moved : changes.jointsMoved) joint(moved.joint);
    for (const JointBroken& broken : changes.jointsBroken) joint(broken.joint);
    for (const NoteHandle handle : changes.notes) updateSlot(world.notes, m_last.notes, handle, before.notes);
    if (changes.environmentChanged) before.environment = std::exchange(m_last.environment, world.environment);
    if (changes.materialsChanged) before.materials = std::exchange(m_last.materials, world.materials);
    if (changes.settingsChanged) before.settings = std::exchange(m_last.settings, world.settings);
    if (changes.scriptsChanged) before.scripts = std::exchange(m_last.scripts, world.scripts);
    forEachKind([](const auto& map, std::vector<uint32_t>& free) { free = map.freeSlots(); }, world, m_freeSlots);
    return before;
}

void WorldBaseline::move(const WorldData& world, std::span<const RopeMotion> ropes,
                         SlotValues<JointHandle, Joint>& before) {
    for (const RopeMotion& rope : ropes) updateMoved(world.joints, m_last.joints, rope.rope, before);
}

void WorldBaseline::move(const WorldData& world, std::span<const BodyPose> poses,
                         SlotValues<BodyHandle, Body>& before) {
    for (const BodyPose& pose : poses) updateMoved(world.bodies, m_last.bodies, pose.body, before);
}

void WorldBaseline::move(const WorldData& world, std::span<const CharacterMove> moves,
                         SlotValues<CharacterHandle, Character>& before) {
    for (const CharacterMove& move : moves) updateMoved(world.characters, m_last.characters, move.character, before);
}

}  // namespace rubble
