#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <lua.hpp>
#include <string>
#include <string_view>
#include <unordered_set>

#include "runtime/script/sandbox/block_cache.h"

namespace rubble::script {

/// What a script may use up. The first four are counted, so that a script ends at the same place on every machine.
struct SandboxLimits {
    size_t memory = 16 << 20;             ///< bytes of all that it holds
    size_t longestString = 256 << 10;     ///< bytes: what a single instruction on strings can cost
    int64_t work = 2'000'000;             ///< of one call into it; a unit is about one instruction of Lua, some 10 ns
    int64_t workPerFrame = 4'000'000;     ///< of all calls from one beginFrame() to the next; at least `work`
    double processorSeconds = 0.25;       ///< of one call: a net for what its work does not show; of a frame four times
    uint64_t seed = 0x9e3779b97f4a7c15u;  ///< of math.random
};

/// What several sandboxes hold together.
struct SharedMemory {
    static constexpr size_t kScripts = 16;  ///< they may hold as much as so many of them may

    size_t used = 0;        ///< bytes
    uint64_t refusals = 0;  ///< how often a script wanted more than they may hold together
    BlockCache blocks;      ///< that wait to be used again: in all as many bytes as one cache may keep
};

/// What a call into a script came to.
struct RunResult {
    enum State { Done, Waits, Failed } state = Done;
    int results = 0;         ///< on the stack of the thread, where it is done or waits
    std::string error = {};  ///< where it failed: script, line, what was expected, what was found
};

/// A state of Lua that cannot do harm: it reads and writes nothing outside of itself, and every call into it ends
/// within its limits. What makes that true:
///
///  - A count hook charges instructions. Functions of C that work for long charge what they do (charge()), and
///    allocations charge their bytes.
///  - A script over its limits is stopped for good: pcall, coroutines and `__close` pass the stop on, because all of
///    them look at isStopped().
///  - Nothing runs where hooks do not: no finalisers, own patterns, own sort.
///  - No file, process, bytecode or address of memory is in reach, and nothing depends on the time: `pairs` has a fixed
///    order, `math.random` a seed.
///
/// One thread at a time uses a sandbox.
class Sandbox {
public:
    static constexpr int64_t kErrorWork = 2000;  ///< of an error that is caught

    /// Makes a state with the safe libraries. `owner` is what owner() gives to functions of C.
    /// shared: what it holds counts there too, and is bounded there; it outlives the sandbox.
    explicit Sandbox(const SandboxLimits& limits, void* owner = nullptr, SharedMemory* shared = nullptr);
    ~Sandbox();
    Sandbox(const Sandbox&) = delete;
    Sandbox& operator=(const Sandbox&) = delete;

    /// The main thread of the state. Only functions that cannot fail may be called on it outside of run().
    lua_State* state() const { return m_state; }
    /// The sandbox of any thread of its state.
    static Sandbox& of(lua_State* L) { return **static_cast<Sandbox**>(lua_getextraspace(L)); }
    /// What the constructor was given.
    void* owner() const { return m_owner; }
    /// The limits.
    const SandboxLimits& limits() const { return m_limits; }

    /// From here on all calls together have the work of a frame. Garbage is collected if the memory did not suffice in
    /// the one before.
    void beginFrame();
    /// Starts or goes on with a coroutine, as lua_resume() does, under new limits of work and time: for a start the
    /// function and its arguments lie on its stack. A thread that has failed is ready for another start.
    RunResult run(lua_State* thread, int arguments);
    /// Runs a function of C in protected mode, for those that prepare a state; false: it has failed, refusal() says
    /// why.
    bool prepare(lua_CFunction function, void* argument);

    /// Collects garbage where the memory may not suffice for a long text: Lua does it before it gives up an object, but
    /// not for what a text is put together in. For functions that make texts, at their begin.
    void makeRoom(lua_State* L);
    /// Counts work of a function of C, before it is done. Stops the script if that is more than it has left.
    void charge(lua_State* L, int64_t work) {
        if (work > m_workLeft) stopForWork(L);
        m_workLeft -= work;
    }
    /// Stops the script if it has less than that left: before work that is charged in parts and done whole or not at
    /// all.
    void require(lua_State* L, int64_t work) {
        if (work > m_workLeft) stopForWork(L);
    }
    /// Stops the script for good. `reason` follows "the script": "wanted more than ...".
    [[noreturn]] void stop(lua_State* L, const std::string& reason);
    /// The same outside of run(), where prepare() has failed for what the script cannot go on without. `place`: of it.
    void stopRefused(const std::string& place) { m_stopReason = place + ": " + m_refusal + " and was stopped"; }
    /// Whether it was stopped. A function of C that has caught an error passes it on then by raiseStop().
    bool isStopped() const { return !m_stopReason.empty(); }
    /// Passes a stop on.
    [[noreturn]] static void raiseStop(lua_State* L);
    /// Why it was stopped, with the place; "" if it was not.
    const std::string& stopReason() const { return m_stopReason; }
    /// Gives a thread the hook that counts; every thread has it before it runs.
    void watch(lua_State* thread) const;
    /// Keeps a thread from coroutine.resume and coroutine.close, as one that the host runs, until it is done with it.
    void protectThread(const lua_State* thread) { m_protected.insert(thread); }
    /// Ends that.
    void unprotectThread(const lua_State* thread) { m_protected.erase(thread); }
    /// Whether it is kept from them.
    bool isProtected(const lua_State* thread) const { return m_protected.contains(thread); }
    /// Why memory was refused, or prepare() failed, last.
    const std::string& refusal() const { return m_refusal; }

    /// While one lives the host itself puts values into the state, outside of run(): memory is not refused.
    class HostAccess {
    public:
        /// Begins it.
        explicit HostAccess(Sandbox& box) : m_box(box) { m_box.m_isHost = true; }
        ~HostAccess() { m_box.m_isHost = false; }
        HostAccess(const HostAccess&) = delete;
        HostAccess& operator=(const HostAccess&) = delete;

    private:
        Sandbox& m_box;
    };

    /// What the present or last call has used of its work.
    int64_t workUsed() const { return m_callWork - m_workLeft; }
    /// Bytes that it holds now.
    size_t memoryUsed() const { return m_memory; }
    /// The most that it has held.
    size_t peakMemory() const { return m_peak; }
    /// How often it has asked for memory.
    uint64_t allocations() const { return m_allocations; }

    /// Where print() and its like go; nothing is printed without it.
    std::function<void(std::string_view)> output;

private:
    static constexpr int kInterval = 100;  ///< instructions from one count to the next

    static void* allocate(void* sandbox, void* block, size_t oldSize, size_t size);
    static void onCount(lua_State* L, lua_Debug*);
    [[noreturn]] void stopForWork(lua_State* L);
    void collect(lua_State* L);
    bool mayGrow(size_t kind, size_t size, size_t growth);
    void beginCall(int64_t work);
    double lateSeconds() const;
    bool isLate();
    void watchTime(lua_State* L);
    std::string timeLimit() const;
    std::string errorOf(lua_State* thread, int status);

    SandboxLimits m_limits;
    void* m_owner;
    SharedMemory m_own;  ///< of a script that shares none
    SharedMemory& m_shared;
    int64_t m_callWork, m_workLeft;  ///< of the present call: all, and what is left
    int64_t m_frameWork;             ///< what is left of it for calls to come
    double m_frameSeconds = 0.0;     ///< processor time of slow calls of the frame
    size_t m_memory = 0, m_peak = 0;
    bool m_isHost = false;
    bool m_isFull = false;          ///< it wanted more memory than it may have
    uint64_t m_sharedRefusals = 0;  ///< those of all scripts when it last collected its garbage
    int m_framesToCollect = 0;      ///< until beginFrame() may collect garbage again
    size_t m_collected = 0;         ///< bytes that were left when its garbage was last collected for lack of memory
    size_t m_reserve = 0;           ///< bytes above the limit, with which an error is told
    uint64_t m_allocations = 0;
    double m_startedAt = -1.0;  ///< processor time when the present call was first slow; negative: it never was
    int64_t m_lastLookAt = 0;   ///< nanoseconds of the steady clock
    std::string m_stopReason, m_refusal;
    std::unordered_set<const lua_State*> m_protected;
    lua_State* m_state = nullptr;
};

/// "SCRIPT:LINE" of the innermost function of Lua that runs, or "" if none does.
std::string placeOf(lua_State* L);

}  // namespace rubble::script
