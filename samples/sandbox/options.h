#pragma once
#include <cstdint>
#include <string>

namespace rubble {

/// What `./rubble sandbox` was asked to do.
struct SandboxOptions {
    std::string model;        ///< .vox, .vdb or .rubble to put on the street instead of the house
    std::string level;        ///< a whole level to open instead of the town
    bool district = false;    ///< the town of four blocks instead of its first one
    bool yard = false;        ///< the yard with the vehicles instead of the town
    std::string scene;        ///< one of the scripted scenes instead of the town; "all": one after the other
    std::string write;        ///< where the level goes to, as .rubble; nothing is played then
    std::string time;         ///< time of day instead of the level's own: noon, afternoon, dusk, night or rain
    int frames = 0;           ///< draw this many stills, evenly over the run, and no MP4; 0: a video at `fps`
    std::string out = "out";  ///< folder for frames and figures
    std::string size = "640x360";
    int width = 640, height = 360;
    int fps = 0;           ///< frames per second of game time, which divide 60; 0: 30, of the film 20
    double seconds = 0.0;  ///< game time; 0: as long as the scene says, or ten
    std::string preset = "balanced";
    std::string fullscreen = "auto";  ///< what draws full-screen passes: auto, fragment, compute or fastest
    uint64_t seed = 1;
    std::string pass = "final";  ///< which target of the renderer is shown
    bool headless = false;       ///< no window even where there is a display
    bool noRender = false;       ///< state and figures only
    bool inlineShadow = false;   ///< the shadow volume on the main thread
    bool allPasses = false;      ///< also write every pass of every frame on the sheet
    bool map = false;            ///< without a window: the whole level from above
    std::string screenshot;      ///< window mode: write one frame here and leave
    bool bot = false;            ///< a script plays the game, without a window
    std::string shot;            ///< of the film: the only one
    std::string gl = "auto";     ///< without a window: auto, osmesa or egl
    std::string shaders;         ///< folder of the shaders
    std::string tools;           ///< folder of rubble-vdb
    bool wantsWindow() const;    ///< there is a display, and no option asks to run without a window
    bool wantsFilm() const;      ///< neither a window is wanted nor what the first release's demolition alone shows
};

}  // namespace rubble
