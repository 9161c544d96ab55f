#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "physics/shapes/voxel_collider.h"
#include "tests/physics/baseline/box_merge.h"
#include "tests/physics/baseline/bullet_compounds.h"
#include "tests/physics/baseline/overlap.h"
#include "tests/physics/baseline/voronoi_pit.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/tradeoff/physics.h"

namespace rubble::tradeoff {
namespace {

using Detail = BulletCompounds::Detail;

enum class Shapes { Voxels, HalfAsFine, Box };
struct Variant {
    const char* name;
    bool isBullet;
    Shapes shapes;  ///< ours
    Detail detail;  ///< Bullet's
};
constexpr Variant kVariants[] = {
    {"every voxel", false, Shapes::Voxels, {}},
    {"voxels half as fine", false, Shapes::HalfAsFine, {}},
    {"voxels of one box", false, Shapes::Box, {}},
    {"Bullet, a box a voxel", true, {}, Detail::EveryVoxel},
    {"Bullet, merged boxes", true, {}, Detail::MergedBoxes},
    {"Bullet, one box", true, {}, Detail::OneBox},
};

/// The level with coarser grids of its dynamic bodies.
Level coarser(Level level, Shapes shapes) {
    for (LevelBody& body : level.bodies) {
        LevelShape& shape = body.shapes[0];
        if (body.isStatic || shapes == Shapes::Voxels) continue;
        const SolidEntries solid = solidEntries(*shape.palette, level.materials);
        if (shapes == Shapes::HalfAsFine) {
            shape.grid = halveGrid(shape.grid, solid);
            shape.voxelSize *= 2.0f;
            continue;
        }
        CellBox all{glm::ivec3(1 << 20), glm::ivec3(0)};
        for (const CellBox& box : mergeGrid(shape.grid, solid))
            all = {glm::min(all.low, box.low), glm::max(all.high, box.high)};
        shape.local.position += glm::dvec3(all.low) * double(shape.voxelSize);
        shape.grid = solidGrid(all.high - all.low, 1);
    }
    return level;
}

/// The pieces of a pit, each on its own a little above a floor.
Level apart(const Level& pit) {
    Level level;
    level.materials = pit.materials;
    const int side = int(std::ceil(std::sqrt(double(pit.bodies.size() - 1))));
    for (size_t i = 1; i < pit.bodies.size(); ++i) {
        LevelBody body = pit.bodies[i];
        const int k = int(i - 1);
        body.pose.position +=
            glm::dvec3(2.0 * (k % side), 0.6, 2.0 * (k / side)) - body.pose.transformPoint(glm::dvec3(0.4));
        level.bodies.push_back(std::move(body));
    }
    LevelBody floor;
    floor.name = "floor";
    floor.isStatic = true;
    floor.pose.position = {-2, -1, -2};
    LevelShape shape;
    shape.name = "floor";
    shape.palette = pit.bodies[0].shapes[0].palette;
    shape.grid = solidGrid({20 * side + 20, 10, 20 * side + 20}, 7);
    floor.shapes.push_back(std::move(shape));
    level.bodies.push_back(std::move(floor));
    return level;
}

/// A level simulated by one of the two engines.
class Run {
public:
    Run(const Level& level, const Variant& variant) {
        if (variant.isBullet) {
            m_bullet = std::make_unique<BulletCompounds>(level, BulletCompounds::Settings{.detail = variant.detail});
            for (size_t i = 0; i < level.bodies.size(); ++i) m_bodies.push_back(i);
            return;
        }
        m_scene = std::make_unique<PhysicsScene>(known::sleepless({}));
        m_scene->level = coarser(level, variant.shapes);
        m_scene->load();
    }
    void step() { m_scene ? m_scene->physics.step() : m_bullet->step(); }
    void afterStep() {
        if (m_scene) m_scene->world.setPoses(m_scene->physics.poses());
    }
    int pairs() const { return m_scene ? m_scene->physics.stats().pairs : m_bullet->pairs(); }
    std::vector<Pose> poses() const {
        std::vector<Pose> all;
        for (const size_t i : m_bodies) all.push_back(m_bullet->pose(i));
        if (m_scene) m_scene->world.bodies().forEach([&](BodyHandle, const Body& body) { all.push_back(body.pose); });
        return all;
    }

private:
    std::unique_ptr<PhysicsScene> m_scene;
    std::unique_ptr<BulletCompounds> m_bullet;
    std::vector<size_t> m_bodies;
};

/// Heap bytes of an empty Bullet world.
double emptyWorldBytes() {
    const size_t before = mallinfo2().uordblks;
    const auto world = std::make_unique<BulletCompounds>(Level{}, BulletCompounds::Settings{});
    return double(mallinfo2().uordblks - before);
}

/// Time and memory per piece of the collision data of a piece that touches others on all sides.
struct Build {
    double ms = 0.0, bytes = 0.0;
};
Build buildOf(const Level& pieces, const Variant& variant) {
    const Level level = variant.isBullet ? pieces : coarser(pieces, variant.shapes);
    World world;
    world.load(level);
    const size_t before = mallinfo2().uordblks;
    std::vector<std::unique_ptr<ColliderPart>> parts;
    std::unique_ptr<BulletCompounds> bullet;
    const double ms = cpuMs([&] {
        if (variant.isBullet) {
            bullet = std::make_unique<BulletCompounds>(level, BulletCompounds::Settings{.detail = variant.detail});
            return;
        }
        world.shapes().forEach([&](ShapeHandle, const Shape& shape) {
            ColliderPart& part = *parts.emplace_back(std::make_unique<ColliderPart>(shape, Pose{}, world.materials()));
            part.hull();
            if (part.whole()) return;
            part.grid().forEachBrick(
                [&](glm::ivec3 brick, const BrickRef&) { part.features(brick), part.rows(brick); });
        });
    });
    const double count = double(level.bodies.size());
    const double bytes = double(mallinfo2().uordblks - before);
    return {ms / count, (bytes - (variant.isBullet ? emptyWorldBytes() : 0.0)) / count};
}

struct Result {
    std::vector<double> us;
    std::vector<double> buildMs;
    double bytes = 0.0, pairs = 0.0;
    Overlaps overlaps;
    std::vector<Pose> rest;
};

void fall(const Level& pit, const Variant& variant, Result& result) {
    constexpr int kSteps = 150;
    Run run(pit, variant);
    double ms = 0.0, pairs = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double once = cpuMs([&] { run.step(); });
        run.afterStep();
        if (i >= kSteps / 2) ms += once, pairs += run.pairs();
    }
    result.us.push_back(ms * 1e3 / std::max(pairs, 1.0));
    result.pairs = pairs / (kSteps / 2);
    if (result.us.size() == 1) result.overlaps = measureOverlaps(pit, run.poses());
}

/// Rest poses compared with the reference: median difference of the heights in mm, and share of pieces with another
/// pose.
std::pair<double, double> compareRest(const Level& level, const std::vector<Pose>& rest,
                                      const std::vector<Pose>& reference) {
    std::vector<double> heights;
    double otherwise = 0.0;
    for (size_t i = 0; i + 1 < level.bodies.size(); ++i) {
        const LevelShape& shape = level.bodies[i].shapes[0];
        const glm::dvec3 center =
            massProperties(gridMoments(shape.grid, *shape.palette, level.materials), shape.voxelSize).center;
        heights.push_back(std::abs(rest[i].transformPoint(center).y - reference[i].transformPoint(center).y) * 1e3);
        const glm::dvec3 up = glm::conjugate(rest[i].rotation) * glm::dvec3(0, 1, 0),
                         was = glm::conjugate(reference[i].rotation) * glm::dvec3(0, 1, 0);
        otherwise += glm::dot(up, was) < std::cos(glm::radians(10.0));
    }
    return {quantile(heights, 0.5), otherwise / double(heights.size())};
}

/// Where the pieces lie after four seconds on a floor, each on its own.
std::vector<Pose> restPoses(Run&& run) {
    for (int i = 0; i < 240; ++i) run.step(), run.afterStep();
    return run.poses();
}

/// The same with every voxel and the accurate preset.
std::vector<Pose> accurateRest(const Level& floor) {
    PhysicsScene accurate(known::sleepless(accuratePhysics()));
    accurate.level = floor;
    accurate.load();
    accurate.seconds(4.0);
    std::vector<Pose> poses;
    accurate.world.bodies().forEach([&](BodyHandle, const Body& body) { poses.push_back(body.pose); });
    return poses;
}

/// Runs all variants in alternation, so that other load on the machine affects them alike.
std::vector<Result> measureVariants(const Options& options, const Level& pit) {
    Level onlyPieces = pit;
    onlyPieces.bodies.erase(onlyPieces.bodies.begin());
    std::vector<Result> results(std::size(kVariants));
    for (int i = 0; i < options.repeats; ++i)
        for (size_t v = 0; v < results.size(); ++v) {
            if (kVariants[v].detail == Detail::EveryVoxel && kVariants[v].isBullet && i > 0 && !options.full)
                continue;  // takes as long as all others together
            fall(pit, kVariants[v], results[v]);
            const Build build = buildOf(onlyPieces, kVariants[v]);
            results[v].buildMs.push_back(build.ms), results[v].bytes = build.bytes;
        }
    return results;
}

constexpr const char* kNote =
    "Overlap: of the original voxels. Pairs: mean number of touching pairs. Build and bytes: all that collision can "
    "need of a piece; ours is computed brick by brick when another body comes near. Rest error: difference in height "
    "of a piece's centre when it lies alone on a floor, from every voxel with the accurate preset, median. Other pose: "
    "rotated by more than 10 degrees.";

}  // namespace

Table collisionTradeoff(const Options& options) {
    const int pieces = options.full ? 144 : 72;
    Table table{
        "T3",
        fmt::format("collision shapes: {} pieces of 64 to 600 voxels in a pit, and one by one on a floor", pieces),
        {"collision shape", "us per pair", "pairs", "build ms per piece", "bytes per piece", "mean overlap mm",
         "max overlap mm", "rest error mm", "other pose %"},
        {}};
    table.note = kNote;
    const Level pit = voronoiPit(pieces, options.seed), floor = apart(pit);
    const std::vector<Pose> reference = accurateRest(floor);
    const std::vector<Result> results = measureVariants(options, pit);
    std::vector<Series> overlap, rest;
    for (size_t v = 0; v < results.size(); ++v) {
        const Result& r = results[v];
        const Measured us = summary(r.us);
        const auto [off, otherwise] = compareRest(floor, restPoses(Run(floor, kVariants[v])), reference);
        table.add({kVariants[v].name, us.text(), fmt::format("{:.0f}", r.pairs), summary(r.buildMs).text(),
                   fmt::format("{:.0f}", r.bytes), fmt::format("{:.2f}", r.overlaps.mean * 1e3),
                   fmt::format("{:.1f}", r.overlaps.worst * 1e3), fmt::format("{:.2f}", off),
                   fmt::format("{:.0f}", otherwise * 100.0)});
        overlap.push_back({kVariants[v].name, {{us.median, std::max(r.overlaps.mean * 1e3, 0.01)}}, true, true});
        rest.push_back({kVariants[v].name, {{us.median, std::max(off, 0.01)}}, true, true});
    }
    const double merged = summary(results[4].us).median, voxels = summary(results[0].us).median;
    table.failed = results[0].overlaps.mean > results[4].overlaps.mean;
    table.conclusion = fmt::format(
        "Every voxel takes {:.1f} us per pair and overlaps by {:.2f} mm; Bullet's merged boxes take {:.1f} us ({:.1f} "
        "times as long) and overlap by {:.2f} mm.",
        voxels, results[0].overlaps.mean * 1e3, merged, merged / voxels, results[4].overlaps.mean * 1e3);
    writePlot(options, "T3-overlap", "Collision shapes: cost against overlap", "us per pair", "mean overlap, mm",
              overlap);
    writePlot(options, "T3-rest", "Collision shapes: cost against rest pose", "us per pair", "error of height, mm",
              rest);
    return table;
}

}  // namespace rubble::tradeoff
