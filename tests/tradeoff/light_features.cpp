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
    {"second bounce", [](RenderSettings& s) { s.bounces = 1; }},
    {"temporal", [](RenderSettings& s) { s.temporal = false; }},
    {"filter", [](RenderSettings& s) { s.filterPasses = 0; }},
    {"forgetting", [](RenderSettings& s) { s.rejectStaleHistory = false; }},
    {"bloom", [](RenderSettings& s) { s.bloom = 0.0f; }},
};

/// Draws frames of all renderers in alternation: other load on the machine affects all alike.
std::vector<std::unique_ptr<LightBench>> drawAll(const ReferenceView& street) {
    std::vector<std::unique_ptr<LightBench>> benches;
    benches.push_back(
        std::make_unique<LightBench>(street.scene.snapshot, street.scene.view, kSize, reference::comparedSettings()));
    for (const Feature& feature : kFeatures) {
        RenderSettings settings = reference::comparedSettings();
        feature.off(settings);
        benches.push_back(std::make_unique<LightBench>(street.scene.snapshot, street.scene.view, kSize, settings));
    }
    for (int i = 0; i < kFrames; ++i)
        for (const auto& bench : benches) bench->draw();
    return benches;
}

}  // namespace

Table lightFeatureTradeoff(const Options& options) {
    Table table{"T12-light",
                "features of light: cost of each, and error of the frame without it",
                {"off", "processor ms per frame", "ms saved", "MB of textures", "draw calls", "FLIP", "relMSE"},
                {}};
    table.note =
        "The street in the evening, 192x108, 16 frames, against the reference. Each row turns one feature off. Passes "
        "and targets of a feature exist only while the scene needs it; tests/render counts them.";
    const ReferenceView street = streetReference(options, kSize);
    const auto benches = drawAll(street);
    const double all = benches[0]->ms();
    const auto differenceTo = [&](const LightBench& bench) {
        return differenceOf(street.referenceImage, bench.read("resolved"), street.scene.snapshot.environment.exposure);
    };
    const Difference best = differenceTo(*benches[0]);
    std::vector<Bar> bars;
    double most = 0.0;
    std::string costliest;
    for (size_t i = 0; i < benches.size(); ++i) {
        const char* name = i ? kFeatures[i - 1].name : "nothing";
        const Difference difference = i ? differenceTo(*benches[i]) : best;
        const double ms = benches[i]->ms();
        table.add({name, fmt::format("{:.1f}", ms), fmt::format("{:.1f}", all - ms),
                   fmt::format("{:.2f}", double(benches[i]->stats().textureBytes) * 1e-6),
                   std::to_string(benches[i]->stats().drawCalls), fmt::format("{:.4f}", difference.flip),
                   fmt::format("{:.5f}", difference.relative)});
        if (all - ms > most) most = all - ms, costliest = name;
        if (i == 0) continue;
        bars.push_back({name, "FLIP without", {difference.flip, difference.flip, difference.flip}});
        bars.push_back({name, "FLIP with", {best.flip, best.flip, best.flip}});
    }
    table.conclusion = fmt::format("All on: {:.1f} ms and a FLIP of {:.4f}; costliest is {}: {:.1f} ms.", all,
                                   best.flip, costliest, most);
    writeBars(options, "T12-light", "Error of the frame without each feature", "FLIP", bars);
    return table;
}

}  // namespace rubble::tradeoff
