#include <algorithm>
#include <cmath>
#include <vector>

#include "runtime/script/binding/calls.h"
#include "samples/sandbox/shell/fields.h"
#include "samples/sandbox/shell/functions.h"
#include "samples/sandbox/shell/game.h"

namespace sandbox {
namespace {

using namespace rubble::script;

struct VectorField {
    const char* name;
    double (rubble_environment::*value)[3];
};
constexpr VectorField kVectors[] = {
    {"sunColor", &rubble_environment::sun_color},         {"skyColor", &rubble_environment::sky_color},
    {"horizonColor", &rubble_environment::horizon_color}, {"groundColor", &rubble_environment::ground_color},
    {"fogColor", &rubble_environment::fog_color},         {"fogTint", &rubble_environment::fog_tint},
    {"sunDirection", &rubble_environment::sun_direction},
};

struct NumberField {
    const char* name;
    double rubble_environment::*value;
};
constexpr NumberField kNumbers[] = {
    {"sunAngle", &rubble_environment::sun_angle},     {"fogDistance", &rubble_environment::fog_distance},
    {"fogDensity", &rubble_environment::fog_density}, {"fogBase", &rubble_environment::fog_base},
    {"fogHeight", &rubble_environment::fog_height},   {"fogForward", &rubble_environment::fog_forward},
    {"clouds", &rubble_environment::clouds},          {"stars", &rubble_environment::stars},
    {"exposure", &rubble_environment::exposure},      {"wetness", &rubble_environment::wetness},
};

/// Calls take(index) with a field of table 1 on the stack, if it is there.
template <class Take>
void withField(lua_State* L, const char* name, Take&& take) {
    lua_getfield(L, 1, name);
    if (!lua_isnil(L, -1)) take(lua_gettop(L));
    lua_pop(L, 1);
}

int setEnvironment(lua_State* L) {
    static const std::vector<const char*> keys = [] {
        std::vector<const char*> all = {"sun"};
        for (const VectorField& field : kVectors) all.push_back(field.name);
        for (const NumberField& field : kNumbers) all.push_back(field.name);
        return all;
    }();
    requireKeys(L, 1, "air", keys);
    auto air = sized<rubble_environment>();
    if (!isDone(L, apiOf(L).get_environment(worldOf(L), &air))) return 0;
    withField(L, "clouds", [&](int at) { air.clouds = numberAt(L, at, "clouds"); });  // the model greys by them
    withField(L, "sun", [&](int at) {
        const Vector sun = vectorAt(L, at, "sun");
        isDone(L, apiOf(L).apply_sky_model(&air, sun.data()));
    });
    for (const VectorField& field : kVectors)
        withField(L, field.name, [&](int at) { copy(air.*field.value, vectorAt(L, at, field.name)); });
    for (const NumberField& field : kNumbers)
        withField(L, field.name, [&](int at) { air.*field.value = numberAt(L, at, field.name); });
    isDone(L, apiOf(L).set_environment(worldOf(L), &air));
    return 0;
}

int getEnvironment(lua_State* L) {
    auto air = sized<rubble_environment>();
    if (!isDone(L, apiOf(L).get_environment(worldOf(L), &air))) return 0;
    lua_newtable(L);
    for (const VectorField& field : kVectors) {
        pushVector(L, air.*field.value);
        lua_setfield(L, -2, field.name);
    }
    for (const NumberField& field : kNumbers) {
        lua_pushnumber(L, air.*field.value);
        lua_setfield(L, -2, field.name);
    }
    return 1;
}

int setRules(lua_State* L) {
    static constexpr const char* kKeys[] = {"stress", "strength", "contactTime", "fireSpread", "fireTime"};
    requireKeys(L, 1, "rules", kKeys);
    auto rules = sized<rubble_settings>();
    if (!isDone(L, apiOf(L).get_settings(worldOf(L), &rules))) return 0;
    withField(L, "stress", [&](int at) {
        if (!lua_isboolean(L, at)) refuseArgument(L, at, "stress", "true or false");
        rules.flags &= ~uint32_t(RUBBLE_SETTING_STRESS);
        if (lua_toboolean(L, at)) rules.flags |= RUBBLE_SETTING_STRESS;
    });
    withField(L, "strength", [&](int at) { rules.strength_scale = numberAt(L, at, "strength"); });
    withField(L, "contactTime", [&](int at) { rules.contact_time = numberAt(L, at, "contactTime"); });
    withField(L, "fireSpread", [&](int at) { rules.fire_spread = numberAt(L, at, "fireSpread"); });
    withField(L, "fireTime", [&](int at) { rules.fire_burn_time = numberAt(L, at, "fireTime"); });
    isDone(L, apiOf(L).set_settings(worldOf(L), &rules));
    return 0;
}

int beginShot(lua_State* L) {
    Requests& requests = gameOf(L).requests();
    requests.shot = textAt(L, 1, "name");
    const bool isName = !requests.shot.empty() && requests.shot.find_first_of("/\\") == std::string::npos;
    if (!isName) refuseArgument(L, 1, "name", "a name without slashes");
    requests.unseen = clampedAt(L, 2, "unseen", 0.0, 600.0);
    requests.filmFrames = int(clampedAt(L, 3, "frames", 1.0, 1e6));
    return 0;
}

constexpr ScriptFunction kFunctions[] = {
    {"BeginShot(name, unseen, frames)",
     "The frames from this one on are another shot of the film, which has so many frames in all; before it so many "
     "seconds of the world pass that nobody sees.",
     beginShot},
    {"SetEnvironment(air)",
     "Sky, sun and air: fields of rubble_environment, as fogDensity, others stay; sun: a direction from which "
     "apply_sky_model() finds the colours.",
     setEnvironment, 0, ""},
    {"GetEnvironment() -> air", "The present sky, sun and air, as SetEnvironment() takes them.", getEnvironment},
    {"SetRules(rules)", "How the world breaks and burns: stress, strength, contactTime, fireSpread, fireTime.",
     setRules, 0, "fire_burn_time fireTime, strength_scale strength"},
};

}  // namespace

std::span<const ScriptFunction> filmFunctions() {
    return kFunctions;
}

}  // namespace sandbox
