// A carve of radius 6 and the split after it, against relabelling the whole grid from bytes, in the same process.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "runtime/destruction/attachment.h"
#include "runtime/destruction/carve.h"
#include "runtime/destruction/split.h"
#include "runtime/world/world.h"
#include "tests/benchmark/run_relabel.h"

namespace rubble {
namespace {

/// What the cut meets: solid ground (nothing comes loose), a pillar (its top does), the one bridge between two halves.
enum Scene { kGround, kPillar, kHalf };

bool isSolid(Scene scene, glm::ivec3 c, int size) {
    if (scene == kHalf) return c.x < size / 2 - 8 || c.x >= size / 2 + 8 || (c.y / 4 == size / 8 && c.z / 4 == size / 8);
    return c.y < size / 2 || (scene == kPillar && (c.x & 12) == 4 && (c.z & 12) == 4);
}

glm::dvec3 cutOf(Scene scene, int size) {
    const double middle = size / 2 + 2.0;
    if (scene == kHalf) return {size / 2.0, middle, middle};
    return scene == kPillar ? glm::dvec3(size / 2 + 6, size / 2 + 20, size / 2 + 6) : glm::dvec3(middle);
}

const VoxelGrid& sceneGrid(Scene scene, int size) {
    static std::map<std::pair<int, int>, VoxelGrid> grids;
    VoxelGrid& grid = grids[{scene, size}];
    if (grid.size().x) return grid;
    grid = VoxelGrid(glm::ivec3(size));
    GridWriter writer(grid);
    for (int z = 0; z < size; ++z)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                if (isSolid(scene, {x, y, z}, size)) writer.set({x, y, z}, uint8_t(1 + (x / 16 + y / 16 + z / 16) % 3));
    writer.flush();
    return grid;
}

Palette stone() {
    Palette palette{};
    for (size_t i = 1; i < 256; ++i) palette[i].material = defaultMaterials().find("brick");
    return palette;
}

/// Anchored at the bottom; the two halves on the left one's side, so that the right one comes off.
CellBox anchorOf(Scene scene, int size) {
    return scene == kHalf ? CellBox{{0, 0, 0}, {1, size, size}} : CellBox{{0, 0, 0}, {size, 1, size}};
}

/// Milliseconds of the reference on the grid after the cut: the median of five.
double referenceMs(Scene scene, int size) {
    static std::map<std::pair<int, int>, double> known;
    double& ms = known[{scene, size}];
    if (ms > 0.0) return ms;
    VoxelGrid grid = sceneGrid(scene, size);
    Carved carved;
    carve(grid, sphereBrush(cutOf(scene, size), {6, 6, 6}), stone(), defaultMaterials(), carved);
    const bench::DenseGrid dense(grid);
    std::vector<double> times;
    for (int i = 0; i < 5; ++i) {
        const auto start = std::chrono::steady_clock::now();
        benchmark::DoNotOptimize(bench::relabelByRuns(dense));
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    std::sort(times.begin(), times.end());
    return ms = times[2];
}

void report(benchmark::State& state, Scene scene, int size, double seconds) {
    const double ours = seconds * 1e3 / double(state.iterations());
    state.counters["reference_ms"] = referenceMs(scene, size);
    state.counters["times_faster"] = referenceMs(scene, size) / ours;
}

/// The grid alone: carve, find what is loose, take it out. `isKnown`: by local search, as after a shape's first cut.
template <bool isKnown>
void carveAndSplit(benchmark::State& state) {
    const Scene scene = Scene(state.range(0));
    const int size = int(state.range(1));
    const Palette palette = stone();
    const std::vector<CellBox> anchors = {anchorOf(scene, size)};
    double seconds = 0.0;
    size_t pieces = 0;
    for (auto _ : state) {
        VoxelGrid grid = sceneGrid(scene, size);
        const auto start = std::chrono::steady_clock::now();
        Carved carved;
        carve(grid, sphereBrush(cutOf(scene, size), {6, 6, 6}), palette, defaultMaterials(), carved);
        BrickSet bricks;
        for (const glm::ivec3 brick : carved.bricks) bricks.insert(brick);
        const Loose loose = isKnown ? findLooseNear(grid, anchors, true, bricks) : findLoose(grid, anchors, true);
        for (const Component& component : loose.pieces) benchmark::DoNotOptimize(takePiece(grid, component));
        const double each = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        state.SetIterationTime(each);
        seconds += each;
        pieces = loose.pieces.size();
    }
    state.counters["pieces"] = double(pieces);
    report(state, scene, size, seconds);
}

/// The whole of World::applyEdits, with moments, bodies and the journal.
void applyEdits(benchmark::State& state) {
    const Scene scene = Scene(state.range(0));
    const int size = int(state.range(1));
    Level level;
    LevelBody body{.name = "body"};
    LevelShape shape{.name = "shape", .grid = sceneGrid(scene, size), .anchors = {anchorOf(scene, size)}};
    shape.palette = std::make_shared<const Palette>(stone());
    body.shapes.push_back(std::move(shape));
    level.bodies.push_back(std::move(body));
    World fresh;
    fresh.load(level);
    CarveEdit first{.position = {0.8, 0.05 * size, 0.8}, .radii = {0.2, 0.2, 0.2}}, cut{.position = cutOf(scene, size) * 0.1};
    fresh.applyEdits({first});
    cut.radii.fill(0.6);
    double seconds = 0.0;
    for (auto _ : state) {
        World world = fresh;
        const auto start = std::chrono::steady_clock::now();
        benchmark::DoNotOptimize(world.applyEdits({cut}));
        const double each = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        state.SetIterationTime(each);
        seconds += each;
    }
    report(state, scene, size, seconds);
}

void scenes(benchmark::internal::Benchmark* benchmark) {
    benchmark->ArgNames({"scene", "size"})->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(0.2);
    for (const int size : {128, 256})
        for (const Scene scene : {kGround, kPillar, kHalf}) benchmark->Args({scene, size});
}

BENCHMARK(carveAndSplit<true>)->Name("Split/known")->Apply(scenes);
BENCHMARK(carveAndSplit<false>)->Name("Split/firstCut")->Apply(scenes);
BENCHMARK(applyEdits)->Name("Split/applyEdits")->Apply(scenes);

}  // namespace
}  // namespace rubble
