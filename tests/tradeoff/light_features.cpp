#include <fmt/format.h>

#include "tests/tradeoff/light.h"
#include "tests/tradeoff/light_bench.h"

namespace rubble::tradeoff {
namespace {

constexpr glm::ivec2 kSize(192, 108);
constexpr int kFrames = 16;

struct Feature {
    const char* name;
    void (*off)(RenderSettings&);
};

const Feature kFeatures[] = {
    {"sun", [](RenderSettings& s) { s.sun = false; }},
    {"sky", [](RenderSettings& s) { s.sky = false; }},
    {"local lights", [](RenderSettings& s) { s.localLights = false; }},
    {"reflections", [](RenderSettings& s) { s.reflections = false; }},
    {"bounce", [](RenderSettings& s) { s.bounce = false; }},
    {"temporal", [](RenderSettings& s) { s.temporal = false; }},
    {"filter", [](RenderSettings& s) { s.filterPasses = 0; }},
    {"forgetting", [](RenderSettings& s) { s.forgetsChanges = false; }},
    {"bloom", [](RenderSettings& s) { s.bloom = 0.0f; }},
};

struct Run {
    Difference difference;
    double ms = 0.0;
    uint64_t bytes = 0;
    int draws = 0;
};

Run runOf(const Judged& street, const RenderSettings& settings) {
    LightBench bench(street.scene.snapshot, street.scene.view, kSize, settings);
    bench.draw(kFrames);
    return {differenceOf(street.truth, bench.read("resolved"), street.scene.snapshot.environment.exposure), bench.ms(), bench.figures().textureBytes,
            bench.figures().drawCalls};
}

}  // namespace

Table lightFeatureTradeoff(const Options& options) {
    Table table{"T12-light",
                "features of light: what each takes, and what the picture loses without it",
                {"off", "ms a picture", "ms saved", "MB of textures", "draw calls", "FLIP", "relMSE"},
                {}};
    table.note =
        "The street in the evening, 192x108, 16 pictures, against the truth. Each row turns one feature off. By rule means: its passes and targets "
        "are there "
        "only while the scene has something for it; tests/render counts them.";
    const Judged street = streetTruth(options, kSize);
    const Run all = runOf(street, reference::comparedSettings());
    const auto add = [&](const char* name, const Run& run) {
        table.add({name, fmt::format("{:.1f}", run.ms), fmt::format("{:.1f}", all.ms - run.ms), fmt::format("{:.2f}", double(run.bytes) * 1e-6),
                   std::to_string(run.draws), fmt::format("{:.4f}", run.difference.flip), fmt::format("{:.5f}", run.difference.relative)});
    };
    add("nothing", all);
    std::vector<Bar> bars;
    double most = 0.0;
    std::string dearest;
    for (const Feature& feature : kFeatures) {
        RenderSettings settings = reference::comparedSettings();
        feature.off(settings);
        const Run run = runOf(street, settings);
        add(feature.name, run);
        bars.push_back({feature.name, "FLIP without", {run.difference.flip, run.difference.flip, run.difference.flip}});
        bars.push_back({feature.name, "FLIP with", {all.difference.flip, all.difference.flip, all.difference.flip}});
        if (all.ms - run.ms > most) most = all.ms - run.ms, dearest = feature.name;
    }
    table.bottomLine = fmt::format("All on: {:.1f} ms and a FLIP of {:.4f}; dearest is {}: {:.1f} ms.", all.ms, all.difference.flip, dearest, most);
    writeBars(options, "T12-light", "What the picture loses without each feature", "FLIP", bars);
    return table;
}

}  // namespace rubble::tradeoff
