#include "runtime/script/functions/vocabulary.h"

#include <chrono>
#include <functional>
#include <optional>

namespace rubble::script {
namespace {

constexpr int64_t kCallWork = 20;
const char kWait = 0;  ///< its address marks a wait

/// Adds what happens while it lives to what a function has cost.
class CostMeter {
public:
    CostMeter(const Sandbox& box, FunctionCost& cost)
        : m_box(box), m_cost(cost), m_start(std::chrono::steady_clock::now()), m_allocations(box.allocations()) {}
    ~CostMeter() {
        m_cost.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
        m_cost.allocations += m_box.allocations() - m_allocations;
    }
    CostMeter(const CostMeter&) = delete;
    CostMeter& operator=(const CostMeter&) = delete;

private:
    const Sandbox& m_box;
    FunctionCost& m_cost;
    std::chrono::steady_clock::time_point m_start;
    uint64_t m_allocations;
};

bool isOfHost(const ScriptWorld& shared, const ScriptFunction& function) {
    const std::less_equal<const ScriptFunction*> isNotAfter;
    const std::span<const ScriptFunction> functions = shared.hostFunctions;
    return !functions.empty() && isNotAfter(functions.data(), &function) && isNotAfter(&function, &functions.back());
}

/// Calls the function of a row. Upvalues: the row, its number in the vocabulary, or -1.
int callFunction(lua_State* L) {
    Sandbox& box = Sandbox::of(L);
    box.charge(L, kCallWork);
    const lua_Integer index = lua_tointeger(L, lua_upvalueindex(2));
    const ScriptFunction& function = runningFunction(L);
    if (function.stepWork) chargeStep(L, function.stepWork);
    if (index < 0) return function.function(L);
    ScriptContext& context = *static_cast<ScriptContext*>(box.owner());
    ++context.calls[size_t(index)];
    // In destroy() after a load: what the host's functions work on belongs to the world that came.
    if (!context.shared.world && isOfHost(context.shared, function)) return 0;
    std::optional<CostMeter> meter;
    if (!context.costs.empty()) meter.emplace(box, context.costs[size_t(index)]);
    CallObserver* const observer = context.shared.observer;
    if (!observer) return function.function(L);
    observer->begin(L, function);
    return endCall(L, function.function(L));
}

int yieldUntil(lua_State* L, double until, lua_KContext context, lua_KFunction continuation) {
    if (ScriptContext::of(L).callback != L)
        return luaL_error(L, "%s: expected a callback or what start() has begun, found a coroutine of the script",
                          runningFunction(L).name().c_str());
    if (!lua_isyieldable(L))
        return luaL_error(L,
                          "%s: expected a callback that can wait, found one inside of a call of table.sort, require "
                          "or another function that calls back",
                          runningFunction(L).name().c_str());
    if (CallObserver* const observer = ScriptContext::of(L).shared.observer) observer->wait(L, runningFunction(L));
    lua_pushlightuserdata(L, const_cast<char*>(&kWait));
    lua_pushnumber(L, until);
    return lua_yieldk(L, 2, context, continuation);
}

int nothing(lua_State* L, int, lua_KContext) {
    return endCall(L, 0);
}

}  // namespace

const std::vector<Subject>& vocabulary() {
    static const std::vector<Subject> subjects = {
        {"vectors", "Vectors", vectorFunctions()},
        {"rotations", "Rotations", rotationFunctions()},
        {"transforms", "Transforms", transformFunctions()},
        {"break", "Breaking, fire and paint", breakFunctions()},
        {"find", "Finding things, tags and handles", findFunctions()},
        {"bodies", "Bodies", bodyFunctions()},
        {"constraints", "Holding bodies for a step", constrainFunctions()},
        {"shapes", "Shapes", shapeFunctions()},
        {"shape-edits", "Making and changing shapes", shapeEditFunctions()},
        {"lights", "Lights", lightFunctions()},
        {"joints", "Joints and ropes", jointFunctions()},
        {"queries", "Queries", queryFunctions()},
        {"particles", "Particles", particleFunctions()},
        {"world", "World, time and waiting", worldFunctions()},
        {"ui", "Drawing: places, colours, letters", uiStateFunctions()},
        {"ui-items", "Drawing: texts, shapes, images, lines", uiDrawFunctions()},
        {"files", "Files and saved tables", fileFunctions()},
        {"registry", "Registry and parameters", registryFunctions()},
        {"game", "What belongs to the game", gameFunctions()},
    };
    return subjects;
}

void pushFunction(lua_State* L, const ScriptFunction& function, lua_Integer index) {
    lua_pushlightuserdata(L, const_cast<ScriptFunction*>(&function));
    lua_pushinteger(L, index);
    lua_pushcclosure(L, callFunction, 2);
}

void openVocabulary(lua_State* L) {
    lua_Integer index = 0;
    const auto open = [&](std::span<const ScriptFunction> functions) {
        for (const ScriptFunction& function : functions) {
            pushFunction(L, function, index++);
            lua_setglobal(L, function.name().c_str());
        }
    };
    for (const Subject& subject : vocabulary()) open(subject.functions);
    open(ScriptContext::of(L).shared.hostFunctions);
    ScriptContext::of(L).calls.assign(size_t(index), 0);
    openVectorOperators(L);
    openRotationOperators(L);
    openTransformOperators(L);
}

void openOperators(lua_State* L, ValueKind kind, std::span<const ScriptFunction> operators) {
    pushMetatable(L, kind);
    for (const ScriptFunction& function : operators) {
        pushFunction(L, function, -1);
        lua_setfield(L, -2, function.name().c_str());
    }
    lua_pop(L, 1);
}

int waitForStep(lua_State* L, lua_KContext context, lua_KFunction continuation) {
    return yieldUntil(L, -1.0, context, continuation);
}

int waitUntil(lua_State* L, double time) {
    if (!ScriptContext::of(L).shared.hasTime)
        return luaL_error(L, "%s: expected a world in which time passes, found one that stands still: play first",
                          runningFunction(L).name().c_str());
    return yieldUntil(L, time, 0, nothing);
}

bool isWait(lua_State* L, int results, double& until) {
    if (results != 2 || lua_touserdata(L, -2) != &kWait) return false;
    until = lua_tonumber(L, -1);
    return true;
}

}  // namespace rubble::script
