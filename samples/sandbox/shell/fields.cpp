#include "samples/sandbox/shell/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace sandbox {

using namespace rubble::script;

namespace {

template <size_t N>
bool areFinite(const std::array<double, N>& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
}

}  // namespace

void requireTable(lua_State* L, int index, const char* name) {
    if (lua_type(L, index) != LUA_TTABLE) refuseArgument(L, index, name, "a table");
}

void requireKeys(lua_State* L, int index, const char* name, std::span<const char* const> keys, lua_Integer length) {
    requireTable(L, index, name);
    for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
        const int key = lua_gettop(L) - 1;
        const bool isText = lua_type(L, key) == LUA_TSTRING;
        const std::string_view text = isText ? lua_tostring(L, key) : "";
        if (isText && std::find(keys.begin(), keys.end(), text) != keys.end()) continue;
        if (lua_isinteger(L, key) && lua_tointeger(L, key) >= 1 && lua_tointeger(L, key) <= length) continue;
        if (keys.empty() && !length) refuseArgument(L, key, name, "a list, without other keys");
        const std::string numbers = length ? fmt::format("1 to {}{}", length, keys.empty() ? "" : ", ") : "";
        refuseArgument(L, key, name, fmt::format("only the keys {}{}", numbers, fmt::join(keys, ", ")).c_str());
    }
}

double rangedAt(lua_State* L, int index, const char* name, double low, double high) {
    const double number = numberAt(L, index, name);
    if (number >= low && number <= high) return number;
    refuseArgument(L, index, name, fmt::format("a number from {:g} to {:g}", low, high).c_str());
}

Vector finiteVectorAt(lua_State* L, int index, const char* name) {
    const Vector vector = vectorAt(L, index, name);
    if (!areFinite(vector)) refuseArgument(L, index, name, "finite numbers");
    return vector;
}

Placement finitePlacementAt(lua_State* L, int index, const char* name) {
    const Placement place = placementAt(L, index, name);
    if (!areFinite(place.position) || !areFinite(place.rotation)) refuseArgument(L, index, name, "finite numbers");
    return place;
}

int wholeAt(lua_State* L, int index, const char* name, int low, int high) {
    const double number = numberAt(L, index, name);
    if (number >= low && number <= high && number == std::floor(number)) return int(number);
    refuseArgument(L, index, name, fmt::format("a whole number from {} to {}", low, high).c_str());
}

int pushJoint(lua_State* L, const rubble_joint_settings& settings) {
    rubble_joint joint = 0;
    isDone(L, apiOf(L).create_joint(worldOf(L), &settings, &joint));
    if (joint) ScriptContext::of(L).shared.pending.created[joint] = RUBBLE_KIND_JOINT;
    pushHandle(L, joint);
    return 1;
}

}  // namespace sandbox
