// Sounds by their names: the game makes them itself, and reads no files.
#include <algorithm>
#include <filesystem>

#include "runtime/script/binding/calls.h"
#include "samples/sandbox/shell/fields.h"
#include "samples/sandbox/shell/functions.h"
#include "samples/sandbox/shell/game.h"
#include "samples/sandbox/sound/named_sounds.h"

namespace sandbox {
namespace {

using namespace rubble::script;

/// A handle is the place of a name in the list of all, and one more.
int pushSound(lua_State* L, std::span<const std::string_view> names) {
    const std::string name = std::filesystem::path(textAt(L, 1, "path")).stem().string();
    const auto place = std::find(names.begin(), names.end(), name);
    if (place == names.end()) warnOnce(L, "there is no sound of the name \"" + name + "\"");
    pushHandle(L, place == names.end() ? 0 : uint64_t(place - names.begin()) + 1);
    return 1;
}

std::string nameAt(lua_State* L, const char* argument, std::span<const std::string_view> names) {
    const uint64_t handle = handleAt(L, 1, argument);
    return handle >= 1 && handle <= names.size() ? std::string(names[handle - 1]) : "";
}

std::optional<glm::dvec3> placeAt(lua_State* L, int index) {
    if (lua_isnoneornil(L, index)) return std::nullopt;
    const Vector v = finiteVectorAt(L, index, "pos");
    return glm::dvec3(v[0], v[1], v[2]);
}

/// A factor; what is left out or nil is `otherwise`.
double shareOr(lua_State* L, int index, const char* name, double otherwise) {
    return lua_isnoneornil(L, index) ? otherwise : rangedAt(L, index, name, 0.0, 1e3);
}

int loadSound(lua_State* L) {
    return pushSound(L, sound::soundNames());
}
int loadLoop(lua_State* L) {
    return pushSound(L, sound::loopNames());
}
int playSound(lua_State* L) {
    const std::string name = nameAt(L, "sound", sound::soundNames());
    gameOf(L).sound().play(name, placeAt(L, 2), shareOr(L, 3, "volume", 1.0));
    return 0;
}
int playLoop(lua_State* L) {
    const std::string name = nameAt(L, "loop", sound::loopNames());
    const double volume = shareOr(L, 3, "volume", 1.0), pitch = shareOr(L, 4, "pitch", 1.0);
    gameOf(L).sound().loop(name, placeAt(L, 2), volume, pitch);
    return 0;
}
int uiSound(lua_State* L) {
    const std::string name = std::filesystem::path(textAt(L, 1, "path")).stem().string();
    gameOf(L).sound().play(name, std::nullopt, shareOr(L, 2, "volume", 1.0));
    return 0;
}
int setSoundVolume(lua_State* L) {
    gameOf(L).setVolume(clampedAt(L, 1, "volume", 0.0, 1.0));
    return 0;
}

constexpr ScriptFunction kFunctions[] = {
    {"LoadSound(path) -> handle", "A sound by the name of a file, without folder and ending; 0: there is none.",
     loadSound},
    {"PlaySound(sound, pos, volume)", "Plays it once; without a place before the eyes.", playSound},
    {"LoadLoop(path) -> handle", "A sound that goes on, by its name; 0: there is none.", loadLoop},
    {"PlayLoop(loop, pos, volume, pitch)", "Plays it in this frame: call it in each. Without a place from all around.",
     playLoop},
    {"UiSound(path, volume)", "Plays a sound of menus.", uiSound},
    {"SetSoundVolume(volume)", "How loud all is, 0 to 1; 0: there is no sound.", setSoundVolume},
};

}  // namespace

std::span<const ScriptFunction> soundFunctions() {
    return kFunctions;
}

}  // namespace sandbox
