// Rays and sphere casts through a World of many shapes: one by one, and as a batch over threads.
#include <benchmark/benchmark.h>

#include <thread>

#include "runtime/core/random.h"
#include "runtime/world/queries/query.h"
#include "runtime/world/world.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

constexpr int kRays = 4096;

/// A field of 20 x 20 rotated blocks over a floor.
World makeField() {
    Random random(3);
    Level level;
    auto palette = std::make_shared<Palette>();
    (*palette)[1].material = level.materials.find("brick");
    const auto add = [&](glm::ivec3 size, glm::dvec3 at, double turn) {
        LevelBody body{.name = "block", .pose = {at, glm::angleAxis(turn, glm::dvec3(0.6, 0.8, 0.0))}};
        LevelShape shape{.name = "block", .grid = solidGrid(size), .palette = palette};
        body.shapes.push_back(std::move(shape));
        level.bodies.push_back(std::move(body));
    };
    add({600, 4, 600}, {0.0, -0.4, 0.0}, 0.0);
    for (int i = 0; i < 400; ++i) add({6 + i % 9, 20, 10}, {3.0 * (i % 20), 0.5, 3.0 * (i / 20)}, random.unit());
    World world;
    world.load(level);
    return world;
}

std::vector<RayQuery> makeRays(double radius) {
    Random random(4);
    std::vector<RayQuery> rays;
    for (int i = 0; i < kRays; ++i) {
        const float x = random.unit();
        const float z = random.unit();
        const float dx = random.unit();
        const float dz = random.unit();
        rays.push_back({{60.0 * x, 1.5, 60.0 * z}, {dx - 0.5, -0.05, dz - 0.5}, 50.0, radius});
    }
    return rays;
}

void twoThreads(size_t count, const std::function<void(size_t)>& body) {
    const auto half = [&](size_t first) {
        for (size_t i = first; i < count; i += 2) body(i);
    };
    std::thread other(half, 1);
    half(0);
    other.join();
}

void castOneByOne(benchmark::State& state) {
    const World world = makeField();
    const std::vector<RayQuery> rays = makeRays(double(state.range(0)) * 0.01);
    for (auto _ : state)
        for (const RayQuery& ray : rays) benchmark::DoNotOptimize(castRay(world, ray));
    state.SetItemsProcessed(state.iterations() * kRays);
}
void castBatch(benchmark::State& state) {
    const World world = makeField();
    const std::vector<RayQuery> rays = makeRays(double(state.range(0)) * 0.01);
    std::vector<WorldHit> hits(rays.size());
    for (auto _ : state)
        castRays(world, rays, hitsInto(hits), {},
                 state.range(1) == 2 ? ParallelFor(twoThreads) : ParallelFor(serialFor));
    state.SetItemsProcessed(state.iterations() * kRays);
}
// Arguments: radius in centimetres; number of threads.
BENCHMARK(castOneByOne)->Arg(0)->Arg(20)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(castBatch)
    ->Args({0, 1})
    ->Args({0, 2})
    ->Args({20, 1})
    ->Args({20, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace rubble
