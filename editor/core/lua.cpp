// Commands for scripts in Lua.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "editor/core/editor.h"
#include "runtime/script/binding/arguments.h"
#include "runtime/script/binding/script_context.h"
#include "runtime/script/script_host.h"

namespace editor {
namespace {

using rubble::script::Callback;
using rubble::script::Script;
using rubble::script::ScriptContext;
using rubble::script::ScriptFunction;
using rubble::script::ScriptHost;

constexpr int64_t kWork = 100'000'000;  ///< instructions of one call: seconds
constexpr int kMaxSteps = 100'000;      ///< of play, while a script waits

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
    std::stable_sort(line.given.begin(), line.given.end(),
                     [](const Given& a, const Given& b) { return a.name < b.name; });
    return "";
}

/// A script that runs: what it queues is carried out before its next command, and while it waits.
class LuaRun {
public:
    LuaRun(Editor& editor, std::string name) : m_editor(editor), m_name(std::move(name)) {}
    void run(ScriptHost& host, const std::string& text);
    Outcome command(const Line& line);
    /// What went wrong beside errors of the script; "" if nothing did.
    const std::string& error() const { return m_error; }

private:
    void carryOut();
    bool goOn();

    Editor& m_editor;
    std::string m_name, m_error;
    ScriptHost* m_host = nullptr;
    uint64_t m_calls = 0;  ///< of functions beside Command, at the last look
};

/// Runs the command and pushes what it has to say, or what is wrong: false.
bool pushOutcome(lua_State* L) {
    Line line;
    const std::string wrong = readCall(L, line);
    LuaRun& run = *static_cast<LuaRun*>(ScriptContext::of(L).shared.host);
    const Outcome outcome = wrong.empty() ? run.command(line) : Outcome{false, wrong};
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

/// In play edits wait for its next step.
void LuaRun::carryOut() {
    uint64_t calls = 0;
    for (const Script& script : m_host->scripts()) {
        const std::vector<uint64_t>& all = script.context().calls;
        calls = std::accumulate(all.begin(), all.end() - std::size(kFunctions), calls);
    }
    if (m_editor.document().isPlaying() || std::exchange(m_calls, calls) == calls) return;
    m_host->beforeEdits();
    m_editor.document().carryOut(m_name);
    m_host->afterEdits();
}

Outcome LuaRun::command(const Line& line) {
    Document& document = m_editor.document();
    try {
        if (document.isPlaying()) m_host->beforeEdits();
        carryOut();
    } catch (const std::exception& wrong) {
        return {false, wrong.what()};
    }
    const uint64_t before = document.playedSteps();
    const Outcome outcome = m_editor.run(line);
    const uint64_t steps = document.playedSteps() - std::min(before, document.playedSteps());
    if (!document.isPlaying() || steps) m_host->afterEdits(document.isPlaying() ? steps : 0);
    m_host->shared().hasTime = document.isPlaying();
    return outcome;
}

/// Lets pass what the script waits for; false: that will not come.
bool LuaRun::goOn() {
    Document& document = m_editor.document();
    const Script& script = m_host->scripts().front();
    const uint64_t resumed = script.profile(Callback::Resume).calls;
    if (document.isPlaying()) {
        document.step([&] {
            if (m_host->step() != RUBBLE_OK) throw Refused(rubble::api().get_last_error());
        });
        return true;
    }
    carryOut();
    m_host->resumeWaiting();
    return script.profile(Callback::Resume).calls != resumed;
}

void LuaRun::run(ScriptHost& host, const std::string& text) {
    m_host = &host;
    host.shared().hasTime = m_editor.document().isPlaying();
    const Script& script = host.add(m_name, text);
    try {
        for (int i = 0; script.isWaiting() && script.error().empty(); ++i) {
            if (i == kMaxSteps) throw Refused(fmt::format("expected an end, found none in {} steps of play", i));
            if (!goOn()) throw Refused("the script waits for a time that does not come: its play has ended");
        }
        carryOut();
    } catch (const std::exception& wrong) {
        m_error = fmt::format("{}: {}", m_name, wrong.what());
    }
}

}  // namespace

Outcome Editor::runLua(const std::string& name, const std::string& text) {
    std::string said;
    rubble::script::ScriptHostSettings settings;
    settings.limits.work = kWork;
    settings.limits.processorSeconds = 600.0;
    settings.limits.memory = size_t(256) << 20;
    settings.functions = kFunctions;
    LuaRun run(*this, name);
    settings.host = &run;
    settings.log = [&](int level, const std::string& line) {
        if (level == RUBBLE_LOG_INFO) said += line + "\n";
    };
    ScriptHost host(rubble::api(), world().handle(), settings);
    run.run(host, text);
    const std::string& error = host.scripts().front().error().empty() ? run.error() : host.scripts().front().error();
    return {error.empty(), said + error};
}

}  // namespace editor
