#include "samples/sandbox/headless.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "render/gl/offscreen.h"
#include "runtime/core/log.h"
#include "runtime/plugin/frame_loop.h"
#include "samples/sandbox/figures.h"
#include "samples/sandbox/stage.h"
#include "samples/scenes/scene.h"
#include "samples/support/gl_context.h"
#include "samples/support/image.h"
#include "samples/support/progress.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;

constexpr int kStepsPerSecond = 60;
constexpr int kWarmUpFrames = 12;  ///< before the first frame, so that its light has settled
constexpr int kMaxSheetFrames = 12;
constexpr int kPassColumns = 4;
constexpr int kHistoryFrames =
    6;  ///< steps drawn before a frame that stands alone, so that light and edges have a past

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

    /// The same frame through every pass, into `folder`, and all of them on a sheet beside it.
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
    std::unique_ptr<GlContext> m_context;  // first made, last destroyed
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<Offscreen> m_offscreen;
};

void makeVideo(const fs::path& out, int fps) {
    if (std::system("command -v ffmpeg >/dev/null 2>&1") != 0) {
        logInfo("no MP4: ffmpeg is not installed");
        return;
    }
    const std::string command = fmt::format(
        "ffmpeg -loglevel error -y -framerate {} -i '{}/frames/%04d.png' -pix_fmt yuv420p -crf 16 '{}/demolition.mp4'",
        fps, out.string(), out.string());
    if (std::system(command.c_str()) != 0) logWarning("ffmpeg failed: no MP4");
}

/// Which frames of a run are drawn and which of these are on the contact sheet.
class Schedule {
public:
    Schedule(const SandboxOptions& options, int steps) : m_steps(steps), m_areStills(options.frames > 0) {
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
    /// Drawn but not kept: what the next frame's light and edges remember.
    bool isHistoryFrame(int step) const {
        for (int ahead = 1; m_areStills && ahead <= kHistoryFrames; ++ahead)
            if (step + ahead <= m_steps && frameAt(step + ahead) >= 0) return true;
        return false;
    }
    /// Twelve frames evenly over the run, the first and the last among them; all of those that stand alone.
    bool isOnSheet(int frame) const {
        if (m_areStills || m_frames <= kMaxSheetFrames || frame == 0) return true;
        return frame * (kMaxSheetFrames - 1) / (m_frames - 1) != (frame - 1) * (kMaxSheetFrames - 1) / (m_frames - 1);
    }

private:
    int stepOf(int frame) const { return int(int64_t(frame + 1) * m_steps / m_frames); }
    int m_steps, m_stepsPerFrame = 1, m_frames = 0;
    bool m_areStills;
};

/// Steps of the run: as asked for, as the scene says, or ten seconds.
int runLength(const SandboxOptions& options) {
    if (options.seconds > 0.0) return int(options.seconds * kStepsPerSecond);
    const Scene* scene = findScene(options.scene);
    return scene ? scene->steps : 10 * kStepsPerSecond;
}

}  // namespace

int runHeadless(const SandboxOptions& options) {
    const fs::path out(options.out);
    std::error_code ignored;
    fs::create_directories(out / "frames", ignored);
    Result<SandboxStage> stage = loadStage(options);
    if (!stage) return logError(stage.error()), 1;

    FrameLoopSettings settings;
    settings.shadow = options.inlineShadow ? ShadowWorker::Mode::Inline : ShadowWorker::Mode::Thread;
    settings.waitForShadow = true;
    settings.publish = !options.noRender;
    FrameLoop loop(settings);
    loop.world().setSettings(stage->settings);
    loop.load(stage->level);
    std::unique_ptr<FrameRecorder> recorder;
    if (!options.noRender) {
        auto created = FrameRecorder::create(options, *stage);
        if (!created) return logError(created.error()), 1;
        recorder = std::move(*created);
    }

    Figures figures;
    std::vector<Image> sheet;
    const int steps = runLength(options);
    const Schedule schedule(options, steps);
    Progress progress(recorder ? "demolition, frames" : "demolition, steps", recorder ? schedule.frames() : steps);
    for (int step = 1; step <= steps; ++step) {
        loop.edits().push(stage->script(step - 1));
        const uint64_t before = allocationCount();
        loop.step();
        figures.addStep(loop, allocationCount() - before);
        if (!recorder) {
            progress.advance(step);
            continue;
        }
        const int frame = schedule.frameAt(step);
        const double seconds = double(step) / kStepsPerSecond;
        if (frame < 0) {
            if (schedule.isHistoryFrame(step)) recorder->draw(loop, seconds);
            continue;
        }
        const Image image = recorder->draw(loop, seconds);
        figures.addFrame(loop, recorder->renderer());
        if (auto written = writePng(fmt::format("{}/frames/{:04d}.png", out.string(), frame), image); !written)
            return logError(written.error()), 1;
        if (schedule.isOnSheet(frame)) {
            sheet.push_back(image);
            if (options.allPasses) recorder->writeAllPasses(loop, seconds, out / fmt::format("passes_{:04d}", frame));
        }
        progress.advance(frame + 1);
    }

    if (recorder && !sheet.empty()) {
        if (auto written = writePng((out / "contact_sheet.png").string(), tile(sheet, schedule.columns())); !written)
            return logError(written.error()), 1;
        if (!schedule.areStills()) makeVideo(out, options.fps);
    }
    if (!figures.writeJson((out / "figures.json").string()))
        return logError((out / "figures.json").string() + ": cannot write"), 1;
    const std::string table = figures.table();
    std::ofstream(out / "figures.txt") << table;
    std::fputs(table.c_str(), stdout);
    std::printf("frames and figures are in %s\n", fs::absolute(out).string().c_str());
    return loop.world().voxelAccounting().balances() ? 0 : 1;
}

}  // namespace rubble
