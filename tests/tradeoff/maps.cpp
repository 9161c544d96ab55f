#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "runtime/plugin/frame_loop.h"
#include "samples/scenes/canvas.h"
#include "samples/scenes/placement.h"
#include "samples/scenes/recipes.h"
#include "samples/scenes/test_scenes.h"
#include "tests/tradeoff/destruction.h"

namespace rubble::tradeoff {
namespace {

constexpr double kStable = 1000.0 / 60.0, kDegraded = 100.0;  // ms a step

Outcome outcomeOf(double ms) {
    return ms <= kStable ? Outcome::Stable : ms <= kDegraded ? Outcome::Degraded : Outcome::Refused;
}

Level block(int size) {
    using namespace scenes;
    Canvas canvas{ivec3(size)};
    const Swatch concrete = canvas.mix(kConcrete);
    canvas.fill(ivec3(0), ivec3(size), [&](ivec3) { return concrete.first; });
    Level level;
    addStatic(level, canvas.finish("block"), ivec3(0));
    return level;
}

/// A block in the air over a floor, held at one corner cell only, and the cuts that make count^3 dice of three cells of it.
Level heldBlock(int count) {
    using namespace scenes;
    Level level = makeLoneCube(1, 0.1);
    Canvas canvas{ivec3(4 * count)};
    canvas.box(ivec3(0), ivec3(4 * count), canvas.mix(kBrick));
    LevelShape shape = canvas.finish("block");
    shape.anchors = {{{0, 0, 0}, {1, 1, 1}}};
    addStatic(level, std::move(shape), ivec3(40 - 2 * count, 6, 40 - 2 * count));
    return level;
}

Edits dice(int count) {
    const glm::dvec3 corner = glm::dvec3(40 - 2 * count, 6, 40 - 2 * count) * 0.1;
    Edits edits;
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < count; ++i) {
            CarveEdit cut;
            cut.kind = BrushKind::Box;
            cut.position = corner + glm::dvec3(0.2 * count);
            cut.position[axis] = corner[axis] + 0.4 * i + 0.35;
            cut.halfSize = glm::dvec3(0.2 * count + 0.1);
            cut.halfSize[axis] = 0.05;
            edits.push_back(cut);
        }
    return edits;
}

/// A beam of `depth` x `depth` cells that grows `length` cells out of a wall.
Level cantilever(int depth, int length) {
    using namespace scenes;
    Canvas canvas({length + 4, depth, depth});
    const Swatch concrete = canvas.mix(kConcrete);
    canvas.fill(ivec3(0), canvas.size(), [&](ivec3) { return concrete.first; });
    Level level;
    addStatic(level, canvas.finish("beam"), ivec3(0));
    level.bodies[0].shapes[0].anchors = {{{0, 0, 0}, {4, depth, depth}}};
    return level;
}

/// Stress over strength at the wall, by beam theory: 3 rho g L^2 / d over the tensile strength as it is scaled.
double beamTheory(int depth, int length, double scale) {
    const Material& concrete = defaultMaterials()[defaultMaterials().find("concrete")];
    return 3.0 * double(concrete.density) * 9.81 * std::pow(0.1 * length, 2) / (0.1 * depth) / (double(concrete.tensileStrength) * scale);
}

}  // namespace

Table piecesMap(const Options& options) {
    Table table{"T13-pieces",
                "loose pieces that fall together, against the budget of those that move",
                {"pieces", "awake at most", "step ms p95", "left", "outcome"},
                {}};
    std::vector<MapCell> cells;
    const std::vector<int> counts = options.full ? std::vector<int>{4, 8, 12, 16} : std::vector<int>{4, 6, 9};
    const std::vector<uint32_t> budgets = options.full ? std::vector<uint32_t>{10'000, 2000, 500, 100} : std::vector<uint32_t>{10'000, 500, 100};
    for (const uint32_t budget : budgets)
        for (const int count : counts) {
            FrameLoopSettings settings;
            settings.shadowVolume = settings.publish = false;
            FrameLoop loop(settings);
            WorldSettings how;
            how.debris.awakeBodies = budget;
            loop.world().setSettings(how);
            loop.load(heldBlock(count));
            loop.edits().push(dice(count));
            std::vector<double> ms;
            for (int step = 0; step < (options.full ? 180 : 60); ++step) {
                const ScopedTimer timer(ms.emplace_back());
                loop.step();
            }
            const double p95 = quantile(ms, 0.95);
            const size_t left = loop.world().bodies().size() - 2;
            table.add({std::to_string(count * count * count - 1), std::to_string(budget), fmt::format("{:.2f}", p95), std::to_string(left),
                       nameOf(outcomeOf(p95))});
            cells.push_back({std::to_string(count * count * count - 1), std::to_string(budget), outcomeOf(p95), fmt::format("{:.1f} ms", p95)});
        }
    writeMap(options, "T13-pieces", "Pieces that fall against the budget of those that move", "pieces", "awake at most", cells);
    return table;
}

Table brushMap(const Options& options) {
    Table table{"T13-brush",
                "one carve: radius against size of the grid, and numbers no brush should have",
                {"grid", "radius cells", "ms", "voxels", "outcome"},
                {}};
    std::vector<MapCell> cells;
    const std::vector<int> sizes = options.full ? std::vector<int>{32, 128, 256, 512} : std::vector<int>{32, 128, 256};
    for (const int size : sizes) {
        const Level level = block(size);
        for (const double radius : {1.0, 4.0, 16.0, 64.0, 1e6, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
            uint64_t removed = 0;
            const Measured ms = measure(options.repeats(), [&] {
                World world;
                world.load(level);
                world.applyEdits({});
                CarveEdit carve;
                carve.position = glm::dvec3(size * 0.05, size * 0.1, size * 0.05);
                carve.radii = {radius * 0.1, radius * 0.1, radius * 0.1};
                double one = 0.0;
                removed = 0;
                {
                    const ScopedTimer timer(one);
                    for (const RemovedVoxels& each : world.applyEdits({carve}).removed) removed += each.count;
                }
                return one;
            });
            const Outcome outcome = removed == 0 ? Outcome::Refused : outcomeOf(ms.median);
            table.add({fmt::format("{}^3", size), fmt::format("{:g}", radius), ms.text(), std::to_string(removed), nameOf(outcome)});
            cells.push_back(
                {fmt::format("{:g}", radius), fmt::format("{}^3", size), outcome, removed ? fmt::format("{:.2f} ms", ms.median) : "nothing"});
        }
    }
    writeMap(options, "T13-brush", "One carve: radius against grid", "radius, cells", "grid", cells);
    return table;
}

Table beamMap(const Options& options) {
    Table table{"T13-beam",
                "a concrete cantilever: does it stand, and should it by beam theory?",
                {"depth cells", "length cells", "stress over strength by beam theory", "stands", "steps until it broke", "us a step p99", "outcome"},
                {}};
    std::vector<MapCell> cells;
    const std::vector<int> depths = options.full ? std::vector<int>{1, 2, 4, 8, 16} : std::vector<int>{2, 4, 8};
    const std::vector<int> lengths = options.full ? std::vector<int>{16, 24, 32, 48, 64, 96, 128} : std::vector<int>{16, 32, 48, 64};
    for (const int depth : depths)
        for (const int length : lengths) {
            World world;
            WorldSettings settings;
            settings.load.on = true;
            world.setSettings(settings);
            world.load(cantilever(depth, length));
            std::vector<double> us;
            int broke = -1;
            for (int step = 0; step < 120 && broke < 0; ++step) {
                double ms = 0.0;
                {
                    const ScopedTimer timer(ms);
                    if (!world.applyEdits({}).splits.empty()) broke = step;
                }
                us.push_back(ms * 1000.0);
            }
            const double theory = beamTheory(depth, length, settings.load.strengthScale);
            const bool stands = broke < 0, should = theory<1.0, near = theory> 0.9 && theory < 1.1;
            const Outcome outcome = stands == should || near ? Outcome::Stable : Outcome::Degraded;
            table.add({std::to_string(depth), std::to_string(length), fmt::format("{:.2f}", theory), stands ? "yes" : "no",
                       stands ? "" : std::to_string(broke), fmt::format("{:.0f}", quantile(us, 0.99)), nameOf(outcome)});
            cells.push_back({std::to_string(length), std::to_string(depth), outcome, fmt::format("{} {:.2f}", stands ? "stands" : "breaks", theory)});
        }
    writeMap(options, "T13-beam", "A cantilever: what it does, and stress over strength by beam theory", "length, cells", "depth, cells", cells);
    return table;
}

}  // namespace rubble::tradeoff
