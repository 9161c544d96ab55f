#include "runtime/script/binding/arguments.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "runtime/script/binding/messages.h"
#include "runtime/script/binding/script_context.h"

namespace rubble::script {
namespace {

const char kMetatables[3] = {};  ///< their addresses are keys in the registry

/// The first bytes of a text, with its zero bytes as "\\0": what reads a message ends at one.
std::string shownText(lua_State* L, int index) {
    size_t length = 0;
    const char* const bytes = lua_tolstring(L, index, &length);
    std::string shown;
    for (size_t i = 0; i < std::min<size_t>(length, 40); ++i) shown += bytes[i] ? std::string(1, bytes[i]) : "\\0";
    return shown;
}

/// What a message says that was found.
std::string described(lua_State* L, int index) {
    switch (lua_type(L, index)) {
        case LUA_TNONE:
            return "nothing";
        case LUA_TNIL:
            return "nil";
        case LUA_TBOOLEAN:
            return lua_toboolean(L, index) ? "true" : "false";
        case LUA_TNUMBER: {
            lua_pushvalue(L, index);
            const std::string text = lua_tostring(L, -1);
            lua_pop(L, 1);
            return text;
        }
        case LUA_TSTRING:
            return "\"" + shownText(L, index) + "\"";
        case LUA_TTABLE:
            return "a table of " + std::to_string(lua_rawlen(L, index)) + " values";
        default:
            return std::string("a ") + luaL_typename(L, index);
    }
}

/// Reads `count` numbers of a table; false: they are not all there.
bool readNumbers(lua_State* L, int index, double* out, int count) {
    if (lua_type(L, index) != LUA_TTABLE) return false;
    bool isGood = true;
    for (int i = 0; i < count; ++i) {
        isGood = lua_rawgeti(L, index, i + 1) == LUA_TNUMBER && isGood;
        out[i] = lua_tonumber(L, -1);
        lua_pop(L, 1);
    }
    return isGood;
}

void pushNumbers(lua_State* L, const double* numbers, int count, ValueKind kind) {
    lua_createtable(L, count, 0);
    for (int i = 0; i < count; ++i) {
        lua_pushnumber(L, numbers[i]);
        lua_rawseti(L, -2, i + 1);
    }
    pushMetatable(L, kind);
    lua_setmetatable(L, -2);
}

}  // namespace

void refuseArgument(lua_State* L, int index, const char* name, const char* expected) {
    luaL_error(L, "%s: %s: expected %s, found %s", runningFunction(L).name().c_str(),
               name ? name : parameterAt(L, index).c_str(), expected, described(L, index).c_str());
    std::abort();  // luaL_error() does not return
}

double numberAt(lua_State* L, int index, const char* name) {
    int isNumber = 0;
    const double number = lua_tonumberx(L, index, &isNumber);
    if (!isNumber) refuseArgument(L, index, name, "a number");
    return number;
}

double numberOr(lua_State* L, int index, const char* name, double otherwise) {
    return lua_isnoneornil(L, index) ? otherwise : numberAt(L, index, name);
}

double finiteAt(lua_State* L, int index, const char* name) {
    const double number = numberAt(L, index, name);
    if (!std::isfinite(number)) refuseArgument(L, index, name, "a finite number");
    return number;
}

double finiteOr(lua_State* L, int index, const char* name, double otherwise) {
    return lua_isnoneornil(L, index) ? otherwise : finiteAt(L, index, name);
}

double clampedAt(lua_State* L, int index, const char* name, double low, double high) {
    const double number = numberAt(L, index, name);
    if (std::isnan(number)) refuseArgument(L, index, name, "a number");
    return std::clamp(number, low, high);
}

double limitedAt(lua_State* L, int index, const char* name, double low, double high) {
    const double number = numberAt(L, index, name), limited = clampedAt(L, index, name, low, high);
    if (limited == number) return number;
    char text[100];
    std::snprintf(text, sizeof text, "%s: expected %g to %g, found %g: it counts as %g", name, low, high, number,
                  limited);
    warnOnce(L, text);
    return limited;
}

bool boolOr(lua_State* L, int index, bool otherwise) {
    return lua_isnoneornil(L, index) ? otherwise : lua_toboolean(L, index);
}

Vector vectorAt(lua_State* L, int index, const char* name) {
    Vector vector;
    if (!readNumbers(L, index, vector.data(), 3)) refuseArgument(L, index, name, "a vector {x, y, z}");
    return vector;
}

std::pair<Vector, Vector> cornersAt(lua_State* L) {
    const std::pair corners{vectorAt(L, 1, "min"), vectorAt(L, 2, "max")};
    const auto isNear = [](double each) { return std::abs(each) <= 1e9; };
    const auto& [low, high] = corners;
    if (!std::all_of(low.begin(), low.end(), isNear)) refuseArgument(L, 1, "min", "a vector of -1e9 to 1e9 m");
    if (!std::all_of(high.begin(), high.end(), isNear)) refuseArgument(L, 2, "max", "a vector of -1e9 to 1e9 m");
    for (size_t i = 0; i < 3; ++i)
        if (low[i] > high[i]) refuseArgument(L, 2, "max", "no less than min");
    return corners;
}

Rotation rotationAt(lua_State* L, int index, const char* name) {
    Rotation rotation;
    if (!readNumbers(L, index, rotation.data(), 4)) refuseArgument(L, index, name, "a rotation {x, y, z, w}");
    return rotation;
}

Placement placementAt(lua_State* L, int index, const char* name) {
    Placement placement;
    if (lua_type(L, index) != LUA_TTABLE) refuseArgument(L, index, name, "a transform {pos =, rot =}");
    lua_getfield(L, index, "pos");
    lua_getfield(L, index, "rot");
    const bool isGood = readNumbers(L, lua_gettop(L) - 1, placement.position.data(), 3) &&
                        readNumbers(L, lua_gettop(L), placement.rotation.data(), 4);
    lua_pop(L, 2);
    if (!isGood) refuseArgument(L, index, name, "a transform {pos =, rot =}");
    return placement;
}

Placement poseAt(lua_State* L, int index, const char* name) {
    constexpr double kExact = 0.002, kNear = 0.1;  // what is exact stays as it is, bit by bit
    Placement placement = placementAt(L, index, name);
    double squared = 0.0;
    for (const double each : placement.rotation) squared += each * each;
    if (squared == 0.0) refuseArgument(L, index, name, "a transform {pos =, rot =} with a rotation that is not 0");
    const double length = std::sqrt(squared);
    if (std::abs(squared - 1.0) > kExact && std::abs(length - 1.0) <= kNear)
        for (double& each : placement.rotation) each /= length;
    return placement;
}

std::string textAt(lua_State* L, int index, const char* name) {
    if (lua_type(L, index) != LUA_TSTRING) refuseArgument(L, index, name, "a text");
    size_t length = 0;
    const char* bytes = lua_tolstring(L, index, &length);
    return {bytes, length};
}

std::string textOr(lua_State* L, int index, const char* name, const char* otherwise) {
    return lua_isnoneornil(L, index) ? otherwise : textAt(L, index, name);
}

uint64_t handleAt(lua_State* L, int index, const char* name) {
    int isInteger = 0;
    const lua_Integer handle = lua_tointegerx(L, index, &isInteger);
    if (!isInteger) refuseArgument(L, index, name, "a handle");
    return uint64_t(handle);
}

void pushMetatable(lua_State* L, ValueKind kind) {
    const void* key = &kMetatables[int(kind)];
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, key) == LUA_TTABLE) return;
    lua_pop(L, 1);
    lua_newtable(L);
    lua_pushvalue(L, -1);
    lua_rawsetp(L, LUA_REGISTRYINDEX, key);
}

void pushVector(lua_State* L, const double* vector) {
    pushNumbers(L, vector, 3, ValueKind::Vec);
}

void pushRotation(lua_State* L, const double* rotation) {
    pushNumbers(L, rotation, 4, ValueKind::Quat);
}

void pushPlacement(lua_State* L, const Placement& placement) {
    lua_createtable(L, 0, 2);
    pushVector(L, placement.position.data());
    lua_setfield(L, -2, "pos");
    pushRotation(L, placement.rotation.data());
    lua_setfield(L, -2, "rot");
    pushMetatable(L, ValueKind::Transform);
    lua_setmetatable(L, -2);
}

void pushHandle(lua_State* L, uint64_t handle) {
    lua_pushinteger(L, lua_Integer(handle));
}

int pushHandles(lua_State* L, const uint64_t* handles, size_t count) {
    lua_createtable(L, int(count), 0);
    for (size_t i = 0; i < count; ++i) {
        pushHandle(L, handles[i]);
        lua_rawseti(L, -2, lua_Integer(i) + 1);
    }
    return 1;
}

bool isDone(lua_State* L, rubble_result result) {
    if (result == RUBBLE_OK) return true;
    if (!ScriptContext::of(L).shared.world) return false;
    const std::string text = messageOf(L, ScriptContext::of(L).shared.api->get_last_error());
    if (result != RUBBLE_ERROR_STALE) luaL_error(L, "%s: %s", runningFunction(L).name().c_str(), text.c_str());
    warnOnce(L, text);
    return false;
}

void warnOnce(lua_State* L, const std::string& text) {
    ScriptContext& context = ScriptContext::of(L);
    const std::string place = placeOf(L);
    if (context.warned.size() < 1000 && context.warned.insert(place).second && context.shared.log)
        context.shared.log(RUBBLE_LOG_WARNING, place + ": " + runningFunction(L).name() + ": " + text);
}

void requireStep(lua_State* L, int64_t work) {
    const ScriptContext& context = ScriptContext::of(L);
    const SandboxLimits& limits = Sandbox::of(L).limits();
    const int64_t most = std::max(limits.work, limits.workPerFrame);
    const bool isOwn = context.stepWork + work > limits.work;
    if (!isOwn && context.shared.stepWork + work <= most) return;
    luaL_error(L, "%s: expected edits of at most %I of %s for one step, found more: wait(0) lets the step take place",
               runningFunction(L).name().c_str(), lua_Integer(isOwn ? limits.work : most),
               isOwn ? "a script" : "all scripts");
}

void chargeStep(lua_State* L, int64_t work) {
    requireStep(L, work);
    ScriptContext& context = ScriptContext::of(L);
    context.stepWork += work;
    context.shared.stepWork += work;
}

int endCall(lua_State* L, int results) {
    if (CallObserver* const observer = ScriptContext::of(L).shared.observer)
        observer->end(L, runningFunction(L), results);
    return results;
}

const ScriptFunction& runningFunction(lua_State* L) {
    return *static_cast<const ScriptFunction*>(lua_touserdata(L, lua_upvalueindex(1)));
}

}  // namespace rubble::script
