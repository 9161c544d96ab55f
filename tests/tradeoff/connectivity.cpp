#include <fmt/format.h>

#include <algorithm>

#include "runtime/core/profile.h"
#include "runtime/core/random.h"
#include "runtime/destruction/detachment.h"
#include "runtime/world/world.h"
#include "samples/scenes/canvas.h"
#include "samples/scenes/placement.h"
#include "samples/scenes/surface_styles.h"
#include "tests/tradeoff/destruction.h"

namespace rubble::tradeoff {
namespace {

/// A block with rows of cavities, as a building has rooms.
Level holedBlock(int size) {
    using namespace scenes;
    Canvas canvas{ivec3(size)};
    canvas.box(ivec3(0), ivec3(size), canvas.addSurface(kConcrete));
    for (int z = 6; z + 12 < size; z += 18)
        for (int y = 6; y + 12 < size; y += 18)
            for (int x = 6; x + 12 < size; x += 18) canvas.clear({x, y, z}, {x + 12, y + 12, z + 12});
    Level level;
    addStatic(level, canvas.finish("block"), ivec3(0));
    return level;
}

/// Small spheres, and every eighth time slabs that cut off a corner.
Edits cutAt(int i, int size, Random& random) {
    const double side = size * 0.1, x = side * random.unit(), y = side * (0.25 + 0.75 * random.unit()),
                 z = side * random.unit();
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

/// Voxels that are not connected to the bottom layer, by a plain flood fill over all cells.
uint64_t floodFill(const VoxelGrid& grid) {
    const std::vector<bool> anchored = scenes::anchoredCells(grid);
    return grid.voxelCount() - uint64_t(std::count(anchored.begin(), anchored.end(), true));
}

struct Run {
    std::vector<double> cutUs, waitUs;  ///< steps with a cut; steps between cuts
    int maxHangingSteps = 0;            ///< longest time that an unanchored voxel stayed attached
    uint64_t stillLoose = 0;
};

/// `watched`: after every step looks for unanchored components in the whole grid, which takes far longer than the step.
Run cutUp(int size, size_t partsPerStep, int cuts, uint64_t seed, bool watched) {
    World world;
    WorldSettings settings;
    settings.split.partsPerStep = partsPerStep;
    world.setSettings(settings);
    world.load(holedBlock(size));
    world.applyEdits({CarveEdit{.radii = {0.1, 0.1, 0.1}}});  // the first cut of a shape examines all of it
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
            run.stillLoose = 0;
            if (shape)
                for (const Component& loose : findDetached(shape->grid, shape->anchors, true).pieces)
                    run.stillLoose += loose.voxels;
            hanging = run.stillLoose ? hanging + 1 : 0;
            run.maxHangingSteps = std::max(run.maxHangingSteps, hanging);
        }
    return run;
}

/// A quantile over the steps of equal runs. Each step counts with its median over the runs, which removes other load on
/// the machine.
Measured overRuns(const std::vector<Run>& runs, std::vector<double> Run::*list, double share) {
    std::vector<double> typical, each;
    for (size_t i = 0; i < (runs[0].*list).size(); ++i) {
        std::vector<double> same;
        for (const Run& run : runs) same.push_back((run.*list)[i]);
        typical.push_back(quantile(same, 0.5));
    }
    for (const Run& run : runs) each.push_back(quantile(run.*list, share));
    return {quantile(typical, share), quantile(each, 0.0), quantile(each, 1.0)};
}

}  // namespace

Table connectivityTradeoff(const Options& options) {
    Table table{"T5",
                "splits at once or in slices: cost of a cut, and how long an unanchored piece stays attached",
                {"grid", "parts per step", "cut us p50", "cut us p99", "step between us p99",
                 "steps a piece stays attached", "unanchored at the end"},
                {}};
    table.note =
        "Every step counts with its median over the runs, which removes other load on the machine; the spread is that "
        "of single runs.";
    const int size = options.full ? 256 : 128, cuts = options.full ? 96 : 32;
    double atOnce = 0.0, smallest = 0.0, typical = 0.0;
    int hangs = 0;
    uint64_t stillLoose = 0;
    std::vector<Series> plot{
        {"cut, in slices", {}}, {"cut, at once", {}}, {"step between cuts", {}}, {"flood fill", {}}};
    for (const size_t parts : {size_t(0), size_t(512), size_t(128), size_t(32), size_t(8), size_t(2)}) {
        std::vector<Run> runs;
        for (int i = 0; i < options.repeats; ++i) runs.push_back(cutUp(size, parts, cuts, options.seed, i == 0));
        const Measured p50 = overRuns(runs, &Run::cutUs, 0.5), p99 = overRuns(runs, &Run::cutUs, 0.99),
                       wait = overRuns(runs, &Run::waitUs, 0.99);
        table.add({fmt::format("{}^3", size), parts ? std::to_string(parts) : "at once", p50.text(), p99.text(),
                   wait.text(), std::to_string(runs[0].maxHangingSteps), std::to_string(runs[0].stillLoose)});
        (parts ? smallest : atOnce) = p99.median;
        if (!parts) typical = p50.median;
        hangs = runs[0].maxHangingSteps, stillLoose = runs[0].stillLoose;
        if (parts) plot[0].points.emplace_back(parts, p99.median), plot[2].points.emplace_back(parts, wait.median);
    }
    const Level level = holedBlock(size);
    const Measured flood = measure(options.repeats, [&] {
        double ms = 0.0;
        {
            const ScopedTimer timer(ms);
            floodFill(level.bodies[0].shapes[0].grid);
        }
        return ms * 1000.0;
    });
    table.add({fmt::format("{}^3", size), "full flood fill", flood.text(), flood.text(), "0", "0", "0"});
    for (const double parts : {2.0, 512.0}) {
        plot[1].points.emplace_back(parts, atOnce);
        plot[3].points.emplace_back(parts, flood.median);
    }
    table.conclusion = fmt::format(
        "A full flood fill takes {:.0f} times as long as the median cut with its split; done at once, the slowest cuts "
        "take {:.0f} us (p99); in the smallest slices {:.0f} us, but then a piece stays attached for up to {} steps, "
        "and {} voxels remain attached at the end.",
        flood.median / typical, atOnce, smallest, hangs, stillLoose);
    writePlot(options, "T5", "Connectivity: cost of a cut, by how much of it a step may examine", "parts per step",
              "us, p99", plot);
    return table;
}

}  // namespace rubble::tradeoff
