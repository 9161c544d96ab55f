#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/world/history/frame_changes.h"
#include "runtime/world/state/world_data.h"

namespace rubble {

/// Slots and what is in them: a handle and its value, or an empty handle and nothing.
template <class Handle, class T>
using SlotValues = std::map<uint32_t, std::pair<Handle, std::optional<T>>>;

/// Some objects of a World as they were, or as they are to be, and the numbers that belong to no object. Bricks,
/// directories and palettes are shared.
struct WorldDelta : ObjectKinds<SlotValues> {
    ObjectKinds<FreeSlots> freeSlots;  ///< that are used next
    uint64_t imported = 0, removed = 0;
    WorldBox made, footprint;
    bool numbersChanged = false;  ///< these four: also by shapes that were made and gone in one step
    bool footprintChanged = false;
    FireState fire;
    std::vector<ShapeHandle> waiting;                 ///< for their split, see WorldState::pendingSplits
    std::optional<Environment> environment;           ///< none: it has not changed
    std::optional<MaterialTable> materials;           ///< the same
    std::optional<std::vector<LevelScript>> scripts;  ///< the same
    std::optional<WorldSettings> settings;            ///< the same; their limit of undo marks is of no account

    /// Whether it holds no object, no other numbers, no environment, no materials, no settings and no scripts.
    bool empty() const;
};

/// Calls f with each value of a world that edits change and that belongs to no object, one from every set.
template <class F, class... Sets>
void forEachWorldValue(F&& f, Sets&&... sets) {
    f(sets.environment...);
    f(sets.materials...);
    f(sets.settings...);
    f(sets.scripts...);
}

/// Puts the delta's objects in their slots, adds that to the journal, and returns what was there before. Shapes that
/// wait for their split and stress analyses stay as they are, and so does the limit of undo marks, which is the host's.
WorldDelta swapObjects(WorldData& world, WorldDelta target, FrameChanges& changes);

/// Takes out bodies that have changed in nothing but how they move: free bodies whose pose, velocity or sleep is
/// another one. before: as they were, from WorldBaseline::update().
void dropMotion(SlotValues<BodyHandle, Body>& before, const WorldData& world);

}  // namespace rubble
