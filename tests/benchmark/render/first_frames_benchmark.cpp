// How long the frames take in which something is first seen, or in which the whole image loses its history, against the
// frames around them: a game must not stop there.
#include <fmt/format.h>

#include <algorithm>

#include "render/gl/offscreen.h"
#include "tests/benchmark/render/benchmarks.h"
#include "tests/benchmark/render/gbuffer_rig.h"
#include "tests/benchmark/render/town_views.h"
#include "tests/support/temp_folder.h"

namespace rubble::bench {
namespace {

constexpr int kFramesAfter = 10;    ///< drawn after each event; the last half of them is what a frame takes
constexpr int kSettledFrames = 24;  ///< after which all pixels have a long history
constexpr int kDropFrames = 3;      ///< in which what has changed is drawn with more rays
constexpr int kDropRuns = 3;

/// Something that a game may show for the first time.
struct Event {
    const char* name;
    void (*happen)(World& world, EditQueue& edits);
};

void change(World& world, EditQueue& edits, void (*set)(Environment&)) {
    Environment environment = world.environment();
    set(environment);
    edits.push(Edit(SetEnvironmentEdit{environment}));
}

const Event kEvents[] = {
    {"the level is loaded", [](World&, EditQueue&) {}},
    {"first explosion",
     [](World&, EditQueue& edits) {
         edits.push(Edit(ExplodeEdit{{30.0, 2.0, 32.0}, 2.0}));
     }},
    {"second explosion",
     [](World&, EditQueue& edits) {
         edits.push(Edit(ExplodeEdit{{27.0, 2.0, 33.0}, 2.0}));
     }},
    {"fog", [](World& w, EditQueue& edits) { change(w, edits, [](Environment& e) { e.fogDensity = 0.05f; }); }},
    {"rain", [](World& w, EditQueue& edits) { change(w, edits, [](Environment& e) { e.wetness = 1.0f; }); }},
    {"water",
     [](World&, EditQueue& edits) {
         Water flood;
         flood.outline = {{18, 20}, {46, 20}, {46, 46}, {18, 46}};
         flood.surface = 0.4;
         edits.push(Edit(AddWaterEdit{flood}));
     }},
    {"night",
     [](World& w, EditQueue& edits) {
         change(w, edits, [](Environment& e) { e.sunDirection = {0.3f, -0.4f, 0.2f}; });
     }},
};

/// Every shape's palette with this opacity for its glass. No edit changes a palette's opacity, so glass is shown to the
/// renderer alone.
FrameSnapshot glassOf(const World& world, uint8_t opacity) {
    FrameSnapshot step;
    step.version = step.newestStep = world.step();
    const int glass = world.materials().find("glass");
    world.shapes().forEach([&](ShapeHandle handle, const Shape& shape) {
        auto palette = std::make_shared<Palette>(*shape.palette);
        for (PaletteEntry& entry : *palette)
            if (entry.material == glass) entry.opacity = opacity;
        step.palettes.push_back({handle, std::move(palette), shape.paintColors});
    });
    return step;
}

/// Milliseconds by frameClockMs().
double drawOnce(FrameLoop& loop, Renderer& renderer, const View& view) {
    glFinish();
    const double start = frameClockMs();
    loop.draw(renderer, view, 1.0f);
    glFinish();
    return frameClockMs() - start;
}

void print(const char* name, const std::vector<double>& ms) {
    const double usual = median({ms.begin() + kFramesAfter / 2, ms.end()});
    fmt::print("{:<20} first frame {:7.0f} ms, then {:6.0f} ms: {:.1f}x (wanted 3)\n", name, ms[0], usual,
               ms[0] / usual);
}

/// The town's windows, which were opaque until then.
void benchGlass(FrameLoop& loop, Renderer& renderer, const View& view) {
    loop.load(makeTown(1));
    loop.step();
    loop.draw(renderer, view, 1.0f);
    renderer.apply(glassOf(loop.world(), 255));
    for (int i = 0; i < kFramesAfter; ++i) loop.draw(renderer, view, 1.0f);
    renderer.apply(glassOf(loop.world(), 60));
    std::vector<double> ms;
    for (int i = 0; i < kFramesAfter; ++i) ms.push_back(drawOnce(loop, renderer, view));
    print("glass", ms);
}

/// Something after which no pixel, or hardly one, keeps what it remembers. `run` counts its runs.
struct Drop {
    const char* name;
    void (*happen)(FrameLoop& loop, View& view, int run);
};

const Drop kDrops[] = {{"a cut", [](FrameLoop&, View& view, int) { view.cut = true; }},
                       {"an explosion that fills the view",
                        [](FrameLoop& loop, View& view, int run) {
                            const double metres = 4.0 + 0.7 * run;
                            const glm::dvec3 ahead = view.rotation * glm::dvec3(0.0, 0.0, -metres);
                            loop.edits().push(Edit(ExplodeEdit{view.position + ahead, 0.7 * metres}));
                        }},
                       {"another sky and sun",
                        [](FrameLoop& loop, View&, int run) {
                            Environment environment = loop.world().environment();
                            std::swap(environment.skyColor.r, environment.skyColor.b);
                            environment.skyColor *= run % 2 ? 0.25f : 4.0f;
                            environment.sunDirection.x = -environment.sunDirection.x;
                            environment.sunColor *= run % 2 ? 4.0f : 0.25f;
                            loop.edits().push(Edit(SetEnvironmentEdit{environment}));
                        }},
                       {"a flash of light everywhere", [](FrameLoop& loop, View& view, int) {
                            Light flash;
                            flash.local.position = view.position + glm::dvec3(0.0, 3.0, 0.0);
                            flash.color = glm::vec3(4000.0f);
                            flash.reach = 200.0f;
                            loop.edits().push(Edit(AddLightEdit{flash}));
                        }}};

/// The worst of the frames after each drop, against the median of those before.
void benchDrops(FrameLoop& loop, Renderer& renderer, const View& usual) {
    for (const Drop& drop : kDrops) {
        loop.load(makeTown(1));
        std::vector<double> ratios, before, worst;
        for (int run = 0; run < kDropRuns; ++run) {
            View view = usual;
            std::vector<double> ms;
            for (int i = 0; i < kSettledFrames + kDropFrames; ++i) {
                if (i == kSettledFrames) drop.happen(loop, view, run);
                loop.step();
                ms.push_back(drawOnce(loop, renderer, view));
                view.cut = false;
            }
            before.push_back(median({ms.begin() + kSettledFrames / 2, ms.begin() + kSettledFrames}));
            worst.push_back(*std::max_element(ms.begin() + kSettledFrames, ms.end()));
            ratios.push_back(worst.back() / before.back());
        }
        fmt::print("{:<33} {:6.0f} ms before, then at most {:6.0f} ms: {:.2f}x, at most {:.2f}x (wanted 3)\n",
                   drop.name, median(before), median(worst), median(ratios),
                   *std::max_element(ratios.begin(), ratios.end()));
    }
}

/// A renderer with the programs of all features; prints how long that took. Null: it says why.
std::unique_ptr<Renderer> makeRenderer(const Options& options, GlContext& context, const std::string& cache,
                                       const char* what) {
    RenderSettings settings = RenderSettings::preset(options.preset);
    settings.compileAhead = true;
    settings.fullscreen = RenderSettings::fullscreenFromName(options.fullscreen);
    settings.programCache = cache;
    const double before = frameClockMs();
    auto renderer = Renderer::create(context.loader(), options.shaders, settings);
    glFinish();
    if (!renderer) {
        fmt::print(stderr, "{}\n", renderer.error());
        return nullptr;
    }
    fmt::print("{:<50}{:7.0f} ms {}\n", what, frameClockMs() - before, frameClockName());
    return std::move(*renderer);
}

}  // namespace

int benchPrograms(const Options& options, GlContext& context) {
    const TempFolder cache;
    const std::string programs = cache / "programs";
    for (const auto& [folder, what] : {std::pair(std::string(), "programs of all features"),
                                       std::pair(programs, "the same, written to a cache of programs"),
                                       std::pair(programs, "the same, read from it")})
        if (!makeRenderer(options, context, folder, what)) return 1;
    return 0;
}

int benchFirstFrames(const Options& options, GlContext& context) {
    FrameLoopSettings loopSettings;
    loopSettings.shadow = ShadowWorker::Mode::Inline;
    loopSettings.waitForShadow = true;
    FrameLoop loop(loopSettings);
    loop.load(makeTown(1));
    loop.step();
    auto renderer = makeRenderer(options, context, "", "programs of all features, before the first frame");
    if (!renderer) return 1;
    const Offscreen target(options.size);
    const View view = townViews()[0].view(options.size, target.framebuffer());
    for (const Event& event : kEvents) {
        event.happen(loop.world(), loop.edits());
        std::vector<double> ms;
        for (int i = 0; i < kFramesAfter; ++i) {
            loop.step();
            ms.push_back(drawOnce(loop, *renderer, view));
        }
        print(event.name, ms);
    }
    benchGlass(loop, *renderer, view);
    benchDrops(loop, *renderer, view);
    return 0;
}

}  // namespace rubble::bench
