#include "physics/character/character.h"

#include <gtest/gtest.h>

#include <cmath>

#include "runtime/core/constants.h"
#include "runtime/core/random.h"
#include "runtime/world/queries/query.h"
#include "runtime/world/state/world_state.h"
#include "tests/physics/physics_scene.h"

namespace rubble {
namespace {

/// A scene with one character.
struct Walk : PhysicsScene {
    explicit Walk(glm::dvec3 feet = {0.0, 0.01, 0.0}) {
        level.characters.emplace_back();
        level.characters[0].position = feet;
    }
    void wish(glm::dvec3 velocity, bool jump = false, bool crouch = false) {
        edits.push_back(MoveCharacterEdit{who(), velocity, jump, crouch});
    }
    void walk(int steps) {
        for (int i = 0; i < steps; ++i) stepWith(std::exchange(edits, {}));
    }
    /// Walks toward a velocity for a time and returns how far it came.
    glm::dvec3 go(glm::dvec3 velocity, double time) {
        const glm::dvec3 before = me().position;
        wish(velocity);
        walk(int(time * 60.0));
        return me().position - before;
    }
    CharacterHandle who() const { return world.characters().handleAt(0); }
    const Character& me() const { return world.characters().at(who()); }
    bool isInside() const {
        const Character& c = me();
        const QueryShape capsule{.kind = QueryShapeKind::Capsule,
                                 .position = c.position + glm::dvec3(0, c.radius, 0),
                                 .end = c.position + glm::dvec3(0, c.currentHeight() - c.radius, 0),
                                 .radius = c.radius - 1e-6};
        return !overlappingShapes(world, capsule, {.rejectDynamic = true}).empty();
    }
    Edits edits;
};

TEST(Character, WalksOnTheGroundAtItsSpeedAndStops) {
    Walk scene;
    scene.addFloor();
    scene.load();
    scene.walk(30);
    EXPECT_TRUE(scene.me().grounded);
    EXPECT_TRUE(scene.me().ground == scene.handle(0));
    EXPECT_NEAR(scene.me().position.y, 0.0, 0.02);
    const glm::dvec3 distance = scene.go({2.0, 0.0, 0.0}, 1.0);
    EXPECT_NEAR(distance.x, 2.0, 0.01);
    EXPECT_NEAR(scene.go({0.0, 0.0, 30.0}, 1.0).z, 4.0, 0.05) << "no faster than its walking speed";
    EXPECT_NEAR(glm::length(scene.go({}, 1.0)), 0.0, 1e-6);
}

TEST(Character, SlidesAlongAWall) {
    Walk scene;
    scene.addFloor();
    scene.add(solidGrid({2, 30, 100}, 7), {1.0, 0.0, -5.0}, true);
    scene.load();
    scene.walk(10);
    const glm::dvec3 distance = scene.go({2.0, 0.0, 2.0}, 1.5);
    EXPECT_NEAR(scene.me().position.x, 0.7, 0.02);
    EXPECT_NEAR(distance.z, 3.0, 0.1);
    EXPECT_FALSE(scene.isInside());
}

TEST(Character, ClimbsStepsUpToItsStepHeightAndNoHigher) {
    for (const int rise : {1, 2, 3, 4, 5, 8}) {
        Walk scene;
        scene.addFloor();
        for (int i = 0; i < 5; ++i) scene.add(solidGrid({6, rise * (i + 1), 30}, 7), {1.0 + 0.6 * i, 0.0, -1.5}, true);
        scene.load();
        scene.walk(10);
        scene.go({2.0, 0.0, 0.0}, 1.8);
        EXPECT_FALSE(scene.isInside());
        if (rise > 4) {
            EXPECT_LT(scene.me().position.y, 0.02) << rise;
            continue;
        }
        EXPECT_NEAR(scene.me().position.y, 0.1 * rise * 5, 0.1 * rise + 0.02) << rise;
        EXPECT_GT(scene.me().position.x, 3.0) << rise;
        scene.go({-2.0, 0.0, 0.0}, 2.5);  // down again, without losing the ground
        EXPECT_NEAR(scene.me().position.y, 0.0, 0.02) << rise;
    }
}

TEST(Character, WalksUpSlopesThatItCanStandOn) {
    for (const auto& [degrees, climbs] : {std::pair(20.0, true), std::pair(40.0, true), std::pair(55.0, false)}) {
        Walk scene;
        scene.addFloor();
        const double angle = degrees * kPi / 180.0;
        scene.add(solidGrid({60, 4, 30}, 7), {1.0 + 0.4 * std::sin(angle), -0.4 * std::cos(angle), -1.5}, true,
                  glm::angleAxis(angle, glm::dvec3(0, 0, 1)));
        scene.load();
        scene.walk(10);
        scene.go({2.0, 0.0, 0.0}, 2.0);
        if (climbs)
            EXPECT_GT(scene.me().position.y, 0.5) << degrees;
        else
            EXPECT_LT(scene.me().position.y, 0.35) << degrees;
        EXPECT_FALSE(scene.isInside());
    }
}

TEST(Character, ASteepStairOfVoxelsIsASteepSlope) {
    for (const auto& [run, climbs] : {std::pair(2, true), std::pair(1, true)}) {  // 0.1 m steps, 0.2 and 0.1 m deep
        Walk scene;
        scene.addFloor();
        VoxelGrid stairs({20 * run, 20, 30});
        {
            GridWriter writer(stairs);
            for (int z = 0; z < 30; ++z)
                for (int x = 0; x < 20 * run; ++x)
                    for (int y = 0; y <= x / run; ++y) writer.set({x, y, z}, 7);
        }
        scene.add(std::move(stairs), {1.0, 0.0, -1.5}, true);
        scene.load();
        scene.walk(10);
        scene.go({2.0, 0.0, 0.0}, 1.8);
        EXPECT_EQ(scene.me().position.y > 0.6, climbs) << run << " " << scene.me().position.y;
    }
    Walk scene;
    scene.addFloor();
    VoxelGrid stairs({10, 30, 30});  // three up, one along
    {
        GridWriter writer(stairs);
        for (int z = 0; z < 30; ++z)
            for (int x = 0; x < 10; ++x)
                for (int y = 0; y <= 3 * x && y < 30; ++y) writer.set({x, y, z}, 7);
    }
    scene.add(std::move(stairs), {1.0, 0.0, -1.5}, true);
    scene.load();
    scene.walk(10);
    scene.go({2.0, 0.0, 0.0}, 1.8);
    EXPECT_LT(scene.me().position.y, 0.5);
}

TEST(Character, JumpsAsHighAsItsSpeedAndFalls) {
    Walk scene;
    scene.addFloor();
    scene.load();
    scene.walk(10);
    scene.wish({}, true);
    double highest = 0.0;
    for (int i = 0; i < 90; ++i) {
        scene.walk(1);
        highest = std::max(highest, scene.me().position.y);
    }
    EXPECT_NEAR(highest, 4.5 * 4.5 / (2.0 * 9.81), 0.06);
    EXPECT_TRUE(scene.me().grounded);
    EXPECT_NEAR(scene.me().position.y, 0.0, 0.02);
}

TEST(Character, CrouchesUnderThingsAndStandsUpOnlyWhereThereIsSpace) {
    Walk scene;
    scene.addFloor();
    scene.add(solidGrid({20, 5, 40}, 7), {1.0, 1.3, -2.0}, true);
    scene.load();
    scene.walk(10);
    scene.go({2.0, 0.0, 0.0}, 1.0);
    EXPECT_LT(scene.me().position.x, 0.75) << "too tall";
    scene.wish({2.0, 0.0, 0.0}, false, true);
    scene.walk(60);
    EXPECT_GT(scene.me().position.x, 1.5);
    EXPECT_TRUE(scene.me().crouched);
    scene.wish({});
    scene.walk(10);
    EXPECT_TRUE(scene.me().crouched) << "the ceiling is too low";
    scene.go({2.0, 0.0, 0.0}, 2.5);
    EXPECT_GT(scene.me().position.x, 3.3);
    EXPECT_FALSE(scene.me().crouched);
    EXPECT_FALSE(scene.isInside());
}

TEST(Character, FallsIntoAHoleThatIsBlastedUnderIt) {
    Walk scene;
    scene.add(solidGrid({100, 5, 100}, 5), {-5.0, -0.5, -5.0}, true);
    scene.addFloor(7, {0.0, -3.0, 0.0});
    scene.load();
    scene.walk(20);
    ASSERT_NEAR(scene.me().position.y, 0.0, 0.02);
    CarveEdit hole{.position = {0.0, -0.2, 0.0}};
    hole.radii.fill(1.0);
    scene.edits.push_back(hole);
    scene.walk(90);
    EXPECT_NEAR(scene.me().position.y, -3.0, 0.02);
    EXPECT_TRUE(scene.me().grounded);
}

TEST(Character, IsCarriedByWhatItStandsOnAndTurnsWithIt) {
    Walk scene({1.5, 1.21, 0.0});
    scene.level.environment.gravity = {};  // else character and platform would fall differently
    LevelBody& plate = scene.add(solidGrid({60, 2, 60}, 13), {-3.0, 1.0, -3.0}, false);
    plate.velocity = {1.0f, 0.0f, 0.0f};
    plate.angularVelocity = {0.0f, 0.5f, 0.0f};
    scene.load();
    scene.walk(60);
    const glm::dvec3 middle = scene.center(0), from = scene.me().position - middle;
    EXPECT_NEAR(std::hypot(from.x, from.z), 1.5, 0.08);
    EXPECT_NEAR(std::atan2(-from.z, from.x), 0.5, 0.08);
    EXPECT_TRUE(scene.me().ground == scene.handle(0));
}

TEST(Character, LandsWhereItJumpedFromWhatMoves) {
    for (const float speed : {3.0f, 10.0f}) {
        Walk scene({0.0, 0.21, 0.0});
        scene.add(solidGrid({400, 2, 40}, 7), {-2.0, 0.0, -2.0}, false);
        scene.load();
        scene.stepWith({SetBodyEdit{.body = scene.handle(0),
                                    .setsVelocity = true,
                                    .velocity = {speed, 0.0, 0.0},
                                    .setsGravityScale = true,
                                    .gravityScale = 0.0}});
        scene.walk(5);
        ASSERT_TRUE(scene.me().grounded);
        const auto onPlatform = [&] { return scene.me().position.x - scene.center(0).x; };
        const double before = onPlatform();
        scene.wish({}, true);
        for (int i = 0; i < 90; ++i) scene.walk(1);
        ASSERT_TRUE(scene.me().grounded);
        EXPECT_NEAR(onPlatform(), before, 0.1) << speed;
    }
}

TEST(Character, LandsOnAPlatformThatRises) {
    for (const double speed : {0.5, 1.0, 3.0, 8.0}) {
        Walk scene({0.0, 1.2, 0.0});
        scene.add(solidGrid({20, 2, 20}, 7), {-1.0, 0.0, -1.0}, false);
        scene.load();
        scene.stepWith({SetBodyEdit{.body = scene.handle(0),
                                    .setsVelocity = true,
                                    .velocity = {0.0, speed, 0.0},
                                    .setsGravityScale = true,
                                    .gravityScale = 0.0}});
        int steps = 0;
        for (; !scene.me().grounded && steps < 60; ++steps) scene.walk(1);
        ASSERT_LT(steps, 60) << speed;
        for (int i = 0; i < 60; ++i) {
            scene.walk(1);
            ASSERT_TRUE(scene.me().grounded) << speed << " m/s, step " << i;
        }
        EXPECT_NEAR(scene.me().position.y - scene.center(0).y - 0.1, 0.0, 0.01) << speed;
    }
}

TEST(Character, PushesWhatIsLightAndIsStoppedByWhatIsHeavy) {
    Walk scene;
    scene.addFloor();
    scene.add(solidGrid({4, 6, 4}, 5), {1.0, 0.0, -0.2}, false);  // higher than its step height
    scene.add(solidGrid({12, 12, 12}, 13), {-2.6, 0.0, -0.6}, false);
    scene.load();
    scene.walk(30);
    scene.go({2.0, 0.0, 0.0}, 2.0);
    EXPECT_GT(scene.center(1).x, 2.0);
    const glm::dvec3 before = scene.center(2);
    scene.go({-2.0, 0.0, 0.0}, 4.0);
    EXPECT_NEAR(scene.center(2).x, before.x, 0.1);
    EXPECT_GT(scene.me().position.x, -1.2);
}

TEST(Character, IsPushedByWhatIsHeavyAndNeverThroughTheFloor) {
    Walk scene;
    scene.addFloor();
    LevelBody& block = scene.add(solidGrid({15, 15, 15}, 13), {-4.0, 0.01, -0.75}, false);
    block.velocity = {8.0f, 0.0f, 0.0f};
    scene.add(solidGrid({10, 10, 10}, 13), {1.2, 3.0, -0.5}, false);
    scene.load();
    for (int i = 0; i < 120; ++i) {
        scene.walk(1);
        ASSERT_GT(scene.me().position.y, -0.01);
        ASSERT_FALSE(scene.isInside());
    }
    EXPECT_GT(scene.me().position.x, 0.2);
}

TEST(Character, SwimsAndClimbsOut) {
    Walk scene({0.0, -2.5, 0.0});
    scene.addFloor(7, {0.0, -3.0, 0.0});
    scene.add(solidGrid({30, 30, 60}, 7), {2.0, -3.0, -3.0}, true);  // a bank as high as the water
    scene.level.waters.push_back(
        {.name = "pool", .outline = {{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, .surface = -0.2, .depth = 2.8});
    scene.load();
    scene.walk(5);
    EXPECT_TRUE(scene.me().swimming);
    const glm::dvec3 up = scene.go({0.0, 1.0, 0.0}, 1.0);
    EXPECT_NEAR(up.y, 1.0, 0.2);
    scene.go({1.0, 1.0, 0.0}, 3.0);
    for (int i = 0; i < 120 && !scene.me().grounded; ++i) scene.wish({2.0, 2.0, 0.0}, true), scene.walk(1);
    EXPECT_TRUE(scene.me().grounded);
    scene.go({2.0, 0.0, 0.0}, 0.5);
    EXPECT_NEAR(scene.me().position.y, 0.0, 0.03);
}

/// Blocks, gaps, slanted plates and dynamic pieces.
void addRuin(Walk& scene, uint64_t seed) {
    Random random(seed);
    scene.addFloor();
    for (int i = 0; i < 60; ++i) {
        const int x = int(random.below(80)), z = int(random.below(80)), w = 2 + int(random.below(12)),
                  h = 1 + int(random.below(14)), d = 2 + int(random.below(12));
        const double tilt = i % 3 ? 0.0 : double(random.unit()) - 0.5;
        scene.add(solidGrid({w, h, d}, 7), {0.1 * x - 4.0, i % 4 == 1 ? 1.2 : 0.0, 0.1 * z - 4.0}, true,
                  glm::angleAxis(tilt, glm::dvec3(0.6, 0.0, 0.8)));
    }
    for (int i = 0; i < 12; ++i) {
        const int x = int(random.below(80)), z = int(random.below(80));
        scene.add(solidGrid({3 + i % 4, 4, 3}, 4), {0.1 * x - 4.0, 2.0, 0.1 * z - 4.0}, false);
    }
}

TEST(Character, TenThousandRandomMovesNeverEndInside) {
    Random random(11);
    int jumps = 0;
    for (int run = 0; run < 5; ++run) {
        Walk scene({0.0, 3.0, 0.0});
        addRuin(scene, uint64_t(run));
        scene.load();
        for (int i = 0; i < 2000; ++i) {
            if (i % 25 == 0) {
                const float x = random.unit();
                const float z = random.unit();
                const bool jump = random.below(4) == 0, crouch = random.below(5) == 0;
                scene.wish({12.0 * x - 6.0, 0.0, 12.0 * z - 6.0}, jump, crouch);
                jumps += jump;
            }
            scene.walk(1);
            ASSERT_FALSE(scene.isInside()) << run << " " << i;
            if (std::abs(scene.me().position.x) > 8.0 || std::abs(scene.me().position.z) > 8.0)
                scene.edits.push_back(TeleportCharacterEdit{scene.who(), {0.0, 3.0, 0.0}});
        }
        EXPECT_GT(scene.me().position.y, -0.01);
    }
    EXPECT_GT(jumps, 20);
}

/// Who stands on a raft of 200 kg without friction under it.
struct Raft : Walk {
    Raft() : Walk({0.0, 1.21, 0.0}) {
        Material& ice = level.materials.materials[7];
        ice.friction = 0.0f, ice.restitution = 0.0f, ice.density = 625;
        addFloor();
        add(solidGrid({14, 10, 8}, 7), {-1.0, 0.0, -0.4}, true);
        add(solidGrid({20, 2, 8}, 7), {-1.0, 1.0, -0.4}, false);
    }
    double raftSpeed() const { return body(2).velocity.x; }
    double mass() const { return bodyMass(world, handle(2)).mass; }
};

TEST(Character, ARaftGoesBackUnderWhoRunsOnIt) {
    Raft scene;
    scene.load();
    scene.walk(30);
    ASSERT_NEAR(scene.mass(), 200.0, 1e-3);
    for (const double speed : {2.0, -1.0, 0.0}) {
        scene.wish({speed, 0.0, 0.0});
        scene.walk(20);
        EXPECT_NEAR(scene.me().velocity.x, speed, 1e-6) << "against the raft";
        EXPECT_NEAR(scene.mass() * scene.raftSpeed() + scene.me().mass * (scene.raftSpeed() + speed), 0.0, 2.0);
    }
    scene.wish({2.0, 0.0, 0.0});  // off its end
    scene.walk(10);
    const double before = scene.raftSpeed();
    while (scene.me().grounded) scene.walk(1);
    EXPECT_NEAR(scene.me().velocity.x, 2.0 + before, 0.1) << "it takes the raft's velocity along";
}

/// The cabin is one body. Nothing outside pushes it.
TEST(Character, WhoPushesTheWallOfACabinFromWithinDoesNotMoveIt) {
    Raft scene;
    scene.level.bodies[2].shapes[0].grid =
        gridOf({20, 12, 8}, [](glm::ivec3 c) { return uint8_t(c.y < 2 || c.x >= 18 || c.x < 2 ? 7 : 0); });
    scene.load();
    scene.walk(30);
    scene.wish({2.0, 0.0, 0.0});
    scene.walk(240);
    EXPECT_NEAR(scene.me().velocity.x, 0.0, 1e-6) << "it leans on the wall";
    EXPECT_NEAR(scene.raftSpeed(), 0.0, 0.01);
}

TEST(Character, ALightPlankOnAFloorStaysUnderWhoBeginsToRun) {
    Walk scene({0.0, 0.11, 0.0});
    scene.level.materials.materials[9].density = 250;
    scene.addFloor();
    scene.add(solidGrid({30, 1, 4}, 9), {-1.5, 0.0, -0.2}, false);
    scene.load();
    scene.walk(60);
    const double before = scene.center(1).x;
    const double way = scene.go({4.0, 0.0, 0.0}, 0.3).x;
    EXPECT_NEAR(scene.center(1).x, before, 0.01);
    EXPECT_GT(way, 0.2);
}

TEST(Character, IsTheSameAfterASave) {
    Walk scene({0.0, 3.0, 0.0});
    addRuin(scene, 3);
    scene.load();
    scene.wish({1.5, 0.0, 0.7});
    scene.walk(100);
    Walk other;
    other.world.setState(scene.world.state());
    other.physics.load(other.world);
    scene.physics.load(scene.world);
    for (Walk* each : {&scene, &other}) {
        each->wish({-1.0, 0.0, 2.0}, true);
        each->walk(120);
    }
    EXPECT_EQ(scene.me().hash(), other.me().hash());
}

}  // namespace
}  // namespace rubble
