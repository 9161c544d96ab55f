#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/world/world.h"

namespace rubble {

/// Slots and what is in them: a handle and its value, or an empty handle and nothing.
template <class Handle, class T>
using SlotValues = std::map<uint32_t, std::pair<Handle, std::optional<T>>>;

/// Some objects of a World as they were, or are to be. Bricks, directories and palettes are shared.
struct WorldDelta {
    SlotValues<BodyHandle, Body> bodies;
    SlotValues<ShapeHandle, Shape> shapes;
    SlotValues<LightHandle, Light> lights;
    SlotValues<LightGroupHandle, LightGroup> groups;
    SlotValues<WaterHandle, Water> waters;
    SlotValues<TriggerHandle, Trigger> triggers;
    SlotValues<CharacterHandle, Character> characters;
    uint64_t imported = 0, removed = 0;
    FireState fire;
    std::optional<Environment> environment;  ///< none: it has not changed
    SlotValues<JointHandle, Joint> joints;
    std::vector<uint32_t> freeBodies, freeShapes, freeLights, freeWaters, freeTriggers, freeCharacters,
        freeJoints;  ///< slots that are used next

    bool empty() const {
        return bodies.empty() && shapes.empty() && lights.empty() && groups.empty() && waters.empty() &&
               triggers.empty() && characters.empty() && joints.empty() && !environment;
    }
};

}  // namespace rubble
