#include "samples/sandbox/headless.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "render/gl/offscreen.h"
#include "runtime/core/constants.h"
#include "runtime/core/log.h"
#include "runtime/plugin/frame_loop.h"
#include "samples/sandbox/figures.h"
#include "samples/sandbox/shell/allocations.h"
#include "samples/sandbox/stage.h"
#include "samples/scenes/scene.h"
#include "samples/support/gl_context.h"
#include "samples/support/image.h"
#include "samples/support/progress.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;

constexpr int kWarmUpFrames = 12;  ///< drawn before the first frame, so that its light has converged
constexpr int kMaxSheetFrames = 12;
constexpr int kPassColumns = 4;
constexpr int kHistoryFrames = 6;  ///< drawn before a still and not kept: the history of the temporal filters

/// Draws frames of a running world into files.
class FrameRecorder {
public:
    static Result<std::unique_ptr<FrameRecorder>> create(const SandboxOptions& options, const SandboxStage& stage) {
        auto recorder = std::unique_ptr<FrameRecorder>(new FrameRecorder(options, stage));
        auto context = GlContext::create(GlContext::kindOf(options.gl));
        if (!context) return Error{context.error()};
        recorder->m_context = std::move(*context);
        RenderSettings settings = RenderSettings::preset(options.preset);
        settings.fullscreen = RenderSettings::fullscreenFromName(options.fullscreen);
        settings.warmUpFrames = kWarmUpFrames;
        settings.passTimes = true;
        auto renderer = Renderer::create(recorder->m_context->loader(), options.shaders, settings);
        if (!renderer) return Error{renderer.error()};
        recorder->m_renderer = std::move(*renderer);
        recorder->m_offscreen = std::make_unique<Offscreen>(glm::ivec2(options.width, options.height));
        if (!recorder->m_renderer->showPass(options.pass)) {
            std::string names;
            for (const std::string& name : recorder->m_renderer->passNames()) names += " " + name;
            return Error{"--pass " + options.pass + ": no such pass; there are:" + names};
        }
        return recorder;
    }

    /// Draws the world as the stage's camera sees it after `seconds`.
    Image draw(FrameLoop& loop, double seconds) {
        View view;
        const Pose camera = m_stage.camera(seconds);
        view.position = camera.position;
        view.rotation = camera.rotation;
        view.verticalFov = m_stage.verticalFov;
        view.size = {m_options.width, m_options.height};
        view.framebuffer = m_offscreen->framebuffer();
        loop.draw(*m_renderer, view, 1.0f);
        Image image(m_options.width, m_options.height);
        image.rgb = m_offscreen->readRgb();
        return image;
    }

    /// Writes the same frame as each pass leaves it into `folder`, and a sheet of all passes beside the folder.
    void writeAllPasses(FrameLoop& loop, double seconds, const fs::path& folder) {
        fs::create_directories(folder);
        std::vector<Image> sheet;
        for (const std::string& name : m_renderer->passNames()) {
            m_renderer->showPass(name);
            sheet.push_back(draw(loop, seconds));
            if (auto written = writePng((folder / (name + ".png")).string(), sheet.back()); !written)
                logError(written.error());
        }
        m_renderer->showPass(m_options.pass);
        if (auto written = writePng(folder.string() + ".png", tile(sheet, kPassColumns)); !written)
            logError(written.error());
    }

    const Renderer& renderer() const { return *m_renderer; }

private:
    FrameRecorder(const SandboxOptions& options, const SandboxStage& stage) : m_options(options), m_stage(stage) {}
    SandboxOptions m_options;
    const SandboxStage& m_stage;
    std::unique_ptr<GlContext> m_context;  // declared first: what draws with it is destroyed before it
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<Offscreen> m_offscreen;
};

void makeVideo(const fs::path& out, int fps) {
    if (std::system("command -v ffmpeg >/dev/null 2>&1") != 0) {
        logInfo("no MP4 was made: ffmpeg is not installed (Debian package ffmpeg)");
        return;
    }
    const std::string command = fmt::format(
        "ffmpeg -loglevel error -y -framerate {} -i '{}/frames/%04d.png' -pix_fmt yuv420p -crf 16 '{}/demolition.mp4'",
        fps, out.string(), out.string());
    if (std::system(command.c_str()) != 0) logWarning("no MP4 was made: ffmpeg failed; its message is above");
}

/// Says which steps of a run are drawn, and which of these frames are on the contact sheet. Stills (--frames N) are
/// spread evenly over the run; otherwise a frame is drawn at a fixed rate (--fps).
class FrameSchedule {
public:
    FrameSchedule(const SandboxOptions& options, int steps) : m_steps(steps), m_areStills(options.frames > 0) {
        m_stepsPerFrame = kStepsPerSecond / options.fps;
        m_frames = m_areStills ? std::min(options.frames, steps) : steps / m_stepsPerFrame;
    }
    int frames() const { return m_frames; }
    int columns() const { return std::clamp(m_frames, 1, m_areStills && m_frames % 3 != 0 ? 2 : 3); }
    bool areStills() const { return m_areStills; }

    /// Number of the frame that shows the world after `step` steps; -1 if there is none.
    int frameAt(int step) const {
        if (!m_areStills) return step % m_stepsPerFrame == 0 ? step / m_stepsPerFrame - 1 : -1;
        const int frame = int((int64_t(step) * m_frames + m_steps - 1) / m_steps) - 1;
        return stepOf(frame) == step ? frame : -1;
    }
    /// Whether a step is drawn, though not kept, because the next still needs its history.
    bool isHistoryFrame(int step) const {
        for (int ahead = 1; m_areStills && ahead <= kHistoryFrames; ++ahead)
            if (step + ahead <= m_steps && frameAt(step + ahead) >= 0) return true;
        return false;
    }
    /// All stills are on the sheet; of a video, twelve frames evenly over the run with the first and the last.
    bool isOnSheet(int frame) const {
        if (m_areStills || m_frames <= kMaxSheetFrames || frame == 0) return true;
        return frame * (kMaxSheetFrames - 1) / (m_frames - 1) != (frame - 1) * (kMaxSheetFrames - 1) / (m_frames - 1);
    }

private:
    int stepOf(int frame) const { return int(int64_t(frame + 1) * m_steps / m_frames); }
    int m_steps, m_stepsPerFrame = 1, m_frames = 0;
    bool m_areStills;
};

/// Steps of the run: as the options say, else as the scene says, else ten seconds.
int runLength(const SandboxOptions& options) {
    if (options.seconds > 0.0) return int(options.seconds * kStepsPerSecond);
    const Scene* scene = findScene(options.scene);
    return scene ? scene->steps : 10 * kStepsPerSecond;
}

FrameLoopSettings loopSettings(const SandboxOptions& options) {
    FrameLoopSettings settings;
    settings.shadow = options.inlineShadow ? ShadowWorker::Mode::Inline : ShadowWorker::Mode::Thread;
    settings.waitForShadow = true;
    settings.publish = !options.noRender;
    return settings;
}

/// One demolition from its first step to its files.
class HeadlessRun {
public:
    HeadlessRun(const SandboxOptions& options, SandboxStage stage)
        : m_options(options),
          m_out(options.out),
          m_stage(std::move(stage)),
          m_loop(loopSettings(options)),
          m_steps(runLength(options)),
          m_schedule(options, m_steps) {
        m_loop.world().setSettings(m_stage.settings);
        m_loop.load(m_stage.level);
    }

    /// Exit code.
    int run() {
        if (!m_options.noRender) {
            auto created = FrameRecorder::create(m_options, m_stage);
            if (!created) return logError(created.error()), 1;
            m_recorder = std::move(*created);
        }
        Progress progress(m_recorder ? "demolition, frames" : "demolition, steps",
                          m_recorder ? m_schedule.frames() : m_steps);
        for (int step = 1; step <= m_steps; ++step) {
            m_loop.edits().push(m_stage.script(step - 1));
            const uint64_t before = allocationCount();
            m_loop.step();
            m_figures.addStep(m_loop, allocationCount() - before);
            if (!m_recorder) {
                progress.advance(step);
                continue;
            }
            const Result<bool> kept = drawStep(step);
            if (!kept) return logError(kept.error()), 1;
            if (*kept) progress.advance(m_schedule.frameAt(step) + 1);
        }
        if (const Result<Done> written = writeResults(); !written) return logError(written.error()), 1;
        return voxelAccounting(m_loop.world()).balances() ? 0 : 1;
    }

private:
    /// Draws the frame of a step if it has one; true if the frame was kept.
    Result<bool> drawStep(int step) {
        const int frame = m_schedule.frameAt(step);
        const double seconds = double(step) / kStepsPerSecond;
        if (frame < 0) {
            if (m_schedule.isHistoryFrame(step)) m_recorder->draw(m_loop, seconds);
            return false;
        }
        const Image image = m_recorder->draw(m_loop, seconds);
        m_figures.addFrame(m_loop, m_recorder->renderer());
        if (auto written = writePng(fmt::format("{}/frames/{:04d}.png", m_options.out, frame), image); !written)
            return Error{written.error()};
        if (m_schedule.isOnSheet(frame)) {
            m_sheet.push_back(image);
            if (m_options.allPasses)
                m_recorder->writeAllPasses(m_loop, seconds, m_out / fmt::format("passes_{:04d}", frame));
        }
        return true;
    }

    /// Contact sheet, video and figures.
    Result<Done> writeResults() {
        if (!m_sheet.empty()) {
            const Image sheet = tile(m_sheet, m_schedule.columns());
            if (auto written = writePng((m_out / "contact_sheet.png").string(), sheet); !written)
                return Error{written.error()};
            if (!m_schedule.areStills()) makeVideo(m_out, m_options.fps);
        }
        const std::string json = (m_out / "figures.json").string();
        if (!m_figures.writeJson(json)) return Error{json + ": cannot write the figures"};
        const std::string table = m_figures.table();
        std::ofstream(m_out / "figures.txt") << table;
        std::fputs(table.c_str(), stdout);
        std::printf("frames and figures are in %s\n", fs::absolute(m_out).string().c_str());
        return Done{};
    }

    const SandboxOptions m_options;
    const fs::path m_out;
    const SandboxStage m_stage;
    FrameLoop m_loop;
    const int m_steps;
    const FrameSchedule m_schedule;
    std::unique_ptr<FrameRecorder> m_recorder;
    Figures m_figures;
    std::vector<Image> m_sheet;
};

}  // namespace

int runHeadless(const SandboxOptions& options) {
    std::error_code ignored;
    fs::create_directories(fs::path(options.out) / "frames", ignored);
    Result<SandboxStage> stage = loadStage(options);
    if (!stage) return logError(stage.error()), 1;
    return HeadlessRun(options, std::move(*stage)).run();
}

}  // namespace rubble
