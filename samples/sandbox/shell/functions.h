#pragma once
#include <span>

#include "runtime/script/binding/script_context.h"

namespace sandbox {

class Game;

/// What each of them may use up.
rubble::script::SandboxLimits scriptLimits();

/// What scripts of the game have beside the functions of all scripts: input, player, camera, saves, models.
std::span<const rubble::script::ScriptFunction> gameFunctions();

// Their rows, by subject: one file each.
/// Input and player.
std::span<const rubble::script::ScriptFunction> playerFunctions();
/// Camera, menus, saves, undo.
std::span<const rubble::script::ScriptFunction> sessionFunctions();
/// Bodies of boxes, ropes, nails.
std::span<const rubble::script::ScriptFunction> makeFunctions();
/// Joints, wheels, lights, water.
std::span<const rubble::script::ScriptFunction> vehicleFunctions();

/// Shots, sky and rules, for films.
std::span<const rubble::script::ScriptFunction> filmFunctions();

/// Files that were dropped on the window.
std::span<const rubble::script::ScriptFunction> dropFunctions();

/// Sounds.
std::span<const rubble::script::ScriptFunction> soundFunctions();

/// The game whose script runs.
Game& gameOf(lua_State* L);

}  // namespace sandbox
