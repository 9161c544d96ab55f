#include "samples/sandbox/window.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "runtime/core/constants.h"
#include "runtime/core/log.h"
#include "runtime/plugin/frame_loop.h"
#include "runtime/world/queries/query.h"
#include "samples/sandbox/player.h"
#include "samples/sandbox/stage.h"
#include "samples/sandbox/tools.h"
#include "samples/support/image.h"
#include "samples/support/window.h"

namespace rubble {
namespace {

constexpr double kStepSeconds = 1.0 / kStepsPerSecond;
constexpr int kMaxStepsPerFrame = 4;  ///< a slower machine runs game time slower instead of falling ever further behind
constexpr int kScreenshotFrames = 12;                 ///< drawn before --screenshot writes its image
constexpr double kToolSeconds[] = {0.25, 0.5, 0.03};  ///< between two uses while the button is held

constexpr double kGrabDistance = 4.0, kGrabForce = 3000.0, kThrowImpulse = 250.0;  // metres, N, N s

constexpr const char* kToolNames[] = {"hammer", "explosive", "spray can"};

/// The running game behind one window. Steps have a fixed length of 1/60 s; time that is left over is carried in an
/// accumulator and drawn by interpolation (Fiedler 2004, "Fix Your Timestep!").
class Game {
public:
    Game(const SandboxOptions& options, Window& window, SandboxStage stage, std::unique_ptr<Renderer> renderer)
        : m_options(options),
          m_window(window),
          m_stage(std::move(stage)),
          m_renderer(std::move(renderer)),
          m_seed(uint32_t(options.seed)) {
        reset();
        m_renderer->showPass(options.pass);
        m_passes = m_renderer->passNames();
    }

    /// Runs the steps that are due and draws a frame; false when the player has left.
    bool frame() {
        if (!m_window.poll() || m_window.pressed(GLFW_KEY_ESCAPE)) return false;
        const auto now = std::chrono::steady_clock::now();
        const double elapsed = std::min(std::chrono::duration<double>(now - m_last).count(), 0.25);
        m_last = now;
        readKeys(elapsed);
        m_accumulator = std::min(m_accumulator + elapsed, kMaxStepsPerFrame * kStepSeconds);
        for (; m_accumulator >= kStepSeconds; m_accumulator -= kStepSeconds) step();
        showNames();
        draw(m_accumulator / kStepSeconds);
        m_window.present();
        return true;
    }

    Image captureFrame() {
        draw(1.0);
        return m_window.readPixels();
    }

private:
    void reset() {
        m_loop.world().setSettings(m_stage.settings);
        m_loop.load(m_stage.level);
        m_player.place(m_stage.camera(0.0));
        m_step = 0;
        m_cut = true;
        m_held = {};
        m_loop.step();
    }

    void step() {
        if (!m_options.scene.empty()) m_loop.edits().push(m_stage.script(m_step++));
        m_loop.edits().push(m_player.carryTorch(m_loop.world()));
        m_loop.step();
    }

    void readKeys(double elapsed) {
        const PlayerInput input = readPlayerInput(m_window);
        m_loop.edits().push(m_player.move(input, m_loop.world(), elapsed));
        for (int i = 0; i < 3; ++i)
            if (m_window.pressed(GLFW_KEY_1 + i)) {
                m_tool = HandTool(i);
                m_shownName = kToolNames[i];
            }
        if (m_window.pressed(GLFW_KEY_F)) m_player.toggleWalk();
        if (m_window.pressed(GLFW_KEY_T)) m_player.toggleTorch();
        if (m_window.pressed(GLFW_KEY_R)) reset();
        if (m_window.pressed(GLFW_KEY_P)) {
            m_pass = (m_pass + 1) % m_passes.size();
            m_renderer->showPass(m_passes[m_pass]);
            m_shownName = m_passes[m_pass];
        }
        grab();
        m_toolCooldown -= elapsed;
        if (m_window.mouseHeld() && m_toolCooldown <= 0.0) {
            m_loop.edits().push(
                useTool(m_tool, m_loop.world(), m_player.camera().position, m_player.camera().forward(), m_seed++));
            m_toolCooldown = kToolSeconds[int(m_tool)];
        }
    }

    /// While G is held, the body under the crosshair is held at its distance. Letting go drops it, or throws it along
    /// the view if the mouse button is held.
    void grab() {
        const glm::dvec3 eye = m_player.camera().position, ahead = m_player.camera().forward();
        if (!m_window.held(GLFW_KEY_G)) {
            if (std::exchange(m_held, {}))
                m_loop.edits().push(ReleaseEdit{m_window.mouseHeld() ? ahead * kThrowImpulse : glm::dvec3(0.0)});
            return;
        }
        if (!m_held) {
            const WorldHit hit = castRay(m_loop.world(), {eye, ahead, kGrabDistance});
            if (!hit.shape) return;  // nothing, or the ground around the level
            m_held = m_loop.world().shapes().at(hit.shape).body;
            m_heldDistance = hit.distance;
        }
        if (const Body* body = m_loop.world().bodies().find(m_held); body && !body->isStatic)
            m_loop.edits().push(GrabEdit{.body = m_held,
                                         .point = eye + ahead * m_heldDistance,
                                         .target = eye + ahead * m_heldDistance,
                                         .maxForce = kGrabForce});
    }

    /// Reloads shaders whose files have changed, twice a second at most.
    void reloadShaders() {
        const auto now = std::chrono::steady_clock::now();
        if (now - m_shadersCheckedAt < std::chrono::milliseconds(500)) return;
        m_shadersCheckedAt = now;
        if (m_renderer->reloadShaders()) logInfo("shaders reloaded");
        const std::vector<std::string> errors = m_renderer->shaderErrors();
        if (errors != m_shaderErrors)
            for (const std::string& error : errors) logError(error);
        m_shaderErrors = errors;
    }

    /// Draws a crosshair, and the name of the tool or of the pass that was chosen last.
    void showNames() {
        const glm::vec2 size(m_window.size());
        OverlayItem crosshair, name;
        crosshair.transform[2] = size * 0.5f, crosshair.align = {0.5f, 0.5f};
        crosshair.size = {12.0f, 12.0f}, crosshair.radius = 6.0f, crosshair.stroke = 1.5f;
        crosshair.color = {1.0f, 1.0f, 1.0f, 0.8f};
        name.kind = OverlayItem::Kind::Text, name.text = m_shownName;
        name.fontSize = 18.0f, name.outline = 1.5f;
        name.transform[2] = {size.x * 0.5f, size.y - 16.0f}, name.align = {0.5f, 1.0f};
        if (const auto set = m_renderer->overlay().set({crosshair, name}); !set && !std::exchange(m_hasWarned, true))
            logWarning(set.error());
    }

    void draw(double alpha) {
        reloadShaders();
        View view = m_player.camera().view(m_window.size(), 0);
        view.cut = std::exchange(m_cut, false);
        m_loop.draw(*m_renderer, view, float(alpha));
    }

    SandboxOptions m_options;
    Window& m_window;
    SandboxStage m_stage;
    std::unique_ptr<Renderer> m_renderer;
    FrameLoop m_loop;
    Player m_player;
    HandTool m_tool = HandTool::Hammer;
    std::string m_shownName = kToolNames[0];
    bool m_hasWarned = false;  ///< of a missing font
    uint32_t m_seed;
    int m_step = 0;  ///< next step of the scene's script
    double m_toolCooldown = 0.0, m_accumulator = 0.0;
    bool m_cut = true;
    BodyHandle m_held;            ///< by the hand
    double m_heldDistance = 0.0;  ///< metres from the eye
    std::vector<std::string> m_shaderErrors;
    std::chrono::steady_clock::time_point m_shadersCheckedAt{};
    std::vector<std::string> m_passes;
    size_t m_pass = 0;
    std::chrono::steady_clock::time_point m_last = std::chrono::steady_clock::now();
};

}  // namespace

int runWindow(const SandboxOptions& options) {
    Result<SandboxStage> stage = loadStage(options);
    if (!stage) return logError(stage.error()), 1;
    auto window = Window::create({options.width, options.height}, "Rubble sandbox");
    if (!window) return logError(window.error() + "; without a display run with --headless"), 1;
    RenderSettings settings = RenderSettings::preset(options.preset);
    settings.fullscreen = RenderSettings::fullscreenFromName(options.fullscreen);
    settings.hostState = HostState::Reset;
    settings.compileAhead = true;
    settings.programCache = (std::filesystem::path(options.tools).parent_path() / "programs").string();
    auto renderer = Renderer::create((*window)->loader(), options.shaders, settings);
    if (!renderer) return logError(renderer.error()), 1;
    Game game(options, **window, std::move(*stage), std::move(*renderer));
    for (int frames = 1; game.frame(); ++frames) {
        if (options.screenshot.empty() || frames < kScreenshotFrames) continue;
        auto written = writePng(options.screenshot, game.captureFrame());
        if (!written) return logError(written.error()), 1;
        break;
    }
    return 0;
}

}  // namespace rubble
