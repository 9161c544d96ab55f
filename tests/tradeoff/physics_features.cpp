#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/physics/baseline/voronoi_pit.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/tradeoff/physics.h"
#include "tests/tradeoff/valgrind_counts.h"

namespace rubble::tradeoff {
namespace {

using namespace known;

constexpr int kSteps = 90;
constexpr double kMinGainKept = 0.9, kMaxCostShare = 0.3,
                 kNegligible = 0.005;       ///< promised shares; negligible extra cost
constexpr double kMaxUnneededCost = 0.001;  ///< allowed cost in a scene that does not need the feature

struct State {
    const char *feature, *state;
    std::function<void(PhysicsSettings&)> set;
};

const std::vector<State>& states() {
    using S = PhysicsSettings;
    static const std::vector<State> all{
        {"conserving rotation", "off", [](S& s) { s.rotation = RotationRule::Never; }},
        {"conserving rotation", "by rule", [](S&) {}},
        {"conserving rotation", "always", [](S& s) { s.rotation = RotationRule::Always; }},
        {"continuous collision", "off", [](S& s) { s.continuous = false; }},
        {"continuous collision", "by rule", [](S&) {}},
        {"continuous collision", "always", [](S& s) { s.sweepThreshold = -1.0; }},
        {"heavy passes", "off", [](S& s) { s.loadBearingPasses = 0; }},
        {"heavy passes", "by rule", [](S&) {}},
        {"heavy passes", "always", [](S& s) { s.loadBearingRatio = 0.0; }},
        {"sleep", "off", [](S& s) { s.sleepTime = 1e9; }},
        {"sleep", "by rule", [](S&) {}},
    };
    return all;
}

PhysicsSettings settingsOf(const State& state) {
    PhysicsSettings settings;
    state.set(settings);
    return settings;
}

/// A level that uses each feature: pieces tumble into a pit, with shots among them, and an anvil lands on all.
Level yard() {
    Level level = voronoiPit(36);
    const auto add = [&](glm::ivec3 size, glm::dvec3 corner, uint8_t entry) -> LevelBody& {
        LevelBody body;
        body.name = "thrown";
        body.pose.position = corner;
        LevelShape shape;
        shape.name = body.name;
        shape.palette = level.bodies[0].shapes[0].palette;
        shape.grid = solidGrid(size, entry);
        body.shapes.push_back(std::move(shape));
        body.isStatic = false;
        level.bodies.push_back(std::move(body));
        return level.bodies.back();
    };
    add(glm::ivec3(16), {3.2, 2.6, 3.2}, 7);
    for (int i = 0; i < 4; ++i) add(glm::ivec3(2), {1.0 + i, 8.0, 2.0 + i}, 7).velocity = {5.0 * i, -60.0, 0.0};
    return level;
}

void runYard(const PhysicsSettings& settings, int steps) {
    PhysicsScene scene(settings);
    scene.level = yard();
    scene.load();
    scene.step(steps);
}

/// Most bodies need no feature: 64 cubes in towers. Among them are two tumbling planks, two shots, and one cube that
/// supports a hundred times its mass.
void runMixed(const PhysicsSettings& settings, int steps) {
    PhysicsScene scene(sleepless(settings));
    const uint8_t light = setMaterial(scene, 7, 0.6f, 0.0f, 20), heavy = setMaterial(scene, 8, 0.6f, 0.0f, 2000);
    scene.add(solidGrid({200, 80, 200}, 7), {-10, -8, -10},
              true);  // so thick that shots stay in it in every state
    const auto addCube = [&](glm::dvec3 corner, uint8_t entry) {
        scene.add(solidGrid({5, 5, 5}, entry), corner, false);
    };
    for (int i = 0; i < 64; ++i) addCube({i % 4 * 0.8, 0.5 * (i / 16), i / 4 % 4 * 0.8}, light);
    addCube({-2, 0, 0}, light);
    addCube({-2, 0.5, 0}, heavy);
    for (int i = 0; i < 2; ++i) {
        LevelBody& plank = scene.add(solidGrid({24, 5, 2}, light), {6.0, 2.0, 4.0 * i}, false);
        plank.velocity = {0, 8, 0}, plank.angularVelocity = {6, 9, 5};
        scene.add(solidGrid({2, 2, 2}, light), {-5, 20.0, 4.0 * i}, false).velocity = {0, -60, 0};
    }
    scene.load();
    scene.step(steps);
}

/// Towers of equal cubes at rest, which need no feature.
void runTowers(const PhysicsSettings& settings, int steps) {
    PhysicsScene scene(sleepless(settings));
    scene.addFloor();
    for (int i = 0; i < 64; ++i)
        scene.add(solidGrid({5, 5, 5}, 7), {i % 4 * 0.8, 0.5 * (i / 16), i / 4 % 4 * 0.8}, false);
    scene.load();
    scene.step(steps);
}

/// Mean distance in mm that the resting pieces of the yard creep in 2 s.
double creep(const PhysicsSettings& settings) {
    PhysicsScene scene(settings);
    scene.level = yard();
    scene.load();
    scene.seconds(12.0);
    std::vector<glm::dvec3> before;
    const int count = int(scene.level.bodies.size());
    for (int i = 1; i < count; ++i) before.push_back(scene.center(i));
    scene.seconds(2.0);
    double sum = 0.0;
    for (int i = 1; i < count; ++i) sum += glm::length(scene.center(i) - before[size_t(i - 1)]);
    return sum * 1e3 / (count - 1);
}

/// The error that each feature reduces.
struct Purpose {
    const char* feature;
    const char* what;
    double (*error)(const PhysicsSettings&, uint64_t seed);
};
constexpr Purpose kPurposes[] = {
    {"conserving rotation", "direction of a plank's momentum after 20 s, rad",
     [](const PhysicsSettings& s, uint64_t) {
         return spinFreely(s, solidGrid({24, 5, 2}, 7), {6, 9, 5}, 20.0).direction;
     }},
    {"continuous collision", "shots of up to 300 m/s through a wall, %",
     [](const PhysicsSettings& s, uint64_t seed) {
         const Shots shots = shoot(s, 300, seed, 300.0);
         return 100.0 * shots.through / shots.fired;
     }},
    {"heavy passes", "100 times as heavy a body sinks in, mm",
     [](const PhysicsSettings& s, uint64_t) { return sink(s, 100.0) * 1e3; }},
    {"sleep", "resting pieces creep, mm in 2 s", [](const PhysicsSettings& s, uint64_t) { return creep(s); }},
};

struct Figures {
    Measured cost;
    double inPit = 0.0;  ///< instructions
    double error = 0.0;
};

using States = std::map<std::string, Figures>;  ///< of one feature, by the name of the state

std::string noteText(bool counts) {
    return fmt::format(
        "Cost: {} steps of 64 cubes that stand in towers, two planks that tumble, two shots and a cube under one a "
        "hundred times as heavy{}. Where all need it (with --full): 36 pieces, four shots and an anvil that fall into "
        "a pit. Promised: the rule keeps {:.0f} % of the accuracy that always on gains, for {:.0f} % of its extra cost "
        "over off or for a negligible cost ({:.1f} %).",
        kSteps,
        counts ? ", instructions counted by valgrind: the same on every run"
               : " (processor time: valgrind is not installed)",
        kMinGainKept * 100.0, kMaxCostShare * 100.0, kNegligible * 100.0);
}

const Purpose& purposeOf(const char* feature) {
    return *std::find_if(std::begin(kPurposes), std::end(kPurposes),
                         [&](const Purpose& each) { return each.feature == std::string(feature); });
}

/// Cost and error of a feature in one state. `loading`: instructions of loading the scene, 0 without valgrind.
Figures measureState(const Options& options, const State& state, const Purpose& purpose, double loading,
                     double loadingPit) {
    const PhysicsSettings settings = settingsOf(state);
    Figures figures;
    if (loading > 0.0) {
        const std::string name = std::string(state.feature) + ", " + state.state;
        const double millions = (instructionsOf(name) - loading) / 1e6;
        figures.cost = {millions, millions, millions};
        if (options.full) figures.inPit = instructionsOf("pit: " + name) - loadingPit;
    } else {
        figures.cost = measure(options.repeats, [&] { return cpuMs([&] { runMixed(settings, kSteps); }); });
    }
    figures.error = purpose.error(settings, options.seed);
    return figures;
}

/// Whether the rule keeps the promised share of the accuracy at the promised cost.
void judgeRule(const std::string& feature, const States& of, Table& table) {
    const Figures &off = of.at("off"), &rule = of.at("by rule"), &always = of.at("always");
    const double gain = off.error - always.error, kept = gain > 0.0 ? (off.error - rule.error) / gain : 1.0;
    const double ruleCost = rule.cost.median - off.cost.median, alwaysCost = always.cost.median - off.cost.median;
    const bool holds =
        kept >= kMinGainKept && (ruleCost <= kMaxCostShare * alwaysCost || ruleCost <= kNegligible * off.cost.median);
    table.failed |= !holds;
    table.conclusion +=
        fmt::format("{}: the rule keeps {:.1f} % of the accuracy for {:+.2f} % where always on costs {:+.2f} %{}. ",
                    feature, kept * 100.0, ruleCost / off.cost.median * 100.0, alwaysCost / off.cost.median * 100.0,
                    holds ? "" : ": NOT AS PROMISED");
}

/// What the rule costs in a scene that does not need the feature.
void addUnneededRow(const std::string& feature, Table& table) {
    const double without = instructionsOf("towers: " + feature + ", off"),
                 with = instructionsOf("towers: " + feature + ", by rule");
    const double unneeded = with / without - 1.0;
    table.add({feature, "not needed", fmt::format("{:.2f}", with / 1e6), fmt::format("{:+.3f}", unneeded * 100.0), "-",
               "-", "towers of equal cubes"});
    table.failed |= unneeded > kMaxUnneededCost;
    table.conclusion += fmt::format("In a scene that does not need it, it costs {:+.3f} %{}. ", unneeded * 100.0,
                                    unneeded > kMaxUnneededCost ? ": NOT AS PROMISED" : "");
}

}  // namespace

bool runFeatureScene(const std::string& setting) {
    if (setting == "nothing used") return runWithoutFeatures(), true;
    if (setting == "nothing") return runMixed({}, 0), true;
    if (setting == "pit: nothing") return runYard({}, 0), true;
    for (const State& state : states()) {
        const std::string name = std::string(state.feature) + ", " + state.state;
        if (setting == name) return runMixed(settingsOf(state), kSteps), true;
        if (setting == "pit: " + name) return runYard(settingsOf(state), kSteps), true;
        if (setting == "towers: " + name) return runTowers(settingsOf(state), kSteps), true;
    }
    return false;
}

Table physicsFeatureTradeoff(const Options& options) {
    const double loading = instructionsOf("nothing"), loadingPit = options.full ? instructionsOf("pit: nothing") : 0.0;
    const bool counts = loading > 0.0;
    Table table{"T12-physics",
                "cost and benefit of each feature of physics, with the others by rule",
                {"feature", "state", counts ? "million instructions" : "ms", "over off %",
                 "where all need it: over off %", "error", "of what"},
                {}};
    table.note = noteText(counts);
    std::vector<Bar> bars;
    std::map<std::string, std::map<std::string, Figures>> all;
    for (const State& state : states()) {
        const Purpose& purpose = purposeOf(state.feature);
        Figures& figures = all[state.feature][state.state];
        figures = measureState(options, state, purpose, loading, loadingPit);
        const Figures& off = all[state.feature]["off"];
        const double over = figures.cost.median / off.cost.median - 1.0, overInPit = figures.inPit / off.inPit - 1.0;
        table.add({state.feature, state.state,
                   counts ? fmt::format("{:.2f}", figures.cost.median) : figures.cost.text(),
                   fmt::format("{:+.2f}", over * 100.0),
                   figures.inPit > 0.0 ? fmt::format("{:+.2f}", overInPit * 100.0) : "-",
                   fmt::format("{:.3g}", figures.error), purpose.what});
        bars.push_back({state.feature, state.state, {over * 100.0, over * 100.0, over * 100.0}});
    }
    for (const auto& [feature, of] : all) {
        if (!of.count("always")) continue;
        judgeRule(feature, of, table);
        if (counts) addUnneededRow(feature, table);
    }
    writeBars(options, "T12-physics", "Features of physics: off, by rule, always",
              counts ? "instructions over off, %" : "processor time over off, %", bars);
    return table;
}

}  // namespace rubble::tradeoff
