#include <algorithm>
#include <cctype>
#include <filesystem>
#include <glm/trigonometric.hpp>

#include "runtime/script/binding/calls.h"
#include "samples/sandbox/shell/fields.h"
#include "samples/sandbox/shell/functions.h"
#include "samples/sandbox/shell/game.h"

namespace sandbox {
namespace {

using namespace rubble::script;

Frame frameAt(lua_State* L, int index, const char* name) {
    const Placement place = finitePlacementAt(L, index, name);
    const Rotation& turn = place.rotation;
    return {{place.position[0], place.position[1], place.position[2]}, {turn[3], turn[0], turn[1], turn[2]}};
}

double fovAt(lua_State* L, int index) {
    return glm::radians(clampedAt(L, index, "fov", 10.0, 140.0));
}

/// Letters, digits, - and _, so that no two names are one file and none lies elsewhere.
bool isPlain(std::string_view name) {
    return !name.empty() && name.size() <= 100 && std::all_of(name.begin(), name.end(), [](unsigned char letter) {
        return (letter < 128 && std::isalnum(letter)) || letter == '-' || letter == '_';
    });
}

std::string saveNameAt(lua_State* L) {
    const std::string name = textAt(L, 1, "name");
    if (!isPlain(name)) refuseArgument(L, 1, "name", "1 to 100 of A-Z, a-z, 0-9, - and _");
    return name;
}

int setCameraTransform(lua_State* L) {
    gameOf(L).camera().frame = frameAt(L, 1, "transform");
    if (!lua_isnoneornil(L, 2)) gameOf(L).camera().fov = fovAt(L, 2);
    return 0;
}
int setCameraOffsetTransform(lua_State* L) {
    gameOf(L).camera().offset = frameAt(L, 1, "transform");
    return 0;
}
int setCameraFov(lua_State* L) {
    gameOf(L).camera().fov = fovAt(L, 1);
    return 0;
}
int makeInteractive(lua_State* L) {
    gameOf(L).requests().isInteractive = true;
    return 0;
}
/// Names of the files of a folder, sorted; of one that is not there none.
std::vector<std::string> filesOf(const std::string& folder) {
    namespace fs = std::filesystem;
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (at->is_regular_file(error)) names.push_back(at->path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

int listFiles(lua_State* L) {
    const std::string folder = textAt(L, 1, "folder");
    if (!isPlain(folder)) refuseArgument(L, 1, "folder", "1 to 100 of A-Z, a-z, 0-9, - and _");
    lua_newtable(L);
    lua_Integer count = 0;
    for (const std::string& name : filesOf(gameOf(L).settings().folder + "/" + folder)) {
        lua_pushstring(L, name.c_str());
        lua_rawseti(L, -2, ++count);
    }
    return 1;
}
int applyEdits(lua_State* L) {
    gameOf(L).requests().appliesEdits = true;
    return 0;
}
int addUndoMark(lua_State* L) {
    if (!gameOf(L).addUndoMark()) isDone(L, RUBBLE_ERROR_ARGUMENT);
    return 0;
}
int undo(lua_State* L) {
    lua_pushboolean(L, gameOf(L).undo());
    return 1;
}
int saveGame(lua_State* L) {
    gameOf(L).requests().save = saveNameAt(L);
    return 0;
}
int loadGame(lua_State* L) {
    const std::string name = saveNameAt(L);
    const bool loads = gameOf(L).canLoad(name);
    if (loads) gameOf(L).requests().load = name;
    lua_pushboolean(L, loads);
    return 1;
}
int hasSave(lua_State* L) {
    lua_pushboolean(L, gameOf(L).hasSave(saveNameAt(L)));
    return 1;
}
int restartLevel(lua_State* L) {
    gameOf(L).requests().restarts = true;
    return 0;
}
int quitGame(lua_State* L) {
    gameOf(L).requests().quits = true;
    return 0;
}
int setPreset(lua_State* L) {
    static constexpr std::string_view kPresets[] = {"draft", "fast", "balanced", "accurate"};
    const std::string name = textAt(L, 1, "name");
    if (std::find(std::begin(kPresets), std::end(kPresets), name) == std::end(kPresets))
        refuseArgument(L, 1, "name", "\"draft\", \"fast\", \"balanced\" or \"accurate\"");
    gameOf(L).requests().preset = name;
    return 0;
}
int getPreset(lua_State* L) {
    lua_pushstring(L, gameOf(L).settings().preset.c_str());
    return 1;
}
int keepReplay(lua_State* L) {
    gameOf(L).replay().keep(clampedAt(L, 1, "seconds", 0.0, 300.0));
    return 0;
}
int getReplayLength(lua_State* L) {
    lua_pushnumber(L, gameOf(L).replay().length());
    return 1;
}
int showReplay(lua_State* L) {
    const double ago = clampedAt(L, 1, "ago", 0.0, 300.0);
    const std::string what = gameOf(L).replay().show(ago, textAt(L, 2, "unseen"));
    lua_pushboolean(L, what.empty());
    lua_pushstring(L, what.c_str());
    return 2;
}
int screenshot(lua_State* L) {
    const std::string file = textAt(L, 1, "file");
    if (!file.ends_with(".png") || !isPlain(std::string_view(file).substr(0, file.size() - 4)))
        refuseArgument(L, 1, "file", "a name of A-Z, a-z, 0-9, - and _ that ends in .png");
    Requests& requests = gameOf(L).requests();
    if (!lua_isnoneornil(L, 2))
        requests.imageSize = {wholeAt(L, 2, "width", 16, 8192), wholeAt(L, 3, "height", 16, 8192)};
    requests.image = file;
    return 0;
}
int getScreenshotProgress(lua_State* L) {
    lua_pushnumber(L, gameOf(L).imageProgress());
    return 1;
}
int getDrawMemory(lua_State* L) {
    lua_pushinteger(L, lua_Integer(gameOf(L).drawMemory()));
    return 1;
}

constexpr ScriptFunction kFunctions[] = {
    {"SetCameraTransform(transform, fov)", "The camera of this frame, in place of the player's eyes; fov in degrees.",
     setCameraTransform},
    {"SetCameraOffsetTransform(transform)", "Moves the camera from the player's eyes.", setCameraOffsetTransform},
    {"SetCameraFov(fov)", "The vertical field of view, in degrees.", setCameraFov},
    {"UiMakeInteractive()", "Menus have the cursor in this frame.", makeInteractive},
    {"ListFiles(folder) -> names", "The files of a folder beside the game's scripts, sorted.", listFiles},
    {"ApplyEdits()", "Shows what was changed while no time passes, as a photo's light.", applyEdits},
    {"AddUndoMark()", "Sets a mark to which Undo() returns.", addUndoMark},
    {"Undo() -> boolean",
     "Takes back what came after the last mark, and each time again after the one before; false: there is none.", undo},
    {"KeepReplay(seconds)", "How many of the last seconds are kept, 0 to 300; 0: none, which costs nothing.",
     keepReplay},
    {"GetReplayLength() -> seconds", "How many there are.", getReplayLength},
    {"ShowReplay(ago, unseen) -> boolean, why",
     "Shows in this frame what was there so many seconds ago, without bodies of a tag; false: it cannot.", showReplay},
    {"SaveGame(name)", "Saves the game after this frame.", saveGame},
    {"LoadGame(name) -> boolean", "Goes on with a saved game after this frame; false: there is none that loads.",
     loadGame},
    {"HasSave(name) -> boolean", "Whether there is one.", hasSave},
    {"RestartLevel()", "Loads the level again after this frame.", restartLevel},
    {"QuitGame()", "Ends the game after this frame.", quitGame},
    {"SetPreset(name)", "Draws by another preset: \"draft\", \"fast\", \"balanced\" or \"accurate\".", setPreset},
    {"GetPreset() -> name", "The one in use.", getPreset},
    {"Screenshot(file, width, height)",
     "Writes this frame as PNG; in another size than the window's it is drawn in the frames that follow.", screenshot},
    {"GetScreenshotProgress() -> share", "How far one of another size is, 0 to 1; 1: there is none to come.",
     getScreenshotProgress},
    {"GetDrawMemory() -> bytes", "That the renderer held on the GPU when it drew last.", getDrawMemory},
};

}  // namespace

std::span<const ScriptFunction> sessionFunctions() {
    return kFunctions;
}

}  // namespace sandbox
