// Cost of the stress analysis in processor time: steps of a tower of 100,000 voxels whose foot is cut.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "runtime/world/world.h"
#include "tests/support/cpu_time.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

constexpr int kSide = 40, kWall = 4, kStorey = 32, kHeight = 165;

Level tower(int offset, bool isStatic = true) {
    const auto isWall = [](int c) { return c < kWall || c >= kSide - kWall; };
    VoxelGrid grid = gridOf(glm::ivec3(kSide, kHeight, kSide) + offset, [&](glm::ivec3 cell) {
        const glm::ivec3 c = cell - offset;
        if (c.x < 0 || c.y < 0 || c.z < 0) return uint8_t(0);
        return uint8_t(isWall(c.x) || isWall(c.z) || c.y % kStorey == kStorey - 1);
    });
    Level level;
    Palette palette{};
    palette[1].material = level.materials.find("concrete");
    LevelShape shape{.name = "tower", .grid = std::move(grid), .palette = std::make_shared<const Palette>(palette)};
    LevelBody body{.name = "tower", .isStatic = isStatic};
    body.shapes.push_back(std::move(shape));
    level.bodies.push_back(std::move(body));
    return level;
}

/// Steps of a world with small cuts at the foot of a tower that stays up. A new cut follows when the analysis of the
/// previous one has finished.
void towerStep(benchmark::State& state) {
    const int offset = int(state.range(0));
    WorldSettings settings;
    settings.stress.on = true;
    settings.stress.strengthScale = 1.0;
    World world;
    world.setSettings(settings);
    world.load(tower(offset));
    std::vector<double> times, cutTimes;
    int cuts = 0;
    for (auto _ : state) {
        const double start = threadMs();
        world.applyEdits({});
        times.push_back(threadMs() - start);
        state.SetIterationTime(times.back() * 1e-3);
        if (world.data().stress->isBusy()) continue;
        CarveEdit hole{.position = glm::dvec3(offset + 4 + cuts % 9 * 4, offset + 8 + cuts / 9 * 6, offset + 2) * 0.1};
        hole.radii = {0.15, 0.15, 0.15};
        const double cutStart = threadMs();
        world.applyEdits({hole});
        cutTimes.push_back(threadMs() - cutStart);
        ++cuts;
    }
    state.counters["cut_max_ms"] = cutTimes.empty() ? 0.0 : *std::max_element(cutTimes.begin(), cutTimes.end());
    std::sort(times.begin(), times.end());
    state.counters["max_ms"] = times.back();
    state.counters["p99_ms"] = times[times.size() * 99 / 100];
    state.counters["steps_per_cut"] = cuts ? double(times.size()) / cuts : 0.0;
    state.counters["voxels"] = double(voxelAccounting(world).standing);
}

/// The same tower as a free body, hit too weakly to break: cost of that analysis.
void fracturePiece(benchmark::State& state) {
    WorldSettings settings;
    settings.stress.on = true;
    World world;
    world.setSettings(settings);
    world.load(tower(0, false));
    ShapeHandle shape;
    world.shapes().forEach([&](ShapeHandle handle, const Shape&) { shape = handle; });
    for (auto _ : state) world.applyEdits({ImpactLoadEdit{shape, {2.0, 16.0, 0.05}, {0.0, 0.0, 1000.0}}});
    state.counters["voxels"] = double(voxelAccounting(world).standing + voxelAccounting(world).inPieces);
}

BENCHMARK(fracturePiece)->Name("destruction/stress/impact_on_piece")->Unit(benchmark::kMillisecond);
BENCHMARK(towerStep)
    ->Name("destruction/stress/tower_step")
    ->Arg(0)
    ->Arg(3)
    ->Iterations(1500)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rubble
