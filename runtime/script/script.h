#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/script/binding/script_context.h"
#include "runtime/script/sandbox/sandbox.h"

namespace rubble::script {

/// What scripts are called for. A script without such a function costs nothing for it.
enum class Callback : uint8_t {
    Init,       ///< init(), once
    Tick,       ///< tick(dt), each frame
    Update,     ///< update(dt), each step, before it
    Destroy,    ///< destroy(), at the end
    Split,      ///< onSplit(shape, pieces)
    Break,      ///< onBreak(shape, voxels, entry)
    BodyBreak,  ///< onBodyBreak(body), when it loses voxels for the first time
    Contact,    ///< onContact(bodyA, bodyB, pos, normal, impulse)
    LightOut,   ///< onLightOut(group)
    Fire,       ///< onFire(shape, pos, lit)
    Joint,      ///< onJoint(joint, what, from, to); "voxel gone", "overloaded", "removed", "cut", "moved" or "loose"
    Trigger,    ///< onTrigger(trigger, body, entered)
    Draw,       ///< draw(dt), each frame, after tick()
    Load,       ///< onLoad(), in place of init() after a load and a reload
    Text,       ///< no function: the text of the script
    Resume,     ///< no function: what goes on after wait(), and what start() began
};
inline constexpr size_t kCallbacks = size_t(Callback::Resume) + 1;
/// The name of the function, or of what is none in brackets.
const char* nameOf(Callback callback);

/// A script as a level names it: its path, and its parameters, "name=value", a line each.
using LevelScriptName = std::pair<std::string, std::string>;

/// What calls into a script have cost.
struct CallbackProfile {
    uint64_t calls = 0;
    double seconds = 0.0;
    uint64_t allocations = 0;
    int64_t work = 0;  ///< units of SandboxLimits::work
};

/// One script of a world: a state of Lua of its own, which nothing of other scripts is in reach of.
class Script {
public:
    /// `name` stands before the line in messages.
    Script(ScriptWorld& shared, const std::string& name, const SandboxLimits& limits);

    /// Compiles and runs the text of a script, which defines its callbacks; false: it has failed, error() says why.
    /// isAgain: it has run before, in this world or in the one of a save. The text may wait, and has no callbacks until
    /// it is done.
    bool load(const std::string& text, bool isAgain);
    /// Whether the text has come to its end and nobody was told of it yet.
    bool takeReadiness() { return std::exchange(m_isReady, false); }
    /// What is called first: init(), or onLoad() of one that has run before.
    Callback first() { return m_isAgain && has(Callback::Load) ? Callback::Load : Callback::Init; }
    /// Compiles a text and runs it as a callback would run; false: it has failed. What it returns is in `answer`; of a
    /// text that waits takeAnswer() gives it.
    bool evaluate(const std::string& text, std::string& answer);
    /// What texts that have waited have returned since the last call.
    std::string takeAnswer() { return std::exchange(m_answer, {}); }

    /// Whether a text is whole: without running it.
    bool compiles(const std::string& text);
    /// Whether a text is no whole one yet, but the begin of one.
    bool isBegin(const std::string& text);
    /// What the last word of a line can become, sorted: keywords and globals, or of "a.b:c" fields of a.b, functions
    /// with their bracket. Runs nothing of the script.
    std::vector<std::string> completions(std::string_view line);

    /// Whether the script has such a function now. It is looked for again only where the script has run since: it may
    /// have defined one, or taken one away.
    bool has(Callback callback) {
        Known& known = m_known[size_t(callback)];
        if (known.runs != m_runs) lookFor(callback);
        return known.isThere;
    }
    /// From here on all calls together have the work of a frame.
    void beginFrame();
    /// Calls a callback. `push` puts its arguments onto the stack and returns how many.
    template <class Push>
    void call(Callback callback, Push&& push) {
        int reference = 0;
        if (lua_State* thread = begin(callback, reference))
            settle(thread, reference, run(callback, thread, pushTrusted(thread, push)));
    }
    /// After a step: goes on with all that waits for that, or for a time of the world that has come, and begins what
    /// start() was given.
    void resumeWaiting();
    /// Whether anything waits.
    bool isWaiting() const { return !m_waiting.empty() || !m_context.started.empty(); }
    /// Whether a text of evaluate() waits, so that its answer is to come.
    bool owesAnswer() const { return !m_evaluated.empty() && !isStopped(); }

    /// What saved() keeps: the text of each table by its name.
    std::map<std::string, std::string> savedTables();
    /// The text that load() was given.
    const std::string& text() const { return m_text; }
    /// As the level names it, so that it ends with the level; none: the level does not.
    const std::optional<LevelScriptName>& ofLevel() const { return m_ofLevel; }
    /// Says so.
    void setOfLevel(LevelScriptName name) { m_ofLevel = std::move(name); }
    /// As the constructor was given it.
    const std::string& name() const { return m_context.name; }
    /// What its functions work on: parameters, calls of each function.
    ScriptContext& context() { return m_context; }
    /// The same.
    const ScriptContext& context() const { return m_context; }
    /// Its state of Lua: what it has used.
    const Sandbox& sandbox() const { return m_sandbox; }
    /// It took more than it may and runs no more.
    bool isStopped() const { return m_sandbox.isStopped(); }
    /// What has failed last, with script and line; "" if nothing has.
    const std::string& error() const { return m_error; }
    /// What a callback has cost so far.
    const CallbackProfile& profile(Callback callback) const { return m_profile[size_t(callback)]; }

    /// Bytes that print() may write at once, and from one frame or step to the next.
    static constexpr int64_t kPrintBurst = 1 << 20, kPrintPerFrame = 16 << 10;

private:
    /// Whether there is a callback, after how many runs that was looked for, and whether something else has its name.
    struct Known {
        uint64_t runs = 0;
        bool isThere = false, isTold = false;
    };
    /// A coroutine that waits.
    struct Waiting {
        lua_State* thread;
        int reference;  ///< that keeps it alive
        double until;   ///< seconds of steps; negative: the next step
    };

    template <class Push>
    int pushTrusted(lua_State* thread, Push&& push) {
        const Sandbox::HostAccess access(m_sandbox);
        return push(thread);
    }
    void lookFor(Callback callback);
    int pushCallback(Callback callback);
    lua_State* takeThread(int& reference);
    void dropThread(lua_State* thread, int reference);
    void keepAnswer(lua_State* thread, int results);
    lua_State* begin(Callback callback, int& reference);
    RunResult run(Callback callback, lua_State* thread, int arguments);
    void settle(lua_State* thread, int reference, const RunResult& result);
    void startAll();
    void report(const std::string& error);
    void print(std::string_view line);

    ScriptContext m_context;
    Sandbox m_sandbox;
    lua_State* m_names = nullptr;  ///< a thread with the globals and the names of all callbacks on its stack
    Known m_known[kCallbacks];
    uint64_t m_runs = 1;  ///< of anything in the script
    CallbackProfile m_profile[kCallbacks];
    std::vector<Waiting> m_waiting;
    std::vector<std::pair<lua_State*, int>> m_idle;  ///< threads for calls, with their references
    std::string m_text;
    lua_State* m_textThread = nullptr;  ///< that runs the text, while it waits
    std::set<lua_State*> m_evaluated;   ///< threads of texts that shall give an answer
    std::string m_answer;
    bool m_isReady = false, m_isAgain = false;
    std::optional<LevelScriptName> m_ofLevel;
    std::string m_error;
    uint64_t m_repeats = 0;             ///< of the same error
    std::map<std::string, int> m_told;  ///< how many errors of a place were logged
    int64_t m_printable = kPrintBurst;  ///< bytes that print() may write now
    bool m_isPrintTold = false;         ///< that it wanted more
};

}  // namespace rubble::script
