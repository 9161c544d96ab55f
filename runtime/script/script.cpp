#include "runtime/script/script.h"

#include <chrono>

#include "runtime/script/binding/directives.h"
#include "runtime/script/functions/vocabulary.h"
#include "runtime/script/sandbox/libraries.h"

namespace rubble::script {
namespace {

constexpr const char* kNames[kCallbacks] = {
    "init",       "tick",   "update",  "destroy",   "onSplit", "onBreak", "onBodyBreak", "onContact",
    "onLightOut", "onFire", "onJoint", "onTrigger", "draw",    "onLoad",  "(text)",      "(after wait)"};
constexpr size_t kMaxIdle = 4;

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int openScript(lua_State* L) {
    openVocabulary(L);
    return 0;
}

/// Makes a thread that a reference keeps alive: an answer for the caller of prepare().
struct NewThread {
    lua_State* thread = nullptr;
    int reference = 0;
};

int makeThread(lua_State* L) {
    auto& made = *static_cast<NewThread*>(lua_touserdata(L, 1));
    made.thread = lua_newthread(L);
    made.reference = luaL_ref(L, LUA_REGISTRYINDEX);
    return 0;
}

/// Compiles a text onto the stack of a thread.
struct Chunk {
    lua_State* thread;
    const std::string& text;
    const std::string& name;
};

int compile(lua_State* L) {
    const auto& chunk = *static_cast<const Chunk*>(lua_touserdata(L, 1));
    Sandbox::of(L).charge(L, compileCost(chunk.text));
    const std::string name = "=" + chunk.name, text = withoutDirectives(chunk.text);
    if (luaL_loadbufferx(L, text.data(), text.size(), name.c_str(), "t") != LUA_OK) return lua_error(L);
    lua_xmove(L, chunk.thread, 1);
    return 0;
}

/// What a text returned, as it is shown.
struct Answer {
    lua_State* thread;
    int results;
    std::string& text;
};

int writeAnswer(lua_State* L) {
    const auto& answer = *static_cast<const Answer*>(lua_touserdata(L, 1));
    Sandbox::of(L).watch(L);  // tostring() may run the script's own function
    luaL_checkstack(L, answer.results + 8, nullptr);
    lua_xmove(answer.thread, L, answer.results);
    for (int i = 2; i < 2 + answer.results; ++i) {
        if (lua_isnil(L, i)) continue;
        if (!answer.text.empty()) answer.text += "\t";
        pushText(L, i);
        answer.text += lua_tostring(L, -1);
        lua_pop(L, 1);
    }
    return 0;
}

}  // namespace

const char* nameOf(Callback callback) {
    return kNames[size_t(callback)];
}

Script::Script(ScriptWorld& shared, const std::string& name, const SandboxLimits& limits)
    : m_context{.shared = shared, .name = name}, m_sandbox(limits, &m_context) {
    m_sandbox.output = [this](std::string_view line) {
        if (m_context.shared.log) m_context.shared.log(RUBBLE_LOG_INFO, m_context.name + ": " + std::string(line));
    };
    if (!m_sandbox.prepare(openScript, nullptr)) report(m_sandbox.refusal());
}

void Script::report(const std::string& error) {
    if (error == m_error) {
        ++m_repeats;
        return;
    }
    const auto& log = m_context.shared.log;
    if (log && m_repeats) log(RUBBLE_LOG_ERROR, m_error + " (" + std::to_string(m_repeats) + " times more)");
    m_error = error;
    m_repeats = 0;
    if (log) log(RUBBLE_LOG_ERROR, error);
}

lua_State* Script::takeThread(int& reference) {
    if (!m_idle.empty()) {
        const auto [thread, kept] = m_idle.back();
        m_idle.pop_back();
        reference = kept;
        return thread;
    }
    NewThread made;
    if (isStopped() || !m_sandbox.prepare(makeThread, &made)) return nullptr;
    reference = made.reference;
    return made.thread;
}

RunResult Script::run(Callback callback, lua_State* thread, int arguments) {
    CallbackProfile& profile = m_profile[size_t(callback)];
    const double startedAt = seconds();
    const uint64_t allocations = m_sandbox.allocations();
    m_context.callback = thread;
    RunResult result = m_sandbox.run(thread, arguments);
    ++profile.calls;
    profile.seconds += seconds() - startedAt;
    profile.allocations += m_sandbox.allocations() - allocations;
    profile.work += m_sandbox.workUsed();
    double until = 0.0;
    if (result.state == RunResult::Waits && !isWait(thread, result.results, until))
        result = {RunResult::Failed, 0,
                  placeOf(thread) + ": coroutine.yield: expected a coroutine, found a callback: use wait()"};
    m_context.callback = nullptr;
    return result;
}

void Script::settle(lua_State* thread, int reference, const RunResult& result) {
    if (result.state == RunResult::Failed) report(result.error);
    if (isStopped()) return;  // nothing of it runs again
    if (thread == m_textThread && result.state != RunResult::Waits) {
        m_textThread = nullptr;
        findCallbacks();
        m_isReady = result.state == RunResult::Done;
    }
    if (result.state == RunResult::Waits) {
        double until = 0.0;
        isWait(thread, result.results, until);
        lua_pop(thread, result.results);
        m_waiting.push_back({thread, reference, until});
    } else if (lua_status(thread) == LUA_OK && m_idle.size() < kMaxIdle) {
        lua_settop(thread, 0);
        m_idle.emplace_back(thread, reference);
    } else {
        luaL_unref(m_sandbox.state(), LUA_REGISTRYINDEX, reference);
    }
}

bool Script::load(const std::string& text, bool isAgain) {
    std::string answer;
    m_text = text;
    m_isAgain = isAgain;
    const bool isGood = evaluate(text, answer);
    if (!m_waiting.empty()) {
        m_textThread = m_waiting.back().thread;
        return true;
    }
    if (!isStopped()) findCallbacks();
    m_isReady = isGood;
    return isGood;
}

bool Script::evaluate(const std::string& text, std::string& answer) {
    int reference = 0;
    beginFrame();
    lua_State* thread = takeThread(reference);
    Chunk chunk{thread, text, m_context.name};
    if (!thread || !m_sandbox.prepare(compile, &chunk)) {
        report(isStopped() ? m_sandbox.stopReason() : m_sandbox.refusal());
        if (thread) m_idle.emplace_back(thread, reference);
        return false;
    }
    const RunResult result = run(Callback::Text, thread, 0);
    if (result.state == RunResult::Done) {
        Answer given{thread, result.results, answer};
        if (!m_sandbox.prepare(writeAnswer, &given)) report(isStopped() ? m_sandbox.stopReason() : m_sandbox.refusal());
    }
    settle(thread, reference, result);
    return result.state != RunResult::Failed;
}

bool Script::compiles(const std::string& text) {
    int reference = 0;
    lua_State* thread = takeThread(reference);
    if (!thread) return false;
    Chunk chunk{thread, text, m_context.name};
    const bool isGood = m_sandbox.prepare(compile, &chunk);
    lua_settop(thread, 0);
    m_idle.emplace_back(thread, reference);
    return isGood;
}

bool Script::isBegin(const std::string& text) {
    return !compiles(text) && !isStopped() && m_sandbox.refusal().ends_with("<eof>");
}

void Script::findCallbacks() {
    const Sandbox::HostAccess access(m_sandbox);
    lua_State* L = m_sandbox.state();
    lua_rawgeti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
    for (size_t i = 0; i < kCallbacks; ++i) {
        lua_pushstring(L, kNames[i]);
        m_has[i] = lua_rawget(L, -2) == LUA_TFUNCTION;
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
}

lua_State* Script::begin(Callback callback, int& reference) {
    if (!has(callback) || isStopped()) return nullptr;
    lua_State* thread = takeThread(reference);
    if (!thread) return nullptr;
    const Sandbox::HostAccess access(m_sandbox);
    lua_rawgeti(thread, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
    lua_pushstring(thread, nameOf(callback));
    const bool isThere = lua_rawget(thread, -2) == LUA_TFUNCTION;
    lua_remove(thread, -2);
    if (isThere) return thread;
    m_has[size_t(callback)] = false;  // the script has taken it away
    lua_settop(thread, 0);
    m_idle.emplace_back(thread, reference);
    return nullptr;
}

void Script::startAll() {
    std::vector<int> started;
    started.swap(m_context.started);
    for (const int list : started) {
        int reference = 0;
        lua_State* thread = isStopped() ? nullptr : takeThread(reference);
        if (!thread) return;
        const int count = pushTrusted(thread, [&](lua_State* L) {
            lua_rawgeti(L, LUA_REGISTRYINDEX, list);
            lua_rawgeti(L, 1, 0);
            const int values = int(lua_tointeger(L, -1));
            lua_pop(L, 1);
            luaL_checkstack(L, values, nullptr);
            for (int i = 1; i <= values; ++i) lua_rawgeti(L, 1, i);
            lua_remove(L, 1);
            luaL_unref(L, LUA_REGISTRYINDEX, list);
            return values;
        });
        settle(thread, reference, run(Callback::Resume, thread, count - 1));
    }
}

void Script::resumeWaiting() {
    std::vector<Waiting> waiting;
    waiting.swap(m_waiting);
    for (const Waiting& each : waiting) {
        if (isStopped()) return;
        if (each.until <= m_context.shared.time + 1e-9)
            settle(each.thread, each.reference, run(Callback::Resume, each.thread, 0));
        else
            m_waiting.push_back(each);
    }
    if (!m_context.started.empty()) startAll();
}

}  // namespace rubble::script
