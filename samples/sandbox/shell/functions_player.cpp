#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "runtime/script/binding/calls.h"
#include "samples/sandbox/shell/fields.h"
#include "samples/sandbox/shell/functions.h"
#include "samples/sandbox/shell/game.h"

namespace sandbox {
namespace {

using namespace rubble::script;

glm::dvec3 pointAt(lua_State* L, int index, const char* name) {
    const Vector v = finiteVectorAt(L, index, name);
    return {v[0], v[1], v[2]};
}

int pushPoint(lua_State* L, glm::dvec3 point) {
    const double values[] = {point.x, point.y, point.z};
    pushVector(L, values);
    return 1;
}

int pushFrame(lua_State* L, const Frame& frame) {
    const glm::dquat& turn = frame.rotation;
    pushPlacement(L, {{frame.position.x, frame.position.y, frame.position.z}, {turn.x, turn.y, turn.z, turn.w}});
    return 1;
}

int inputPressed(lua_State* L) {
    lua_pushboolean(L, gameOf(L).input().isPressed(textAt(L, 1, "input")));
    return 1;
}
int inputDown(lua_State* L) {
    lua_pushboolean(L, gameOf(L).input().isDown(textAt(L, 1, "input")));
    return 1;
}
int inputReleased(lua_State* L) {
    lua_pushboolean(L, gameOf(L).input().isReleased(textAt(L, 1, "input")));
    return 1;
}
int inputValue(lua_State* L) {
    lua_pushnumber(L, gameOf(L).input().value(textAt(L, 1, "input")));
    return 1;
}
int inputLastPressed(lua_State* L) {
    lua_pushstring(L, gameOf(L).input().lastPressed().c_str());
    return 1;
}
int bindInput(lua_State* L) {
    std::vector<std::string> keys;
    for (int i = 2; i <= lua_gettop(L); ++i) keys.push_back(textAt(L, i, "key"));
    gameOf(L).input().bind(textAt(L, 1, "action"), std::move(keys));
    return 0;
}
int setInput(lua_State* L) {
    gameOf(L).input().ask(textAt(L, 1, "input"), bool(lua_toboolean(L, 2)));
    return 0;
}
int addInput(lua_State* L) {
    gameOf(L).input().ask(textAt(L, 1, "input"), rangedAt(L, 2, "amount", -1e6, 1e6));
    return 0;
}
int setGamepad(lua_State* L) {
    static const std::vector<const char*> keys = [] {
        std::vector<const char*> all(GamepadState::kButtons.begin(), GamepadState::kButtons.end());
        all.insert(all.end(), GamepadState::kAxes.begin(), GamepadState::kAxes.end());
        return all;
    }();
    requireKeys(L, 1, "pad", keys);
    GamepadState pad;
    for (size_t i = 0; i < pad.buttons.size(); ++i, lua_pop(L, 1)) {
        lua_getfield(L, 1, GamepadState::kButtons[i]);
        pad.buttons[i] = lua_toboolean(L, -1);
    }
    for (size_t i = 0; i < pad.axes.size(); ++i, lua_pop(L, 1)) {
        lua_getfield(L, 1, GamepadState::kAxes[i]);
        if (!lua_isnil(L, -1)) pad.axes[i] = rangedAt(L, lua_gettop(L), "pad", -1.0, 1.0);
    }
    gameOf(L).hold(pad);
    return 0;
}
int setCursor(lua_State* L) {
    gameOf(L).input().place(rangedAt(L, 1, "x", -1e6, 1e6), rangedAt(L, 2, "y", -1e6, 1e6));
    return 0;
}

int getPlayerTransform(lua_State* L) {
    const Player& player = gameOf(L).player();
    return pushFrame(L, {player.feet(), glm::angleAxis(player.yaw(), glm::dvec3(0, 1, 0))});
}
int getPlayerCameraTransform(lua_State* L) {
    return pushFrame(L, gameOf(L).player().eye(1.0));
}
int setPlayerTransform(lua_State* L) {
    const Placement place = finitePlacementAt(L, 1, "transform");
    Player& player = gameOf(L).player();
    player.place({place.position[0], place.position[1], place.position[2]});
    const glm::dquat turn(place.rotation[3], place.rotation[0], place.rotation[1], place.rotation[2]);
    const glm::dvec3 ahead = turn * glm::dvec3(0, 0, -1);
    player.look(std::atan2(-ahead.x, -ahead.z), std::asin(std::clamp(ahead.y, -1.0, 1.0)));
    return 0;
}
int getPlayerVelocity(lua_State* L) {
    return pushPoint(L, gameOf(L).player().velocity());
}
int setPlayerVelocity(lua_State* L) {
    gameOf(L).player().push(pointAt(L, 1, "velocity"));
    return 0;
}
int getPlayerLook(lua_State* L) {
    lua_pushnumber(L, gameOf(L).player().yaw());
    lua_pushnumber(L, gameOf(L).player().pitch());
    return 2;
}
int setPlayerLook(lua_State* L) {
    gameOf(L).player().look(rangedAt(L, 1, "yaw", -1e6, 1e6), clampedAt(L, 2, "pitch", -1.55, 1.55));
    return 0;
}
int movePlayer(lua_State* L) {
    gameOf(L).player().move(pointAt(L, 1, "velocity"), boolOr(L, 2, false), boolOr(L, 3, false));
    return 0;
}
int setPlayerWalking(lua_State* L) {
    gameOf(L).player().walk(boolOr(L, 1, true));
    return 0;
}
int isPlayerWalking(lua_State* L) {
    lua_pushboolean(L, gameOf(L).player().walks());
    return 1;
}
int isPlayerGrounded(lua_State* L) {
    lua_pushboolean(L, gameOf(L).player().isGrounded());
    return 1;
}
int isPlayerSwimming(lua_State* L) {
    lua_pushboolean(L, gameOf(L).player().isSwimming());
    return 1;
}

constexpr ScriptFunction kFunctions[] = {
    {"InputPressed(input) -> boolean", "Whether a key, a button or an action went down in this frame.", inputPressed},
    {"InputDown(input) -> boolean", "Whether it is down.", inputDown},
    {"InputReleased(input) -> boolean", "Whether it went up in this frame.", inputReleased},
    {"InputValue(input) -> number",
     "\"mousedx\", \"mousedy\", \"mousewheel\", \"mousex\", \"mousey\"; of a gamepad \"padlx\", \"padly\", \"padrx\", "
     "\"padry\", \"padlt\", \"padrt\".",
     inputValue},
    {"InputLastPressed() -> input", "A key or button that went down in this frame, or \"\".", inputLastPressed},
    {"BindInput(action, keys...)", "What an action is bound to: keys, or two at a time, as \"ctrl+z\".", bindInput},
    {"SetInput(input, down)", "From the next frame on a key is down or up, as a bot wants it.", setInput},
    {"AddInput(input, amount)", "Moves \"mousedx\", \"mousewheel\", \"padlx\" and the like in the next frame.",
     addInput},
    {"SetGamepad(pad)",
     "From the next frame on a bot holds a gamepad: {a = true, lx = 0.5}; buttons a, b, x, y, lb, rb, back, start, ls, "
     "rs, up, right, down, left; axes -1 to 1, y downwards: lx, ly, rx, ry, and of triggers lt and rt.",
     setGamepad},
    {"SetCursor(x, y)", "Where the cursor is on the canvas.", setCursor},
    {"GetPlayerTransform() -> transform", "Where the player's feet are, and which way they point.", getPlayerTransform},
    {"GetPlayerCameraTransform() -> transform", "Where the player's eyes are after the last step.",
     getPlayerCameraTransform},
    {"SetPlayerTransform(transform)", "Puts the player elsewhere: feet, and the way he looks.", setPlayerTransform},
    {"GetPlayerVelocity() -> v", "How the player moves, in m/s.", getPlayerVelocity},
    {"SetPlayerVelocity(velocity)", "Throws the player.", setPlayerVelocity},
    {"GetPlayerLook() -> yaw, pitch", "Where the player looks, in radians to the left of -z and upwards.",
     getPlayerLook},
    {"SetPlayerLook(yaw, pitch)", "Turns the player's head.", setPlayerLook},
    {"MovePlayer(velocity, jumps, crouches)", "How the player moves until the next call, in m/s.", movePlayer},
    {"SetPlayerWalking(walks)", "Walks, or flies.", setPlayerWalking},
    {"IsPlayerWalking() -> boolean", "Whether the player walks, or flies.", isPlayerWalking},
    {"IsPlayerGrounded() -> boolean", "Whether the player stands on something.", isPlayerGrounded},
    {"IsPlayerSwimming() -> boolean", "Whether the player swims.", isPlayerSwimming},
};

}  // namespace

Game& gameOf(lua_State* L) {
    return *static_cast<Game*>(ScriptContext::of(L).shared.host);
}

std::span<const ScriptFunction> playerFunctions() {
    return kFunctions;
}

SandboxLimits scriptLimits() {
    SandboxLimits limits;
    limits.memory = 64 << 20;
    limits.work = limits.workPerFrame;  // all files of the game are read in one call
    return limits;
}

std::span<const ScriptFunction> gameFunctions() {
    static const std::vector<ScriptFunction> all = [] {
        std::vector<ScriptFunction> rows;
        for (const auto& some : {playerFunctions(), sessionFunctions(), makeFunctions(), vehicleFunctions(),
                                 filmFunctions(), dropFunctions(), soundFunctions()})
            rows.insert(rows.end(), some.begin(), some.end());
        return rows;
    }();
    return all;
}

}  // namespace sandbox
