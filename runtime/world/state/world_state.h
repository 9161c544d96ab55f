#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "runtime/core/pose.h"
#include "runtime/core/world_box.h"
#include "runtime/voxel/material.h"
#include "runtime/world/objects/named_data.h"
#include "runtime/world/objects/world_objects.h"
#include "runtime/world/settings/world_settings.h"
#include "runtime/world/state/fire_state.h"
#include "runtime/world/state/pending_split.h"

namespace rubble {

/// A box without what is beyond the range of places; none if nothing is left.
WorldBox withinRange(const WorldBox& box);
/// The box around shapes, and around it half of its longest side, but at least 128 m, where what is thrown from them
/// comes down again, and at most 512 m, withinRange(). None if there is no box.
WorldBox boundsAround(const WorldBox& shapes);

/// Everything of a World that decides what happens next, as a value, with slots and generations: what a save file
/// holds. Bricks, directories and palettes are shared: a copy costs the number of objects, not of voxels.
struct WorldState : WorldObjects {
    std::string name;
    uint64_t step = 0;                  ///< steps done since the level was loaded
    uint64_t imported = 0;              ///< voxels that the level brought
    uint64_t removed = 0;               ///< voxels that are gone
    std::vector<BodyHandle> unsettled;  ///< settled bodies that physics has woken since the last step
    MaterialTable materials;
    Environment environment;
    WorldSettings settings;
    WorldBox bounds;     ///< of the level: where the world ends, if BoundsSettings say nothing else; low == high: none
    WorldBox footprint;  ///< around all static shapes, wherever a step has left them; low == high: none
    /// Without `bounds`: around all shapes that there have been, where the step that made them left them, and all
    /// static ones, as `footprint`.
    WorldBox made;
    std::vector<std::pair<std::string, Pose>> locations;  ///< named places of the level
    std::vector<LevelScript> scripts;                     ///< of the level and of prefabs
    std::vector<HostData> hostData;                       ///< not in the hash: nothing follows from it
    FireState fire;
    std::vector<PendingSplit> pendingSplits;

    /// The box outside of which BoundsRule applies: of the settings, or else the level's, or else boundsAround()
    /// `made`; low == high: there is none.
    WorldBox boundsInUse() const;
};

/// Drops connectivity tests that have begun: those that wait will begin with the whole shape, in their order.
void restartPendingSplits(WorldState& world);

}  // namespace rubble
