#include <fmt/format.h>

#include <algorithm>

#include "runtime/core/profile.h"
#include "runtime/core/random.h"
#include "runtime/world/world.h"
#include "samples/scenes/canvas.h"
#include "samples/scenes/placement.h"
#include "samples/scenes/recipes.h"
#include "tests/tradeoff/destruction.h"

namespace rubble::tradeoff {
namespace {

/// A block with storeys of holes, as a building has rooms.
Level holedBlock(int size) {
    using namespace scenes;
    Canvas canvas{ivec3(size)};
    canvas.box(ivec3(0), ivec3(size), canvas.mix(kConcrete));
    for (int z = 6; z + 12 < size; z += 18)
        for (int y = 6; y + 12 < size; y += 18)
            for (int x = 6; x + 12 < size; x += 18) canvas.clear({x, y, z}, {x + 12, y + 12, z + 12});
    Level level;
    addStatic(level, canvas.finish("block"), ivec3(0));
    return level;
}

/// Spheres that nibble, and every eighth time a slab cut that takes a corner off.
Edits cutAt(int i, int size, Random& random) {
    const double side = size * 0.1, x = side * random.unit(), y = side * (0.25 + 0.75 * random.unit()), z = side * random.unit();
    CarveEdit cut;
    cut.position = {x, y, z};
    cut.radii = {0.6, 0.6, 0.6};
    if (i % 8 == 7) {
        cut.kind = BrushKind::Box;
        cut.position = {i % 16 == 7 ? 0.0 : side, side, z};
        cut.halfSize = {side * 0.25, side * 0.25, 0.08};
        CarveEdit other = cut, under = cut;
        other.position.z = z + side * 0.2;
        under.position = {cut.position.x, side * 0.75, z + side * 0.1};
        under.halfSize = {side * 0.25, 0.08, side * 0.1 + 0.08};
        CarveEdit behind = cut;
        behind.position = {i % 16 == 7 ? side * 0.25 : side * 0.75, side, z + side * 0.1};
        behind.halfSize = {0.08, side * 0.25 + 0.08, side * 0.1 + 0.08};
        return {cut, other, under, behind};
    }
    return {cut};
}

/// Voxels that no path through faces joins to the bottom layer: the plain way, every cell.
uint64_t floodFill(const VoxelGrid& grid) {
    const std::vector<bool> anchored = scenes::anchoredCells(grid);
    return grid.voxelCount() - uint64_t(std::count(anchored.begin(), anchored.end(), true));
}

struct Run {
    std::vector<double> cutUs, waitUs;  ///< steps with a cut; those between
    int mostFrames = 0;                 ///< that a loose voxel hung
    uint64_t stillLoose = 0;
};

/// watched: after every step the flood fill looks for what hangs, which takes far longer than the step.
Run cutUp(int size, size_t partsAStep, int cuts, uint64_t seed, bool watched) {
    World world;
    WorldSettings settings;
    settings.split.partsAStep = partsAStep;
    world.setSettings(settings);
    world.load(holedBlock(size));
    world.applyEdits({});
    const auto standing = [&]() -> const Shape* {
        const Shape* found = nullptr;
        world.shapes().forEach([&](ShapeHandle, const Shape& shape) {
            if (!shape.isPiece) found = &shape;
        });
        return found;
    };
    Random random(seed, 51);
    Run run;
    int hanging = 0;
    for (int i = 0; i < cuts; ++i)
        for (int frame = 0; frame < 4; ++frame) {
            double ms = 0.0;
            const Edits edits = frame == 0 ? cutAt(i, size, random) : Edits{};
            {
                const ScopedTimer timer(ms);
                world.applyEdits(edits);
            }
            (frame == 0 ? run.cutUs : run.waitUs).push_back(ms * 1000.0);
            if (!watched) continue;
            const Shape* shape = standing();
            run.stillLoose = shape ? floodFill(shape->grid) : 0;
            hanging = run.stillLoose ? hanging + 1 : 0;
            run.mostFrames = std::max(run.mostFrames, hanging);
        }
    return run;
}

}  // namespace

Table connectivityTradeoff(const Options& options) {
    Table table{"T5",
                "when what a cut has loosened comes off: a cut's cost, and how long a loose piece hangs",
                {"grid", "parts a step", "cut us p50", "cut us p99", "step between us p99", "frames a loose piece hangs", "loose at the end"},
                {}};
    const int size = options.full ? 128 : 64, cuts = options.full ? 96 : 32;
    std::vector<Series> plot{{"slices", {}}, {"at once", {}}, {"flood fill", {}}};
    for (const size_t parts : {size_t(0), size_t(512), size_t(128), size_t(32), size_t(8), size_t(2)}) {
        std::vector<double> p50, p99, wait;
        Run last;
        for (int i = 0; i < options.repeats(); ++i) {
            const Run run = cutUp(size, parts, cuts, options.seed, i == 0);
            if (i == 0) last = run;
            p50.push_back(quantile(run.cutUs, 0.5));
            p99.push_back(quantile(run.cutUs, 0.99));
            wait.push_back(quantile(run.waitUs, 0.99));
        }
        const auto spread = [](const std::vector<double>& v) { return Measured{quantile(v, 0.5), quantile(v, 0.0), quantile(v, 1.0)}; };
        table.add({fmt::format("{}^3", size), parts ? std::to_string(parts) : "at once", spread(p50).text(), spread(p99).text(), spread(wait).text(),
                   std::to_string(last.mostFrames), std::to_string(last.stillLoose)});
        plot[parts ? 0 : 1].points.emplace_back(spread(p99).median, last.mostFrames);
    }
    const Level level = holedBlock(size);
    const Measured flood = measure(options.repeats(), [&] {
        double ms = 0.0;
        {
            const ScopedTimer timer(ms);
            floodFill(level.bodies[0].shapes[0].grid);
        }
        return ms * 1000.0;
    });
    table.add({fmt::format("{}^3", size), "full flood fill", flood.text(), flood.text(), "0", "0", "0"});
    plot[2].points.emplace_back(flood.median, 0.0);
    writePlot(options, "T5", "Connectivity: cost of a cut against how long a loose piece hangs", "us a cut, p99", "frames", plot);
    return table;
}

}  // namespace rubble::tradeoff
