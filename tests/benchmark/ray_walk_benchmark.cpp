// The exact walk over bricks, compared with Teardown's walk over an object's mips and with a plain 3D-DDA.
#include <benchmark/benchmark.h>

#include <chrono>
#include <glm/geometric.hpp>

#include "runtime/core/random.h"
#include "tests/benchmark/houses.h"
#include "tests/benchmark/mip_walks.h"

namespace rubble {
namespace {

const VoxelGrid& houses() {
    static const VoxelGrid grid = makeHouses();
    return grid;
}

/// Rays from points around and inside the grid to points inside it, as a camera casts them.
const std::vector<CellRay>& rays() {
    static const std::vector<CellRay> all = [] {
        std::vector<CellRay> out;
        Random random(1);
        for (int i = 0; i < 20'000; ++i) {
            glm::dvec3 from, to;
            for (int a = 0; a < 3; ++a) {
                from[a] = (1.4 * double(random.unit()) - 0.2) * houses().size()[a];
                to[a] = double(random.unit()) * houses().size()[a];
            }
            out.push_back({from, glm::normalize(to - from), 1000.0});
        }
        return out;
    }();
    return all;
}

template <class F>
void run(benchmark::State& state, F&& walk) {
    int hits = 0;
    size_t different = 0;
    rays();  // builds them before the timing starts
    for (auto _ : state)
        for (const CellRay& ray : rays()) hits += walk(ray);
    for (const CellRay& ray : rays()) different += walk(ray) != walkRay(houses(), ray).hit;
    benchmark::DoNotOptimize(hits);
    state.counters["rays"] = benchmark::Counter(double(rays().size()), benchmark::Counter::kIsIterationInvariantRate);
    state.counters["wrong_per_million"] = double(different) * 1e6 / double(rays().size());
}

void rayWalkBricks(benchmark::State& state) {
    run(state, [](const CellRay& ray) { return walkRay(houses(), ray).hit; });
}
void rayWalkMips(benchmark::State& state) {
    const MipGrid grid(houses());
    run(state, [&](const CellRay& ray) { return walkMips(grid, ray); });
}
void rayWalkVoxels(benchmark::State& state) {
    const MipGrid grid(houses());
    run(state, [&](const CellRay& ray) { return walkVoxels(grid, ray); });
}
BENCHMARK(rayWalkBricks)->Unit(benchmark::kMillisecond);
BENCHMARK(rayWalkMips)->Unit(benchmark::kMillisecond);
BENCHMARK(rayWalkVoxels)->Unit(benchmark::kMillisecond);

/// Ratios of times from one process, measured in alternation: the speed of a machine drifts.
void rayWalkRatios(benchmark::State& state) {
    const MipGrid grid(houses());
    double bricks = 0.0, mips = 0.0, voxels = 0.0;
    const auto time = [](double& seconds, auto&& walk) {
        const auto start = std::chrono::steady_clock::now();
        int hits = 0;
        for (const CellRay& ray : rays()) hits += walk(ray);
        benchmark::DoNotOptimize(hits);
        seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    for (auto _ : state) {
        time(bricks, [](const CellRay& ray) { return walkRay(houses(), ray).hit; });
        time(mips, [&](const CellRay& ray) { return walkMips(grid, ray); });
        time(voxels, [&](const CellRay& ray) { return walkVoxels(grid, ray); });
    }
    state.counters["mips_over_bricks"] = mips / bricks;
    state.counters["voxels_over_bricks"] = voxels / bricks;
}
BENCHMARK(rayWalkRatios)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rubble
