#include "runtime/world/undo_history.h"

#include <iterator>
#include <utility>

namespace rubble {
namespace {

template <class Handle, class T>
void addMissing(SlotValues<Handle, T>& into, SlotValues<Handle, T> from) {
    into.merge(from);
}

/// Objects of an earlier moment over those of a later one.
void addMissing(WorldDelta& into, WorldDelta from) {
    addMissing(into.bodies, std::move(from.bodies));
    addMissing(into.shapes, std::move(from.shapes));
    addMissing(into.lights, std::move(from.lights));
    addMissing(into.groups, std::move(from.groups));
    addMissing(into.waters, std::move(from.waters));
    addMissing(into.triggers, std::move(from.triggers));
    addMissing(into.characters, std::move(from.characters));
    addMissing(into.joints, std::move(from.joints));
    if (!into.environment) into.environment = from.environment;
}

/// For each slot of `slots`: its value in `first`, else in `second`.
template <class Handle, class T>
SlotValues<Handle, T> pick(const SlotValues<Handle, T>& slots, const SlotValues<Handle, T>& first, SlotValues<Handle, T>& second) {
    SlotValues<Handle, T> out;
    for (const auto& [slot, value] : slots) {
        const auto found = first.find(slot);
        out.emplace(slot, found != first.end() ? found->second : std::move(second.at(slot)));
    }
    return out;
}

}  // namespace

UndoHistory::UndoHistory(const World& world) : m_mirror(world), m_open(m_mirror.emptyDelta()) {}

void UndoHistory::mark(size_t limit) {
    if (m_isDrift) {  // what moved since the undo belongs to the mark before it
        if (!m_marks.empty()) addMissing(m_marks.back(), std::move(m_open));
        m_isDrift = false;
        m_redo.clear();
    } else if (!m_open.empty()) {
        m_marks.push_back(std::move(m_open));
    }
    m_open = m_mirror.emptyDelta();
    while (m_marks.size() + 1 > limit && !m_marks.empty()) m_marks.pop_front();
}

/// Puts the entry's objects into the World, and what moved since back; returns those of its slots as they were before that.
WorldDelta UndoHistory::swapIn(World& world, WorldDelta entry, FrameChanges& changes) {
    const WorldDelta slots = entry;
    const WorldDelta drift = m_isDrift ? std::move(m_open) : WorldDelta{};
    addMissing(entry, drift);
    WorldDelta was = world.exchange(std::move(entry), changes);
    m_mirror.update(world, changes);
    WorldDelta out = m_isDrift ? drift : was;
    out.bodies = pick(slots.bodies, drift.bodies, was.bodies);
    out.shapes = pick(slots.shapes, drift.shapes, was.shapes);
    out.lights = pick(slots.lights, drift.lights, was.lights);
    out.groups = pick(slots.groups, drift.groups, was.groups);
    out.waters = pick(slots.waters, drift.waters, was.waters);
    out.triggers = pick(slots.triggers, drift.triggers, was.triggers);
    out.characters = pick(slots.characters, drift.characters, was.characters);
    out.joints = pick(slots.joints, drift.joints, was.joints);
    out.environment.reset();
    if (slots.environment) out.environment = drift.environment ? drift.environment : was.environment;
    m_open = m_mirror.emptyDelta();
    m_isDrift = true;
    return out;
}

bool UndoHistory::undo(World& world, FrameChanges& changes) {
    if (!m_isDrift && !m_open.empty()) m_marks.push_back(std::move(m_open)), m_open = m_mirror.emptyDelta();
    if (m_marks.empty()) return false;
    WorldDelta entry = std::move(m_marks.back());
    m_marks.pop_back();
    m_redo.push_back(swapIn(world, std::move(entry), changes));
    return true;
}

bool UndoHistory::redo(World& world, FrameChanges& changes) {
    if (m_redo.empty()) return false;
    WorldDelta entry = std::move(m_redo.back());
    m_redo.pop_back();
    m_marks.push_back(swapIn(world, std::move(entry), changes));
    return true;
}

void UndoHistory::note(const World& world, const FrameChanges& changes, bool wentBack) {
    if (changes.empty()) return;
    addMissing(m_open, m_mirror.update(world, changes));
    if (wentBack) return;
    m_isDrift = false;
    m_redo.clear();
}

void UndoHistory::noteMoved(const World& world, std::span<const RopeMotion> ropes) {
    m_mirror.move(world, ropes, m_open.joints);
}

void UndoHistory::noteMoved(const World& world, std::span<const BodyPose> poses) {
    m_mirror.move(world, poses, m_open.bodies);
}

void UndoHistory::noteMoved(const World& world, std::span<const CharacterMove> moves) {
    m_mirror.move(world, moves, m_open.characters);
}

}  // namespace rubble
