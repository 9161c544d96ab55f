// Commands for scripts in Lua.
#include <fmt/format.h>

#include "editor/core/editor.h"
#include "runtime/script/binding/arguments.h"
#include "runtime/script/binding/script_context.h"
#include "runtime/script/script_host.h"

namespace editor {
namespace {

using rubble::script::ScriptContext;
using rubble::script::ScriptFunction;

/// A value of a table as it is typed on a command line; false: no command takes such a value.
bool readValue(lua_State* L, int index, std::string& out) {
    switch (lua_type(L, index)) {
        case LUA_TBOOLEAN:
            out = lua_toboolean(L, index) ? "yes" : "no";
            return true;
        case LUA_TNUMBER:
            out = lua_isinteger(L, index) ? fmt::format("{}", lua_tointeger(L, index))
                                          : fmt::format("{:.17g}", lua_tonumber(L, index));
            return true;
        case LUA_TSTRING:
            out = lua_tostring(L, index);
            return true;
        case LUA_TTABLE:
            break;
        default:
            return false;
    }
    out.clear();
    for (int i = 1; i <= 3; ++i) {
        lua_rawgeti(L, index, i);
        std::string number;
        const bool good = lua_type(L, -1) == LUA_TNUMBER && readValue(L, lua_gettop(L), number);
        lua_pop(L, 1);
        if (!good) return false;
        out += (i > 1 ? "," : "") + number;
    }
    return true;
}

/// The line that a call says; else what is wrong with the call.
std::string readCall(lua_State* L, Line& line) {
    if (lua_type(L, 1) != LUA_TSTRING) return "Command: name: expected a text";
    line.command = lua_tostring(L, 1);
    if (lua_isnoneornil(L, 2)) return "";
    if (!lua_istable(L, 2)) return fmt::format("Command: {}: expected a table of parameters", line.command);
    for (lua_pushnil(L); lua_next(L, 2); lua_pop(L, 1)) {
        Given given;
        if (lua_type(L, -2) == LUA_TSTRING) given.name = lua_tostring(L, -2);
        if (!readValue(L, lua_gettop(L), given.value)) {
            lua_pop(L, 2);
            return fmt::format("Command: {}: {}: expected a text, a number, true or false, or {{x, y, z}}",
                               line.command, given.name);
        }
        line.given.push_back(std::move(given));
    }
    return "";
}

/// Runs the command and pushes what it has to say, or what is wrong: false.
bool pushOutcome(lua_State* L) {
    Line line;
    const std::string wrong = readCall(L, line);
    Editor& editor = *static_cast<Editor*>(ScriptContext::of(L).shared.host);
    const Outcome outcome = wrong.empty() ? editor.run(line) : Outcome{false, wrong};
    lua_pushlstring(L, outcome.text.data(), outcome.text.size());
    return outcome.isDone;
}

int runCommand(lua_State* L) {
    if (pushOutcome(L)) return 1;
    luaL_where(L, 1);
    lua_insert(L, -2);
    lua_concat(L, 2);
    return lua_error(L);
}

constexpr ScriptFunction kFunctions[] = {
    {"Command(name, parameters) -> text", "Runs a command of the editor.", runCommand},
};

}  // namespace

Outcome Editor::runLua(const std::string& name, const std::string& text) {
    std::string said;
    rubble::script::ScriptHostSettings settings;
    settings.limits.work = int64_t(1) << 40;
    settings.limits.processorSeconds = 600.0;
    settings.limits.memory = size_t(256) << 20;
    settings.functions = kFunctions;
    settings.host = this;
    settings.log = [&](int level, const std::string& line) {
        if (level == RUBBLE_LOG_INFO) said += line + "\n";
    };
    rubble::script::ScriptHost host(rubble::api(), world().handle(), settings);
    const std::string error = host.add(name, text).error();
    try {
        if (!m_document.isPlaying()) m_document.edit(name, [] {});
    } catch (const std::exception& wrong) {
        return {false, error.empty() ? fmt::format("{}: {}", name, wrong.what()) : error};
    }
    return {error.empty(), said + error};
}

}  // namespace editor
