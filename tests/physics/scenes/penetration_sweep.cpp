#include "tests/physics/scenes/penetration_sweep.h"

#include <algorithm>

#include "tests/physics/baseline/bullet_compounds.h"
#include "tests/physics/baseline/voronoi_pit.h"
#include "tests/physics/scenes/known_scenes.h"
#include "tests/support/cpu_time.h"

namespace rubble::known {
namespace {

/// Runs `step` as often as asked; the mean of the last quarter, ms.
template <class Step>
double timeLast(int steps, Step&& step) {
    const int from = steps - steps / 4;
    for (int i = 0; i < from; ++i) step();
    const double start = threadMs();
    for (int i = from; i < steps; ++i) step();
    return (threadMs() - start) / std::max(1, steps - from);
}

PenetrationPoint runRubble(const Level& level, int steps, int substeps) {
    PhysicsSettings settings;
    settings.substeps = substeps;
    settings.contactHertz = 1e9;  // as stiff as so many substeps allow
    PhysicsScene scene(sleepless(settings));
    scene.level = level;
    scene.load();
    PenetrationPoint point{"rubble", substeps, settings.iterations};
    point.stepMs = timeLast(steps, [&] { scene.step(); });
    std::vector<Pose> poses;
    scene.world.bodies().forEach([&](BodyHandle, const Body& body) { poses.push_back(body.pose); });
    point.overlaps = measureOverlaps(level, poses);
    return point;
}

PenetrationPoint runBullet(const Level& level, int steps, int substeps, int iterations) {
    BulletCompounds bullet(level, {.substeps = substeps, .iterations = iterations});
    PenetrationPoint point{"bullet", substeps, iterations};
    point.stepMs = timeLast(steps, [&] { bullet.step(); });
    std::vector<Pose> poses;
    for (size_t i = 0; i < level.bodies.size(); ++i) poses.push_back(bullet.pose(i));
    point.overlaps = measureOverlaps(level, poses);
    return point;
}

}  // namespace

std::vector<PenetrationPoint> sweepPenetration(int pieces, int steps) {
    const Level level = voronoiPit(pieces);
    std::vector<PenetrationPoint> points;
    for (const int substeps : {1, 2, 3, 4, 6, 8, 12}) points.push_back(runRubble(level, steps, substeps));
    for (const int substeps : {1, 2, 4}) points.push_back(runBullet(level, steps, substeps, 10));
    points.push_back(runBullet(level, steps, 1, 30));
    return points;
}

}  // namespace rubble::known
