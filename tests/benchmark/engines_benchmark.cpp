// One table: time, overlap and height of the same falling pile by engine. Steps alternate, in processor time, without
// sleep. Bullet is compounds of merged boxes, as Debian builds it.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "tests/benchmark/pile.h"
#include "tests/physics/baseline/overlap.h"
#include "tests/physics/baseline/voronoi_pit.h"

namespace rubble {
namespace {

constexpr int kSteps = 480;
/// The steps of the two windows: pieces land; they lie.
constexpr int kLanding[2] = {120, 240}, kLying[2] = {360, 480};

struct Engine {
    std::string name;
    std::function<void()> step;
    std::function<std::vector<Pose>()> poses;
    std::vector<double> ms = {};
    /// Milliseconds of a step, the mean over a window.
    double mean(const int (&window)[2]) const {
        double sum = 0.0;
        for (int i = window[0]; i < window[1]; ++i) sum += ms[size_t(i)];
        return sum / (window[1] - window[0]);
    }
};

Engine ours(const std::string& name, const Level& level, const PhysicsSettings& settings) {
    const auto pile = std::make_shared<Pile>(level, sleepless(settings));
    return {name, [pile] { pile->step(); }, [pile] { return pile->poses(); }};
}
Engine bullet(const std::string& name, const Level& level, int frictionDirections) {
    const auto world =
        std::make_shared<BulletCompounds>(level, BulletCompounds::Settings{.frictionDirections = frictionDirections});
    return {name, [world] { world->step(); }, [world, &level] { return posesOf(*world, level); }};
}

void compare(benchmark::State& state, const std::string& title, const Level& level) {
    std::vector<Engine> engines;
    engines.push_back(bullet("Bullet", level, 1));
    engines.push_back(bullet("Bullet, two friction directions", level, 2));
    engines.push_back(ours("Rubble, fast", level, fastPhysics()));
    engines.push_back(ours("Rubble", level, balancedPhysics()));
    engines.push_back(ours("Rubble, accurate", level, accuratePhysics()));
    for (auto _ : state)
        for (int i = 0; i < kSteps; ++i)
            for (Engine& engine : engines) engine.ms.push_back(cpuMs(engine.step));

    fmt::print("\n{}: ms a step and share of Bullet's, steps {} to {} and {} to {}\n", title, kLanding[0], kLanding[1],
               kLying[0], kLying[1]);
    fmt::print("{:<32} {:>7} {:>6} {:>7} {:>6} {:>7} {:>10} {:>13} {:>8}\n", "", "landing", "share", "lying", "share",
               "p99", "overlap mm", "worst, voxels", "height m");
    for (const Engine& engine : engines) {
        const double landing = engine.mean(kLanding), lying = engine.mean(kLying);
        const double landingShare = landing / engines[0].mean(kLanding), lyingShare = lying / engines[0].mean(kLying);
        const Overlaps overlaps = measureOverlaps(level, engine.poses());
        fmt::print("{:<32} {:>7.1f} {:>6.2f} {:>7.1f} {:>6.2f} {:>7.1f} {:>10.2f} {:>13.2f} {:>8.2f}\n", engine.name,
                   landing, landingShare, lying, lyingShare, percentile(engine.ms, 99), overlaps.mean * 1e3,
                   overlaps.worst * 10, overlaps.middle);
        if (engine.name != "Rubble") continue;
        state.counters["landing_share"] = landingShare;
        state.counters["lying_share"] = lyingShare;
    }
    std::fflush(stdout);
}

void pieces(benchmark::State& state) {
    compare(state, fmt::format("{} Voronoi pieces", state.range(0)), voronoiPit(int(state.range(0))));
}
BENCHMARK(pieces)->Name("physics/engines/pieces")->Arg(144)->Arg(1000)->Unit(benchmark::kMillisecond)->Iterations(1);

void boxes(benchmark::State& state) {
    compare(state, fmt::format("{} boxes of 5x5x5 voxels", state.range(0)), boxPit(int(state.range(0))));
}
BENCHMARK(boxes)->Name("physics/engines/boxes")->Arg(3000)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace rubble
