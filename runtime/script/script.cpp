#include "runtime/script/script.h"

#include <algorithm>
#include <chrono>

#include "runtime/script/binding/directives.h"
#include "runtime/script/functions/vocabulary.h"
#include "runtime/script/sandbox/libraries.h"

namespace rubble::script {
namespace {

constexpr const char* kNames[kCallbacks] = {
    "init",       "tick",   "update",  "destroy",   "onSplit", "onBreak", "onBodyBreak", "onContact",
    "onLightOut", "onFire", "onJoint", "onTrigger", "draw",    "onLoad",  "(text)",      "(after wait)"};
constexpr size_t kFunctions = size_t(Callback::Text);  ///< callbacks that have a function
constexpr size_t kMaxIdle = 4;
constexpr int kMaxErrors = 20;  ///< of one line that are logged

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
    Sandbox::of(L).protectThread(made.thread);
    return 0;
}

/// The thread of Script::m_names.
int makeNames(lua_State* L) {
    lua_State* thread = lua_newthread(L);
    luaL_ref(L, LUA_REGISTRYINDEX);
    lua_rawgeti(thread, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
    for (size_t i = 0; i < kFunctions; ++i) lua_pushstring(thread, kNames[i]);
    *static_cast<lua_State**>(lua_touserdata(L, 1)) = thread;
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
    const int64_t mostBytes = Sandbox::of(L).limits().work / kCompileWork;
    if (int64_t(chunk.text.size()) > mostBytes)
        return luaL_error(L, "%s: expected a text of at most %I bytes, found one of %I", chunk.name.c_str(),
                          lua_Integer(mostBytes), lua_Integer(chunk.text.size()));
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
        if (i > 2) answer.text += "\t";
        pushText(L, i);
        size_t length = 0;
        const char* bytes = lua_tolstring(L, -1, &length);
        answer.text.append(bytes, length);
        lua_pop(L, 1);
    }
    return 0;
}

}  // namespace

const char* nameOf(Callback callback) {
    return kNames[size_t(callback)];
}

Script::Script(ScriptWorld& shared, const std::string& name, const SandboxLimits& limits)
    : m_context{.shared = shared, .name = name}, m_sandbox(limits, &m_context, &shared.memory) {
    m_sandbox.output = [this](std::string_view line) { print(line); };
    if (!m_sandbox.prepare(openScript, nullptr) || !m_sandbox.prepare(makeNames, &m_names)) report(m_sandbox.refusal());
}

void Script::beginFrame() {
    m_sandbox.beginFrame();
    m_printable = std::min(m_printable + kPrintPerFrame, kPrintBurst);
}

void Script::print(std::string_view line) {
    const auto& log = m_context.shared.log;
    if (!log) return;
    if (int64_t(line.size()) <= m_printable) {
        m_printable -= int64_t(line.size()) + 1;
        log(RUBBLE_LOG_INFO, m_context.name + ": " + std::string(line));
    } else if (!std::exchange(m_isPrintTold, true)) {
        log(RUBBLE_LOG_WARNING, m_context.name + ": print: expected at most " + std::to_string(kPrintPerFrame) +
                                    " bytes a frame, found more: lines are left out");
    }
}

void Script::report(const std::string& error) {
    if (error == m_error) {
        ++m_repeats;
        return;
    }
    const auto& log = m_context.shared.log;
    if (log && m_repeats && m_told[m_error.substr(0, m_error.find(": "))] < kMaxErrors)
        log(RUBBLE_LOG_ERROR, m_error + " (" + std::to_string(m_repeats) + " times more)");
    m_error = error;
    m_repeats = 0;
    const int told = ++m_told[error.substr(0, error.find(": "))];
    if (!log || told > kMaxErrors) return;
    log(RUBBLE_LOG_ERROR, error + (told == kMaxErrors ? " (what else goes wrong there is not logged)" : ""));
}

lua_State* Script::takeThread(int& reference) {
    if (!m_idle.empty()) {
        const auto [thread, kept] = m_idle.back();
        m_idle.pop_back();
        reference = kept;
        return thread;
    }
    NewThread made;
    if (isStopped()) return nullptr;
    if (!m_sandbox.prepare(makeThread, &made)) {
        m_sandbox.stopRefused(m_context.name);
        return nullptr;
    }
    reference = made.reference;
    return made.thread;
}

RunResult Script::run(Callback callback, lua_State* thread, int arguments) {
    CallbackProfile& profile = m_profile[size_t(callback)];
    const double startedAt = seconds();
    const uint64_t allocations = m_sandbox.allocations();
    m_context.callback = thread;
    RunResult result = m_sandbox.run(thread, arguments);
    ++m_runs;
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
        m_isReady = result.state == RunResult::Done;
    }
    if (result.state != RunResult::Waits && m_evaluated.erase(thread) && result.state == RunResult::Done)
        keepAnswer(thread, result.results);
    if (result.state == RunResult::Waits) {
        double until = 0.0;
        isWait(thread, result.results, until);
        lua_pop(thread, result.results);
        m_waiting.push_back({thread, reference, until});
    } else if (lua_status(thread) == LUA_OK && m_idle.size() < kMaxIdle) {
        lua_settop(thread, 0);
        m_idle.emplace_back(thread, reference);
    } else {
        dropThread(thread, reference);
    }
}

void Script::dropThread(lua_State* thread, int reference) {
    m_sandbox.unprotectThread(thread);
    luaL_unref(m_sandbox.state(), LUA_REGISTRYINDEX, reference);
}

void Script::keepAnswer(lua_State* thread, int results) {
    Answer given{thread, results, m_answer};
    if (!m_sandbox.prepare(writeAnswer, &given)) report(isStopped() ? m_sandbox.stopReason() : m_sandbox.refusal());
    ++m_runs;  // of __tostring
}

bool Script::load(const std::string& text, bool isAgain) {
    std::string answer;
    m_text = text;
    m_isAgain = isAgain;
    const bool isGood = evaluate(text, answer);
    m_evaluated.clear();
    if (!m_waiting.empty()) {
        m_textThread = m_waiting.back().thread;
        return true;
    }
    m_isReady = isGood;
    return isGood;
}

bool Script::evaluate(const std::string& text, std::string& answer) {
    int reference = 0;
    beginFrame();
    m_told.clear();
    lua_State* thread = takeThread(reference);
    Chunk chunk{thread, text, m_context.name};
    if (!thread || !m_sandbox.prepare(compile, &chunk)) {
        report(isStopped() ? m_sandbox.stopReason() : m_sandbox.refusal());
        if (thread) m_idle.emplace_back(thread, reference);
        return false;
    }
    m_evaluated.insert(thread);
    const RunResult result = run(Callback::Text, thread, 0);
    settle(thread, reference, result);
    answer = takeAnswer();
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

/// Pushes what has the name of a callback onto the thread of the names; returns its type. Takes no memory.
int Script::pushCallback(Callback callback) {
    lua_pushvalue(m_names, int(callback) + 2);
    return lua_rawget(m_names, 1);
}

void Script::lookFor(Callback callback) {
    Known& known = m_known[size_t(callback)];
    known.runs = m_runs;
    known.isThere = false;
    if (!m_names || m_textThread || isStopped() || size_t(callback) >= kFunctions) return;
    const int type = pushCallback(callback);
    lua_pop(m_names, 1);
    known.isThere = type == LUA_TFUNCTION;
    if (known.isThere || type == LUA_TNIL || std::exchange(known.isTold, true) || !m_context.shared.log) return;
    m_context.shared.log(RUBBLE_LOG_WARNING, m_context.name + ": " + nameOf(callback) +
                                                 ": expected a function, which is called, found a " +
                                                 lua_typename(m_names, type));
}

lua_State* Script::begin(Callback callback, int& reference) {
    if (!has(callback) || isStopped()) return nullptr;
    lua_State* thread = takeThread(reference);
    if (!thread) {
        report(m_sandbox.stopReason());
        return nullptr;
    }
    pushCallback(callback);
    lua_xmove(m_names, thread, 1);
    return thread;
}

void Script::startAll() {
    std::vector<int> started;
    started.swap(m_context.started);
    for (const int list : started) {
        int reference = 0;
        if (isStopped()) return;
        lua_State* thread = takeThread(reference);
        if (!thread) return report(m_sandbox.stopReason());
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
