#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/golden/lit_scene.h"
#include "tests/tradeoff/light.h"
#include "tests/tradeoff/light_bench.h"

namespace rubble::tradeoff {
namespace {

constexpr glm::ivec2 kSize(160, 90);
constexpr int kSettled = 48, kWatched = 16, kConverged = 768, kAfter = 120;
constexpr int kMaxLagFrames = 12;

struct Setting {
    int history, radius;
    bool forgets;
};

std::vector<Setting> settingsOf(const Options& options) {
    std::vector<Setting> all;
    for (const int history : {4, 16, 32, 64})
        for (const int radius : {0, 2, 4, 5})
            for (const bool forgets : {true, false})
                if (options.full || (history == 32 && radius == 4) || (forgets && (history == 32 || radius == 4)))
                    all.push_back({history, radius, forgets});
    return all;
}

RenderSettings renderSettings(const Setting& setting) {
    RenderSettings settings = reference::comparedSettings();
    settings.historyFrames = setting.history;
    settings.filterPasses = setting.radius;
    settings.rejectStaleHistory = setting.forgets;
    return settings;
}

/// A floor in the shadow of a wall that can be removed.
struct RemovableScreen {
    LitScene scene;
    ShapeHandle screen;
    View view;
    RemovableScreen() : scene(streetPalette()) {
        const glm::dquat level(1, 0, 0, 0);
        scene.environment.sunDirection = {0.0f, 0.3f, 1.0f};
        scene.add({80, 2, 80}, {{-4, -0.2, -4}, level}, [](glm::ivec3) { return uint8_t(1); });
        screen = scene.add({80, 60, 2}, {{-4, 0, 2}, level}, [](glm::ivec3) { return uint8_t(1); });
        Camera camera;
        camera.position = {0, 3.0, -1.5};
        camera.lookAt({0, 0, 1.0});
        view = camera.view({0, 0}, 0);
    }
};

/// Mean of the sun's share and of the light's luminance, in the middle of the frame.
glm::dvec2 middleOf(const FloatImage& image) {
    glm::dvec2 sum(0.0);
    const glm::ivec2 low = image.size / 3, high = image.size * 2 / 3;
    for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x)
            sum +=
                glm::dvec2(image.at(x, y).a, glm::dot(glm::vec3(image.at(x, y)), glm::vec3(0.2126f, 0.7152f, 0.0722f)));
    return sum / double((high.x - low.x) * (high.y - low.y));
}

/// Frames until 90 % of the new light has arrived (the later of sun and sky), and the share that is wrong after 30
/// frames.
struct Response {
    int lag = 0;
    double ghost = 0.0;
};
Response responseOf(const Setting& setting) {
    RemovableScreen opening;
    LightBench bench(opening.scene.snapshot(), opening.view, {96, 64}, renderSettings(setting));
    bench.draw(40);
    const glm::dvec2 before = middleOf(bench.read("denoisedLight"));
    opening.scene.edit(opening.screen, [](glm::ivec3) { return uint8_t(0); });
    bench.apply(opening.scene.step());
    std::vector<glm::dvec2> after;
    for (int i = 0; i < kAfter; ++i) bench.draw(), after.push_back(middleOf(bench.read("denoisedLight")));
    glm::dvec2 settled(0.0);  // mean of 40 frames, against noise
    for (int i = kAfter - 40; i < kAfter; ++i) settled += after[size_t(i)] / 40.0;
    Response response;
    for (int c = 0; c < 2; ++c) {
        const auto share = [&](size_t i) { return (after[i][c] - before[c]) / (settled[c] - before[c]); };
        int lag = kAfter;
        while (lag > 0 && share(size_t(lag - 1)) >= 0.9) --lag;
        response.lag = std::max(response.lag, lag + 1);
        response.ghost = std::max(response.ghost, std::abs(1.0 - share(29)));
    }
    return response;
}

/// Of a still view: bias of the mean of many frames from the converged light, and flicker of single frames around their
/// mean.
struct Still {
    double bias = 0.0, flicker = 0.0, ms = 0.0;
};
Still stillOf(const Setting& setting, const reference::SceneView& street, const FloatImage& converged) {
    LightBench bench(street.snapshot, street.view, kSize, renderSettings(setting));
    bench.draw(kSettled);
    const size_t pixels = converged.pixels.size();
    std::vector<double> sum(pixels, 0.0), squares(pixels, 0.0);
    for (int i = 0; i < kWatched; ++i) {
        bench.draw();
        const FloatImage image = bench.read("denoisedLight");
        for (size_t p = 0; p < pixels; ++p)
            sum[p] += image.pixels[p].g, squares[p] += double(image.pixels[p].g) * image.pixels[p].g;
    }
    Still still;
    double light = 0.0;
    for (size_t p = 0; p < pixels; ++p) {
        const double mean = sum[p] / kWatched;
        still.bias += std::abs(mean - converged.pixels[p].g);
        still.flicker += std::sqrt(std::max(squares[p] / kWatched - mean * mean, 0.0));
        light += converged.pixels[p].g;
    }
    still.bias /= light, still.flicker /= light;
    still.ms = bench.ms("accumulate") + bench.ms("filter");
    return still;
}

/// The mean of the unfiltered rays over many frames, at the same pixels.
FloatImage convergedStreet(const reference::SceneView& street) {
    RenderSettings settings = reference::comparedSettings();
    settings.skyRays = 8;
    LightBench bench(street.snapshot, street.view, kSize, settings);
    FloatImage sum(kSize);
    for (int i = 0; i < kConverged / 8; ++i) {
        bench.draw();
        const FloatImage image = bench.read("noisyLight");
        for (size_t p = 0; p < sum.pixels.size(); ++p) sum.pixels[p] += image.pixels[p] / float(kConverged / 8);
    }
    return sum;
}

}  // namespace

Table denoiserTradeoff(const Options& options) {
    Table table{
        "T9",
        "the denoiser's history, filter and response to changes, against the renderer's converged light",
        {"history", "filter passes", "forgets changes", "ms", "bias %", "flicker %", "lag frames", "ghost after 30 %"},
        {}};
    table.note =
        "Bias and flicker: of a still view's light, in per cent of its mean. Lag: frames after a wall is removed until "
        "90 % of the sun's and sky's new light has arrived; ghost: what is still wrong of it after 30 frames. ms: "
        "accumulation and filter at 160x90, the minimum of 64 frames.";
    const reference::SceneView street = reference::tuningViews(false)[0];
    const FloatImage converged = convergedStreet(street);
    Series bias{"bias", {}, true}, flicker{"flicker", {}, true};
    for (const Setting& setting : settingsOf(options)) {
        const Still still = stillOf(setting, street, converged);
        const Response response = responseOf(setting);
        table.add({std::to_string(setting.history), std::to_string(setting.radius), setting.forgets ? "yes" : "no",
                   fmt::format("{:.2f}", still.ms), fmt::format("{:.2f}", still.bias * 100),
                   fmt::format("{:.2f}", still.flicker * 100), std::to_string(response.lag),
                   fmt::format("{:.2f}", response.ghost * 100)});
        bias.points.emplace_back(still.ms, still.bias * 100),
            flicker.points.emplace_back(still.ms, still.flicker * 100);
        if (setting.history != 32 || setting.radius != 4 || !setting.forgets) continue;
        table.conclusion = fmt::format(
            "Balanced (32 frames, 4 passes): bias {:.1f} %, flicker {:.1f} %, 90 % of new light after {} frames, ghost "
            "{:.1f} %.",
            still.bias * 100, still.flicker * 100, response.lag, response.ghost * 100);
        table.failed = response.lag > kMaxLagFrames || response.ghost > 0.02;
    }
    writePlot(options, "T9", "The denoiser: bias and flicker by time", "ms", "per cent of the light", {bias, flicker});
    return table;
}

}  // namespace rubble::tradeoff
