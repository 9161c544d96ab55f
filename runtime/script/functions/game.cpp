// What belongs to the game: players, input, sound, tools. A host that has it gives functions of its own in place of
// these, which let a script of another game run without.
#include "runtime/script/functions/ui.h"
#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {
namespace {

/// Tells once in a script that a function has no effect.
void tell(lua_State* L) {
    ScriptContext& context = ScriptContext::of(L);
    const std::string name = runningFunction(L).name();
    if (context.warned.size() < 1000 && context.warned.insert(name).second && context.shared.log)
        context.shared.log(RUBBLE_LOG_INFO, placeOf(L) + ": " + name + ": this game has none, so it has no effect");
}

int giveNothing(lua_State* L) {
    tell(L);
    return 0;
}

int giveFalse(lua_State* L) {
    tell(L);
    lua_pushboolean(L, false);
    return 1;
}

int giveZero(lua_State* L) {
    tell(L);
    lua_pushinteger(L, 0);
    return 1;
}

int giveOne(lua_State* L) {
    tell(L);
    lua_pushnumber(L, 1.0);
    return 1;
}

int giveNoVector(lua_State* L) {
    tell(L);
    pushVector(L, Vector{}.data());
    return 1;
}

int giveCamera(lua_State* L) {
    pushPlacement(L, cameraOf(L));
    return 1;
}

int givePlace(lua_State* L) {
    pushVector(L, cameraOf(L).position.data());
    return 1;
}

constexpr ScriptFunction kFunctions[] = {
    {"GetPlayerTransform() -> transform", "The camera of the last frame.", giveCamera},
    {"GetPlayerCameraTransform() -> transform", "The camera of the last frame.", giveCamera},
    {"GetPlayerPos() -> v", "The place of the camera of the last frame.", givePlace},
    {"SetPlayerTransform(transform)", "No effect.", giveNothing},
    {"GetPlayerVelocity() -> v", "(0, 0, 0).", giveNoVector},
    {"SetPlayerVelocity(velocity)", "No effect.", giveNothing},
    {"GetPlayerHealth() -> number", "1.", giveOne},
    {"SetPlayerHealth(health)", "No effect.", giveNothing},
    {"GetPlayerVehicle() -> handle", "0.", giveZero},
    {"GetPlayerGrabBody() -> handle", "0.", giveZero},
    {"GetPlayerPickBody() -> handle", "0.", giveZero},
    {"GetPlayerInteractBody() -> handle", "0.", giveZero},
    {"GetPlayerInteractShape() -> handle", "0.", giveZero},
    {"FindVehicle(tag, global) -> handle", "0.", giveZero},
    {"DriveVehicle(vehicle, drive, steering, handbrake)", "No effect.", giveNothing},
    {"InputPressed(input) -> boolean", "false.", giveFalse},
    {"InputDown(input) -> boolean", "false.", giveFalse},
    {"InputReleased(input) -> boolean", "false.", giveFalse},
    {"InputValue(input) -> number", "0.", giveZero},
    {"RegisterTool(id, name, file, group)", "No effect.", giveNothing},
    {"SetToolTransform(transform, sway)", "No effect.", giveNothing},
    {"GetToolBody() -> handle", "0.", giveZero},
    {"LoadSound(path, distance) -> handle", "0.", giveZero},
    {"PlaySound(sound, pos, volume)", "No effect.", giveNothing},
    {"LoadLoop(path, distance) -> handle", "0.", giveZero},
    {"PlayLoop(loop, pos, volume)", "No effect.", giveNothing},
    {"PlayMusic(path)", "No effect.", giveNothing},
    {"StopMusic()", "No effect.", giveNothing},
    {"UiMakeInteractive()", "No effect.", giveNothing},
    {"UiSound(path, volume)", "No effect.", giveNothing},
    {"ShakeCamera(amount)", "No effect.", giveNothing},
};

}  // namespace

std::span<const ScriptFunction> gameFunctions() {
    return kFunctions;
}

}  // namespace rubble::script
