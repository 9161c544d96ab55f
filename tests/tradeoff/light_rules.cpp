#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "generated/paths.h"
#include "tests/golden/lit_scene.h"
#include "tests/tradeoff/light.h"
#include "tests/tradeoff/light_bench.h"

namespace rubble::tradeoff {
namespace {

constexpr glm::ivec2 kSize(192, 108);
constexpr int kFrames = 16;

/// A rule is a line of a shader. `always` replaces the line so that the feature is always on.
struct Rule {
    const char* feature;
    const char* words;  ///< the rule in words
    const char* file;
    const char* line;
    const char* always;
    void (*off)(RenderSettings&);
};

const Rule kRules[] = {
    {"mirror rays", "where 1.2 % of the light or more is mirrored", "lib/mirror.glsl", "kMinMirrorShare = 0.012",
     "kMinMirrorShare = -1.0", [](RenderSettings& s) { s.reflections = false; }},
    {"light rays", "every frame where a light may give 0.01, else at random", "passes/local_lights.frag",
     "min(reservoir.weightSum / (kPi * uFullRayRadiance), 1.0)", "min(1.0 + uFullRayRadiance, 1.0)",
     [](RenderSettings& s) { s.localLights = false; }},
    {"wide filter steps", "where there is no history, or noise in spite of it", "passes/filter.frag",
     "centre.z >= kLongHistory", "centre.z >= 1e9", [](RenderSettings& s) { s.filterPasses = 2; }},
};

/// Copies the shaders to a folder and replaces the rule's line. Returns the folder.
std::string shadersWith(const Options& options, const Rule& rule) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::path(options.out) / "always" / fs::path(rule.file).stem();
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    fs::create_directories(folder);
    fs::copy(RUBBLE_SOURCE_DIR "/shaders", folder, fs::copy_options::recursive);
    std::ifstream in(folder / rule.file);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    const size_t at = text.find(rule.line);
    if (at == std::string::npos) fmt::print("{} no longer contains \"{}\"\n", rule.file, rule.line), std::exit(1);
    text.replace(at, std::string(rule.line).size(), rule.always);
    std::ofstream(folder / rule.file) << text;
    return folder.string();
}

/// Costs of lights and mirrors in a scene that has none.
struct Unused {
    double ratio = 0.0;
    int64_t bytes = 0;
    int draws = 0;
};
Unused unusedCost() {
    auto diffuse = std::make_shared<Palette>(*streetPalette());
    for (PaletteEntry& e : *diffuse) e.reflectivity = e.metallic = 0, e.roughness = e.opacity = 255, e.emission = 0.0f;
    LitScene plain(diffuse);
    plain.add({80, 2, 80}, {{-4, -0.2, -4}}, [](glm::ivec3) { return uint8_t(1); });
    Camera camera;
    camera.position = {0, 2, 3};
    camera.lookAt({0, 0, 0});
    RenderSettings on = reference::comparedSettings(), off = on;
    off.localLights = off.reflections = false;
    LightBench with(plain.snapshot(), camera.view(kSize, 0), kSize, on),
        without(plain.snapshot(), camera.view(kSize, 0), kSize, off);
    for (int i = 0; i < 48; ++i) with.draw(), without.draw();
    return {with.ms() / without.ms(), int64_t(with.stats().textureBytes) - int64_t(without.stats().textureBytes),
            with.stats().drawCalls - without.stats().drawCalls};
}

}  // namespace

Table lightRuleTradeoff(const Options& options) {
    Table table{"T12-light-rules",
                "features of light that a rule limits: always on, by rule and off",
                {"feature", "rule", "ms always", "ms by rule", "ms off", "FLIP always", "FLIP by rule", "FLIP off",
                 "cost kept %", "gain kept %"},
                {}};
    table.note =
        "The street in the evening, 192x108, 16 frames, against the reference; processor time. Cost kept and gain "
        "kept: shares of the cost and of the gain of always on. A rule should keep 90 % of the gain for 30 % of the "
        "cost.";
    const ReferenceView street = streetReference(options, kSize);
    int kept = 0;
    for (const Rule& rule : kRules) {
        RenderSettings off = reference::comparedSettings();
        rule.off(off);
        LightBench benches[] = {{street.scene.snapshot, street.scene.view, kSize, reference::comparedSettings(),
                                 shadersWith(options, rule)},
                                {street.scene.snapshot, street.scene.view, kSize, reference::comparedSettings()},
                                {street.scene.snapshot, street.scene.view, kSize, off}};
        for (int i = 0; i < kFrames; ++i)
            for (LightBench& bench : benches) bench.draw();
        double ms[3], flip[3];
        for (int i = 0; i < 3; ++i) {
            ms[i] = benches[i].ms();
            flip[i] = differenceOf(street.referenceImage, benches[i].read("resolved"),
                                   street.scene.snapshot.environment.exposure)
                          .flip;
        }
        const double cost = (ms[1] - ms[2]) / std::max(ms[0] - ms[2], 1e-3),
                     gain = (flip[2] - flip[1]) / std::max(flip[2] - flip[0], 1e-5);
        table.add({rule.feature, rule.words, fmt::format("{:.1f}", ms[0]), fmt::format("{:.1f}", ms[1]),
                   fmt::format("{:.1f}", ms[2]), fmt::format("{:.4f}", flip[0]), fmt::format("{:.4f}", flip[1]),
                   fmt::format("{:.4f}", flip[2]), fmt::format("{:.0f}", cost * 100),
                   fmt::format("{:.0f}", gain * 100)});
        kept += cost <= 0.3 && gain >= 0.9;
    }
    const Unused unused = unusedCost();
    table.conclusion = fmt::format(
        "{} of {} rules keep 90 % of the gain for 30 % of the cost. In a scene without lights and mirrors: {:+.2f} % "
        "of a frame's time, {} bytes of textures, {} draw calls.",
        kept, std::size(kRules), (unused.ratio - 1.0) * 100, unused.bytes, unused.draws);
    table.failed = unused.bytes != 0 || unused.draws != 0;
    return table;
}

}  // namespace rubble::tradeoff
