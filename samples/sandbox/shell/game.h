#pragma once
#include <rubble/rubble.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/script/script_host.h"
#include "samples/sandbox/shell/drops.h"
#include "samples/sandbox/shell/film.h"
#include "samples/sandbox/shell/gamepad.h"
#include "samples/sandbox/shell/input.h"
#include "samples/sandbox/shell/player.h"
#include "samples/sandbox/shell/replay.h"
#include "samples/sandbox/shell/still.h"
#include "samples/sandbox/sound/sound.h"
#include "samples/support/display.h"

namespace sandbox {

inline constexpr uint32_t kUndoMarks = 24;  ///< that are kept

/// What the game is started with.
struct GameSettings {
    std::string level, vdbTool;  ///< the level's file, and the program that reads .vdb
    std::string levelFolder;     ///< of the scripts that the level names; "": that of its file
    std::string folder;          ///< of the game's scripts: main.lua and what it requires
    std::string bot;             ///< a file of that folder that plays in place of a player; "": nobody
    std::string saves;           ///< folder of saved games and options
    std::string out;             ///< folder of images
    FilmSettings film;           ///< a film in place of the game
    std::string preset = "balanced";
    std::string programs;   ///< folder of compiled programs; "": none
    bool isSilent = false;  ///< no sound card is asked for
    std::string wav;        ///< file of the sound, in place of a sound card; "": none
};

/// What scripts ask for while they run, and gets done between two frames.
struct Requests {
    std::string save, load, image, preset;
    glm::ivec2 imageSize{0};  ///< 0: that of the window
    std::string shot;         ///< of the film: its name
    double unseen = 0.0;      ///< seconds of the world that pass before it
    int filmFrames = 0;       ///< of the whole film
    bool restarts = false, quits = false;
    bool isInteractive = false;  ///< menus have the cursor in this frame
    bool appliesEdits = false;   ///< in this frame, without a step
};

/// A camera of the scripts for one frame, in place of the player's eyes.
struct CameraOverride {
    std::optional<Frame> frame;
    Frame offset;      ///< in the frame of the eyes
    double fov = 1.2;  ///< radians, vertical
};

/// The shell around the game's scripts: input, camera, saves, drawing. What the game is they decide: folder/main.lua.
class Game {
public:
    /// The display must outlive it.
    Game(const rubble_api& api, rubble::Display& display, GameSettings settings);
    ~Game();
    Game(const Game&) = delete;
    Game& operator=(const Game&) = delete;

    /// Loads the level and starts the scripts. What is wrong, or "".
    std::string begin();
    /// A frame of so many seconds; false: the game is over.
    bool frame(double seconds);
    /// Makes the film of the settings, to its end. What is wrong, or "".
    std::string shootFilm();
    /// Whether frames are drawn, or those alone of which scripts want an image.
    void drawAlways(bool isAlways) { m_drawsAlways = isAlways; }
    /// Draws some frames of the world as it is, so that light settles, and writes the last one. What is wrong, or "".
    std::string writeImage(const std::string& path);
    /// How far the image of another size is, 0 to 1; 1: there is none to come.
    double imageProgress() const { return m_still ? m_still->progress() : m_requests.imageSize.x > 0 ? 0.0 : 1.0; }
    /// Bytes that the renderer held on the GPU when it drew last.
    uint64_t drawMemory() const;
    /// Whether a script has failed, or an image could not be written.
    bool hasFailed() const;

    /// The functions of the interface.
    const rubble_api& api() const { return m_api; }
    /// The world.
    rubble_world world() const { return m_world; }
    /// What the player does.
    Input& input() { return m_input; }
    /// A gamepad that a bot holds, until it puts another one down.
    void hold(const GamepadState& pad) { m_botPad = pad; }
    /// The player.
    Player& player() { return *m_player; }
    /// What is done after this frame.
    Requests& requests() { return m_requests; }
    /// What is heard.
    sound::Sound& sound() { return m_sound; }
    /// How loud; 0: no sound.
    void setVolume(double volume);
    /// What scripts want of the camera.
    CameraOverride& camera() { return m_camera; }
    /// Sets a mark to which undo() returns.
    bool addUndoMark();
    /// Returns to the last mark before the next step, and each time again to the one before that, although the world
    /// goes on between; the player stays where he is. False: there is none.
    bool undo();
    /// The last seconds of the game.
    Replay& replay() { return m_replay; }
    /// The files that were dropped on the window.
    Drops& drops() { return m_drops; }
    /// What the camera sees between the last two steps.
    Frame cameraFrame() const;
    /// What it was started with, but for the preset, which is the one in use.
    const GameSettings& settings() const { return m_settings; }
    /// Whether there is a saved game of that name.
    bool hasSave(const std::string& name) const;
    /// Whether that is one which loads; what is wrong with it is printed.
    bool canLoad(const std::string& name) const;

private:
    void startScripts();
    bool addScript(const std::string& name);
    std::string makeRenderer();
    std::string createRenderer(rubble_world world, rubble_renderer& renderer);
    rubble_renderer shownRenderer() const { return m_replay.renderer() ? m_replay.renderer() : m_renderer; }
    void carryOutRequests();
    std::string save(const std::string& name);
    std::string load(const std::string& name);
    std::string testPrefab(const std::string& name, const std::string& text);
    std::string savePath(const std::string& name) const;
    std::string optionsPath() const;
    void readOptions();
    void writeOptions();
    void step();
    void applyEdits();
    void carryOutUndo();
    void cutToShot();
    bool isPlayed() const { return m_settings.bot.empty() && m_settings.film.script.empty(); }
    void fail(const std::string& what);
    rubble_view view() const;
    rubble_view shownView();
    void draw(double seconds);
    void takeImage(const std::string& path, glm::ivec2 size);
    void drawStill();
    void hear(double seconds);

    const rubble_api& m_api;
    rubble::Display& m_display;
    GameSettings m_settings;
    Drops m_drops;
    Replay m_replay;
    rubble_api m_scriptApi;  ///< of which the replay notes what it must
    sound::Sound m_sound;
    rubble_world m_world = 0;
    rubble_renderer m_renderer = 0;
    std::unique_ptr<rubble::script::ScriptHost> m_scripts;
    std::optional<Player> m_player;
    std::optional<Film> m_film;
    std::unique_ptr<Still> m_still;  ///< that is drawn
    Input m_input;
    std::optional<GamepadState> m_botPad;
    Requests m_requests;
    CameraOverride m_camera;
    double m_due = 0.0;  ///< seconds that no step has covered yet
    bool m_drawsAlways = true, m_hasUndone = false, m_hasFailed = false, m_isCut = true;
    uint32_t m_marks = 0;  ///< that undo() may return to
    bool m_wantsUndo = false, m_isUndoAgain = false;
    bool m_isUnseen = false;  ///< steps that a film leaves out
};

}  // namespace sandbox
