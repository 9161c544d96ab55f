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

constexpr int kStepsASecond = 60;
constexpr int kWarmUpFrames = 12;  ///< before the first picture, so that its light has settled
constexpr int kSheetPictures = 12;
constexpr int kPassColumns = 4;
constexpr int kRunUp = 6;  ///< steps drawn before a picture that stands alone, so that light and edges have a past

/// Draws pictures of a running world into files.
class Cameraman {
public:
    static Result<std::unique_ptr<Cameraman>> create(const SandboxOptions& options, const SandboxStage& stage) {
        auto cameraman = std::unique_ptr<Cameraman>(new Cameraman(options, stage));
        auto context = GlContext::create(GlContext::kindOf(options.gl));
        if (!context) return Error{context.error()};
        cameraman->m_context = std::move(*context);
        RenderSettings settings = RenderSettings::preset(options.preset);
        settings.fullscreen = RenderSettings::fullscreenFromName(options.fullscreen);
        settings.warmUpFrames = kWarmUpFrames;
        auto renderer = Renderer::create(cameraman->m_context->loader(), options.shaders, settings);
        if (!renderer) return Error{renderer.error()};
        cameraman->m_renderer = std::move(*renderer);
        cameraman->m_offscreen = std::make_unique<Offscreen>(glm::ivec2(options.width, options.height));
        if (!cameraman->m_renderer->showPass(options.pass)) {
            std::string names;
            for (const std::string& name : cameraman->m_renderer->passNames()) names += " " + name;
            return Error{"--pass " + options.pass + ": no such pass; there are:" + names};
        }
        return cameraman;
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

    /// The same picture through every pass, into `folder`, and all of them on a sheet beside it.
    void writeAllPasses(FrameLoop& loop, double seconds, const fs::path& folder) {
        fs::create_directories(folder);
        std::vector<Image> sheet;
        for (const std::string& name : m_renderer->passNames()) {
            m_renderer->showPass(name);
            sheet.push_back(draw(loop, seconds));
            if (auto written = writePng((folder / (name + ".png")).string(), sheet.back()); !written) logError(written.error());
        }
        m_renderer->showPass(m_options.pass);
        if (auto written = writePng(folder.string() + ".png", tile(sheet, kPassColumns)); !written) logError(written.error());
    }

    const Renderer& renderer() const { return *m_renderer; }

private:
    Cameraman(const SandboxOptions& options, const SandboxStage& stage) : m_options(options), m_stage(stage) {}
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
    const std::string command =
        fmt::format("ffmpeg -loglevel error -y -framerate {} -i '{}/frames/%04d.png' -pix_fmt yuv420p -crf 16 '{}/demolition.mp4'", fps, out.string(),
                    out.string());
    if (std::system(command.c_str()) != 0) logWarning("ffmpeg failed: no MP4");
}

/// Which pictures of a run are drawn and which of these are on the contact sheet.
class Schedule {
public:
    Schedule(const SandboxOptions& options, int steps) : m_steps(steps), m_alone(options.pictures > 0) {
        m_stepsAPicture = kStepsASecond / options.fps;
        m_pictures = m_alone ? std::min(options.pictures, steps) : steps / m_stepsAPicture;
    }
    int pictures() const { return m_pictures; }
    int columns() const { return std::clamp(m_pictures, 1, m_alone && m_pictures % 3 != 0 ? 2 : 3); }
    bool alone() const { return m_alone; }

    /// Number of the picture that shows the world after `step` steps; -1 if there is none.
    int pictureAt(int step) const {
        if (!m_alone) return step % m_stepsAPicture == 0 ? step / m_stepsAPicture - 1 : -1;
        const int picture = int((int64_t(step) * m_pictures + m_steps - 1) / m_steps) - 1;
        return stepOf(picture) == step ? picture : -1;
    }
    /// Drawn but not kept: what the next picture's light and edges remember.
    bool isRunUp(int step) const {
        for (int ahead = 1; m_alone && ahead <= kRunUp; ++ahead)
            if (step + ahead <= m_steps && pictureAt(step + ahead) >= 0) return true;
        return false;
    }
    /// Twelve pictures evenly over the run, the first and the last among them; all of those that stand alone.
    bool isOnSheet(int picture) const {
        if (m_alone || m_pictures <= kSheetPictures || picture == 0) return true;
        return picture * (kSheetPictures - 1) / (m_pictures - 1) != (picture - 1) * (kSheetPictures - 1) / (m_pictures - 1);
    }

private:
    int stepOf(int picture) const { return int(int64_t(picture + 1) * m_steps / m_pictures); }
    int m_steps, m_stepsAPicture = 1, m_pictures = 0;
    bool m_alone;
};

/// Steps of the run: as asked for, as the scene says, or ten seconds.
int runLength(const SandboxOptions& options) {
    if (options.seconds > 0.0) return int(options.seconds * kStepsASecond);
    const Scene* scene = findScene(options.scene);
    return scene ? scene->steps : 10 * kStepsASecond;
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
    std::unique_ptr<Cameraman> cameraman;
    if (!options.noRender) {
        auto created = Cameraman::create(options, *stage);
        if (!created) return logError(created.error()), 1;
        cameraman = std::move(*created);
    }

    Figures figures;
    std::vector<Image> sheet;
    const int steps = runLength(options);
    const Schedule schedule(options, steps);
    Progress progress(cameraman ? "demolition, pictures" : "demolition, steps", cameraman ? schedule.pictures() : steps);
    for (int step = 1; step <= steps; ++step) {
        loop.edits().push(stage->script(step - 1));
        const uint64_t before = allocationCount();
        loop.step();
        figures.addStep(loop, allocationCount() - before);
        if (!cameraman) {
            progress.advance(step);
            continue;
        }
        const int picture = schedule.pictureAt(step);
        const double seconds = double(step) / kStepsASecond;
        if (picture < 0) {
            if (schedule.isRunUp(step)) cameraman->draw(loop, seconds);
            continue;
        }
        const Image image = cameraman->draw(loop, seconds);
        figures.addPicture(loop, cameraman->renderer());
        if (auto written = writePng(fmt::format("{}/frames/{:04d}.png", out.string(), picture), image); !written) return logError(written.error()), 1;
        if (schedule.isOnSheet(picture)) {
            sheet.push_back(image);
            if (options.allPasses) cameraman->writeAllPasses(loop, seconds, out / fmt::format("passes_{:04d}", picture));
        }
        progress.advance(picture + 1);
    }

    if (cameraman && !sheet.empty()) {
        if (auto written = writePng((out / "contact_sheet.png").string(), tile(sheet, schedule.columns())); !written)
            return logError(written.error()), 1;
        if (!schedule.alone()) makeVideo(out, options.fps);
    }
    if (!figures.writeJson((out / "figures.json").string())) return logError((out / "figures.json").string() + ": cannot write"), 1;
    const std::string table = figures.table();
    std::ofstream(out / "figures.txt") << table;
    std::fputs(table.c_str(), stdout);
    std::printf("pictures and figures are in %s\n", fs::absolute(out).string().c_str());
    return loop.world().voxelAccounting().balances() ? 0 : 1;
}

}  // namespace rubble
