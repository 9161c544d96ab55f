#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/plugin/frame_loop.h"
#include "samples/scenes/canvas.h"
#include "samples/scenes/placement.h"
#include "samples/scenes/surface_styles.h"
#include "samples/scenes/test_scenes.h"
#include "tests/tradeoff/destruction.h"

namespace rubble::tradeoff {
namespace {

constexpr double kStable = 1000.0 / 60.0, kDegraded = 100.0;  // ms per step

constexpr Meanings kTimes = {"up to 16.7 ms", "up to 100 ms", "more", "nothing breaks"};

Outcome outcomeOf(double ms) {
    return ms <= kStable ? Outcome::Stable : ms <= kDegraded ? Outcome::Degraded : Outcome::Failed;
}

std::string countOf(const std::vector<MapCell>& cells, Outcome outcome) {
    const auto count =
        std::count_if(cells.begin(), cells.end(), [&](const MapCell& cell) { return cell.outcome == outcome; });
    return fmt::format("{} of {}", count, cells.size());
}

Level block(int size, const scenes::SurfaceStyle& style = scenes::kConcrete) {
    using namespace scenes;
    Canvas canvas{ivec3(size)};
    const Swatch swatch = canvas.addSurface(style);
    canvas.fill(ivec3(0), ivec3(size), [&](ivec3) { return swatch.first; });
    Level level;
    addStatic(level, canvas.finish("block"), ivec3(0));
    return level;
}

/// A block in the air over a floor, anchored at one corner cell; dice() cuts it into count^3 cubes of three cells.
Level heldBlock(int count) {
    using namespace scenes;
    Level level = makeSingleCube(1, 0.1);
    Canvas canvas{ivec3(4 * count)};
    canvas.box(ivec3(0), ivec3(4 * count), canvas.addSurface(kBrick));
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

/// A beam of `depth` x `depth` cells that extends `length` cells from a wall.
Level cantilever(int depth, int length) {
    using namespace scenes;
    Canvas canvas({length + 4, depth, depth});
    const Swatch concrete = canvas.addSurface(kConcrete);
    canvas.fill(ivec3(0), canvas.size(), [&](ivec3) { return concrete.first; });
    Level level;
    addStatic(level, canvas.finish("beam"), ivec3(0));
    level.bodies[0].shapes[0].anchors = {{{0, 0, 0}, {4, depth, depth}}};
    return level;
}

/// Stress over strength at the wall by beam theory: 3 rho g L^2 / d, divided by the scaled tensile strength.
double beamTheory(int depth, int length, double scale) {
    const Material& concrete = defaultMaterials()[defaultMaterials().find("concrete")];
    return 3.0 * double(concrete.density) * 9.81 * std::pow(0.1 * length, 2) / (0.1 * depth) /
           (double(concrete.tensileStrength) * scale);
}

}  // namespace

Table piecesMap(const Options& options) {
    Table table{"T13-pieces",
                "loose pieces that fall at once, against the budget of awake pieces",
                {"pieces", "max awake", "step ms p95", "left", "outcome"},
                {}};
    std::vector<MapCell> cells;
    const std::vector<int> counts = options.full ? std::vector<int>{4, 8, 12, 16} : std::vector<int>{3, 5, 8};
    const std::vector<uint32_t> budgets =
        options.full ? std::vector<uint32_t>{10'000, 2000, 500, 100} : std::vector<uint32_t>{10'000, 500, 100};
    const int most = counts.back();
    size_t kept = 0;
    double unlimited = 0.0, tightest = 0.0;
    for (const uint32_t budget : budgets)
        for (const int count : counts) {
            size_t left = 0;
            const Measured ms = measure(options.repeats, [&] {
                FrameLoopSettings settings;
                settings.shadowVolume = settings.publish = false;
                FrameLoop loop(settings);
                WorldSettings worldSettings;
                worldSettings.debris.awakeBodies = budget;
                loop.world().setSettings(worldSettings);
                loop.load(heldBlock(count));
                loop.edits().push(dice(count));
                std::vector<double> steps;
                for (int step = 0; step < (options.full ? 180 : 45); ++step) {
                    const ScopedTimer timer(steps.emplace_back());
                    loop.step();
                }
                left = loop.world().bodies().size() - 2;
                return quantile(steps, 0.95);
            });
            const double p95 = ms.median;
            if (count == most) (budget == budgets.front() ? unlimited : tightest) = p95;
            if (count == most && budget == budgets.back()) kept = left;
            table.add({std::to_string(count * count * count - 1), std::to_string(budget), ms.text(),
                       std::to_string(left), nameOf(outcomeOf(p95))});
            cells.push_back({std::to_string(count * count * count - 1), std::to_string(budget), outcomeOf(p95),
                             fmt::format("{:.1f} ms\n{} left", p95, left)});
        }
    table.conclusion = fmt::format(
        "{} points stay within 1/60 s; {} pieces take {:.1f} ms per step if all may be awake, {:.1f} ms if {} may: "
        "then the others turn to dust, and {} are left.",
        countOf(cells, Outcome::Stable), most * most * most - 1, unlimited, tightest, budgets.back(), kept);
    writeMap(options, "T13-pieces", "Pieces that fall at once, and how many may be awake: ms per step, p95",
             "loose pieces", "awake at most", cells, kTimes);
    return table;
}

Table splitMap(const Options& options) {
    Table table{"T13-split",
                "one cut and its split: radius against size of the object, and invalid radii",
                {"grid", "radius cells", "ms", "voxels", "outcome"},
                {}};
    std::vector<MapCell> cells;
    const std::vector<int> sizes = options.full ? std::vector<int>{32, 128, 256, 512} : std::vector<int>{32, 128, 256};
    double inSmallest = 0.0, inLargest = 0.0;
    uint64_t nanTouched = 0;
    for (const int size : sizes) {
        const Level level = block(size);
        for (const double radius : {1.0, 4.0, 16.0, 64.0, 1e6, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
            uint64_t removed = 0;
            const Measured ms = measure(options.repeats, [&] {
                World world;
                world.load(level);
                world.applyEdits({CarveEdit{.radii = {0.1, 0.1, 0.1}}});  // the first cut of a shape examines all of it
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
            if (radius == 16.0) (size == sizes.front() ? inSmallest : inLargest) = ms.median;
            if (std::isnan(radius)) nanTouched += removed;
            table.add({fmt::format("{}^3", size), fmt::format("{:g}", radius), ms.text(), std::to_string(removed),
                       nameOf(outcome)});
            cells.push_back({fmt::format("{:g}", radius), fmt::format("{}^3", size), outcome,
                             removed ? fmt::format("{:.2f} ms", ms.median) : "nothing"});
        }
    }
    table.conclusion = fmt::format(
        "{} points stay within 1/60 s; a radius of 16 cells takes {:.2f} ms in the smallest cube and {:.2f} ms in the "
        "largest; a radius of NaN removes nothing.",
        countOf(cells, Outcome::Stable), inSmallest, inLargest);
    table.failed = inLargest > 4.0 * inSmallest || nanTouched > 0;
    writeMap(options, "T13-split", "One cut and its split: ms of that step", "radius of the cut, cells", "cube, cells",
             cells, kTimes);
    return table;
}

Table fragmentMap(const Options& options) {
    Table table{"T13-fragments",
                "one explosion at a block of 48^3 cells: size against hardness",
                {"material", "hardness", "size of the explosion", "ms", "fragments", "voxels of dust", "outcome"},
                {}};
    std::vector<MapCell> cells;
    uint64_t maxPieces = 0;
    double slowest = 0.0;
    const std::vector<double> charges = options.full ? std::vector<double>{0.25, 0.5, 1.0, 2.0, 4.0, 1e3, 1e300}
                                                     : std::vector<double>{0.5, 1.0, 2.0, 4.0, 1e300};
    for (const scenes::SurfaceStyle& style : {scenes::kLeaves, scenes::kPlaster, scenes::kTimber, scenes::kBrick,
                                              scenes::kConcrete, scenes::kSteel, scenes::kRock}) {
        const Level level = block(48, style);
        const Material& material = defaultMaterials()[defaultMaterials().find(style.material)];
        const char* hardness =
            std::array{"soft", "medium", "hard", "unbreakable", "unphysical"}[size_t(material.hardness)];
        for (const double charge : charges) {
            uint64_t pieces = 0, dust = 0;
            const Measured ms = measure(options.repeats, [&] {
                World world;
                world.load(level);
                world.applyEdits({});
                double one = 0.0;
                FrameChanges changes;
                {
                    const ScopedTimer timer(one);
                    changes = world.applyEdits({ExplodeEdit{{2.4, 3.6, 4.8}, charge}});
                }
                pieces = dust = 0;
                for (const ShapeSplit& split : changes.splits) pieces += split.children.size();
                for (const RemovedVoxels& each : changes.removed) dust += each.count;
                return one;
            });
            const Outcome outcome = pieces + dust == 0 ? Outcome::Refused : outcomeOf(ms.median);
            maxPieces = std::max(maxPieces, pieces), slowest = std::max(slowest, ms.median);
            table.add({std::string(style.material), hardness, fmt::format("{:g}", charge), ms.text(),
                       std::to_string(pieces), std::to_string(dust), nameOf(outcome)});
            cells.push_back({fmt::format("{:g}", charge), fmt::format("{}, {}", style.material, hardness), outcome,
                             pieces + dust ? fmt::format("{} pieces\n{:.1f} ms", pieces, ms.median) : "nothing"});
        }
    }
    table.conclusion = fmt::format("{} points stay within 1/60 s; at most {} pieces, at most {:.0f} ms.",
                                   countOf(cells, Outcome::Stable), maxPieces, slowest);
    writeMap(options, "T13-fragments", "One explosion: fragments, and ms of that step",
             "size of the explosion: radius in metres in soft material", "material, hardness", cells, kTimes);
    return table;
}

Table stressMap(const Options& options) {
    constexpr int kDepth = 4;
    Table table{
        "T13-stress",
        "a concrete cantilever 4 cells deep: whether it stands, by strength and span, compared with beam theory",
        {"strength scale", "span cells", "stress over strength by beam theory", "stands", "steps until it broke",
         "max step us", "outcome"},
        {}};
    std::vector<MapCell> cells;
    const std::vector<double> scales = options.full
                                           ? std::vector<double>{1e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3, 1.0, 10.0}
                                           : std::vector<double>{1e-3, 0.01, 0.03, 0.1, 1.0};
    const std::vector<int> spans = options.full ? std::vector<int>{4, 8, 16, 24, 32, 48, 64, 96, 128, 256}
                                                : std::vector<int>{8, 12, 16, 24, 32, 38, 48, 64};
    double slowest = 0.0;
    for (const double scale : scales)
        for (const int span : spans) {
            World world;
            WorldSettings settings;
            settings.stress.on = true;
            settings.stress.strengthScale = scale;
            world.setSettings(settings);
            world.load(cantilever(kDepth, span));
            std::vector<double> us;
            int broke = -1;
            for (int step = 0; step < 120 && broke < 0; ++step) {
                double ms = 0.0;
                {
                    const ScopedTimer timer(ms);
                    if (!world.applyEdits({}).cracks.empty()) broke = step;
                }
                us.push_back(ms * 1000.0);
            }
            const double theory = beamTheory(kDepth, span, scale);
            const bool stands = broke < 0, should = theory<1.0, isNear = theory> 0.9 && theory < 1.1;
            const Outcome outcome = stands == should ? Outcome::Stable : isNear ? Outcome::Degraded : Outcome::Failed;
            slowest = std::max(slowest, *std::max_element(us.begin(), us.end()));
            table.add({fmt::format("{:g}", scale), std::to_string(span), fmt::format("{:.3g}", theory),
                       stands ? "yes" : "no", stands ? "" : std::to_string(broke),
                       fmt::format("{:.0f}", *std::max_element(us.begin(), us.end())), nameOf(outcome)});
            cells.push_back({std::to_string(span), fmt::format("{:g}", scale), outcome,
                             fmt::format("{}\n{}", stands ? "stands" : "breaks",
                                         theory < 100.0 ? fmt::format("{:.2f}", theory) : ">99")});
        }
    table.failed =
        std::any_of(cells.begin(), cells.end(), [](const MapCell& cell) { return cell.outcome == Outcome::Failed; });
    table.conclusion = fmt::format(
        "{} points agree with beam theory (disagree, but within 10 % of its limit: {}; contradict it: {}); the slowest "
        "step takes {:.1f} ms.",
        countOf(cells, Outcome::Stable), countOf(cells, Outcome::Degraded), countOf(cells, Outcome::Failed),
        slowest / 1000.0);
    writeMap(options, "T13-stress", "A cantilever: whether it stands, and stress over strength by beam theory",
             "span, cells of 0.1 m", "strength, as a share of the real one", cells,
             {"agrees with theory", "within 10 % of it", "contradicts it", nullptr});
    return table;
}

}  // namespace rubble::tradeoff
