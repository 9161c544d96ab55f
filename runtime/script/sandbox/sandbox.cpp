#include "runtime/script/sandbox/sandbox.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <new>
#include <utility>

#include "runtime/script/sandbox/libraries.h"

namespace rubble::script {
namespace {

constexpr int64_t kAllocationWork = 16;  ///< of one, besides its bytes
constexpr int kFramesToCollect = 30;     ///< between two collections of garbage for lack of memory
constexpr size_t kReserve = 64 << 10;
constexpr size_t kLargeBlock = 4 << 10;      ///< bytes: allocations that look at the time
constexpr size_t kStringHeader = 25;         ///< what Lua adds to the bytes of a string
constexpr size_t kLargestStack = 400 << 10;  ///< bytes: a single call by way of `__call` may take its square
constexpr double kSlowCallsPerFrame = 4.0;
constexpr int64_t kSlowInterval = 2'000'000;  ///< ns for kInterval instructions, beyond which each is watched

/// Before each block of Lua: how many were made before it.
struct alignas(std::max_align_t) Header {
    uint64_t number;
};

double processorSeconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

int64_t steadyNanoseconds() {
    return std::chrono::steady_clock::now().time_since_epoch().count();
}

/// Whether a new block without a kind may be the stack of a thread: Lua doubles it, but for 5 spare slots. Those of
/// tables are powers of two, or three times that.
bool isStack(size_t size) {
    return !std::has_single_bit(size) && !(size % 3 == 0 && std::has_single_bit(size / 3));
}

int openAll(lua_State* L) {
    openLibraries(L);
    return 0;
}

/// Whether a message has ":LINE:" in it, as those that Lua gives a place have.
bool namesPlace(std::string_view message) {
    for (size_t at = message.find(':'); at != message.npos; at = message.find(':', at + 1)) {
        const size_t end = message.find_first_not_of("0123456789", at + 1);
        if (end != message.npos && end > at + 1 && message[end] == ':') return true;
    }
    return false;
}

/// The text of an error value, which may be anything.
int textOf(lua_State* L) {
    pushText(L, 1);
    return 1;
}

}  // namespace

uint64_t creationOf(const void* block) {
    return (static_cast<const Header*>(block) - 1)->number;
}

std::string placeOf(lua_State* L) {
    lua_Debug frame;
    for (int level = 0; lua_getstack(L, level, &frame); ++level) {
        lua_getinfo(L, "Sl", &frame);
        if (frame.currentline > 0) return std::string(frame.short_src) + ":" + std::to_string(frame.currentline);
    }
    return "";
}

Sandbox::Sandbox(const SandboxLimits& limits, void* owner, SharedMemory* shared)
    : m_limits(limits),
      m_owner(owner),
      m_shared(shared ? *shared : m_own),
      m_callWork(limits.work),
      m_workLeft(limits.work) {
    m_sharedRefusals = m_shared.refusals;
    beginFrame();
    m_state = lua_newstate(allocate, this);
    if (!m_state) throw std::bad_alloc();
    *static_cast<Sandbox**>(lua_getextraspace(m_state)) = this;
    if (!prepare(openAll, nullptr)) {
        lua_close(m_state);
        throw std::bad_alloc();
    }
}

Sandbox::~Sandbox() {
    lua_close(m_state);
}

void* Sandbox::allocate(void* sandbox, void* block, size_t oldSize, size_t size) {
    Sandbox& box = *static_cast<Sandbox*>(sandbox);
    const size_t held = block ? oldSize : 0;
    Header* const header = block ? static_cast<Header*>(block) - 1 : nullptr;
    if (size == 0) {
        if (header) box.m_shared.blocks.give(header, oldSize + sizeof(Header));
        box.m_memory -= held;
        box.m_shared.used -= held;
        return nullptr;
    }
    if (size > held) {
        const size_t kind = block ? LUA_NUMTYPES : oldSize;  // so Lua tells what it allocates
        if (!box.mayGrow(kind, size, size - held)) return nullptr;
        box.m_workLeft -= kAllocationWork + int64_t(size >> 5);
        ++box.m_allocations;
    }
    void* const found = header ? box.m_shared.blocks.resize(header, oldSize + sizeof(Header), size + sizeof(Header))
                               : box.m_shared.blocks.take(size + sizeof(Header));
    if (!found && size > held) return nullptr;
    auto* const moved = found ? static_cast<Header*>(found) : header;  // Lua relies on it that a block can shrink
    if (!header) moved->number = box.m_allocations;
    box.m_memory += size - held;
    box.m_shared.used += size - held;
    box.m_peak = std::max(box.m_peak, box.m_memory);
    return moved + 1;
}

bool Sandbox::mayGrow(size_t kind, size_t size, size_t growth) {
    if (m_isHost) return true;
    const auto bytes = [](size_t count) { return std::to_string(count) + " bytes"; };
    if (kind == LUA_TSTRING && size > m_limits.longestString + kStringHeader)
        m_refusal = "a string of " + bytes(size - kStringHeader) + ", of at most " + bytes(m_limits.longestString);
    else if (kind == LUA_TNIL && size > kLargestStack && isStack(size))
        m_refusal = "a stack of more than " + bytes(kLargestStack) + " for calls inside of calls";
    else if (size >= kLargeBlock && isLate())
        m_refusal = timeLimit();
    else if (m_memory + growth > m_limits.memory + m_reserve)
        m_isFull = true, m_refusal = "more than its " + bytes(m_limits.memory) + " of memory";
    else if (m_state && m_shared.used + growth > SharedMemory::kScripts * m_limits.memory + m_reserve)
        ++m_shared.refusals, m_refusal = "more than the " + bytes(SharedMemory::kScripts * m_limits.memory) +
                                         " of memory of all scripts";
    else
        return true;
    m_refusal = "the script wanted " + m_refusal;
    m_workLeft -= int64_t(m_memory >> 5);  // Lua collects all garbage before it gives up
    return false;
}

void Sandbox::makeRoom(lua_State* L) {
    const size_t wanted = m_memory + 2 * m_limits.longestString;
    if (wanted <= m_limits.memory || m_memory <= m_collected + m_limits.longestString) return;
    charge(L, int64_t(m_memory >> 7));
    collect(L);
}

void Sandbox::collect(lua_State* L) {
    lua_gc(L, LUA_GCCOLLECT);
    m_collected = m_memory;
}

void Sandbox::watch(lua_State* thread) const {
    lua_sethook(thread, onCount, LUA_MASKCOUNT, isStopped() ? 1 : kInterval);
}

void Sandbox::onCount(lua_State* L, lua_Debug*) {
    Sandbox& box = of(L);
    if (box.isStopped()) {
        box.watch(L);
        raiseStop(L);
    }
    box.charge(L, lua_gethookcount(L));
    box.watchTime(L);
}

/// Asking for the processor time is a system call, so that a call's begins with its first slow look.
bool Sandbox::isLate() {
    if (steadyNanoseconds() - m_lastLookAt <= kSlowInterval) return false;
    if (m_startedAt < 0.0) m_startedAt = processorSeconds();
    const double late = lateSeconds();
    return late > m_limits.processorSeconds || m_frameSeconds + late > kSlowCallsPerFrame * m_limits.processorSeconds;
}

/// Of the present call, since it was first slow.
double Sandbox::lateSeconds() const {
    return m_startedAt < 0.0 ? 0.0 : processorSeconds() - m_startedAt;
}

void Sandbox::watchTime(lua_State* L) {
    const int64_t now = steadyNanoseconds();
    const bool isSlow = now - m_lastLookAt > kSlowInterval;
    if (isSlow && isLate()) stop(L, "wanted " + timeLimit());
    if (isSlow) lua_sethook(L, onCount, LUA_MASKCOUNT, 1);
    m_lastLookAt = now;
}

std::string Sandbox::timeLimit() const {
    const bool isCall = lateSeconds() > m_limits.processorSeconds;
    return "more than its " + std::to_string(m_limits.processorSeconds * (isCall ? 1.0 : kSlowCallsPerFrame)) +
           " s of processor time in one " + (isCall ? "call" : "frame");
}

void Sandbox::stopForWork(lua_State* L) {
    const bool isCall = m_callWork >= m_limits.work;
    const int64_t most = isCall ? m_limits.work : std::max(m_limits.work, m_limits.workPerFrame);
    stop(L, "wanted more than its " + std::to_string(most) + " instructions in one " + (isCall ? "call" : "frame"));
}

void Sandbox::stop(lua_State* L, const std::string& reason) {
    if (!isStopped()) m_stopReason = placeOf(L) + ": the script " + reason + " and was stopped";
    watch(L);
    raiseStop(L);
}

void Sandbox::raiseStop(lua_State* L) {
    lua_pushlightuserdata(L, nullptr);  // costs no memory
    lua_error(L);
    std::abort();  // lua_error() does not return
}

void Sandbox::beginFrame() {
    if (m_framesToCollect > 0) {
        --m_framesToCollect;
    } else if (m_isFull || m_sharedRefusals != m_shared.refusals) {
        collect(m_state);
        m_isFull = false, m_sharedRefusals = m_shared.refusals, m_framesToCollect = kFramesToCollect;
    }
    m_frameWork = std::max(m_limits.work, m_limits.workPerFrame);
    m_frameSeconds = 0.0;
}

void Sandbox::beginCall(int64_t work) {
    m_callWork = m_workLeft = work;
    m_startedAt = -1.0;
    m_lastLookAt = steadyNanoseconds();
}

bool Sandbox::prepare(lua_CFunction function, void* argument) {
    beginCall(m_limits.work);
    lua_pushcfunction(m_state, function);
    lua_pushlightuserdata(m_state, argument);
    const int status = lua_pcall(m_state, 1, 0, 0);
    if (status != LUA_OK) m_refusal = errorOf(m_state, status);
    lua_settop(m_state, 0);
    return status == LUA_OK;
}

RunResult Sandbox::run(lua_State* thread, int arguments) {
    if (isStopped()) return {RunResult::Failed, 0, m_stopReason};
    beginCall(std::min(m_limits.work, m_frameWork));
    watch(thread);
    RunResult result;
    const int status = lua_resume(thread, nullptr, arguments, &result.results);
    m_frameWork = std::max<int64_t>(0, m_frameWork - workUsed());
    m_frameSeconds += lateSeconds();
    if (status == LUA_OK || status == LUA_YIELD) {
        result.state = status == LUA_OK ? RunResult::Done : RunResult::Waits;
        return result;
    }
    result = {RunResult::Failed};
    if (status == LUA_ERRMEM && !isStopped()) stopRefused(placeOf(thread));
    result.error = isStopped() ? m_stopReason : errorOf(thread, status);
    if (isStopped()) return result;  // hooks are off in a thread whose hook has failed: nothing may run in it
    lua_resetthread(thread);         // closes what waits for it
    lua_settop(thread, 0);
    if (isStopped()) result.error = m_stopReason;
    return result;
}

std::string Sandbox::errorOf(lua_State* thread, int status) {
    if (status == LUA_ERRMEM) return m_refusal;
    if (isStopped()) return m_stopReason;
    const bool hasText = lua_type(thread, -1) == LUA_TSTRING;
    const bool hasPlace = hasText && namesPlace(lua_tostring(thread, -1));
    const std::string place = hasPlace || thread == m_state ? "" : placeOf(thread);
    if (thread != m_state) lua_xmove(thread, m_state, 1);  // a failed thread runs nothing
    m_reserve = kReserve;
    if (!hasText) {
        lua_pushcfunction(m_state, textOf);
        lua_insert(m_state, -2);
        watch(m_state);
        lua_pcall(m_state, 1, 1, 0);
    }
    m_reserve = 0;
    if (isStopped()) return m_stopReason;
    size_t length = 0;
    const char* text = lua_type(m_state, -1) == LUA_TSTRING ? lua_tolstring(m_state, -1, &length) : nullptr;
    const std::string error =
        (place.empty() ? "" : place + ": ") + (text ? std::string(text, length) : "an error whose value has no text");
    lua_settop(m_state, 0);
    return error;
}

}  // namespace rubble::script
