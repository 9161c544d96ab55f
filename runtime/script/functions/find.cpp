#include <algorithm>

#include "runtime/script/binding/calls.h"
#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {
namespace {

/// Whether an object is of a kind, also one that the next step makes.
bool isOfKind(lua_State* L, uint64_t object, uint32_t kind) {
    const rubble_api& api = apiOf(L);
    const rubble_world world = worldOf(L);
    const auto& created = ScriptContext::of(L).shared.pending.created;
    if (const auto made = created.find(object); made != created.end()) return made->second == kind;
    rubble_body_state body = {};
    rubble_shape_state shape = {};
    rubble_joint_state joint = {};
    auto light = sized<rubble_light_settings>();
    uint32_t count = 0;
    switch (kind) {
        case RUBBLE_KIND_BODY:
            return api.get_body_state(world, object, &body) == RUBBLE_OK;
        case RUBBLE_KIND_SHAPE:
            return api.get_shape_state(world, object, &shape) == RUBBLE_OK;
        case RUBBLE_KIND_JOINT:
            return api.get_joint_state(world, object, &joint) == RUBBLE_OK;
        case RUBBLE_KIND_LIGHT:
            return api.get_light_settings(world, object, &light) == RUBBLE_OK;
        default:
            return api.get_trigger_bodies(world, object, nullptr, 0, &count) == RUBBLE_OK;
    }
}

/// Tags that calls of this step have set and taken away, in what the last step knows.
void addPending(lua_State* L, uint32_t kind, const std::string& tag, std::vector<uint64_t>& found) {
    const PendingReads& pending = ScriptContext::of(L).shared.pending;
    Sandbox::of(L).charge(L, int64_t(tag.empty() ? pending.created.size() : pending.tags.size()));
    if (tag.empty())
        for (const auto& [object, made] : pending.created)
            if (made == kind) found.push_back(object);
    for (const auto& [place, value] : pending.tags) {
        if (tag.empty() || place.second != tag) continue;
        const auto known = std::find(found.begin(), found.end(), place.first);
        if (!value && known != found.end()) found.erase(known);
        if (value && known == found.end() && isOfKind(L, place.first, kind)) found.push_back(place.first);
    }
}

/// The objects of a kind with the tag of argument 1; where there are none, those with that name. Without a tag all.
const std::vector<uint64_t>& readFound(lua_State* L, uint32_t kind) {
    const std::string tag = textOr(L, 1, "tag", "");
    const auto read = [&](uint64_t* out, uint32_t capacity, uint32_t* count) {
        if (tag.empty()) return apiOf(L).get_objects(worldOf(L), kind, out, capacity, count);
        return apiOf(L).find_by_tag(worldOf(L), kind, tag.c_str(), nullptr, out, capacity, count);
    };
    readHandles(L, read);
    std::vector<uint64_t>& found = ScriptContext::of(L).rows;
    addPending(L, kind, tag, found);
    if (!found.empty() || tag.empty()) return found;
    return readHandles(L, [&](uint64_t* out, uint32_t capacity, uint32_t* count) {
        return apiOf(L).find_by_name(worldOf(L), kind, tag.c_str(), out, capacity, count);
    });
}

template <uint32_t Kind>
int findOne(lua_State* L) {
    const std::vector<uint64_t>& found = readFound(L, Kind);
    pushHandle(L, found.empty() ? 0 : found.front());
    return 1;
}

template <uint32_t Kind>
int findAll(lua_State* L) {
    const std::vector<uint64_t>& found = readFound(L, Kind);
    return pushHandles(L, found.data(), found.size());
}

/// The named places of the level. Their handles are 1, 2, ... in its order.
std::vector<rubble_location> locationsOf(lua_State* L) {
    uint32_t count = 0;
    isDone(L, apiOf(L).get_locations(worldOf(L), nullptr, 0, &count));
    std::vector<rubble_location> places(count);
    Sandbox::of(L).charge(L, count);
    if (count) isDone(L, apiOf(L).get_locations(worldOf(L), places.data(), count, &count));
    return places;
}

std::vector<uint64_t> locationsNamed(lua_State* L) {
    const std::string tag = textOr(L, 1, "tag", "");
    const std::vector<rubble_location> places = locationsOf(L);
    std::vector<uint64_t> found;
    for (size_t i = 0; i < places.size(); ++i)
        if (tag.empty() || tag == places[i].name) found.push_back(i + 1);
    return found;
}

int findLocation(lua_State* L) {
    const std::vector<uint64_t> found = locationsNamed(L);
    pushHandle(L, found.empty() ? 0 : found.front());
    return 1;
}

int findLocations(lua_State* L) {
    const std::vector<uint64_t> found = locationsNamed(L);
    return pushHandles(L, found.data(), found.size());
}

int getLocationTransform(lua_State* L) {
    const uint64_t number = handleAt(L, 1, "location");
    const std::vector<rubble_location> places = locationsOf(L);
    if (number < 1 || number > places.size()) refuseArgument(L, 1, "location", "what FindLocation() has given");
    pushPlacement(L, placementOf(places[number - 1].position, places[number - 1].rotation));
    return 1;
}

constexpr uint32_t kMaxTagBytes = 16 << 10;  ///< of all tags of an object: each step looks through them

int setTag(lua_State* L) {
    const uint64_t object = handleAt(L, 1, "handle");
    const std::string tag = textAt(L, 2, "tag");
    uint32_t bytes = 0;
    apiOf(L).get_tags(worldOf(L), object, nullptr, 0, &bytes);
    if (bytes > kMaxTagBytes)
        return luaL_error(L, "SetTag: expected an object whose tags have at most %d bytes, found more",
                          int(kMaxTagBytes));
    std::string value;
    if (!lua_isnoneornil(L, 3)) {
        if (!lua_isstring(L, 3)) refuseArgument(L, 3, "value", "a text");
        value = lua_tostring(L, 3);
    }
    if (isDone(L, apiOf(L).set_tag(worldOf(L), object, tag.c_str(), value.c_str())))
        ScriptContext::of(L).shared.pending.tags[{object, tag}] = value;
    return 0;
}

/// The value of a tag, with a zero at its end; empty: there is no such tag.
std::string readTag(lua_State* L) {
    const uint64_t object = handleAt(L, 1, "handle");
    const std::string tag = textAt(L, 2, "tag");
    const auto& pending = ScriptContext::of(L).shared.pending.tags;
    if (const auto set = pending.find({object, tag}); set != pending.end())
        return set->second ? *set->second + '\0' : "";
    std::string value(64, '\0');
    uint32_t count = 0;
    const auto read = [&] {
        return apiOf(L).get_tag(worldOf(L), object, tag.c_str(), value.data(), uint32_t(value.size()), &count);
    };
    rubble_result result = read();
    if (result == RUBBLE_ERROR_CAPACITY) {
        value.resize(count);
        result = read();
    }
    value.resize(isDone(L, result) ? count : 0);
    return value;
}

int hasTag(lua_State* L) {
    lua_pushboolean(L, !readTag(L).empty());
    return 1;
}

int getTagValue(lua_State* L) {
    const std::string value = readTag(L);
    lua_pushstring(L, value.c_str());
    return 1;
}

int removeTag(lua_State* L) {
    const uint64_t object = handleAt(L, 1, "handle");
    const std::string tag = textAt(L, 2, "tag");
    if (isDone(L, apiOf(L).remove_tag(worldOf(L), object, tag.c_str())))
        ScriptContext::of(L).shared.pending.tags[{object, tag}] = std::nullopt;
    return 0;
}

int isHandleValid(lua_State* L) {
    const uint64_t object = handleAt(L, 1, "handle");
    uint64_t value = 0;
    lua_pushboolean(L, apiOf(L).get_user_value(worldOf(L), object, &value) == RUBBLE_OK || isMadeInThisStep(L, object));
    return 1;
}

int getEntityType(lua_State* L) {
    static constexpr std::pair<uint32_t, const char*> kNames[] = {{RUBBLE_KIND_BODY, "body"},
                                                                  {RUBBLE_KIND_SHAPE, "shape"},
                                                                  {RUBBLE_KIND_LIGHT, "light"},
                                                                  {RUBBLE_KIND_JOINT, "joint"},
                                                                  {RUBBLE_KIND_TRIGGER, "trigger"}};
    const uint64_t object = handleAt(L, 1, "handle");
    const auto found = std::find_if(std::begin(kNames), std::end(kNames),
                                    [&](const auto& row) { return object && isOfKind(L, object, row.first); });
    lua_pushstring(L, found == std::end(kNames) ? "" : found->second);
    return 1;
}

int isBodyInTrigger(lua_State* L) {
    const uint64_t trigger = handleAt(L, 1, "trigger"), body = handleAt(L, 2, "body");
    const std::vector<uint64_t>& bodies = readHandles(L, [&](uint64_t* out, uint32_t capacity, uint32_t* count) {
        return apiOf(L).get_trigger_bodies(worldOf(L), trigger, out, capacity, count);
    });
    lua_pushboolean(L, std::find(bodies.begin(), bodies.end(), body) != bodies.end());
    return 1;
}

int deleteObject(lua_State* L) {
    const uint64_t object = handleAt(L, 1, "handle");
    const rubble_api& api = apiOf(L);
    using Remove = rubble_result (*)(rubble_world, uint64_t);
    for (const Remove remove : {Remove(api.destroy_shape), Remove(api.destroy_body), Remove(api.remove_light),
                                Remove(api.remove_joint), Remove(api.remove_water), Remove(api.remove_trigger)}) {
        const rubble_result result = remove(worldOf(L), object);
        if (result == RUBBLE_OK) return 0;
        if (result != RUBBLE_ERROR_STALE) isDone(L, result);
    }
    if (api.remove_character(worldOf(L), object) != RUBBLE_OK && worldOf(L))
        warnOnce(L, "handle: nothing has the handle " + std::to_string(object) + " any more, or ever had");
    return 0;
}

constexpr ScriptFunction kFunctions[] = {
    {"FindBody(tag, global) -> handle",
     "The first body with a tag, else with that name, or 0. Without a tag the first of all.",
     findOne<RUBBLE_KIND_BODY>},
    {"FindBodies(tag, global) -> list", "All bodies with a tag, else with that name. Without a tag all.",
     findAll<RUBBLE_KIND_BODY>},
    {"FindShape(tag, global) -> handle", "The first shape with a tag, else with that name, or 0.",
     findOne<RUBBLE_KIND_SHAPE>},
    {"FindShapes(tag, global) -> list", "All shapes with a tag, else with that name.", findAll<RUBBLE_KIND_SHAPE>},
    {"FindLight(tag, global) -> handle", "The first light with a tag, else with that name, or 0.",
     findOne<RUBBLE_KIND_LIGHT>},
    {"FindLights(tag, global) -> list", "All lights with a tag, else with that name.", findAll<RUBBLE_KIND_LIGHT>},
    {"FindJoint(tag, global) -> handle", "The first joint with a tag, else with that name, or 0.",
     findOne<RUBBLE_KIND_JOINT>},
    {"FindJoints(tag, global) -> list", "All joints with a tag, else with that name.", findAll<RUBBLE_KIND_JOINT>},
    {"FindTrigger(tag, global) -> handle", "The first trigger with a tag, else with that name, or 0.",
     findOne<RUBBLE_KIND_TRIGGER>},
    {"FindTriggers(tag, global) -> list", "All triggers with a tag, else with that name.",
     findAll<RUBBLE_KIND_TRIGGER>},
    {"IsBodyInTrigger(trigger, body) -> boolean", "Whether a body was in a trigger in the last step.", isBodyInTrigger},
    {"FindLocation(tag, global) -> handle", "The first place of the level with this name, or 0.", findLocation},
    {"FindLocations(tag, global) -> list", "All places of the level with this name.", findLocations},
    {"GetLocationTransform(location) -> transform", "Where such a place is.", getLocationTransform},
    {"SetTag(handle, tag, value)", "Gives an object a tag, with a value or without.", setTag, 500},
    {"HasTag(handle, tag) -> boolean", "Whether an object has a tag.", hasTag},
    {"GetTagValue(handle, tag) -> text", "The value of a tag; \"\" if there is none.", getTagValue},
    {"RemoveTag(handle, tag)", "Takes a tag away.", removeTag, 500},
    {"IsHandleValid(handle) -> boolean", "Whether the object is there.", isHandleValid},
    {"GetEntityType(handle) -> text", "\"body\", \"shape\", \"light\", \"joint\" or \"trigger\"; \"\" of what is gone.",
     getEntityType},
    {"Delete(handle)", "Removes an object in the next step, without dust or pieces.", deleteObject, 300},
};

}  // namespace

std::span<const ScriptFunction> findFunctions() {
    return kFunctions;
}

}  // namespace rubble::script
