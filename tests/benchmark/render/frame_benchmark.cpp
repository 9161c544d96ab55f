// The whole frame of the sandbox town, from three places: milliseconds and share of each pass.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "render/gl/offscreen.h"
#include "samples/support/image.h"
#include "tests/benchmark/render/benchmarks.h"
#include "tests/benchmark/render/town_views.h"

namespace rubble::bench {
namespace {

constexpr int kWarmUp = 4;
constexpr int kUntilChosen = 24;  ///< frames of "fastest": see render/shader_library/fullscreen_choice.h

/// The town and a renderer with one method for full-screen passes.
struct Drawn {
    std::string name;
    std::unique_ptr<FrameLoop> loop;
    std::unique_ptr<Renderer> renderer;
};

Result<Drawn> makeDrawn(const Options& options, GlContext& context, const std::string& fullscreen) {
    RenderSettings settings = RenderSettings::preset(options.preset);
    settings.passTimes = true;
    settings.processorTime = options.processorTime;
    settings.fullscreen = RenderSettings::fullscreenFromName(fullscreen);
    auto renderer = Renderer::create(context.loader(), options.shaders, settings);
    if (!renderer) return Error{renderer.error()};
    return Drawn{fullscreen, playTown(), std::move(renderer).value()};
}

struct Measured {
    std::vector<std::pair<std::string, std::vector<double>>> passes;  ///< in the order drawn
    RenderStats figures;
    double ms(const std::string& pass) const {
        for (const auto& [name, all] : passes)
            if (name == pass) return median(all);
        return 0.0;
    }
    double sum() const {
        double sum = 0.0;
        for (const auto& pass : passes) sum += median(pass.second);
        return sum;
    }
};

void addFrame(Drawn& drawn, const View& view, bool counts, Measured& out) {
    drawn.loop->draw(*drawn.renderer, view, 1.0f);
    glFinish();
    if (!counts) return;
    out.figures = drawn.renderer->stats();
    for (const auto& [name, ms] : out.figures.passMs) {
        auto found = std::find_if(out.passes.begin(), out.passes.end(),
                                  [&, name = name](const auto& pass) { return pass.first == name; });
        if (found == out.passes.end()) found = out.passes.insert(found, {name, {}});
        found->second.push_back(ms);
    }
}

/// Draws a frame of each by turns, so that other work on the machine disturbs all alike.
std::vector<Measured> measure(std::vector<Drawn>& all, const View& given, const Options& options) {
    View view = given;
    view.cut = true;
    std::vector<Measured> out(all.size());
    for (int i = -(options.fullscreen == "fastest" ? kUntilChosen : kWarmUp); i < options.frames; ++i) {
        for (size_t each = 0; each < all.size(); ++each) addFrame(all[each], view, i >= 0, out[each]);
        view.cut = false;
    }
    return out;
}

void print(const char* place, const Measured& m) {
    fmt::print("\n{}: {:.1f} ms, {} draws ({} of bodies); by compute: {}\n", place, m.sum(), m.figures.drawCalls,
               m.figures.bodyDraws, fmt::join(m.figures.computePasses, ", "));
    for (const auto& [name, ms] : m.passes)
        fmt::print("  {:<14}{:8.1f} ms{:7.1f} %   least {:.1f}\n", name, median(ms), 100.0 * median(ms) / m.sum(),
                   *std::min_element(ms.begin(), ms.end()));
}

void printSideBySide(const char* place, const Measured& fragment, const Measured& compute) {
    fmt::print("\n{:<14}{:>12}{:>12}{:>10}\n", place, "fragment ms", "compute ms", "ratio");
    const auto line = [](const std::string& name, double a, double b) {
        fmt::print("  {:<12}{:>12.2f}{:>12.2f}{:>9.2f}x\n", name, a, b, b / a);
    };
    for (const char* name : compute.figures.computePasses) line(name, fragment.ms(name), compute.ms(name));
    line("frame", fragment.sum(), compute.sum());
}

}  // namespace

int benchFrame(const Options& options, GlContext& context) {
    std::vector<std::string> names = {options.fullscreen};
    if (options.fullscreen == "both") names = {"fragment", "compute"};
    std::vector<Drawn> all;
    for (const std::string& name : names) {
        auto drawn = makeDrawn(options, context, name);
        if (!drawn) {
            fmt::print(stderr, "{}\n", drawn.error());
            return 1;
        }
        all.push_back(std::move(drawn).value());
    }
    const Offscreen target(options.size);
    for (const TownView& place : townViews()) {
        const std::vector<Measured> measured = measure(all, place.view(options.size, target.framebuffer()), options);
        if (all.size() == 1)
            print(place.name, measured[0]);
        else
            printSideBySide(place.name, measured[0], measured[1]);
        if (options.imageFolder.empty()) continue;
        std::filesystem::create_directories(options.imageFolder);
        Image image(options.size.x, options.size.y);
        image.rgb = target.readRgb();
        if (auto written = writePng(fmt::format("{}/{}.png", options.imageFolder, place.name), image); !written)
            fmt::print(stderr, "{}\n", written.error());
    }
    return 0;
}

}  // namespace rubble::bench
