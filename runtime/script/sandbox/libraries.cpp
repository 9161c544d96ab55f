#include "runtime/script/sandbox/libraries.h"

#include <algorithm>
#include <cmath>

#include "runtime/script/sandbox/sandbox.h"

namespace rubble::script {
namespace {

/// Charges what the arguments hold, then is the function of Lua in its upvalue.
int chargeThenCall(lua_State* L) {
    int64_t work = lua_gettop(L);
    for (int i = lua_gettop(L); i > 0; --i)
        if (lua_type(L, i) == LUA_TSTRING) work += int64_t(lua_rawlen(L, i) >> 4);
    Sandbox::of(L).charge(L, work);
    Sandbox::of(L).makeRoom(L);
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

/// As chargeThenCall(), of functions that give a value for each byte of a string between two positions.
int limitThenCall(lua_State* L) {
    const lua_Integer length = lua_type(L, 1) == LUA_TSTRING ? lua_Integer(lua_rawlen(L, 1)) : 0;
    const auto position = [&](int index, lua_Integer otherwise) {
        const lua_Integer given = luaL_optinteger(L, index, otherwise);
        return given < 0 ? std::max<lua_Integer>(given, -length) + length + 1 : std::min(given, length);
    };
    const lua_Integer first = position(2, 1);
    const lua_Integer count = position(3, first) - first + 1;
    if (count > kMaxResults)
        return luaL_error(L, "expected at most %d values at once, found %d", int(kMaxResults), int(count));
    return chargeThenCall(L);
}

void wrapAll(lua_State* L, const char* const* names, lua_CFunction function) {
    for (; *names; ++names) wrapField(L, *names, function);
}

/// math.randomseed(): without a number it starts the sequence of the sandbox again.
int seedRandom(lua_State* L) {
    if (lua_gettop(L) == 0) lua_pushinteger(L, lua_Integer(Sandbox::of(L).limits().seed));
    lua_pushvalue(L, lua_upvalueindex(1));  // has an upvalue of its own, the state of the numbers
    lua_insert(L, 1);
    lua_call(L, lua_gettop(L) - 1, 0);
    return 0;
}

/// math.pow of Lua 5.1.
int power(lua_State* L) {
    lua_pushnumber(L, std::pow(luaL_checknumber(L, 1), luaL_checknumber(L, 2)));
    return 1;
}

void openLibrary(lua_State* L, const char* name, lua_CFunction open) {
    luaL_requiref(L, name, open, 1);
    lua_pop(L, 1);
}

}  // namespace

void wrapField(lua_State* L, const char* name, lua_CFunction function) {
    lua_getfield(L, -1, name);
    lua_pushcclosure(L, function, 1);
    lua_setfield(L, -2, name);
}

void chargeArguments(lua_State* L, const char* const* names) {
    wrapAll(L, names, chargeThenCall);
}

void limitResults(lua_State* L, const char* const* names) {
    wrapAll(L, names, limitThenCall);
}

int64_t compileCost(std::string_view text) {
    int64_t labels = 0, jumps = 0;
    for (size_t at = text.find("::"); at != text.npos; at = text.find("::", at + 2)) ++labels;
    for (size_t at = text.find("goto"); at != text.npos; at = text.find("goto", at + 4)) ++jumps;
    return int64_t(text.size()) * kCompileWork +
           labels * (labels + jumps) / 8;  // each label is compared with all others
}

void openMath(lua_State* L) {
    static constexpr const char* kUtf8[] = {"char", "len", "offset", "codes", nullptr};
    static constexpr const char* kMany[] = {"codepoint", nullptr};
    openLibrary(L, "utf8", luaopen_utf8);
    lua_getglobal(L, "utf8");
    chargeArguments(L, kUtf8);
    limitResults(L, kMany);
    lua_pop(L, 1);
    static constexpr const char* kMath[] = {"max", "min", "tointeger", nullptr};
    openLibrary(L, "math", luaopen_math);
    lua_getglobal(L, "math");
    chargeArguments(L, kMath);
    lua_pushcfunction(L, power);
    lua_setfield(L, -2, "pow");
    lua_getfield(L, -1, "randomseed");
    lua_pushcclosure(L, seedRandom, 1);
    lua_pushvalue(L, -1);
    lua_setfield(L, -3, "randomseed");
    lua_call(L, 0, 0);
    lua_pop(L, 1);
}

void openLibraries(lua_State* L) {
    openLibrary(L, LUA_GNAME, luaopen_base);
    lua_pushglobaltable(L);
    openBase(L);
    lua_pop(L, 1);
    openLibrary(L, LUA_COLIBNAME, luaopen_coroutine);
    openCoroutine(L);
    openLibrary(L, LUA_STRLIBNAME, luaopen_string);
    openString(L);
    openLibrary(L, LUA_TABLIBNAME, luaopen_table);
    openTable(L);
    openMath(L);
}

}  // namespace rubble::script
