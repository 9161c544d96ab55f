#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "runtime/plugin/frame_loop.h"
#include "samples/scenes/placement.h"
#include "samples/scenes/surface_styles.h"
#include "samples/scenes/test_scenes.h"
#include "tests/tradeoff/destruction.h"

namespace rubble::tradeoff {
namespace {

constexpr int kSteps = 120, kQuietSteps = 60;
constexpr uint32_t kUnlimited = std::numeric_limits<uint32_t>::max();

/// A yard that uses each feature: a brick wall is blown up, a timber hut burns, a concrete canopy loses posts, and
/// paint is sprayed.
Level yard() {
    using namespace scenes;
    Level level = makeWall();
    Canvas hut({24, 20, 24});
    hut.box(ivec3(0), {24, 20, 24}, hut.addSurface(kTimber));
    hut.clear({2, 2, 2}, {22, 18, 22});
    hut.clear({8, 0, 0}, {16, 14, 2});
    addStatic(level, hut.finish("hut"), {6, 0, 6});
    Canvas canopy({44, 16, 24});
    const Swatch concrete = canopy.addSurface(kConcrete);
    canopy.box({0, 12, 0}, {44, 16, 24}, concrete);
    for (const int x : {0, 40})
        for (const int z : {0, 20}) canopy.box({x, 0, z}, {x + 4, 12, z + 4}, concrete);
    addStatic(level, canopy.finish("canopy"), {34, 0, 6});
    return level;
}

struct Variant {
    const char* feature;
    const char* state;
    std::function<void(WorldSettings&, FrameLoopSettings&)> set = [](WorldSettings&, FrameLoopSettings&) {};
    bool fragments = true, sprays = true, paintedBefore = false;
};

Edits blast(glm::dvec3 position, double size, bool fragments) {
    if (fragments) return {ExplodeEdit{position, size}};
    return {CarveEdit{.position = position, .radii = {size, 0.7 * size, 0.4 * size}}};
}

Edits script(int step, const Variant& variant, uint64_t seed) {
    if (step == 5) return blast({3.2, 1.0, 4.0}, 1.6, variant.fragments);
    if (step == 10) return {HeatEdit{.position = {1.2, 0.6, 1.2}, .radius = 0.9, .joules = 4e6, .ignite = true}};
    if (step == 20 || step == 22) return blast({7.6, 0.4, step == 20 ? 0.8 : 2.8}, 1.6, variant.fragments);
    if (step < 30 || step >= 90 || !variant.sprays) return {};
    PaintEdit spray{.position = {2.2 + (step - 30) * 0.06, 0.4 + step % 5 * 0.4, 3.9},
                    .radius = 0.4,
                    .strength = 96,
                    .seed = uint32_t(seed) + uint32_t(step)};
    spray.color = {uint8_t(step / 15 * 30), 40, uint8_t(255 - step / 15 * 30)};
    return {spray};
}

struct Run {
    double stepMs = 0.0;
    std::vector<double> quietUs, busyMs;
    uint64_t early = 0, removed = 0, pieces = 0, cracks = 0, fires = 0, painted = 0, merges = 0, particles = 0;
    size_t left = 0;
};

void note(Run& run, FrameLoop& loop) {
    const FrameChanges& changes = loop.changes();
    for (const RemovedVoxels& each : changes.removed) run.removed += each.count;
    for (const ShapeSplit& split : changes.splits) run.pieces += split.children.size();
    run.cracks += changes.cracks.size();
    run.fires += changes.firesLit.size();
    run.painted += changes.paintedVoxels;
    run.merges += changes.paintMerges;
}

Run simulate(const Level& level, const Variant& variant, uint64_t seed) {
    FrameLoopSettings loopSettings;
    loopSettings.shadowVolume = false;
    loopSettings.particles.maxAlive = 0;
    WorldSettings settings;
    settings.stress.on = true;
    settings.stress.strengthScale = 0.7;
    settings.paint.mode = PaintMode::Layer;
    settings.debris.awakeBodies = 60;
    settings.debris.bodies = 150;
    variant.set(settings, loopSettings);
    FrameLoop loop(loopSettings);
    loop.world().setSettings(settings);
    loop.load(level);
    if (variant.paintedBefore)
        for (double x = 0.5; x < 8.0; x += 1.0)
            for (double z = 0.5; z < 8.0; z += 1.0)
                for (double y = 0.5; y < 3.0; y += 1.0)
                    loop.edits().push(PaintEdit{.position = {x, y, z}, .radius = 1.0, .color = {90, 90, 99}});
    Run run;
    for (int step = 0; step < kQuietSteps; ++step) {  // bodies come to rest, and the stress analysis finishes
        loop.step();
        run.early += loop.changes().cracks.size();
    }
    for (int step = 0; step < kQuietSteps; ++step) {
        double ms = 0.0;
        {
            const ScopedTimer timer(ms);
            loop.step();
        }
        run.quietUs.push_back(ms * 1000.0);
        run.early += loop.changes().cracks.size();
    }
    for (int step = 0; step < kSteps; ++step) {
        loop.edits().push(script(step, variant, seed));
        {
            const ScopedTimer timer(run.busyMs.emplace_back(0.0));
            loop.step();
        }
        run.stepMs += run.busyMs.back() / kSteps;
        note(run, loop);
    }
    loop.world().bodies().forEach([&](BodyHandle, const Body& body) { run.left += !body.isStatic; });
    return run;
}

std::vector<Variant> variants() {
    using W = WorldSettings;
    using L = FrameLoopSettings;
    const auto noBudget = [](W& w, L&) {
        w.debris.awakeBodies = w.debris.bodies = kUnlimited, w.debris.voxels = w.debris.largestPiece = UINT64_MAX;
    };
    return {
        {"stress", "off", [](W& w, L&) { w.stress.on = false; }},
        {"stress", "by rule"},
        {"stress", "always", [](W& w, L&) { w.stress.workPerStep = int64_t(1) << 40; }},
        {"fire", "off", [](W& w, L&) { w.fire.enabled = false; }},
        {"fire", "by rule"},
        {"fire", "always", [](W& w, L&) { w.fire.maxFires = w.fire.maxHot = 1 << 20, w.fire.spread = 4.0f; }},
        {.feature = "paint layer", .state = "off", .sprays = false},
        {"paint layer", "by rule"},
        {.feature = "paint layer", .state = "always", .paintedBefore = true},
        {"paint layer", "blended instead", [](W& w, L&) { w.paint.mode = PaintMode::Blend; }},
        {.feature = "fragments", .state = "off", .fragments = false},
        {"fragments", "by rule"},
        {"fragments", "always",
         [](W& w, L&) {
             w.debris.fragmentsPerBreak = 100'000, w.impactThreshold = 1.0, w.impactSpeed = 0.0, w.impactsPerStep = 64;
         }},
        {"debris budget", "off", noBudget},
        {"debris budget", "by rule"},
        {"debris budget", "always", [](W& w, L&) { w.debris.awakeBodies = w.debris.bodies = 0; }},
        {"particles", "off"},
        {"particles", "by rule", [](W&, L& l) { l.particles.maxAlive = 4096; }},
        {"particles", "always", [](W&, L& l) { l.particles.maxAlive = 1 << 20; }},
    };
}

constexpr const char* kMeaning =
    "stress, always: no limit of work per step; fire, always: no limit of fires, four times the spread; paint, always: "
    "all surfaces have a paint layer from the start; fragments, off: explosions only carve, always: no limit, and "
    "every contact breaks; debris budget, by rule: 60 awake and 150 in all, always: no debris is kept; particles, "
    "always: no limit";

}  // namespace

Table featureTradeoff(const Options& options) {
    Table table{"T12",
                fmt::format("cost and effect of each feature of destruction, with the others by rule: {} steps of a "
                            "yard where a wall is blown up, a hut burns, a canopy loses two posts and paint is sprayed",
                            kSteps),
                {"feature", "state", "step ms", "over off", "max step ms", "nothing happens: us per step",
                 "voxels removed", "pieces", "cracks", "fires", "voxels painted", "merged colours", "bodies left"},
                {}};
    table.note = kMeaning;
    const Level level = yard();
    std::vector<Bar> bars;
    uint64_t early = 0;  // cracks before the first edit: expected none
    double off = 0.0, minQuiet = 1e30, maxQuiet = 0.0, most = 0.0;
    std::string costliest;
    const std::vector<Variant> all = variants();
    std::vector<std::vector<Run>> runs(all.size());
    for (int i = 0; i < options.repeats; ++i)  // in alternation: other load on the machine affects all alike
        for (size_t v = 0; v < all.size(); ++v) runs[v].push_back(simulate(level, all[v], options.seed));
    for (size_t v = 0; v < all.size(); ++v) {
        const Variant& variant = all[v];
        const Run& first = runs[v][0];
        std::vector<double> mean, worst, quiet;
        for (const Run& run : runs[v]) {
            mean.push_back(run.stepMs);
            worst.push_back(*std::max_element(run.busyMs.begin(), run.busyMs.end()));
            quiet.push_back(quantile(run.quietUs, 0.5));
        }
        const Measured ms = summary(mean);
        early += first.early;
        if (variant.state == std::string("off")) off = ms.median;
        const double over = (ms.median / off - 1.0) * 100.0;
        if (variant.state == std::string("by rule") && over > most) most = over, costliest = variant.feature;
        minQuiet = std::min(minQuiet, quantile(quiet, 0.5)), maxQuiet = std::max(maxQuiet, quantile(quiet, 0.5));
        table.add({variant.feature, variant.state, ms.text(), fmt::format("{:+.0f} %", over),
                   fmt::format("{:.1f}", quantile(worst, 0.5)), fmt::format("{:.1f}", quantile(quiet, 0.5)),
                   std::to_string(first.removed), std::to_string(first.pieces), std::to_string(first.cracks),
                   std::to_string(first.fires), std::to_string(first.painted), std::to_string(first.merges),
                   std::to_string(first.left)});
        if (variant.state != std::string("blended instead")) bars.push_back({variant.feature, variant.state, ms});
    }
    table.conclusion = fmt::format(
        "While nothing happens, a step costs {:.1f} to {:.1f} us with any feature on ({} cracks before the first "
        "edit). Of the features by rule, {} costs most compared with off: {:+.0f} %.",
        minQuiet, maxQuiet, early, costliest.empty() ? "none" : costliest, most);
    table.failed = maxQuiet > 50.0 || early > 0;
    writeBars(options, "T12", "Features of destruction: off, by rule, always",
              "ms per step, mean of " + std::to_string(kSteps) + " steps", bars);
    return table;
}

}  // namespace rubble::tradeoff
