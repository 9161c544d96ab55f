#include <fmt/format.h>

#include <algorithm>

#include "tests/tradeoff/light.h"
#include "tests/tradeoff/light_bench.h"

namespace rubble::tradeoff {
namespace {

constexpr glm::ivec2 kSize(192, 108);
constexpr int kFrames = 16;
const float kBalancedLength = RenderSettings{}.skyDistance;

struct Setting {
    int rays;
    float scale, length;  // of each side; in metres
    Noise noise;
    const char* axis;
    std::string text() const {
        return fmt::format("{} ray{} of {:g} m, {} noise, scale {:g}", rays, rays > 1 ? "s" : "", length,
                           noise == Noise::Blue ? "blue" : "white", scale);
    }
};

/// Varies one setting at a time; every combination with --full.
std::vector<Setting> settingsOf(const Options& options) {
    const float lengths[] = {6, 12, 24, kBalancedLength, 200};
    std::vector<Setting> all;
    if (!options.full) {
        for (const int rays : {1, 2, 4, 8}) all.push_back({rays, 1, kBalancedLength, Noise::Blue, "rays"});
        for (const float length : lengths)
            if (length != kBalancedLength) all.push_back({1, 1, length, Noise::Blue, "length"});
        all.push_back({1, 1, kBalancedLength, Noise::White, "noise"});
        for (const float scale : {0.75f, 0.5f})
            for (const int rays : {1, 4}) all.push_back({rays, scale, kBalancedLength, Noise::Blue, "resolution"});
        return all;
    }
    for (const float scale : {1.0f, 0.75f, 0.5f})
        for (const int rays : {1, 2, 4, 8})
            for (const float length : lengths)
                for (const Noise noise : {Noise::Blue, Noise::White})
                    all.push_back({rays, scale, length, noise,
                                   scale == 1.0f    ? "whole"
                                   : scale == 0.75f ? "three quarters"
                                                    : "half"});
    return all;
}

/// A renderer with one of the settings, and its difference from the reference after the first frame.
struct Bench {
    std::unique_ptr<LightBench> renderer;
    Difference first;
};

Difference differenceTo(const ReferenceView& street, const LightBench& bench) {
    return differenceOf(street.referenceImage, bench.read("resolved"), street.scene.snapshot.environment.exposure);
}

/// Draws kFrames frames with every setting.
std::vector<Bench> drawAll(const ReferenceView& street, const std::vector<Setting>& all) {
    std::vector<Bench> benches;
    for (const Setting& setting : all) {
        RenderSettings settings = reference::comparedSettings();
        settings.skyRays = settings.sunRays = setting.rays;
        settings.skyDistance = setting.length;
        settings.noise = setting.noise;
        settings.resolutionScale = setting.scale;
        Bench& bench = benches.emplace_back();
        bench.renderer = std::make_unique<LightBench>(street.scene.snapshot, street.scene.view, kSize, settings);
        bench.renderer->draw();
        bench.first = differenceTo(street, *bench.renderer);
        bench.renderer->resetTimes();
    }
    for (int i = 1; i < kFrames; ++i)  // in alternation: other load on the machine affects all alike
        for (const Bench& bench : benches) bench.renderer->draw();
    return benches;
}

constexpr const char* kNote =
    "The street in the evening, 192x108, software GL. FLIP and relMSE of the anti-aliased frame; relMSE x ms is the "
    "error at equal time, smaller is better. What more rays do not reduce is bias: light that bounces off surfaces "
    "that are not in view, and half a voxel of shadow. Scale: resolution of the traced light, per side; the temporal "
    "pass upscales it.";

}  // namespace

Table rayTradeoff(const Options& options) {
    Table table{
        "T8",
        "sky rays per pixel, their length, their noise and the resolution scale, against the converged reference",
        {"sky rays", "length m", "noise", "scale", "processor ms per frame", "FLIP after 1 frame", "FLIP after 16",
         "relMSE after 16", "relMSE x ms"},
        {}};
    table.note = kNote;
    const ReferenceView street = streetReference(options, kSize);
    std::vector<Series> series;
    std::vector<std::pair<double, double>> cloud;
    double oneRay = 0.0, best = 1e30;
    std::string bestAtEqualTime;
    const std::vector<Setting> all = settingsOf(options);
    const std::vector<Bench> benches = drawAll(street, all);
    for (size_t i = 0; i < all.size(); ++i) {
        const Setting& setting = all[i];
        const Difference later = differenceTo(street, *benches[i].renderer);
        const double ms = benches[i].renderer->ms();
        table.add({std::to_string(setting.rays), fmt::format("{:g}", setting.length),
                   setting.noise == Noise::Blue ? "blue" : "white", fmt::format("{:g}", setting.scale),
                   fmt::format("{:.1f}", ms), fmt::format("{:.4f}", benches[i].first.flip),
                   fmt::format("{:.4f}", later.flip), fmt::format("{:.5f}", later.relative),
                   fmt::format("{:.3f}", later.relative * ms)});
        if (series.empty() || series.back().name != setting.axis) series.push_back({setting.axis, {}});
        series.back().points.emplace_back(ms, later.flip);
        series.back().isCloud = options.full;
        cloud.emplace_back(ms, later.flip);
        if (setting.rays == 1 && setting.scale == 1.0f && setting.length == kBalancedLength &&
            setting.noise == Noise::Blue)
            oneRay = later.flip;
        if (later.relative * ms < best) best = later.relative * ms, bestAtEqualTime = setting.text();
    }
    series.insert(series.begin(), paretoFront("front", cloud));
    table.conclusion = fmt::format(
        "Balanced (1 ray of {:g} m, blue noise) has a FLIP of {:.4f}; the smallest error at equal time has {}.",
        kBalancedLength, oneRay, bestAtEqualTime);
    writePlot(options, "T8", "Rays: FLIP after 16 frames, by the time of a frame", "processor ms per frame", "FLIP",
              series);
    return table;
}

}  // namespace rubble::tradeoff
