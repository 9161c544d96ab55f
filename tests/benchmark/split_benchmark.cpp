// Splits after carves of radius 6 and after cuts in two, compared with a relabelling of the whole grid from bytes: in
// the same process, by the same compiler, with one thread each.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "runtime/assets/assets.h"
#include "runtime/core/random.h"
#include "runtime/destruction/carve.h"
#include "runtime/destruction/detachment.h"
#include "runtime/destruction/local_connectivity.h"
#include "runtime/destruction/split.h"
#include "runtime/world/edits/resolve_brush.h"
#include "runtime/world/world.h"
#include "tests/benchmark/baseline_labels.h"
#include "tests/benchmark/destruction_scenes.h"
#include "tests/support/detached_near.h"
#include "tests/support/models.h"

namespace rubble {
namespace {

using Clock = std::chrono::steady_clock;

double msSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[values.size() / 2];
}

const Palette& stone() {
    static const Palette palette = [] {
        Palette out{};
        for (size_t i = 1; i < 256; ++i) out[i].material = defaultMaterials().find("brick");
        return out;
    }();
    return palette;
}

/// A static grid whose voxels are all connected to its anchors.
struct AnchoredSolid {
    VoxelGrid grid;
    std::vector<CellBox> anchors;
    double relabelMs = 0.0;  ///< a relabelling of the whole grid: median of five

    AnchoredSolid(VoxelGrid whole, const CellBox& anchor) : grid(std::move(whole)), anchors{anchor} {
        for (const Component& loose : findDetached(grid, anchors, true).pieces) takePiece(grid, loose);
        const bench::DenseGrid dense(grid);
        std::vector<double> times;
        for (int i = 0; i < 5; ++i) {
            const auto start = Clock::now();
            benchmark::DoNotOptimize(bench::countComponentsByRuns(dense));
            times.push_back(msSince(start));
        }
        relabelMs = median(times);
    }
};

const AnchoredSolid& anchoredSolid(bench::Solid solid, int size) {
    static std::map<std::pair<bench::Solid, int>, AnchoredSolid> known;
    const auto found = known.find({solid, size});
    if (found != known.end()) return found->second;
    if (size >= 512) known.clear();  // to limit memory
    const CellBox bottom{{0, 0, 0}, {size, 1, size}}, side{{0, 0, 0}, {1, size, size}};
    return known
        .try_emplace({solid, size}, bench::makeSolid(solid, size), solid == bench::Solid::Halves ? side : bottom)
        .first->second;
}

/// Times of one carve and its split. `minMs` is a lower bound for any split: labelling the carved bricks, each on its
/// own, and moving the pieces into grids of their own.
struct Timed {
    double carveMs, minMs, splitMs;
    size_t pieces;
};

double msToLabel(const VoxelGrid& grid, const std::vector<glm::ivec3>& bricks) {
    std::vector<BrickPart> parts;
    parts.reserve(64);
    const auto start = Clock::now();
    for (const glm::ivec3 brick : bricks)
        if (const Brick* content = grid.brickAt(brick)) {
            parts.clear();
            findBrickParts(content->occupancy, parts);
            benchmark::DoNotOptimize(parts.data());
        }
    return msSince(start);
}

Timed carveAndSplit(const AnchoredSolid& anchored, const Brush& brush) {
    VoxelGrid grid = anchored.grid;
    auto start = Clock::now();
    CarveResult carved;
    carve(grid, brush, stone(), defaultMaterials(), carved);
    const double carveMs = msSince(start), labelMs = msToLabel(grid, carved.bricks);
    start = Clock::now();
    if (isLocallyConnected(grid, carved.cells, anchored.anchors)) return {carveMs, labelMs, msSince(start), 0};
    BrickSet bricks;
    for (const glm::ivec3 brick : carved.bricks) bricks.insert(brick);
    const Detached loose = test::findDetachedNear(grid, anchored.anchors, true, bricks);
    const auto found = Clock::now();
    for (const Component& component : loose.pieces) benchmark::DoNotOptimize(takePiece(grid, component));
    return {carveMs, labelMs + msSince(found), msSince(start), loose.pieces.size()};
}

/// A random solid cell.
glm::ivec3 randomVoxel(const VoxelGrid& grid, Random& random) {
    for (;;) {
        const int x = int(random.below(uint32_t(grid.size().x))), y = int(random.below(uint32_t(grid.size().y))),
                  z = int(random.below(uint32_t(grid.size().z)));
        if (grid.at({x, y, z})) return {x, y, z};
    }
}

void report(benchmark::State& state, const std::vector<double>& splits, const std::vector<double>& carves,
            double relabelMs) {
    std::vector<double> sorted = splits;
    std::sort(sorted.begin(), sorted.end());
    state.counters["split_ms"] = median(splits);
    state.counters["p99_ms"] = sorted.empty() ? 0.0 : sorted[sorted.size() * 99 / 100];
    state.counters["carve_ms"] = median(carves);
    state.counters["relabel_ms"] = relabelMs;
    state.counters["times_faster"] = relabelMs / median(splits);
}

/// Two hundred carves at random voxels, each of a fresh copy; only the split is timed.
void carveSplit(benchmark::State& state, bench::Solid solid, int size) {
    const AnchoredSolid& anchored = anchoredSolid(solid, size);
    Random random(1);
    std::vector<double> splits, carves;
    double pieces = 0.0;
    for (auto _ : state) {
        const glm::dvec3 center = glm::dvec3(randomVoxel(anchored.grid, random)) + 0.5;
        const Timed timed = carveAndSplit(anchored, sphereBrush(center, {6, 6, 6}));
        state.SetIterationTime(timed.splitMs * 1e-3);
        splits.push_back(timed.splitMs), carves.push_back(timed.carveMs);
        pieces += double(timed.pieces);
    }
    state.counters["pieces"] = pieces / double(splits.size());
    report(state, splits, carves, anchored.relabelMs);
}

/// The same on the shapes of real models with at least a thousand voxels. Small shapes, up to 64^3 cells, are a
/// benchmark of their own: a full relabelling takes 4 to 100 us in the cache, which leaves little to save. Counters:
/// the median ratio of the shapes; how many shapes are split at least 20 times as fast as relabelled; and the same for
/// the lower bound of a split's time.
void modelSplit(benchmark::State& state, bool areLarge) {
    std::vector<AnchoredSolid> shapes;
    for (const auto& file : modelPaths())
        if (const Result<Level> level = importVox(file, {}))
            for (const LevelBody& body : level->bodies)
                for (const LevelShape& shape : body.shapes)
                    if (const glm::ivec3 size = shape.grid.size();
                        shape.grid.voxelCount() >= 1000 &&
                        areLarge == (size_t(size.x) * size_t(size.y) * size_t(size.z) > (1u << 18)))
                        if (AnchoredSolid anchored(shape.grid,
                                                   CellBox{{0, 0, 0}, {shape.grid.size().x, 2, shape.grid.size().z}});
                            !anchored.grid.empty())
                            shapes.push_back(std::move(anchored));
    if (shapes.empty()) return state.SkipWithError("the test models are missing (tests/support/models.h)");
    Random random(2);
    std::vector<double> splits, carves, references;
    std::vector<std::vector<double>> times(shapes.size()), minTimes(shapes.size());
    for (auto _ : state) {
        const size_t shape = splits.size() % shapes.size();
        const AnchoredSolid& anchored = shapes[shape];
        const Timed timed =
            carveAndSplit(anchored, sphereBrush(glm::dvec3(randomVoxel(anchored.grid, random)) + 0.5, {6, 6, 6}));
        state.SetIterationTime(timed.splitMs * 1e-3);
        splits.push_back(timed.splitMs), carves.push_back(timed.carveMs);
        times[shape].push_back(timed.splitMs), minTimes[shape].push_back(timed.minMs);
    }
    std::vector<double> ratios, bounds;
    for (size_t i = 0; i < shapes.size(); ++i) {
        references.push_back(shapes[i].relabelMs);
        ratios.push_back(shapes[i].relabelMs / median(times[i])),
            bounds.push_back(shapes[i].relabelMs / median(minTimes[i]));
    }
    const auto countTwentyfold = [](const std::vector<double>& all) {
        return double(std::count_if(all.begin(), all.end(), [](double x) { return x >= 20.0; }));
    };
    report(state, splits, carves, median(references));
    state.counters["times_faster"] = median(ratios);
    state.counters["max_times_faster"] = median(bounds);
    state.counters["shapes_20_times"] = countTwentyfold(ratios);
    state.counters["max_shapes_20_times"] = countTwentyfold(bounds);
    state.counters["shapes"] = double(shapes.size());
}

/// A block is cut in two by World::applyEdits(): "halves" by a ball on the bridge between them, "block" by a slab
/// through the middle. `step_ms` is the whole step, `carve_ms` the carve alone. Cold: the first cut, without cached
/// results.
void cutInTwo(benchmark::State& state, bench::Solid solid, bool isCold) {
    const int size = 256;
    const AnchoredSolid& anchored = anchoredSolid(solid, size);
    const CellBox side{{0, 0, 0}, {1, size, size}};
    CarveEdit cut{.position = glm::dvec3(size / 2, size / 2 + 2, size / 2 + 2) * 0.1};
    cut.radii.fill(0.6);
    if (solid == bench::Solid::Block) cut.kind = BrushKind::Box, cut.halfSize = {0.4, 20.0, 20.0};
    std::vector<double> steps, carves;
    for (auto _ : state) {
        Level level;
        LevelBody body{.name = "body"};
        LevelShape shape{
            .name = "shape", .grid = isCold ? bench::coldCopy(anchored.grid) : anchored.grid, .anchors = {side}};
        shape.palette = std::make_shared<const Palette>(stone());
        body.shapes.push_back(std::move(shape));
        level.bodies.push_back(std::move(body));
        World world;
        world.load(level);
        CarveEdit first{.position = {0.8, 0.8, 0.8}, .radii = {0.2, 0.2, 0.2}};
        world.applyEdits({});
        if (!isCold) world.applyEdits({first});
        ShapeHandle handle;
        world.shapes().forEach([&](ShapeHandle each, const Shape&) { handle = each; });
        VoxelGrid grid = world.shapes().at(handle).grid;
        auto start = Clock::now();
        CarveResult carved;
        carve(grid, resolveBrush(cut, shapeToWorld(world, handle), world.shapes().at(handle).voxelSize), stone(),
              defaultMaterials(), carved);
        carves.push_back(msSince(start));
        grid = {};
        start = Clock::now();
        const FrameChanges changes = world.applyEdits({cut});
        steps.push_back(msSince(start));
        if (changes.splits.size() != 1) return state.SkipWithError("the cut must split the block");
        state.SetIterationTime(steps.back() * 1e-3);
    }
    state.counters["step_ms"] = median(steps);
    state.counters["best_ms"] = *std::min_element(steps.begin(), steps.end());  // the least disturbed by other programs
    state.counters["carve_ms"] = median(carves);
    state.counters["relabel_ms"] = anchored.relabelMs;
}

void registerSplits() {
    const auto add = [](const std::string& name, auto&& function, int iterations) {
        benchmark::RegisterBenchmark(name.c_str(), function)
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond)
            ->Iterations(iterations);
    };
    for (const auto solid : {bench::Solid::Building, bench::Solid::Holed, bench::Solid::Cracked})
        for (const int size : {128, 256, 512})
            add(
                std::string("destruction/split/") + bench::kSolidNames[int(solid)] + "/" + std::to_string(size),
                [=](benchmark::State& state) { carveSplit(state, solid, size); }, 200);
    for (const bool areLarge : {true, false})
        add(
            areLarge ? "destruction/split/models/large" : "destruction/split/models/small",
            [=](benchmark::State& state) { modelSplit(state, areLarge); }, 1300);
    for (const bool isCold : {false, true})
        for (const auto solid : {bench::Solid::Halves, bench::Solid::Block})
            add(
                std::string("destruction/split/cutInTwo256/") + bench::kSolidNames[int(solid)] +
                    (isCold ? "/firstCut" : "/known"),
                [=](benchmark::State& state) { cutInTwo(state, solid, isCold); }, 15);
}

[[maybe_unused]] const bool kRegistered = (registerSplits(), true);

}  // namespace
}  // namespace rubble
