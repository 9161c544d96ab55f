#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <functional>

#include "physics/physics_world.h"
#include "runtime/world/world.h"
#include "tests/physics/baseline/box_merge.h"
#include "tests/physics/baseline/bullet_compounds.h"
#include "tests/physics/baseline/overlap.h"
#include "tests/physics/baseline/voronoi_pit.h"

namespace rubble {
namespace {

using Clock = std::chrono::steady_clock;

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
    return values[values.size() / 2];
}

/// Ours: all pieces awake from the start, and for good.
struct Pile {
    explicit Pile(const Level& level, PhysicsSettings settings) : physics(settings) {
        world.load(level);
        FrameChanges changes;
        changes.levelReplaced = true;
        physics.apply(changes, world);
        FrameChanges nudge;
        world.bodies().forEach([&](BodyHandle handle, const Body& body) {
            handles.push_back(handle);
            if (!body.isStatic) nudge.impulses.push_back({handle, body.pose.position, glm::dvec3(0.0)});
        });
        physics.apply(nudge, world);
    }
    void step() {
        physics.step();
        world.setPoses(physics.poses());
    }
    std::vector<Pose> poses() const {
        std::vector<Pose> all;
        for (const BodyHandle handle : handles) all.push_back(world.bodies().at(handle).pose);
        return all;
    }
    World world;
    PhysicsWorld physics;
    std::vector<BodyHandle> handles;
};

/// 1,000 awake Voronoi pieces in a pit: ours and Bullet's compounds of merged boxes, step by step in turn.
void voronoiPieces(benchmark::State& state) {
    const int pieces = int(state.range(0));
    const Level level = voronoiPit(pieces);
    PhysicsSettings settings;
    settings.sleepTime = 1e9;
    Pile ours(level, settings);
    BulletCompounds bullet(level, {});
    const auto timed = [](const std::function<void()>& step) {
        const auto start = Clock::now();
        step();
        return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    };
    std::vector<double> oursMs, bulletMs;
    for (auto _ : state) {
        double sum = 0.0;
        for (int i = 0; i < 600; ++i) {
            const double a = timed([&] { ours.step(); }), b = timed([&] { bullet.step(); });
            sum += a;
            if (i >= 120) oursMs.push_back(a), bulletMs.push_back(b);
        }
        state.SetIterationTime(sum * 1e-3);
    }
    std::vector<Pose> theirs;
    for (size_t i = 0; i < level.bodies.size(); ++i) theirs.push_back(bullet.pose(i));
    const Overlaps a = measureOverlaps(level, ours.poses()), b = measureOverlaps(level, theirs);
    const double m = median(oursMs), n = median(bulletMs);
    std::sort(oursMs.begin(), oursMs.end());
    state.counters["step_ms"] = m;
    state.counters["p99_ms"] = oursMs[oursMs.size() * 99 / 100];
    state.counters["bullet_ms"] = n;
    state.counters["times_faster"] = n / m;
    state.counters["deep_mean_mm"] = a.mean * 1000;
    state.counters["bullet_deep_mean_mm"] = b.mean * 1000;
    state.counters["deep_median_mm"] = a.median * 1000;
    state.counters["bullet_deep_median_mm"] = b.median * 1000;
    state.counters["deep_worst_voxels"] = a.worst * 10;
    state.counters["bullet_deep_worst_voxels"] = b.worst * 10;
    state.counters["overlaps"] = double(a.pairs);
    state.counters["bullet_overlaps"] = double(b.pairs);
    state.counters["height_m"] = a.middle;
    state.counters["bullet_height_m"] = b.middle;
    state.counters["contacts"] = ours.physics.figures().contacts;
    state.counters["boxes"] = double(bullet.boxes());
}
BENCHMARK(voronoiPieces)->Name("physics/voronoiPieces")->Arg(200)->Arg(1000)->Unit(benchmark::kMillisecond)->Iterations(1)->UseManualTime();

}  // namespace
}  // namespace rubble
