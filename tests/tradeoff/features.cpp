#include <fmt/format.h>

#include "runtime/plugin/frame_loop.h"
#include "samples/scenes/scene.h"
#include "tests/tradeoff/destruction.h"

namespace rubble::tradeoff {
namespace {

struct Variant {
    const char* feature;
    const char* state;
    std::function<void(WorldSettings&, FrameLoopSettings&)> set;
};

struct Run {
    double stepMs = 0.0;
    uint64_t removed = 0, pieces = 0;
};

Run simulate(const Scene& scene, const Level& level, const Variant& variant, int steps, uint64_t seed) {
    FrameLoopSettings loopSettings;
    loopSettings.shadowVolume = false;
    loopSettings.particles.most = 0;
    WorldSettings settings = scene.settings;
    settings.load.on = false;
    variant.set(settings, loopSettings);
    FrameLoop loop(loopSettings);
    loop.world().setSettings(settings);
    loop.load(level);
    Run run;
    for (int step = 0; step < steps; ++step) {
        loop.edits().push(scene.script(step, seed));
        double ms = 0.0;
        {
            const ScopedTimer timer(ms);
            loop.step();
        }
        run.stepMs += ms / steps;
        for (const RemovedVoxels& each : loop.changes().removed) run.removed += each.count;
        for (const ShapeSplit& split : loop.changes().splits) run.pieces += split.children.size();
    }
    return run;
}

std::vector<Variant> variants() {
    using W = WorldSettings;
    using L = FrameLoopSettings;
    return {
        {"none", "off", [](W&, L&) {}},
        {"load", "always: no limit of work a step", [](W& w, L&) { w.load.on = true, w.load.workAStep = int64_t(1) << 40; }},
        {"load", "by rule: a budget, only what changed", [](W& w, L&) { w.load.on = true; }},
        {"impact damage", "always: every touch", [](W& w, L&) { w.impactThreshold = 1.0, w.impactSpeed = 0.0, w.impactsAStep = 64; }},
        {"impact damage", "off", [](W& w, L&) { w.impactsAStep = 0; }},
        {"undo", "on: 8 marks", [](W& w, L&) { w.undoMarks = 8; }},
        {"particles", "by rule: only while something flies", [](W&, L& l) { l.particles.most = 4096; }},
        {"shadow volume", "by rule: only what changed", [](W&, L& l) { l.shadowVolume = true, l.shadow = ShadowWorker::Mode::Inline; }},
    };
}

}  // namespace

Table featureTradeoff(const Options& options) {
    Table table{"T12",
                "what each feature of destruction costs and does: the rule 'only what the scene needs'; the first row has all that can be off, off",
                {"scene", "feature", "state", "step ms", "over off", "voxels removed", "pieces"},
                {}};
    const std::vector<std::string_view> names =
        options.full ? std::vector<std::string_view>{"wall", "tower", "bridge", "fire"} : std::vector<std::string_view>{"bridge"};
    for (const std::string_view name : names) {
        const Scene& scene = *findScene(name);
        const Level level = scene.level(options.seed);
        const int steps = options.full ? scene.steps : 150;
        double off = 0.0;
        for (const Variant& variant : variants()) {
            Run last;
            const Measured ms = measure(options.repeats(), [&] {
                last = simulate(scene, level, variant, steps, options.seed);
                return last.stepMs;
            });
            if (off == 0.0) off = ms.median;
            table.add({std::string(name), variant.feature, variant.state, ms.text(), fmt::format("{:+.0f} %", (ms.median / off - 1.0) * 100.0),
                       std::to_string(last.removed), std::to_string(last.pieces)});
        }
    }
    return table;
}

}  // namespace rubble::tradeoff
