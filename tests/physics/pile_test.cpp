#include <gtest/gtest.h>

#include <cstdlib>

#include "physics/solver/constraint_coloring.h"
#include "runtime/core/thread_pool.h"
#include "tests/physics/baseline/overlap.h"
#include "tests/physics/baseline/pile_support.h"
#include "tests/physics/baseline/voronoi_pit.h"
#include "tests/physics/physics_scene.h"

namespace rubble {
namespace {

struct PitScene : PhysicsScene {
    explicit PitScene(int pieces, int pit = 8, const PhysicsSettings& settings = {}) : PhysicsScene(settings) {
        level = voronoiPit(pieces, 1, pit);
        load();
        world.applyEdits({});  // takes out the change that loaded the level: physics has it already
    }
    int awake() const { return physics.stats().awake; }
};

TEST(Pile, SleepsSoonAndNothingFloatsBeforeOrAfterItsFloorGoes) {
    const bool isLong = std::getenv("RUBBLE_LONG") != nullptr;
    const int pieces = isLong ? 5000 : 80, limit = isLong ? 2400 : 720;
    const double side = isLong ? 16.0 : 8.0;
    PitScene scene(pieces, int(side));
    int steps = 0;
    while (steps < limit && scene.awake() * 100 > pieces) scene.step(), ++steps;
    EXPECT_LE(scene.awake() * 100, pieces) << "after " << steps << " steps";
    for (int i = 0; i < limit && scene.awake(); ++i) scene.step();  // a body on something awake is not supported yet
    EXPECT_TRUE(findUnsupported(scene.world).empty());

    // After a hole of 3 m in the pit's floor, the bodies above are awake within a step; those that sleep later are
    // supported again.
    const glm::dvec3 low(0.5 * side - 1.5, -0.85, 0.5 * side - 1.5), high(0.5 * side + 1.5, 0.0, 0.5 * side + 1.5);
    const std::vector<BodyHandle> held = findTouching(scene.world, low, high);
    EXPECT_GT(held.size(), 3u);
    CarveEdit hole{.kind = BrushKind::Box, .position = 0.5 * (low + high), .halfSize = 0.5 * (high - low)};
    hole.shape = scene.body(0).shapes[0];
    scene.stepWith({hole});
    for (const BodyHandle body : held) EXPECT_FALSE(scene.world.bodies().at(body).asleep) << body.slot();
    for (int i = 0; i < limit && scene.awake(); ++i) scene.step();  // a body on something awake may still fall
    EXPECT_TRUE(findUnsupported(scene.world).empty());
}

TEST(Pile, FastPiecesDoNotEndDeepInEachOther) {
    PitScene scene(1000);
    for (int step = 1; step <= 90; ++step) {
        scene.physics.step();
        scene.world.setPoses(scene.physics.poses());
        EXPECT_EQ(scene.physics.stats().crowded, 0) << "these are not in one place";
        if (step % 45) continue;
        std::vector<Pose> poses;
        scene.world.bodies().forEach([&](BodyHandle, const Body& body) { poses.push_back(body.pose); });
        EXPECT_LT(measureOverlaps(scene.level, poses).worst, 0.1) << "metres, after " << step << " steps";
    }
}

TEST(Pile, TheCheckKnowsWhatFloats) {
    PhysicsScene scene;
    scene.addFloor();
    const VoxelGrid cube = solidGrid({4, 4, 4}, 7), plank = solidGrid({20, 2, 4}, 7);
    scene.add(cube, {0, 0, 0}, false);
    scene.add(cube, {0, 0.41, 0}, false);      // on the first
    scene.add(cube, {3, 0.1, 0}, false);       // 10 cm above the floor
    scene.add(plank, {0.13, 0.82, 0}, false);  // its centre of mass is beyond the edge
    scene.add(cube, {0, 5, 0}, false);         // two that touch each other only
    scene.add(cube, {0, 5.4, 0}, false);
    scene.load(false);
    const std::vector<BodyHandle> floating = findUnsupported(scene.world);
    EXPECT_EQ(floating, (std::vector{scene.handle(3), scene.handle(4), scene.handle(5), scene.handle(6)}));
}

/// The state of all bodies after every step.
std::vector<double> trace(const PhysicsSettings& settings, int pieces = 40, int steps = 120, int* pairs = nullptr) {
    PitScene scene(pieces, 4, settings);
    std::vector<double> all;
    for (int i = 0; i < steps; ++i) {
        scene.physics.step();
        for (const BodyPose& p : scene.physics.poses())
            all.insert(all.end(), {p.pose.position.x, p.pose.position.y, p.pose.position.z, p.pose.rotation.w,
                                   p.velocity.x, p.velocity.y});
        scene.world.setPoses(scene.physics.poses());
    }
    if (pairs) *pairs = scene.physics.stats().pairs;
    return all;
}

TEST(Pile, TheSameOnAnyNumberOfThreads) {
    const std::vector<double> one = trace({});
    for (const int threads : {2, 5}) {
        ThreadPool pool(threads);
        PhysicsSettings settings;
        settings.parallelFor = [&](size_t count, const std::function<void(size_t)>& f) { pool.run(count, f); };
        EXPECT_EQ(trace(settings), one) << threads;
    }
}

/// There are enough contacts for the solver to use several colors.
TEST(Pile, TheSameInAnyOrderWhenColored) {
    int pairs = 0;
    const std::vector<double> one = trace({}, 200, 100, &pairs);
    ASSERT_GE(size_t(pairs), 2 * ConstraintColoring::kPairsPerStrip);
    PhysicsSettings settings;
    settings.parallelFor = [](size_t count,
                              const std::function<void(size_t)>& f) {  // in another order, as threads might
        for (size_t i = count; i-- > 0;) f(i);
    };
    EXPECT_EQ(trace(settings, 200, 100), one);
}

/// A cut changes a falling body in place. It then moves like a body that is created from the World again.
TEST(Pile, ACutBodyMovesLikeARebuiltOne) {
    const auto fall = [](bool rebuild) {
        PhysicsScene scene;
        scene.addFloor();
        VoxelGrid block = solidGrid({40, 40, 40}, 7);
        scene.add(block, {-2, 0.5, -2}, false, glm::normalize(glm::dquat(1, 0.1, 0.2, 0.05)));
        scene.load();
        scene.world.applyEdits({});  // takes out the change that loaded the level: physics has it already
        scene.step(20);              // it is still in the air
        const ShapeHandle shape = scene.body(1).shapes[0];
        std::vector<double> all;
        for (int i = 0; i < 120; ++i) {
            Edits edits;
            if (i % 12 == 0) {
                const glm::dvec3 at = scene.body(1).pose.transformPoint({0.4 * (i / 12), 4.0, 2.0});
                edits.push_back(
                    CarveEdit{.kind = BrushKind::Sphere, .position = at, .radii = {0.7, 0.7, 0.7}, .shape = shape});
            }
            FrameChanges changes = scene.world.applyEdits(edits);
            if (rebuild && !edits.empty()) changes.shapesCreated.push_back(shape);
            scene.physics.apply(changes, scene.world);
            scene.step();
            const Body& body = scene.body(1);
            for (int k = 0; k < 3; ++k)
                all.insert(all.end(), {body.pose.position[k], body.velocity[k], body.angularVelocity[k]});
        }
        return all;
    };
    EXPECT_EQ(fall(false), fall(true));
}

}  // namespace
}  // namespace rubble
