#include <fmt/format.h>

#include <algorithm>

#include "runtime/plugin/frame_loop.h"
#include "tests/physics/physics_scene.h"
#include "tests/tradeoff/physics.h"
#include "tests/tradeoff/valgrind_counts.h"

namespace rubble::tradeoff {
namespace {

constexpr int kSteps = 120;
constexpr double kNegligible = 0.001;  ///< share of a step

/// The functions of a feature that run in every step, used or not.
struct Stages {
    const char* feature;
    std::vector<const char*> functions;
};
const std::vector<Stages>& stages() {
    static const std::vector<Stages> all{
        {"joints and ropes",
         {"PhysicsJoints::apply", "PhysicsJoints::begin", "PhysicsJoints::wakeJointed", "PhysicsJoints::gather",
          "PhysicsJoints::findBroken", "PhysicsJoints::putToSleep", "PhysicsJoints::moveRopes", "World::setRopes",
          "releaseUnheldJoints", "updateWinches"}},
        {"water", {"WaterVolumes::applyForces", "WaterVolumes::set"}},
        {"characters", {"PhysicsCharacters::move", "World::setCharacters"}},
        {"triggers", {"updateTriggers"}},
        {"collision filters", {"PhysicsBodies::updateFilter"}},
        {"stress", {"openCracks", "runStressAnalysis"}},
        {"fire and heat", {"FireStage::update"}},
        {"light groups", {"updateLightGroups"}},
        {"debris budget", {"enforceDebrisBudgets"}},
    };
    return all;
}

}  // namespace

void runWithoutFeatures() {
    PhysicsScene scene;
    scene.addFloor();
    for (int i = 0; i < 64; ++i)
        scene.add(solidGrid({5, 5, 5}, 7), {i % 4 * 0.8, 0.5 * (i / 16) + 0.1, i / 4 % 4 * 0.8}, false);
    for (LevelBody& body : scene.level.bodies)
        body.velocity = body.isStatic ? glm::vec3(0.0f) : glm::vec3(0.0f, -0.1f, 0.0f);
    FrameLoopSettings settings;
    settings.publish = settings.shadowVolume = false;
    settings.particles.maxAlive = 0;
    settings.physics.sleepTime = 1e9;
    FrameLoop loop(settings);
    loop.load(scene.level);
    for (int i = 0; i < kSteps; ++i) loop.step();
}

Table unusedFeatureTradeoff(const Options& options) {
    Table table{"T12-unused",
                fmt::format("cost of features that a scene does not use: instructions of their stages in {} steps of "
                            "64 standing cubes, and bytes",
                            kSteps),
                {"feature", "instructions per step", "share of all %", "bytes", "stages without a count"},
                {}};
    table.note =
        "Instructions: counted by valgrind's callgrind, each stage with all functions that it calls: the same on every "
        "run. Bytes: all that the stages ever allocated, loading included, counted by valgrind's dhat (without "
        "allocations in tail calls). Stages that were inlined or never called are named; they have no count.";
    const std::map<std::string, double> counts = instructionsByFunction("nothing used");
    const auto whole = counts.find("rubble::FrameLoop::step");
    if (whole == counts.end()) {
        table.conclusion = "Not measured: valgrind is not installed (Debian package valgrind).";
        return table;
    }
    const std::map<std::string, double> bytes = bytesByFunction("nothing used");
    std::vector<Bar> bars;
    double allBytes = 0.0, most = 0.0, sum = 0.0;
    std::string costliest;
    for (const Stages& each : stages()) {
        double count = 0.0, held = 0.0;
        std::string uncounted;
        for (const char* function : each.functions) {
            const std::string name = std::string("rubble::") + function;
            if (const auto at = bytes.find(name); at != bytes.end()) held += at->second;
            const auto at = counts.find(name);
            if (at != counts.end())
                count += at->second;
            else
                uncounted += std::string(uncounted.empty() ? "" : " ") + function;
        }
        const double share = count / whole->second;
        if (share >= most) most = share, costliest = each.feature;
        sum += share;
        allBytes += held;
        table.add({each.feature, fmt::format("{:.0f}", count / kSteps), fmt::format("{:.4f}", share * 100.0),
                   fmt::format("{:.0f}", held), uncounted.empty() ? "-" : uncounted});
        bars.push_back({each.feature, "unused", {share * 100.0, share * 100.0, share * 100.0}});
    }
    table.failed = most > kNegligible || !bytes.contains("rubble::FrameLoop::FrameLoop") || allBytes > 0.0;
    table.conclusion = fmt::format(
        "The costliest unused feature, {}, takes {:.4f} % of a step; all together take {:.4f} % and {:.0f} bytes.",
        costliest, most * 100.0, sum * 100.0, allBytes);
    writeBars(options, "T12-unused", "Unused features", "instructions, % of a step", bars);
    return table;
}

}  // namespace rubble::tradeoff
