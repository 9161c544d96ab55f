#pragma once
#include <string>
#include <utility>
#include <vector>

#include "runtime/core/slot_map.h"
#include "runtime/world/world.h"

namespace rubble {

/// Everything of a World that decides what happens next, as a value, with slots and generations. Bricks, directories
/// and palettes are shared: it costs the number of objects, not of voxels. What a save file holds.
struct WorldState {
    std::string name;
    uint64_t step = 0, imported = 0, removed = 0;
    SlotMap<BodyHandle, Body> bodies;
    SlotMap<ShapeHandle, Shape> shapes;
    SlotMap<LightHandle, Light> lights;
    SlotMap<LightGroupHandle, LightGroup> groups;
    std::vector<BodyHandle> unsettled;  ///< settled bodies that have woken since the last step
    MaterialTable materials;
    Environment environment;
    WorldSettings settings;
    std::vector<std::pair<std::string, Pose>> locations;
    FireState fire;
    SlotMap<WaterHandle, Water> waters;
    SlotMap<TriggerHandle, Trigger> triggers;
    SlotMap<CharacterHandle, Character> characters;
    SlotMap<JointHandle, Joint> joints;
};

}  // namespace rubble
