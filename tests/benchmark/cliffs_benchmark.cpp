// Scenes in which a step once cost many times what it should: the worst step of each, in processor time.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "runtime/core/random.h"
#include "tests/benchmark/pile.h"
#include "tests/physics/physics_scene.h"

namespace rubble {
namespace {

constexpr uint8_t kMasonry = 7;

/// Steps a level and reports the first, the median and the worst step.
void measure(benchmark::State& state, const Level& level, int steps, const PhysicsSettings& settings = {}) {
    Pile pile(level, settings);
    std::vector<double> ms;
    for (auto _ : state)
        for (int i = 0; i < steps; ++i) ms.push_back(cpuMs([&] { pile.step(); }));
    state.counters["first_ms"] = ms.front();
    state.counters["median_ms"] = median(ms);
    state.counters["worst_ms"] = percentile(ms, 100);
    state.counters["pairs"] = pile.physics.stats().pairs;
}

/// Cubes that were all put into the same place.
void oneSpot(benchmark::State& state) {
    PhysicsScene scene;
    scene.addFloor();
    for (int i = 0; i < int(state.range(0)); ++i) scene.add(solidGrid({4, 4, 4}, kMasonry), {0, 0.5, 0}, false);
    measure(state, scene.level, 200);
}
BENCHMARK(oneSpot)->Name("physics/cliffs/oneSpot")->Arg(1000)->Unit(benchmark::kMillisecond)->Iterations(1);

/// A body on a block of 600 cubes, 22 or 128 times as heavy as one of them.
void heavyBody(benchmark::State& state) {
    PhysicsScene scene;
    scene.addFloor();
    for (int i = 0; i < 600; ++i)
        scene.add(solidGrid({5, 5, 5}, kMasonry), {i % 10 * 0.51, i / 100 * 0.51, i / 10 % 10 * 0.51}, false);
    scene.add(solidGrid({20, int(state.range(0)), 20}, kMasonry), {1.5, 3.2, 1.5}, false);
    measure(state, scene.level, 240, sleepless());
}
BENCHMARK(heavyBody)->Name("physics/cliffs/heavyBody")->Arg(7)->Arg(40)->Unit(benchmark::kMillisecond)->Iterations(1);

/// Voxels in a layer, and bumps on a third of each of its sides.
VoxelGrid roughGrid(int side, uint64_t seed) {
    VoxelGrid grid({side, 3, side});
    GridWriter writer(grid);
    Random random(seed);
    for (int z = 0; z < side; ++z)
        for (int x = 0; x < side; ++x) {
            writer.set({x, 1, z}, kMasonry);
            for (const int y : {0, 2})
                if (random.below(3) == 0) writer.set({x, y, z}, kMasonry);
        }
    return grid;
}

/// A rough plate lands on a rough floor.
void roughPlate(benchmark::State& state) {
    const int side = int(state.range(0));
    PhysicsScene scene;
    scene.add(roughGrid(side + 20, 1), {-1, -0.3, -1}, true);
    scene.add(roughGrid(side, 2), {0, 0.5, 0}, false);
    measure(state, scene.level, 120);
}
BENCHMARK(roughPlate)->Name("physics/cliffs/roughPlate")->Arg(700)->Unit(benchmark::kMillisecond)->Iterations(1);

/// One cut through the middle of bodies that lie on a floor: its edit, what physics applies, and the step after it.
void oneCut(benchmark::State& state) {
    PhysicsScene scene;
    scene.add(solidGrid({400, 4, 400}, kMasonry), {-20, -0.4, -20}, true);
    for (int i = 0; i < int(state.range(0)); ++i)
        scene.add(solidGrid({4, 4, 4}, kMasonry), {-10 + i % 55 * 0.41, 0, -10 + i / 55 * 0.41}, false);
    Pile pile(scene.level, {});
    for (int i = 0; i < 120; ++i) pile.step();
    const CarveEdit cut{.kind = BrushKind::Box, .position = {0, 0.2, 0}, .halfSize = {20, 0.05, 20}};
    for (auto _ : state) {
        FrameChanges changes;
        state.counters["world_ms"] = cpuMs([&] { changes = pile.world.applyEdits({cut}); });
        state.counters["apply_ms"] = cpuMs([&] { pile.physics.apply(changes, pile.world); });
        state.counters["step_ms"] = cpuMs([&] { pile.step(); });
    }
}
BENCHMARK(oneCut)->Name("physics/cliffs/oneCut")->Arg(3000)->Unit(benchmark::kMillisecond)->Iterations(1);

/// An explosion in the middle of a cube of cubes that sleep, of `side` along each edge: its edit, what physics applies,
/// the first step, and the worst of the steps after it.
void explosionInSleepers(benchmark::State& state) {
    const int side = int(state.range(0)), count = side * side * side;
    PhysicsScene scene;
    scene.addFloor();
    const double pitch = 0.401, half = 0.5 * side * pitch;
    for (int i = 0; i < count; ++i) {
        const glm::ivec3 at(i % side, i / (side * side), i / side % side);
        scene.add(solidGrid({4, 4, 4}, kMasonry), {at.x * pitch - half, at.y * 0.4, at.z * pitch - half}, false);
    }
    Pile pile(scene.level, {}, 0);
    for (int i = 0; i < 10; ++i) pile.step();
    const ExplodeEdit blast{.position = {0, half, 0}, .size = double(state.range(1))};
    for (auto _ : state) {
        FrameChanges changes;
        state.counters["world_ms"] = cpuMs([&] { changes = pile.world.applyEdits({blast}); });
        state.counters["apply_ms"] = cpuMs([&] { pile.physics.apply(changes, pile.world); });
        state.counters["first_ms"] = cpuMs([&] { pile.step(); });
        state.counters["awake"] = pile.physics.stats().awake;
        std::vector<double> ms;
        int mostAwake = 0;
        for (int i = 0; i < 120; ++i) {
            ms.push_back(cpuMs([&] { pile.step(); }));
            mostAwake = std::max(mostAwake, pile.physics.stats().awake);
        }
        state.counters["later_median_ms"] = median(ms);
        state.counters["later_worst_ms"] = percentile(ms, 100);
        state.counters["most_awake"] = mostAwake;
    }
}
BENCHMARK(explosionInSleepers)
    ->Name("physics/cliffs/explosion")
    ->Args({22, 1})
    ->Args({22, 4})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

}  // namespace
}  // namespace rubble
