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

Result<Drawn> makeDrawn(const Options& options, GlContext& context, const std::string& fullscreen,
                        const std::string& shaders) {
    RenderSettings settings = RenderSettings::preset(options.preset);
    settings.passTimes = true;
    settings.processorTime = options.processorTime;
    settings.fullscreen = RenderSettings::fullscreenFromName(fullscreen);
    auto renderer = Renderer::create(context.loader(), shaders, settings);
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
    /// The median of this frame by frame relative to another measurement, so that drifting clocks cancel out.
    double ratioTo(const Measured& other, size_t pass) const {
        std::vector<double> ratios;
        for (size_t i = 0; i < passes[pass].second.size(); ++i)
            ratios.push_back(passes[pass].second[i] / std::max(other.passes[pass].second[i], 1e-3));
        return median(ratios);
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

void printSideBySide(const char* place, const Drawn& first, const Drawn& second, const Measured& a, const Measured& b) {
    fmt::print("\n{:<14}{:>12}{:>12}{:>10}\n", place, first.name, second.name, "ratio");
    for (size_t i = 0; i < a.passes.size() && i < b.passes.size(); ++i)
        fmt::print("  {:<12}{:>12.2f}{:>12.2f}{:>9.3f}x\n", a.passes[i].first, median(a.passes[i].second),
                   median(b.passes[i].second), b.ratioTo(a, i));
    fmt::print("  {:<12}{:>12.2f}{:>12.2f}{:>9.3f}x\n", "frame", a.sum(), b.sum(), b.sum() / a.sum());
}

}  // namespace

int benchFrame(const Options& options, GlContext& context) {
    std::vector<Drawn> all;
    const auto add = [&](const std::string& fullscreen, const std::string& shaders, const std::string& name) {
        auto drawn = makeDrawn(options, context, fullscreen, shaders);
        if (drawn)
            all.push_back(std::move(drawn).value()), all.back().name = name;
        else
            fmt::print(stderr, "{}\n", drawn.error());
        return bool(drawn);
    };
    const bool isBoth = options.fullscreen == "both";
    const std::string fullscreen = isBoth ? "fragment" : options.fullscreen;
    if (!add(fullscreen, options.shaders, isBoth ? "fragment ms" : "ms")) return 1;
    if (isBoth && !add("compute", options.shaders, "compute ms")) return 1;
    if (!options.against.empty() && !add(fullscreen, options.against, "against ms")) return 1;
    const Offscreen target(options.size);
    for (const TownView& place : townViews()) {
        const std::vector<Measured> measured = measure(all, place.view(options.size, target.framebuffer()), options);
        if (all.size() == 1) print(place.name, measured[0]);
        for (size_t i = 1; i < all.size(); ++i) printSideBySide(place.name, all[0], all[i], measured[0], measured[i]);
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
