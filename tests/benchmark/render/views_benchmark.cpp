// Two views in a frame, as those of a split screen, against one, in alternation.
#include <fmt/format.h>

#include <array>

#include "render/gl/offscreen.h"
#include "tests/benchmark/frame_clock.h"
#include "tests/benchmark/render/benchmarks.h"
#include "tests/benchmark/render/town_views.h"

namespace rubble::bench {
namespace {

constexpr int kWarmUp = 4;
constexpr int kDemolitionAgain = 120;  ///< step of the script at which playTown() has stopped

/// A town that breaks on, and the views of it that each frame draws.
struct Shown {
    std::string name;
    std::vector<TownView> views;
    std::unique_ptr<FrameLoop> loop;
    std::unique_ptr<Renderer> renderer;
    std::vector<double> ms;
};

/// Steps the town and draws its views. Milliseconds of the drawing.
double frameMs(Shown& shown, const Offscreen& target, int frame) {
    shown.loop->edits().push(demolition(kDemolitionAgain + frame, 1));
    shown.loop->step();
    const double start = frameClockMs();
    for (size_t i = 0; i < shown.views.size(); ++i) {
        View view = shown.views[i].view(target.size(), target.framebuffer());
        view.slot = int(i);
        shown.loop->draw(*shown.renderer, view, 1.0f);
        glFinish();
    }
    return frameClockMs() - start;
}

}  // namespace

int benchViews(const Options& options, GlContext& context) {
    const std::vector<TownView> views = townViews();
    std::array<Shown, 3> all{{{views[0].name, {views[0]}, {}, {}, {}},
                              {views[1].name, {views[1]}, {}, {}, {}},
                              {"both", {views[0], views[1]}, {}, {}, {}}}};
    for (Shown& shown : all) {
        auto renderer = Renderer::create(context.loader(), options.shaders, RenderSettings::preset(options.preset));
        if (!renderer) {
            fmt::print(stderr, "{}\n", renderer.error());
            return 1;
        }
        shown.loop = playTown();
        shown.renderer = std::move(renderer).value();
    }
    const Offscreen target(options.size);
    for (int frame = 0; frame < kWarmUp + options.frames; ++frame)
        for (Shown& shown : all) {
            const double ms = frameMs(shown, target, frame);
            if (frame >= kWarmUp) shown.ms.push_back(ms);
        }
    for (const Shown& shown : all) fmt::print("  {:<10}{:8.1f} ms\n", shown.name, median(shown.ms));
    const double one = 0.5 * (median(all[0].ms) + median(all[1].ms));
    fmt::print("two views in a frame take {:.3f} times as long as one (wanted 2.1)\n", median(all[2].ms) / one);
    return 0;
}

}  // namespace rubble::bench
