#include <algorithm>
#include <string>

#include "runtime/script/sandbox/libraries.h"
#include "runtime/script/sandbox/sandbox.h"

namespace rubble::script {
namespace {

const char kIds = 0;  ///< its address is the key of the numbers of objects in the registry

bool hasField(lua_State* L, int index, const char* event) {
    if (luaL_getmetafield(L, index, event) == LUA_TNIL) return false;
    lua_pop(L, 1);
    return true;
}

/// Pushes a number that belongs to an object alone: 1 for the first that was asked for.
void pushId(lua_State* L, int index) {
    lua_rawgetp(L, LUA_REGISTRYINDEX, &kIds);
    lua_pushvalue(L, index);
    if (lua_rawget(L, -2) == LUA_TNIL) {
        lua_pop(L, 1);
        const lua_Integer next = 1 + (lua_rawgeti(L, -1, 0), lua_tointeger(L, -1));
        lua_pop(L, 1);
        lua_pushinteger(L, next);
        lua_rawseti(L, -2, 0);
        lua_pushvalue(L, index);
        lua_pushinteger(L, next);
        lua_rawset(L, -3);
        lua_pushinteger(L, next);
    }
    lua_remove(L, -2);
}

int toString(lua_State* L) {
    luaL_checkany(L, 1);
    pushText(L, 1);
    return 1;
}

int print(lua_State* L) {
    Sandbox& box = Sandbox::of(L);
    std::string line;
    for (int i = 1, count = lua_gettop(L); i <= count; ++i) {
        pushText(L, i);
        size_t length = 0;
        const char* text = lua_tolstring(L, -1, &length);
        box.charge(L, 100 + int64_t(length));
        line.append(i > 1 ? "\t" : "").append(text, length);
        lua_pop(L, 1);
    }
    if (box.output) box.output(line);
    return 0;
}

/// What a protected call ends with, and what a continued one comes back to.
int finishCall(lua_State* L, int status, lua_KContext skipped) {
    if (status == LUA_OK || status == LUA_YIELD) return lua_gettop(L) - int(skipped);
    Sandbox& box = Sandbox::of(L);
    if (box.isStopped()) Sandbox::raiseStop(L);
    box.charge(L, Sandbox::kErrorWork);
    lua_pushboolean(L, 0);
    if (status == LUA_ERRMEM) {
        const std::string refusal = box.refusal();  // a copy, which lives while its own text is refused memory
        lua_pushstring(L, refusal.c_str());
    } else
        lua_pushvalue(L, -2);
    return 2;
}

int protectedCall(lua_State* L) {
    luaL_checkany(L, 1);
    lua_pushboolean(L, 1);
    lua_insert(L, 1);
    return finishCall(L, lua_pcallk(L, lua_gettop(L) - 2, LUA_MULTRET, 0, 0, finishCall), 0);
}

/// Runs the handler of xpcall, its upvalue, unless the script is stopped.
int handleError(lua_State* L) {
    if (Sandbox::of(L).isStopped()) return 1;
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_insert(L, 1);
    lua_call(L, lua_gettop(L) - 1, 1);
    return 1;
}

int protectedCallWithHandler(lua_State* L) {
    luaL_checktype(L, 2, LUA_TFUNCTION);
    const int arguments = lua_gettop(L) - 2;
    lua_pushvalue(L, 2);
    lua_pushcclosure(L, handleError, 1);
    lua_replace(L, 2);  // the handler
    lua_pushboolean(L, 1);
    lua_pushvalue(L, 1);
    lua_rotate(L, 3, 2);  // f, handler, true, f, arguments
    return finishCall(L, lua_pcallk(L, arguments, LUA_MULTRET, 2, 2, finishCall), 2);
}

int setMetatable(lua_State* L) {
    if (lua_type(L, 2) == LUA_TTABLE) {
        lua_pushliteral(L, "__gc");
        if (lua_rawget(L, 2) != LUA_TNIL)
            return luaL_error(L, "setmetatable: scripts have no finalisers: expected no field __gc, found one");
        lua_pop(L, 1);
    }
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

int collectGarbage(lua_State* L) {
    const std::string what = luaL_optstring(L, 1, "collect");
    Sandbox& box = Sandbox::of(L);
    if (what == "count") {
        lua_pushnumber(L, double(box.memoryUsed()) / 1024.0);
    } else if (what == "collect") {
        box.charge(L, int64_t(box.memoryUsed() >> 4));
        lua_gc(L, LUA_GCCOLLECT);
        lua_pushinteger(L, 0);
    } else {
        return luaL_error(L, "collectgarbage: expected \"count\" or \"collect\", found \"%s\"", what.c_str());
    }
    return 1;
}

/// Replaces a function that gives a text in pieces, up to nil or "", by the text.
void joinPieces(lua_State* L) {
    lua_pushliteral(L, "");
    for (;;) {
        lua_pushvalue(L, 1);
        lua_call(L, 0, 1);
        if (lua_isnil(L, -1) || (lua_type(L, -1) == LUA_TSTRING && lua_rawlen(L, -1) == 0)) break;
        if (lua_type(L, -1) != LUA_TSTRING)
            luaL_error(L, "load: expected pieces of a text, found a %s", luaL_typename(L, -1));
        Sandbox::of(L).charge(L, 10 + int64_t((lua_rawlen(L, -1) + lua_rawlen(L, -2)) >> 5));
        lua_concat(L, 2);
    }
    lua_pop(L, 1);
    lua_replace(L, 1);
}

int load(lua_State* L) {
    if (lua_isfunction(L, 1)) joinPieces(L);
    if (lua_type(L, 1) != LUA_TSTRING)
        return luaL_error(L, "load: expected the text of a chunk or a function that gives it, found a %s",
                          luaL_typename(L, 1));
    size_t length = 0;
    const char* text = lua_tolstring(L, 1, &length);
    Sandbox& box = Sandbox::of(L);
    box.charge(L, compileCost({text, length}));
    const int status = luaL_loadbufferx(L, text, length, luaL_optstring(L, 2, "=(load)"), "t");
    if (box.isStopped()) Sandbox::raiseStop(L);
    if (status != LUA_OK) {
        lua_pushnil(L);
        lua_insert(L, -2);
        return 2;
    }
    if (!lua_isnone(L, 4)) {
        lua_pushvalue(L, 4);
        if (!lua_setupvalue(L, -2, 1)) lua_pop(L, 1);
    }
    return 1;
}

}  // namespace

void pushText(lua_State* L, int index) {
    const int kind = lua_type(L, index);
    const bool isObject = kind == LUA_TTABLE || kind == LUA_TFUNCTION || kind == LUA_TTHREAD || kind == LUA_TUSERDATA ||
                          kind == LUA_TLIGHTUSERDATA;
    if (!isObject || hasField(L, index, "__tostring")) {
        luaL_tolstring(L, index, nullptr);
        return;
    }
    const int object = lua_absindex(L, index);
    pushId(L, object);
    lua_pushfstring(L, "%s: %d", lua_typename(L, kind), int(lua_tointeger(L, -1)));
    lua_remove(L, -2);
}

void openBase(lua_State* L) {
    for (const char* name : {"dofile", "loadfile", "warn"}) {
        lua_pushnil(L);
        lua_setfield(L, -2, name);
    }
    static constexpr const char* kCharged[] = {"select", "tonumber", nullptr};
    chargeArguments(L, kCharged);
    lua_getfield(L, -1, "setmetatable");
    lua_pushcclosure(L, setMetatable, 1);
    lua_setfield(L, -2, "setmetatable");
    static constexpr luaL_Reg kFunctions[] = {{"tostring", toString},
                                              {"print", print},
                                              {"pcall", protectedCall},
                                              {"xpcall", protectedCallWithHandler},
                                              {"collectgarbage", collectGarbage},
                                              {"load", load},
                                              {nullptr, nullptr}};
    luaL_setfuncs(L, kFunctions, 0);
    openPairs(L);
    lua_createtable(L, 0, 0);  // the numbers of objects, which it does not keep alive
    lua_createtable(L, 0, 1);
    lua_pushliteral(L, "k");
    lua_setfield(L, -2, "__mode");
    lua_setmetatable(L, -2);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &kIds);
}

}  // namespace rubble::script
