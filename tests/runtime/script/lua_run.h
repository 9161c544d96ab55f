#pragma once
#include <string>

#include "runtime/script/sandbox/sandbox.h"

namespace rubble::script {

/// Runs a text as the main function of a coroutine of its own, and prints what it returns, separated by spaces; or
/// "error: " and the error.
inline std::string runText(Sandbox& box, const std::string& text) {
    lua_State* state = box.state();
    lua_State* thread = lua_newthread(state);
    std::string answer;
    if (luaL_loadbufferx(thread, text.data(), text.size(), "=test", "t") != LUA_OK) {
        answer = "error: " + std::string(lua_tostring(thread, -1));
    } else {
        const RunResult result = box.run(thread, 0);
        if (result.state == RunResult::Failed) answer = "error: " + result.error;
        for (int i = 1; i <= result.results; ++i) {
            const int index = lua_gettop(thread) - result.results + i;
            size_t length = 0;
            const char* bytes = luaL_tolstring(thread, index, &length);
            answer += (i > 1 ? " " : "") + std::string(bytes, length);
            lua_pop(thread, 1);
        }
    }
    lua_settop(state, 0);
    return answer;
}

}  // namespace rubble::script
