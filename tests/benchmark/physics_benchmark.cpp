#include <benchmark/benchmark.h>

#include "physics/box_merge.h"
#include "runtime/core/random.h"
#include "tests/physics/physics_scene.h"

namespace rubble {
namespace {

/// A connected random lump of up to 100 voxels.
VoxelGrid lump(Random& random) {
    VoxelGrid grid({8, 8, 8});
    GridWriter writer(grid);
    glm::ivec3 cell(4, 4, 4);
    const int count = random.between(50, 300);
    for (int i = 0; i < count; ++i) {
        writer.set(cell, 7);
        const int axis = int(random.below(3));
        const int step = random.below(2) ? 1 : -1;
        cell[axis] = std::clamp(cell[axis] + step, 0, 7);
    }
    return grid;
}

/// One step of a heap of pieces, all awake: 1.5 s after they were dropped.
void stepOfPieces(benchmark::State& state) {
    PhysicsSettings settings;
    settings.sleepTime = 1e9;
    PhysicsScene scene(settings);
    scene.addFloor();
    Random random(1);
    for (int i = 0; i < int(state.range(0)); ++i) {
        VoxelGrid grid = lump(random);
        scene.add(std::move(grid), {(i % 8) * 0.9 - 3.5, 0.3 + i / 64 * 0.9, (i / 8 % 8) * 0.9 - 3.5}, false);
    }
    scene.load();
    scene.seconds(1.5);
    for (auto _ : state) scene.step();
    const PhysicsFigures figures = scene.physics.figures();
    state.counters["awake"] = figures.awake;
    state.counters["contacts"] = figures.contacts;
    state.counters["boxes"] = figures.colliderBoxes;
}
BENCHMARK(stepOfPieces)->Arg(200)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond)->Iterations(30);

/// Solid voxels to boxes: a ragged grid of 64^3.
void mergeBoxes(benchmark::State& state) {
    VoxelGrid grid({64, 64, 64});
    {
        GridWriter writer(grid);
        Random random(2);
        for (int z = 0; z < 64; ++z)
            for (int y = 0; y < 64; ++y)
                for (int x = 0; x < 64; ++x)
                    if (random.below(20)) writer.set({x, y, z}, 1);
    }
    size_t boxes = 0;
    for (auto _ : state) boxes = mergeGrid(grid, ~SolidEntries{}).size();
    state.counters["boxes"] = double(boxes);
}
BENCHMARK(mergeBoxes)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rubble
