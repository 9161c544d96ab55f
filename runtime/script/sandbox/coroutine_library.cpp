#include "runtime/script/sandbox/libraries.h"
#include "runtime/script/sandbox/sandbox.h"

namespace rubble::script {
namespace {

constexpr int64_t kResumeWork = 100;  ///< a thread counts from the start each time: the most that it may run uncounted

/// Calls the function of Lua in upvalue 1 on a thread, and passes a stop on that ended it.
int resumeWatched(lua_State* L, lua_State* thread) {
    Sandbox& box = Sandbox::of(L);
    box.charge(L, kResumeWork);
    if (thread && box.isProtected(thread))
        luaL_error(L, "coroutine: expected one that the script has made, found that of a callback or of start()");
    if (thread && thread != L) box.watch(thread);
    const int results = lua_tocfunction(L, lua_upvalueindex(1))(L);
    if (box.isStopped()) Sandbox::raiseStop(L);
    if (!lua_toboolean(L, -results)) box.charge(L, Sandbox::kErrorWork);
    return results;
}

/// coroutine.resume and coroutine.close.
int resume(lua_State* L) {
    return resumeWatched(L, lua_tothread(L, 1));
}

/// What coroutine.wrap gives: upvalue 1 resumes, upvalue 2 is the thread. An error goes on to who called it.
int resumeWrapped(lua_State* L) {
    lua_State* thread = lua_tothread(L, lua_upvalueindex(2));
    lua_pushvalue(L, lua_upvalueindex(2));
    lua_insert(L, 1);
    const int results = resumeWatched(L, thread);
    if (lua_toboolean(L, -results)) return results - 1;
    const int status = lua_status(thread);
    if (status != LUA_OK && status != LUA_YIELD) {
        lua_resetthread(thread);  // closes what waits for it
        lua_settop(thread, 0);    // and leaves the error, which the next call would start
        if (Sandbox::of(L).isStopped()) Sandbox::raiseStop(L);
    }
    return lua_error(L);
}

int wrap(lua_State* L) {
    lua_pushvalue(L, lua_upvalueindex(2));  // create
    lua_insert(L, 1);
    lua_call(L, lua_gettop(L) - 1, 1);
    lua_pushvalue(L, lua_upvalueindex(1));  // resume of Lua
    lua_insert(L, -2);
    lua_pushcclosure(L, resumeWrapped, 2);
    return 1;
}

int yield(lua_State* L) {
    if (!lua_isyieldable(L))
        return luaL_error(L,
                          "coroutine.yield: expected a coroutine that can yield, found one inside of a call of "
                          "table.sort, require or another function that calls back");
    return lua_yield(L, lua_gettop(L));
}

}  // namespace

void openCoroutine(lua_State* L) {
    lua_getglobal(L, LUA_COLIBNAME);
    lua_getfield(L, -1, "resume");
    lua_getfield(L, -2, "create");
    lua_pushcclosure(L, wrap, 2);
    lua_setfield(L, -2, "wrap");
    wrapField(L, "resume", resume);
    wrapField(L, "close", resume);
    lua_pushcfunction(L, yield);
    lua_setfield(L, -2, "yield");
    lua_pop(L, 1);
}

}  // namespace rubble::script
