#pragma once
#include <cstdint>
#include <type_traits>
#include <vector>

#include "runtime/core/slot_map.h"
#include "runtime/world/objects/body.h"
#include "runtime/world/objects/character.h"
#include "runtime/world/objects/joint.h"
#include "runtime/world/objects/lights.h"
#include "runtime/world/objects/note.h"
#include "runtime/world/objects/shape.h"
#include "runtime/world/objects/trigger.h"
#include "runtime/world/objects/water.h"

namespace rubble {

/// The one list of the kinds of objects that a world has, each in a container of its own: slot maps in a world, values
/// by slot in a delta, lists of free slots. A new kind needs a line here and one in forEachKind().
template <template <class Handle, class T> class Container>
struct ObjectKinds {
    Container<BodyHandle, Body> bodies;
    Container<ShapeHandle, Shape> shapes;
    Container<LightHandle, Light> lights;
    Container<LightGroupHandle, LightGroup> groups;
    Container<WaterHandle, Water> waters;
    Container<TriggerHandle, Trigger> triggers;
    Container<CharacterHandle, Character> characters;
    Container<JointHandle, Joint> joints;
    Container<NoteHandle, Note> notes;
};

/// Calls f with the containers of each kind in turn, one from every set: f(a.bodies, b.bodies), f(a.shapes,
/// b.shapes)...
template <class F, class... Sets>
void forEachKind(F&& f, Sets&&... sets) {
    f(sets.bodies...);
    f(sets.shapes...);
    f(sets.lights...);
    f(sets.groups...);
    f(sets.waters...);
    f(sets.triggers...);
    f(sets.characters...);
    f(sets.joints...);
    f(sets.notes...);
}

/// All objects of a world, by handle.
using WorldObjects = ObjectKinds<SlotMap>;

/// Calls f(map, handle) with the slot map that holds what a handle names, and the handle of that type; with nothing if
/// there is no such map.
template <class Objects, class F>
void withMapOf(Objects& objects, AnyHandle handle, F&& f) {
    const auto call = [&](auto& map) {
        if (map.kType == handle.type()) f(map, typename std::decay_t<decltype(map)>::HandleOf{handle.bits});
    };
    forEachKind(call, objects);
}
/// Whether a handle is reserved and names nothing yet; see SlotMap::reserve().
bool isReserved(const WorldObjects& objects, AnyHandle handle);
/// The map of the objects that a kind of handle names.
template <class Handle>
const auto& mapOf(const WorldObjects& objects) {
    if constexpr (std::is_same_v<Handle, BodyHandle>) return objects.bodies;
    if constexpr (std::is_same_v<Handle, ShapeHandle>) return objects.shapes;
    if constexpr (std::is_same_v<Handle, LightHandle>) return objects.lights;
    if constexpr (std::is_same_v<Handle, LightGroupHandle>) return objects.groups;
    if constexpr (std::is_same_v<Handle, WaterHandle>) return objects.waters;
    if constexpr (std::is_same_v<Handle, TriggerHandle>) return objects.triggers;
    if constexpr (std::is_same_v<Handle, CharacterHandle>) return objects.characters;
    if constexpr (std::is_same_v<Handle, JointHandle>) return objects.joints;
}

/// The slots of one kind that are used next, the last first.
template <class Handle, class T>
using FreeSlots = std::vector<uint32_t>;

/// The highest generation of all handles so far. A later world of the same number that begins above it knows none.
uint32_t highestGeneration(const WorldObjects& objects);
/// What freeSlots() of each slot map gives.
ObjectKinds<FreeSlots> freeSlotsOf(const WorldObjects& objects);

}  // namespace rubble
