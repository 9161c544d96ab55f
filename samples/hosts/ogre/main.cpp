// A host of Ogre 1.12: a window, or with --script a script that writes images.
//     host_ogre PLUGIN LEVEL [--script FOLDER] [--steps N] [--size WIDTHxHEIGHT]
// W A S D and the mouse walk and look, a click makes a hole, E an explosion, space jumps, R begins again.
#include <GL/gl.h>
#include <OgreException.h>
#include <OgreLogManager.h>
#include <SDL.h>
#include <SDL_syswm.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "samples/hosts/ogre/scene.h"
#include "samples/hosts/support/options.h"
#include "samples/hosts/support/report.h"
#include "samples/hosts/support/yard.h"

namespace rubble_ogre {
namespace {

struct Options {
    std::string plugin, level, folder;  // folder: for the images of a script; "": a window
    uint64_t steps = SCRIPT_CYCLE;
    unsigned width = 960, height = 540;
};

const char kUsage[] = "usage: host_ogre PLUGIN LEVEL [--script FOLDER] [--steps N] [--size WIDTHxHEIGHT]\n";

[[noreturn]] void refuse(const std::string& expected, const std::string& found) {
    std::fprintf(stderr, "host_ogre: expected %s, found \"%s\"\n%s", expected.c_str(), found.c_str(), kUsage);
    std::exit(2);
}

Options readOptions(const std::vector<std::string>& words) {
    Options options;
    if (std::find(words.begin(), words.end(), "--help") != words.end()) {
        std::fputs(kUsage, stdout);
        std::exit(0);
    }
    if (words.size() < 2) refuse("a plugin and a level", words.empty() ? "" : words[0]);
    options.plugin = words[0], options.level = words[1];
    for (size_t i = 2; i < words.size(); i += 2) {
        const std::string value = i + 1 < words.size() ? words[i + 1] : "";
        if (words[i] == "--script") {
            options.folder = value;
            if (!is_path(value.c_str())) refuse("a folder for the script's images", value);
        } else if (words[i] == "--steps") {
            if (!read_steps(value.c_str(), &options.steps)) refuse("a number of steps above 0", value);
        } else if (words[i] == "--size") {
            if (!read_size(value.c_str(), &options.width, &options.height)) refuse("a size in pixels", value);
        } else {
            refuse("an option", words[i]);
        }
    }
    return options;
}

class Game {
public:
    Game(const Options& options, const std::string& parent)
        : m_options(options), m_scene(makeScene(options.plugin, parent, options.width, options.height)) {
        yard_enter(&m_yard, options.level.c_str(), nullptr, &m_scene.world->api(), m_scene.world->world());
    }
    ~Game() { destroyScene(m_scene); }
    Game(const Game&) = delete;
    Game& operator=(const Game&) = delete;
    void runScript();
    void runWindow();

private:
    void draw();  // without showing it
    void writeImage(const std::string& name);
    std::vector<uint8_t> readPixels();
    size_t countOwnPixels(const std::vector<uint8_t>& rgb) const;
    bool readInput();

    Options m_options;
    Scene m_scene;
    yard m_yard{};
};

void Game::draw() {
    rubble_view view = {.struct_size = sizeof view};
    view.width = view.height = 1;
    yard_look(&m_yard, &view);
    m_scene.eyes->setPosition(Ogre::Vector3(float(view.position[0]), float(view.position[1]), float(view.position[2])));
    m_scene.eyes->setOrientation(Ogre::Quaternion(float(view.rotation[3]), float(view.rotation[0]),
                                                  float(view.rotation[1]), float(view.rotation[2])));
    m_scene.cube->setOrientation(Ogre::Quaternion(Ogre::Radian(0.7f), Ogre::Vector3(0.3f, 0.9f, 0.1f)));
    m_scene.root->_fireFrameStarted();
    m_scene.window->update(false);
    m_scene.root->_fireFrameEnded();
}

std::vector<uint8_t> Game::readPixels() {
    std::vector<uint8_t> rgb(3 * size_t(m_options.width) * m_options.height);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, GLsizei(m_options.width), GLsizei(m_options.height), GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    return rgb;
}

/// Ogre's own meshes are magenta.
size_t Game::countOwnPixels(const std::vector<uint8_t>& rgb) const {
    size_t count = 0;
    for (size_t i = 0; i < rgb.size(); i += 3) count += rgb[i] > 90 && rgb[i + 1] == 0 && rgb[i + 2] > 90;
    return count;
}

void Game::writeImage(const std::string& name) {
    const std::string path = m_options.folder + "/" + name + ".png";
    m_scene.world->setVisible(false);
    draw();
    const size_t alone = countOwnPixels(readPixels());
    m_scene.world->setVisible(true);
    for (int frame = 0; frame < 4; ++frame) draw();  // light gathers over some frames
    const std::vector<uint8_t> rgb = readPixels();
    if (!write_png(path.c_str(), m_options.width, m_options.height, rgb.data()))
        refuse("a folder to write images to", m_options.folder);
    std::printf("%s: pieces %u, removed voxels %u, own pixels %zu of %zu, changed GL state %u\n", path.c_str(),
                unsigned(m_yard.pieces), unsigned(m_yard.removed), countOwnPixels(rgb), alone,
                unsigned(m_scene.world->changedState()));
}

void Game::runScript() {
    if (!make_folder(m_options.folder.c_str())) refuse("a folder to write images to", m_options.folder);
    while (m_yard.steps < m_options.steps) {
        const uint64_t step = m_yard.steps % SCRIPT_CYCLE;
        yard_play_script(&m_yard);
        yard_step(&m_yard);
        if (const char* image = yard_image_name(&m_yard, m_options.steps)) writeImage(image);
        if (step % 100 == 0) draw();
        if (step == SCRIPT_CYCLE - 1)
            std::printf("memory after %u steps: %u KiB\n", unsigned(m_yard.steps), unsigned(resident_kib()));
    }
}

bool Game::readInput() {
    const Uint8* const keys = SDL_GetKeyboardState(nullptr);
    SDL_Event event;
    while (SDL_PollEvent(&event)) {
        const SDL_Keycode key = event.type == SDL_KEYDOWN && !event.key.repeat ? event.key.keysym.sym : 0;
        if (event.type == SDL_QUIT || key == SDLK_ESCAPE) return false;
        if (event.type == SDL_MOUSEMOTION) {
            m_yard.yaw -= 0.003 * event.motion.xrel;
            m_yard.pitch = std::clamp(m_yard.pitch - 0.003 * event.motion.yrel, -1.5, 1.5);
        }
        if (event.type == SDL_MOUSEBUTTONDOWN) yard_shoot(&m_yard);
        if (key == SDLK_e) yard_explode(&m_yard);
        if (key == SDLK_r) yard_restart(&m_yard);
    }
    yard_walk(&m_yard, 4.0 * (keys[SDL_SCANCODE_W] - keys[SDL_SCANCODE_S]),
              4.0 * (keys[SDL_SCANCODE_D] - keys[SDL_SCANCODE_A]), keys[SDL_SCANCODE_SPACE]);
    return true;
}

void Game::runWindow() {
    Uint64 last = SDL_GetPerformanceCounter();
    double waiting = 0.0;
    SDL_SetRelativeMouseMode(SDL_TRUE);
    while (readInput()) {
        const Uint64 now = SDL_GetPerformanceCounter();
        waiting += double(now - last) / double(SDL_GetPerformanceFrequency()) * 60.0;
        last = now;
        waiting = std::min(waiting, 4.0);
        for (; waiting >= 1.0; waiting -= 1.0) yard_step(&m_yard);
        draw();
        m_scene.window->swapBuffers();
    }
}

/// Ogre draws in a window of SDL, which gives it keys and mouse.
int run(const Options& options) {
    SDL_SysWMinfo info;
    SDL_VERSION(&info.version);
    if (!options.folder.empty()) SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");  // a script reads no events
    if (SDL_Init(SDL_INIT_VIDEO) != 0) refuse("an X display", SDL_GetError());
    SDL_Window* const window = SDL_CreateWindow("Rubble in Ogre", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                                int(options.width), int(options.height), 0);
    if (!window || !SDL_GetWindowWMInfo(window, &info) || info.subsystem != SDL_SYSWM_X11)
        refuse("an X display", SDL_GetCurrentVideoDriver() ? SDL_GetCurrentVideoDriver() : "none");
    {
        Game game(options, std::to_string(info.info.x11.window));
        if (options.folder.empty())
            game.runWindow();
        else
            game.runScript();
    }
    SDL_DestroyWindow(window);
    SDL_Quit();
    return 0;
}

}  // namespace
}  // namespace rubble_ogre

int main(int argc, char** argv) {
    const rubble_ogre::Options options = rubble_ogre::readOptions({argv + 1, argv + argc});
    Ogre::LogManager logs;  // a script prints its own lines alone
    logs.createLog("host_ogre", true, false, true);
    try {
        return rubble_ogre::run(options);
    } catch (const Ogre::Exception& exception) {
        std::fprintf(stderr, "host_ogre: %s\n", exception.getDescription().c_str());
        return 1;
    }
}
