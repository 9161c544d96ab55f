#include "samples/sandbox/shell/game.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "samples/sandbox/shell/allocations.h"
#include "samples/sandbox/shell/functions.h"
#include "samples/sandbox/shell/player_devices.h"
#include "samples/support/window.h"

namespace sandbox {
namespace {

namespace fs = std::filesystem;
using rubble::script::ScriptHost;

constexpr double kStep = 1.0 / 60.0;
constexpr int kMaxSteps = 4;  ///< of a frame: a slower machine runs slower instead of falling behind
constexpr int kStepsOfSecond = 60;
constexpr int kImageFrames = 12;  ///< in which the light of an image settles
constexpr int kFilmWait = 600;    ///< frames in which a film must begin
constexpr int kCutFrames = 6;     ///< in which it does after a cut of a film

std::string readText(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

}  // namespace

Game::Game(const rubble_api& api, rubble::Display& display, GameSettings settings)
    : m_api(api),
      m_display(display),
      m_settings(std::move(settings)),
      m_drops(api, m_settings.vdbTool,
              [this](const std::string& name, const std::string& text) { return testPrefab(name, text); }),
      m_replay(api, isPlayed() ? 0 : RUBBLE_WORLD_WAIT_FOR_SHADOW,
               [this](rubble_world world, rubble_renderer& renderer) { return createRenderer(world, renderer); }),
      m_scriptApi(m_replay.notingApi()),
      m_sound(api, m_settings.wav, !m_settings.isSilent, [](const std::string& line) { fmt::print("{}\n", line); }) {}

Game::~Game() {
    if (m_scripts && m_settings.film.script.empty()) writeOptions();
    m_scripts.reset();
    m_still.reset();
    m_replay.forget();
    if (m_renderer) m_api.destroy_renderer(m_renderer);
    if (m_world) m_api.destroy_world(m_world);
}

void Game::fail(const std::string& what) {
    if (what.empty()) return;
    m_hasFailed = true;
    fmt::print(stderr, "sandbox: {}\n", what);
}

std::string Game::begin() {
    rubble_host host = {};
    host.struct_size = sizeof host;
    host.gl_get_proc_address = m_display.loader();
    if (m_api.set_host(&host) != RUBBLE_OK) return m_api.get_last_error();
    rubble_world_settings settings = {};
    settings.struct_size = sizeof settings;
    settings.flags = isPlayed() ? 0 : RUBBLE_WORLD_WAIT_FOR_SHADOW;
    settings.physics_threads = isPlayed() ? 2 : 1;
    if (m_api.create_world(&settings, &m_world) != RUBBLE_OK) return m_api.get_last_error();
    if (m_api.load_level(m_world, m_settings.level.c_str(), m_settings.vdbTool.c_str()) != RUBBLE_OK)
        return m_api.get_last_error();
    rubble_settings rules = {};
    rules.struct_size = sizeof rules;
    m_api.get_settings(m_world, &rules);
    rules.flags |= RUBBLE_SETTING_PAINT_LAYER;  // soot and sprays keep their colours on full palettes
    if (m_api.set_settings(m_world, &rules) != RUBBLE_OK) return m_api.get_last_error();
    m_player.emplace(m_api, m_world);
    startScripts();
    if (m_hasFailed) return m_settings.folder + ": expected the scripts of a game";
    return makeRenderer();
}

std::string Game::makeRenderer() {
    if (m_renderer) m_api.destroy_renderer(std::exchange(m_renderer, 0));
    m_isCut = true;
    const std::string what = createRenderer(m_world, m_renderer);
    if (what.empty()) step();  // a renderer shows nothing before one
    return what;
}

std::string Game::createRenderer(rubble_world world, rubble_renderer& renderer) {
    rubble_renderer_settings settings = {};
    settings.struct_size = sizeof settings;
    settings.flags = RUBBLE_RENDERER_RESET_STATE;
    if (!m_drawsAlways) settings.flags |= RUBBLE_RENDERER_COMPILE_LATE;
    settings.preset = m_settings.preset.c_str();
    settings.program_cache = m_settings.programs.empty() ? nullptr : m_settings.programs.c_str();
    return m_api.create_renderer(world, &settings, &renderer) == RUBBLE_OK ? "" : m_api.get_last_error();
}

/// Ends the scripts that there are, and begins those of the game in the world as it is.
void Game::startScripts() {
    std::map<std::string, std::string> registry;
    if (m_scripts) registry = m_scripts->shared().registry;
    m_scripts.reset();
    rubble::script::ScriptHostSettings settings;
    settings.folder = m_settings.folder;
    settings.levelFolder =
        m_settings.levelFolder.empty() ? fs::absolute(m_settings.level).parent_path().string() : m_settings.levelFolder;
    settings.limits = scriptLimits();
    settings.functions = gameFunctions();
    settings.host = this;
    m_sound.enter(m_world);
    settings.reports = m_sound.filter();
    settings.log = [](int level, const std::string& line) { fmt::print(level ? stderr : stdout, "{}\n", line); };
    m_scripts = std::make_unique<ScriptHost>(m_scriptApi, m_world, settings);
    m_scripts->shared().registry = registry;
    if (m_settings.film.script.empty()) readOptions();
    m_api.set_undo_limit(m_world, kUndoMarks);
    m_marks = 0;
    m_camera = {};
    m_scripts->setView(view());
    m_scripts->addLevelScripts();
    if (!m_settings.bot.empty()) addScript(m_settings.bot);  // its input is there before the game looks
    const FilmSettings& film = m_settings.film;
    if (film.script.empty()) return (void)addScript("main.lua");
    m_scripts->shared().registry["film.shot"] = film.shot;
    m_scripts->shared().registry["film.seconds"] = fmt::format("{}", film.seconds);
    m_scripts->shared().registry["film.fps"] = fmt::format("{}", film.fps);
    addScript(film.script);
}

bool Game::addScript(const std::string& name) {
    const std::string path = m_settings.folder + "/" + name, text = readText(path);
    if (text.empty()) fail(path + ": expected a script");
    return !text.empty() && m_scripts->add(name, text).error().empty();
}

bool Game::hasFailed() const {
    const auto& all = m_scripts->scripts();
    return m_hasFailed || !m_sound.error().empty() ||
           std::any_of(all.begin(), all.end(), [](const auto& each) { return !each.error().empty(); });
}

bool Game::frame(double seconds) {
    m_input.beginFrame();
    const bool isOpen = readDevices(m_display, m_input);
    if (rubble::Window* window = m_display.window())
        for (const std::string& path : window->takeDrops()) m_drops.add(path);
    if (m_botPad) readGamepad(*m_botPad, m_input);
    m_camera.frame.reset();
    m_scripts->tick(seconds);
    m_isCut |= m_replay.endUnwanted();
    cutToShot();
    const int most = isPlayed() ? kMaxSteps : kStepsOfSecond;
    m_due = std::min(m_due + seconds * m_scripts->timeScale(), most * kStep);
    if (std::exchange(m_requests.appliesEdits, false) && m_due < kStep - 1e-9) applyEdits();
    for (; m_due >= kStep - 1e-9; m_due -= kStep) step();
    m_due = std::max(m_due, 0.0);
    hear(seconds);
    draw(seconds);
    if (rubble::Window* window = m_display.window()) window->captureCursor(!m_requests.isInteractive);
    carryOutRequests();
    if (m_still) drawStill();
    return isOpen && !m_requests.quits;
}

void Game::step() {
    fail(m_replay.beforeStep(m_world));  // may save the game, which an undo that waits would not let it
    if (m_wantsUndo) carryOutUndo();
    m_player->beforeStep();
    const uint64_t before = rubble::allocationCount();
    if (m_scripts->step() != RUBBLE_OK) return fail(m_api.get_last_error());
    if (m_film) {
        rubble_step_stats stats = {};
        stats.struct_size = sizeof stats;
        m_api.get_step_stats(m_world, &stats);
        m_film->figures().addStep(stats, rubble::allocationCount() - before);
    }
    fail(m_replay.afterStep(m_world));
    if (!m_isUnseen) m_sound.step();
    if (std::exchange(m_hasUndone, false)) m_player->adopt(true);
    m_player->afterStep();
}

/// What was changed is there, and no time has passed.
void Game::applyEdits() {
    m_scripts->beforeEdits();
    if (m_api.apply_edits(m_world) != RUBBLE_OK) fail(m_api.get_last_error());
    m_scripts->afterEdits();
}

/// Begins the shot that a script has asked for, after the time that nobody sees.
void Game::cutToShot() {
    if (m_requests.shot.empty() || !m_film) return;
    fail(m_film->beginShot(std::exchange(m_requests.shot, {}), m_requests.filmFrames));
    m_isUnseen = true;
    for (double left = m_requests.unseen; left > 0.5 * kStep; left -= kStep) step();
    m_isUnseen = false;
    m_due = 0.0;
    m_isCut = true;
}

std::string Game::shootFilm() {
    m_film.emplace(m_settings.out, m_settings.film);
    for (int waiting = 0; frame(1.0 / m_settings.film.fps) && !hasFailed();)
        if (!m_film->hasBegun() && ++waiting == kFilmWait)
            return fmt::format("{}: expected BeginShot() within {} frames", m_settings.film.script, kFilmWait);
    if (hasFailed()) return "the film ends early, as the message above says";
    m_sound.close();
    uint64_t hash = 0;
    m_api.get_state_hash(m_world, &hash);
    return m_film->finish(hash);
}

bool Game::addUndoMark() {
    if (m_api.add_undo_mark(m_world) != RUBBLE_OK) return false;
    m_marks = std::min(m_marks + 1, kUndoMarks);
    m_isUndoAgain = false;
    return true;
}

bool Game::undo() {
    if (m_marks == 0 || m_wantsUndo) return false;
    --m_marks;
    return m_wantsUndo = true;
}

/// The world has gone on since the undo before: that mark is returned to first, and from there to the one before.
/// Between the two nothing else may come.
void Game::carryOutUndo() {
    m_wantsUndo = false;
    if (std::exchange(m_isUndoAgain, true)) {
        m_api.apply_edits(m_world);
        m_api.undo(m_world);
        m_api.apply_edits(m_world);
    }
    m_hasUndone = m_api.undo(m_world) == RUBBLE_OK;
    m_scripts->beforeUndo();
}

Frame Game::cameraFrame() const {
    if (m_camera.frame) return *m_camera.frame;
    const Frame eye = m_player->eye(std::clamp(m_due / kStep, 0.0, 1.0));
    return {eye.position + eye.rotation * m_camera.offset.position, eye.rotation * m_camera.offset.rotation};
}

rubble_view Game::view() const {
    rubble_view view = {};
    view.struct_size = sizeof view;
    view.framebuffer = m_display.framebuffer();
    view.width = uint32_t(std::max(1, m_display.size().x)), view.height = uint32_t(std::max(1, m_display.size().y));
    const Frame camera = m_player ? cameraFrame() : Frame{};
    for (int i = 0; i < 3; ++i) view.position[i] = camera.position[i];
    const glm::dquat& turn = camera.rotation;
    view.rotation[0] = turn.x, view.rotation[1] = turn.y, view.rotation[2] = turn.z, view.rotation[3] = turn.w;
    view.vertical_fov = m_camera.fov;
    view.alpha = std::clamp(m_due / kStep, 0.0, 1.0);
    if (m_isCut) view.flags |= RUBBLE_VIEW_CUT;
    return view;
}

rubble_view Game::shownView() {
    rubble_view seen = view();
    if (m_replay.renderer()) m_replay.complete(seen);
    return seen;
}

void Game::hear(double seconds) {
    const Frame ear = cameraFrame();
    const glm::dquat& turn = ear.rotation;
    m_sound.frame(seconds, ear.position, {turn.x, turn.y, turn.z, turn.w});
}

/// The world reports what it sounds like only to who hears it.
void Game::setVolume(double volume) {
    const bool wasOn = m_sound.isOn();
    m_sound.setVolume(volume);
    if (m_scripts && wasOn != m_sound.isOn()) m_scripts->setHostReports(m_sound.filter());
}

void Game::draw(double seconds) {
    rubble_view seen = shownView();
    m_scripts->draw(shownRenderer(), seen, seconds);
    if (!m_drawsAlways) return;
    for (int i = 0; m_isCut && m_film && i < kCutFrames; ++i, seen.flags &= ~uint32_t(RUBBLE_VIEW_CUT))
        if (m_api.draw(shownRenderer(), &seen) != RUBBLE_OK) return fail(m_api.get_last_error());
    m_isCut = false;
    if (m_api.draw(shownRenderer(), &seen) != RUBBLE_OK) return fail(m_api.get_last_error());
    m_display.present();
    if (!m_film || m_requests.quits) return;
    rubble_draw_stats stats = {};
    stats.struct_size = sizeof stats;
    m_api.get_draw_stats(m_renderer, &stats);
    fail(m_film->add(m_display.read(), stats.draw_ms));
}

std::string Game::writeImage(const std::string& path) {
    std::error_code ignored;
    fs::create_directories(fs::path(path).parent_path(), ignored);
    rubble_view seen = shownView();
    seen.flags |= RUBBLE_VIEW_CUT;
    for (int i = 0; i < kImageFrames; ++i, seen.flags &= ~uint32_t(RUBBLE_VIEW_CUT))
        if (m_api.draw(shownRenderer(), &seen) != RUBBLE_OK) return m_api.get_last_error();
    const auto written = rubble::writePng(path, m_display.read());
    return written ? "" : written.error();
}

void Game::takeImage(const std::string& path, glm::ivec2 size) {
    if (size.x == 0) return fail(writeImage(path));
    std::error_code ignored;
    fs::create_directories(fs::path(path).parent_path(), ignored);
    auto still = Still::begin(m_display, path, size);
    if (!still) return fail(still.error());
    m_still = std::move(*still);
}

void Game::drawStill() {
    const std::string what = m_still->draw(m_api, shownRenderer(), shownView());
    fail(what);
    if (!what.empty() || m_still->progress() == 1.0) m_still.reset();
}

uint64_t Game::drawMemory() const {
    rubble_draw_stats stats = {};
    stats.struct_size = sizeof stats;
    m_api.get_draw_stats(m_renderer, &stats);
    return stats.texture_bytes;
}

void Game::carryOutRequests() {
    const Requests now = std::exchange(m_requests, Requests{.quits = m_requests.quits});
    if (!now.image.empty()) takeImage(m_settings.out + "/" + now.image, now.imageSize);
    if (!now.save.empty()) fail(save(now.save));
    if (!now.load.empty()) fail(load(now.load));
    if (!now.preset.empty() && now.preset != m_settings.preset) {
        m_settings.preset = now.preset;
        fail(makeRenderer());
    }
    if (!now.restarts) return;
    writeOptions();
    m_scripts->shared().registry["game.restarted"] = "1";
    if (m_api.load_level(m_world, m_settings.level.c_str(), m_settings.vdbTool.c_str()) != RUBBLE_OK)
        return fail(m_api.get_last_error());
    m_replay.forget();
    m_player.emplace(m_api, m_world);
    startScripts();
    m_isCut = true;
}

}  // namespace sandbox
