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
    float scale, length;  // of each side; metres
    Noise noise;
    const char* axis;
    std::string text() const {
        return fmt::format("{} ray{} of {:g} m, {} noise, scale {:g}", rays, rays > 1 ? "s" : "", length,
                           noise == Noise::Blue ? "blue" : "white", scale);
    }
};

/// Along each axis from the middle; every combination with --full.
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

}  // namespace

Table rayTradeoff(const Options& options) {
    Table table{
        "T8",
        "sky rays a pixel, their length, their noise and the resolution scale, against the converged referenceImage",
        {"sky rays", "length m", "noise", "scale", "processor ms a frame", "FLIP after 1 frame", "FLIP after 16",
         "relMSE after 16", "relMSE x ms"},
        {}};
    table.note =
        "The street in the evening, 192x108, software GL. FLIP and relMSE of the anti-aliased frame; relMSE x ms: "
        "error at equal time, the less "
        "the better. What does not fall with the rays is the shortcuts' bias: light that bounces off what no frame "
        "shows, half a voxel of shadow. "
        "Scale: of each side, what is traced; the temporal "
        "pass brings it to the whole.";
    const ReferenceView street = streetReference(options, kSize);
    std::vector<Series> series;
    std::vector<std::pair<double, double>> cloud;
    double oneRay = 0.0, best = 1e30;
    std::string bestAtEqualTime;
    const std::vector<Setting> all = settingsOf(options);
    std::vector<std::unique_ptr<LightBench>> benches;
    std::vector<Difference> first;
    const float exposure = street.scene.snapshot.environment.exposure;
    const auto differenceTo = [&](const LightBench& bench) {
        return differenceOf(street.referenceImage, bench.read("resolved"), exposure);
    };
    for (const Setting& setting : all) {
        RenderSettings settings = reference::comparedSettings();
        settings.skyRays = settings.sunRays = setting.rays;
        settings.skyDistance = setting.length;
        settings.noise = setting.noise;
        settings.resolutionScale = setting.scale;
        benches.push_back(std::make_unique<LightBench>(street.scene.snapshot, street.scene.view, kSize, settings));
        benches.back()->draw();
        first.push_back(differenceTo(*benches.back()));
        benches.back()->resetTimes();
    }
    for (int i = 1; i < kFrames; ++i)  // in turns: what else the machine does meets all alike
        for (const auto& bench : benches) bench->draw();
    for (size_t i = 0; i < all.size(); ++i) {
        const Setting& setting = all[i];
        const Difference later = differenceTo(*benches[i]);
        const double ms = benches[i]->ms();
        table.add({std::to_string(setting.rays), fmt::format("{:g}", setting.length),
                   setting.noise == Noise::Blue ? "blue" : "white", fmt::format("{:g}", setting.scale),
                   fmt::format("{:.1f}", ms), fmt::format("{:.4f}", first[i].flip), fmt::format("{:.4f}", later.flip),
                   fmt::format("{:.5f}", later.relative), fmt::format("{:.3f}", later.relative * ms)});
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
        "Balanced (1 ray of {:g} m, blue noise) comes to a FLIP of {:.4f}; the least error at equal time has {}.",
        kBalancedLength, oneRay, bestAtEqualTime);
    writePlot(options, "T8", "Rays: FLIP after 16 frames, by what a frame takes", "processor ms a frame", "FLIP",
              series);
    return table;
}

}  // namespace rubble::tradeoff
