#pragma once
#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/ui_state.h"

namespace rubble::script {

/// What the running script has set for drawing.
UiState& uiOf(lua_State* L);

}  // namespace rubble::script
