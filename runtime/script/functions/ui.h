#pragma once
#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/ui_state.h"

namespace rubble::script {

/// What the running script has set for drawing.
UiState& uiOf(lua_State* L);
/// Adds a line of the world for this frame; beyond 10,000 of them none.
void addWorldLine(lua_State* L, const WorldLine& line);

}  // namespace rubble::script
