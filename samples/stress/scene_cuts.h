#pragma once
#include "runtime/script/binding/script_context.h"
#include "samples/stress/checks/scene_requests.h"

namespace stress {

/// What the scenario of a state of Lua has asked for.
inline SceneRequests& requestsOf(lua_State* L) {
    return *static_cast<SceneRequests*>(rubble::script::ScriptContext::of(L).shared.host);
}

/// The function ExactHole() of scenarios.
int exactHole(lua_State* L);
/// The function Cut() of scenarios.
int cut(lua_State* L);

}  // namespace stress
