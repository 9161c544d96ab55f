#include "runtime/world/history/undo_history.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/world/objects/state_hash.h"

namespace rubble {
namespace {

/// Adds the objects of a later delta to those of an earlier one, which stay.
void addMissing(WorldDelta& into, WorldDelta from) {
    forEachKind([](auto& values, auto& earlier) { values.merge(earlier); }, into, from);
    const auto addValue = [](auto& value, auto& earlier) {
        if (!value) value = std::move(earlier);
    };
    forEachWorldValue(addValue, into, from);
}

/// For each slot of `slots`: its value in `first`, or else in `second`.
template <class Handle, class T>
SlotValues<Handle, T> selectSlots(const SlotValues<Handle, T>& slots, const SlotValues<Handle, T>& first,
                                  SlotValues<Handle, T>& second) {
    SlotValues<Handle, T> out;
    for (const auto& [slot, value] : slots) {
        const auto found = first.find(slot);
        out.emplace(slot, found != first.end() ? found->second : std::move(second.at(slot)));
    }
    return out;
}

template <class T>
uint64_t hashOf(const T& value) {
    return value.hash();
}
uint64_t hashOf(const std::vector<LevelScript>& scripts) {
    return hashScripts(scripts);
}

/// Whether a slot holds another object than it did, or one in another state.
template <class Map, class Handle, class T>
bool isOther(const std::pair<const uint32_t, std::pair<Handle, std::optional<T>>>& slot, const Map& now) {
    const auto& [was, value] = slot.second;
    const Handle is = now.handleAt(slot.first);
    return was != is || (is && hashState(*value, 0) != hashState(now.at(is), 0));
}

}  // namespace

UndoHistory::UndoHistory(const WorldData& world) : m_baseline(world), m_current(m_baseline.emptyDelta()) {}

/// Whether anything has since the last mark, undo or redo: objects, or heat, which no journal lists.
bool UndoHistory::hasChanged() const {
    return !m_current.empty() || m_current.fire.hash() != m_baseline.last().fire.hash();
}

bool UndoHistory::differs(const WorldData& world) const {
    bool differs = m_current.made.low != world.made.low || m_current.made.high != world.made.high ||
                   m_current.footprint.low != world.footprint.low || m_current.footprint.high != world.footprint.high;
    const auto compareValues = [&](const auto& was, const auto& is) {
        differs = differs || (was && hashOf(*was) != hashOf(is));
    };
    forEachWorldValue(compareValues, m_current, world);
    const auto compareObjects = [&](const auto& was, const auto& now) {
        differs = differs || std::any_of(was.begin(), was.end(), [&](const auto& slot) { return isOther(slot, now); });
    };
    forEachKind(compareObjects, m_current, world);
    return differs;
}

/// The entry of an interval that ends now.
UndoHistory::Entry UndoHistory::pack(WorldDelta objects) const {
    Entry entry{std::move(objects), {}};
    for (auto& [slot, value] : entry.objects.shapes) {
        const Shape* now = m_baseline.last().shapes.find(value.first);
        if (!now || now->grid.size() != value.second->grid.size()) continue;
        entry.grids.emplace(slot, GridPatch(std::exchange(value.second->grid, {}), now->grid));
    }
    return entry;
}

/// The objects of the entry whose interval ended where m_current begins.
WorldDelta UndoHistory::unpack(Entry entry) const {
    for (const auto& [slot, patch] : entry.grids) {
        auto& [handle, shape] = entry.objects.shapes.at(slot);
        const auto changed = m_current.shapes.find(slot);
        const bool isChanged = changed != m_current.shapes.end();
        shape->grid = patch.applyTo((isChanged ? *changed->second.second : m_baseline.last().shapes.at(handle)).grid);
    }
    return std::move(entry.objects);
}

void UndoHistory::mark(size_t limit) {
    if (m_onlyMotionSinceUndo) {  // what moved since the undo belongs to the mark before it
        if (!m_marks.empty()) {
            WorldDelta last = unpack(std::move(m_marks.back()));
            addMissing(last, std::move(m_current));
            m_marks.back() = pack(std::move(last));
        }
        m_onlyMotionSinceUndo = false;
        m_redo.clear();
    } else if (m_isMarked && hasChanged()) {
        m_marks.push_back(pack(std::move(m_current)));
    }
    m_current = m_baseline.emptyDelta();
    m_isMarked = true;
    while (m_marks.size() + 1 > limit && !m_marks.empty()) m_marks.pop_front();
}

/// Swaps the entry's objects into the World, and undoes what moved since; returns the objects of the entry's slots as
/// they were before that.
WorldDelta UndoHistory::swapEntry(WorldData& world, WorldDelta entry, FrameChanges& changes) {
    const WorldDelta slots = entry;
    const WorldDelta drift = m_onlyMotionSinceUndo ? std::move(m_current) : WorldDelta{};
    addMissing(entry, drift);
    std::vector<PendingSplit> line;
    for (const ShapeHandle shape : entry.waiting) line.push_back({shape, {}, {}});
    WorldDelta was = swapObjects(world, std::move(entry), changes);
    for (const PendingSplit& pending : world.pendingSplits) was.waiting.push_back(pending.shape);
    world.pendingSplits = std::move(line);
    restartPendingSplits(world);
    changes.isRestored = true;
    m_baseline.update(world, changes);
    WorldDelta out = m_onlyMotionSinceUndo ? drift : was;
    forEachKind([](auto& values, const auto& wanted, const auto& moved,
                   auto& swapped) { values = selectSlots(wanted, moved, swapped); },
                out, slots, drift, was);
    const auto select = [](auto& value, const auto& wanted, const auto& moved, const auto& swapped) {
        value.reset();
        if (wanted) value = moved ? moved : swapped;
    };
    forEachWorldValue(select, out, slots, drift, was);
    m_current = m_baseline.emptyDelta();
    m_onlyMotionSinceUndo = true;
    m_isMarked = true;
    return out;
}

bool UndoHistory::undo(WorldData& world, FrameChanges& changes) {
    if (!m_onlyMotionSinceUndo && m_isMarked)
        m_marks.push_back({std::move(m_current), {}}), m_current = m_baseline.emptyDelta();
    if (m_marks.empty()) {
        logWarning("undo: there is no mark to go back to; nothing was undone");
        return false;
    }
    WorldDelta entry = unpack(std::move(m_marks.back()));
    m_marks.pop_back();
    m_redo.push_back(pack(swapEntry(world, std::move(entry), changes)));
    return true;
}

bool UndoHistory::redo(WorldData& world, FrameChanges& changes) {
    if (m_redo.empty()) {
        logWarning("redo: there is no undo to take back; nothing was redone");
        return false;
    }
    WorldDelta entry = unpack(std::move(m_redo.back()));
    m_redo.pop_back();
    m_marks.push_back(pack(swapEntry(world, std::move(entry), changes)));
    return true;
}

void UndoHistory::recordStep(const WorldData& world, const FrameChanges& changes, bool isOnlyHistory) {
    addMissing(m_current, m_baseline.update(world, changes));
    if (isOnlyHistory || changes.empty()) return;
    m_onlyMotionSinceUndo = false;
    m_redo.clear();
}

void UndoHistory::recordMoves(const WorldData& world, std::span<const RopeMotion> ropes) {
    m_baseline.move(world, ropes, m_current.joints);
}

void UndoHistory::recordMoves(const WorldData& world, std::span<const BodyPose> poses) {
    m_baseline.move(world, poses, m_current.bodies);
}

void UndoHistory::recordMoves(const WorldData& world, std::span<const CharacterMove> moves) {
    m_baseline.move(world, moves, m_current.characters);
}

}  // namespace rubble
