// The whole frame of the sandbox town, from three places: milliseconds and share of each pass.
#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "render/gl/offscreen.h"
#include "samples/support/image.h"
#include "tests/benchmark/render/benchmarks.h"
#include "tests/benchmark/render/town_views.h"

namespace rubble::bench {
namespace {

constexpr int kWarmUp = 4;

struct Measured {
    std::vector<std::pair<std::string, std::vector<double>>> passes;  ///< in the order drawn
    RenderFigures figures;
};

Measured measure(Renderer& renderer, FrameLoop& loop, const View& given, int frames) {
    View view = given;
    view.cut = true;
    Measured out;
    std::map<std::string, size_t> index;
    for (int i = -kWarmUp; i < frames; ++i) {
        loop.draw(renderer, view, 1.0f);
        glFinish();
        view.cut = false;
        if (i < 0) continue;
        for (const auto& [name, ms] : renderer.figures().passMs) {
            const auto [found, isNew] = index.try_emplace(name, out.passes.size());
            if (isNew) out.passes.emplace_back(name, std::vector<double>());
            out.passes[found->second].second.push_back(ms);
        }
    }
    out.figures = renderer.figures();
    return out;
}

void print(const char* place, const Measured& m) {
    double sum = 0;
    for (const auto& pass : m.passes) sum += median(pass.second);
    fmt::print("\n{}: {:.1f} ms, {} draws ({} of bodies)\n", place, sum, m.figures.drawCalls, m.figures.bodyDraws);
    for (const auto& [name, ms] : m.passes)
        fmt::print("  {:<14}{:8.1f} ms{:7.1f} %   least {:.1f}\n", name, median(ms), 100.0 * median(ms) / sum,
                   *std::min_element(ms.begin(), ms.end()));
}

}  // namespace

int benchFrame(const Options& options, GlContext& context) {
    const auto loop = playTown();
    RenderSettings renderSettings = RenderSettings::preset(options.preset);
    renderSettings.processorTime = options.processorTime;
    auto renderer = Renderer::create(context.loader(), options.shaders, renderSettings);
    if (!renderer) {
        fmt::print(stderr, "{}\n", renderer.error());
        return 1;
    }
    const Offscreen target(options.size);
    for (const Place& place : placesInTown()) {
        const View view = place.view(options.size, target.framebuffer());
        print(place.name, measure(*renderer.value(), *loop, view, options.frames));
        if (options.picture.empty()) continue;
        std::filesystem::create_directories(options.picture);
        Image image(options.size.x, options.size.y);
        image.rgb = target.readRgb();
        if (auto written = writePng(fmt::format("{}/{}.png", options.picture, place.name), image); !written)
            fmt::print(stderr, "{}\n", written.error());
    }
    return 0;
}

}  // namespace rubble::bench
