#include "samples/sandbox/headless.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "render/gl/offscreen.h"
#include "runtime/core/log.h"
#include "runtime/plugin/frame_loop.h"
#include "samples/sandbox/figures.h"
#include "samples/sandbox/progress.h"
#include "samples/sandbox/stage.h"
#include "samples/scenes/demolition.h"
#include "samples/support/gl_context.h"
#include "samples/support/image.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;

constexpr int kStepsASecond = 60;
constexpr int kWarmUpFrames = 12;  ///< before the first picture, so that its light has settled
constexpr int kSheetPictures = 12;
constexpr int kSheetColumns = 3;

/// Draws pictures of a running world into files.
class Recorder {
public:
    static Result<std::unique_ptr<Recorder>> create(const SandboxOptions& options) {
        auto recorder = std::unique_ptr<Recorder>(new Recorder(options));
        auto context = GlContext::create(GlContext::kindOf(options.gl));
        if (!context) return Error{context.error()};
        recorder->m_context = std::move(*context);
        RenderSettings settings = RenderSettings::preset(options.preset);
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
        const Pose camera = m_options.model.empty() ? demolitionCamera(seconds) : modelCamera(m_low, m_high, seconds);
        view.position = camera.position;
        view.rotation = camera.rotation;
        view.verticalFov = kDemolitionFov;
        view.size = {m_options.width, m_options.height};
        view.framebuffer = m_offscreen->framebuffer();
        loop.draw(*m_renderer, view, 1.0f);
        Image image(m_options.width, m_options.height);
        image.rgb = m_offscreen->readRgb();
        return image;
    }

    /// The same picture through every pass, into `folder`.
    void writeAllPasses(FrameLoop& loop, double seconds, const fs::path& folder) {
        fs::create_directories(folder);
        for (const std::string& name : m_renderer->passNames()) {
            m_renderer->showPass(name);
            if (auto written = writePng((folder / (name + ".png")).string(), draw(loop, seconds)); !written) logError(written.error());
        }
        m_renderer->showPass(m_options.pass);
    }

    void frameModel(glm::dvec3 low, glm::dvec3 high) {
        m_low = low;
        m_high = high;
    }
    const Renderer& renderer() const { return *m_renderer; }

private:
    explicit Recorder(const SandboxOptions& options) : m_options(options) {}
    SandboxOptions m_options;
    std::unique_ptr<GlContext> m_context;  // first made, last destroyed
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<Offscreen> m_offscreen;
    glm::dvec3 m_low{0.0}, m_high{0.0};
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

/// Twelve pictures evenly over the run, the first and the last among them.
bool isSheetPicture(int picture, int pictures) {
    if (pictures <= kSheetPictures) return true;
    return picture * (kSheetPictures - 1) / (pictures - 1) != (picture - 1) * (kSheetPictures - 1) / (pictures - 1) || picture == 0;
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
    loop.load(stage->level);
    std::unique_ptr<Recorder> recorder;
    if (!options.noRender) {
        auto created = Recorder::create(options);
        if (!created) return logError(created.error()), 1;
        recorder = std::move(*created);
        recorder->frameModel(stage->modelLow, stage->modelHigh);
    }

    Figures figures;
    std::vector<Image> sheet;
    const int steps = int(options.seconds * kStepsASecond), stepsAPicture = kStepsASecond / options.fps, pictures = steps / stepsAPicture;
    Progress progress(recorder ? "demolition, pictures" : "demolition, steps", recorder ? pictures : steps);
    for (int step = 0; step < steps; ++step) {
        loop.edits().push(stage->hasModel ? demolishModel(step, stage->modelLow, stage->modelHigh, options.seed) : demolition(step, options.seed));
        const uint64_t before = allocationCount();
        loop.step();
        figures.addStep(loop, allocationCount() - before);
        if (!recorder) {
            progress.advance(step + 1);
            continue;
        }
        if ((step + 1) % stepsAPicture != 0) continue;
        const int picture = (step + 1) / stepsAPicture - 1;
        const double seconds = double(step + 1) / kStepsASecond;
        const Image image = recorder->draw(loop, seconds);
        figures.addPicture(loop, recorder->renderer());
        if (auto written = writePng(fmt::format("{}/frames/{:04d}.png", out.string(), picture), image); !written) return logError(written.error()), 1;
        if (isSheetPicture(picture, pictures)) {
            sheet.push_back(image);
            if (options.allPasses) recorder->writeAllPasses(loop, seconds, out / fmt::format("passes_{:04d}", picture));
        }
        progress.advance(picture + 1);
    }

    if (recorder && !sheet.empty()) {
        if (auto written = writePng((out / "contact_sheet.png").string(), tile(sheet, kSheetColumns)); !written) return logError(written.error()), 1;
        makeVideo(out, options.fps);
    }
    if (!figures.writeJson((out / "figures.json").string())) return logError((out / "figures.json").string() + ": cannot write"), 1;
    const std::string table = figures.table();
    std::ofstream(out / "figures.txt") << table;
    std::fputs(table.c_str(), stdout);
    std::printf("pictures and figures are in %s\n", fs::absolute(out).string().c_str());
    return loop.world().ledger().balances() ? 0 : 1;
}

}  // namespace rubble
