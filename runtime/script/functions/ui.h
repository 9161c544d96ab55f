#pragma once
#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/ui_state.h"

namespace rubble::script {

/// Units of the canvas: nothing is drawn farther off, and nothing is larger.
inline constexpr double kUiReach = 1e5;

/// What the running script has set for drawing.
UiState& uiOf(lua_State* L);
/// The camera of the last frame.
inline Placement cameraOf(lua_State* L) {
    const rubble_view& view = ScriptContext::of(L).shared.ui.view;
    return view.struct_size ? placementOf(view.position, view.rotation) : Placement{};
}

}  // namespace rubble::script
