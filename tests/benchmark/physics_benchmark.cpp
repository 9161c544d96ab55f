// Steps of PhysicsWorld with piles of pieces, compared with Bullet where the name says so.
#include <benchmark/benchmark.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <string>

#include "runtime/core/thread_pool.h"
#include "tests/benchmark/pile.h"
#include "tests/physics/baseline/box_merge.h"
#include "tests/physics/baseline/bullet_compounds.h"
#include "tests/physics/baseline/overlap.h"
#include "tests/physics/baseline/pile_support.h"
#include "tests/physics/baseline/voronoi_pit.h"
#include "tests/support/allocation_count.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

void reportPile(benchmark::State& state, const std::string& who, const std::vector<double>& ms, const Level& level,
                const std::vector<Pose>& poses) {
    const Overlaps overlaps = measureOverlaps(level, poses);
    state.counters[who + "_ms"] = median(ms);
    state.counters[who + "_p99_ms"] = percentile(ms, 99);
    state.counters[who + "_deep_mean_mm"] = overlaps.mean * 1000;
    state.counters[who + "_deep_median_mm"] = overlaps.median * 1000;
    state.counters[who + "_deep_worst_voxels"] = overlaps.worst * 10;
    state.counters[who + "_height_m"] = overlaps.middle;
}

/// Height and overlap of a pile compared with a nearly converged one: Bullet with 8 substeps of 30 iterations.
void convergedPile(benchmark::State& state) {
    const Level level = voronoiPit(int(state.range(0)));
    Pile ours(level, sleepless());
    BulletCompounds bullet(level, {.substeps = 8, .iterations = 30});
    std::vector<double> oursMs, bulletMs;
    for (auto _ : state)
        for (int i = 0; i < int(state.range(1)); ++i) {
            oursMs.push_back(cpuMs([&] { ours.step(); }));
            bulletMs.push_back(cpuMs([&] { bullet.step(); }));
        }
    reportPile(state, "ours", oursMs, level, ours.poses());
    reportPile(state, "bullet", bulletMs, level, posesOf(bullet, level));
}
BENCHMARK(convergedPile)->Name("physics/convergedPile")->Args({144, 480})->Unit(benchmark::kMillisecond)->Iterations(1);

/// A pit of pieces, and around it other pieces that sleep on a plain.
Level pitInAPlain(int pieces, int sleepers) {
    Level level = voronoiPit(pieces);
    const int side = int(std::ceil(std::sqrt(double(sleepers))));
    LevelBody plain = level.bodies[0];
    plain.pose.position = {20.0, -0.8, 0.0};
    plain.shapes[0].grid = solidGridOfSharedBricks({side * 20, 8, side * 20}, 7);
    for (int i = 0; i < sleepers; ++i) {
        LevelBody body = level.bodies[1 + size_t(i % pieces)];
        body.pose = {{20.2 + (i % side) * 1.98, 0.0, 0.2 + (i / side) * 1.98}, {1, 0, 0, 0}};
        level.bodies.push_back(std::move(body));
    }
    level.bodies.push_back(std::move(plain));
    return level;
}

/// Processor time of a step with 10,000 pieces, some of which are awake. The mean over all steps says little: when the
/// pieces lie, their contacts are kept. So the steps in which all tumble are also compared with each other.
void awakeAmongSleepers(benchmark::State& state) {
    const int awake = int(state.range(0));
    constexpr std::ptrdiff_t kTumbling[2] = {60, 150}, kLying[2] = {360, 480};
    Pile pile(pitInAPlain(awake, 10'000 - awake), sleepless(), size_t(awake) + 1);
    std::vector<double> ms;
    for (auto _ : state) {
        for (int i = 0; i < 480; ++i) ms.push_back(cpuMs([&] { pile.step(); }));
        state.SetIterationTime(median(ms) * 1e-3);
    }
    const auto stepsOf = [&](const std::ptrdiff_t(&phase)[2]) {
        return std::vector<double>(ms.begin() + phase[0], ms.begin() + phase[1]);
    };
    const std::vector<double> tumbling = stepsOf(kTumbling);
    state.counters["p99_ms"] = percentile(ms, 99);
    state.counters["mean_ms"] = mean(ms);
    state.counters["p99_to_mean"] = percentile(ms, 99) / mean(ms);
    state.counters["tumbling_mean_ms"] = mean(tumbling);
    state.counters["tumbling_p99_to_mean"] = percentile(tumbling, 99) / mean(tumbling);
    state.counters["lying_mean_ms"] = mean(stepsOf(kLying));
    state.counters["bodies"] = pile.physics.stats().bodies;
    state.counters["awake"] = pile.physics.stats().awake;
}
BENCHMARK(awakeAmongSleepers)
    ->Name("physics/awakeAmongSleepers")
    ->Arg(250)
    ->Arg(500)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->UseManualTime();

void sleepers(benchmark::State& state) {
    Pile pile(pitInAPlain(1, int(state.range(0)) - 1), {}, 0);
    pile.step();
    const size_t before = allocationCount();
    size_t steps = 0;
    for (auto _ : state) {
        pile.physics.step();
        ++steps;
    }
    state.counters["allocations"] = double(allocationCount() - before) / double(steps);
    state.counters["awake"] = pile.physics.stats().awake;
}
BENCHMARK(sleepers)->Name("physics/sleepers")->Arg(10'000)->Unit(benchmark::kMicrosecond);

/// The first line of a file; empty: there is none.
std::string firstLineOf(const char* path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
}

/// The same pile with one and with two threads in alternation, in wall-clock time: meaningless on a busy machine. The
/// first call of parallelFor in a step is the bodies' bounds, the second the narrowphase; later calls are the solver's.
void twoThreads(benchmark::State& state) {
    const Level level = voronoiPit(int(state.range(0)));
    double narrow[2] = {0.0, 0.0};
    int calls[2] = {0, 0};  // in this step
    const auto timeNarrowphase = [&](size_t k, auto&& f) { ++calls[k] == 2 ? void(narrow[k] = wallMs(f)) : f(); };
    ThreadPool pool(2);
    PhysicsSettings settings[2] = {sleepless(), sleepless()};
    settings[0].parallelFor = [&](size_t count, const std::function<void(size_t)>& f) {
        timeNarrowphase(0, [&] { serialFor(count, f); });
    };
    settings[1].parallelFor = [&](size_t count, const std::function<void(size_t)>& f) {
        timeNarrowphase(1, [&] { pool.run(count, f); });
    };
    Pile one(level, settings[0]), two(level, settings[1]);
    std::vector<double> narrowMs[2], stepMs[2];
    for (auto _ : state)
        for (int i = 0; i < 360; ++i) {
            calls[0] = calls[1] = 0;
            stepMs[0].push_back(wallMs([&] { one.physics.step(); }));
            stepMs[1].push_back(wallMs([&] { two.physics.step(); }));
            for (const size_t k : {0, 1}) narrowMs[k].push_back(narrow[k]);
        }
    state.counters["narrowphase_1_ms"] = median(narrowMs[0]);
    state.counters["narrowphase_2_ms"] = median(narrowMs[1]);
    state.counters["step_1_ms"] = median(stepMs[0]);
    state.counters["step_2_ms"] = median(stepMs[1]);
    state.counters["narrowphase_ratio"] = median(narrowMs[0]) / median(narrowMs[1]);
    state.counters["step_ratio"] = median(stepMs[0]) / median(stepMs[1]);
    state.SetLabel("load " + firstLineOf("/proc/loadavg") + "; processors in the core of the first: " +
                   firstLineOf("/sys/devices/system/cpu/cpu0/topology/thread_siblings_list"));
}
BENCHMARK(twoThreads)->Name("physics/twoThreads")->Arg(500)->Unit(benchmark::kMillisecond)->Iterations(1);

/// Seconds from the landing of the last piece (no piece is faster than 3 m/s) until 99 % of the pieces sleep, and how
/// many then sleep without support. Then a hole of 3 x 3 m is cut into the floor: how many pieces above it wake within
/// a step, and how many sleep without support in the end.
void sleepingPile(benchmark::State& state) {
    const int pieces = int(state.range(0));
    Pile pile(voronoiPit(pieces, 1, int(state.range(1))), {});
    double slept = 0.0, landed = 0.0;
    const auto settle = [&] {
        for (int i = 0; i < 2400 && pile.physics.stats().awake; ++i) {
            pile.step();
            const double now = double(i + 1) / 60.0;
            if (pile.physics.stats().awake * 100 > pieces) slept = now;
            for (const BodyPose& moved : pile.physics.poses())
                if (glm::length(moved.velocity) > 3.0) landed = now;
        }
    };
    for (auto _ : state) {
        settle();
        state.counters["landed_s"] = landed;
        state.counters["asleep_99_after_s"] = slept - landed;
        state.counters["awake"] = pile.physics.stats().awake;
        state.counters["floating"] = double(findUnsupported(pile.world).size());

        const double middle = 0.5 * double(state.range(1));
        const glm::dvec3 low(middle - 1.5, -0.85, middle - 1.5), high(middle + 1.5, 0.0, middle + 1.5);
        const std::vector<BodyHandle> held = findTouching(pile.world, low, high);
        CarveEdit hole{.kind = BrushKind::Box, .position = 0.5 * (low + high), .halfSize = 0.5 * (high - low)};
        hole.shape = pile.world.bodies().at(pile.handles[0]).shapes[0];
        pile.physics.apply(pile.world.applyEdits({hole}), pile.world);
        pile.step();
        state.counters["resting_on_hole"] = double(held.size());
        state.counters["woken_of_those"] = double(std::count_if(
            held.begin(), held.end(), [&](BodyHandle body) { return !pile.world.bodies().at(body).asleep; }));
        settle();
        state.counters["floating_after"] = double(findUnsupported(pile.world).size());
    }
}
BENCHMARK(sleepingPile)
    ->Name("physics/sleepingPile")
    ->Args({500, 8})
    ->Args({5000, 16})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

/// Cuts of a body of 256^3 voxels among moving pieces: the time that physics takes to apply a cut's journal.
void cutOfALargeBody(benchmark::State& state) {
    Level level = voronoiPit(100, 1, 40);
    LevelBody block = level.bodies[1];
    block.shapes[0].grid = solidGridOfSharedBricks(glm::ivec3(256), 7);
    block.pose = {{7.0, 0.0, 7.0}, {1, 0, 0, 0}};
    level.bodies.push_back(std::move(block));
    Pile pile(level, sleepless());
    for (int i = 0; i < 120; ++i) pile.step();
    std::vector<double> cutMs, physicsMs, stepMs;
    for (auto _ : state)
        for (int i = 0; i < 60; ++i) {
            const BodyHandle body = pile.handles.back();
            const glm::dvec3 at =
                pile.world.bodies().at(body).pose.transformPoint({(i % 10) * 2.5, 25.6, (i / 10) * 4.0});
            const CarveEdit cut{.kind = BrushKind::Sphere,
                                .position = at,
                                .radii = {0.6, 0.6, 0.6},
                                .shape = pile.world.bodies().at(body).shapes[0]};
            FrameChanges changes;
            cutMs.push_back(cpuMs([&] { changes = pile.world.applyEdits({cut}); }));
            physicsMs.push_back(cpuMs([&] { pile.physics.apply(changes, pile.world); }));
            stepMs.push_back(cpuMs([&] { pile.step(); }));
        }
    state.counters["cut_ms"] = median(cutMs);
    state.counters["physics_ms"] = median(physicsMs);
    state.counters["physics_p99_ms"] = percentile(physicsMs, 99);
    state.counters["step_ms"] = median(stepMs);
}
BENCHMARK(cutOfALargeBody)->Name("physics/cutOfALargeBody")->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace rubble
