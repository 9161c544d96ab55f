// BoundsRule::Ground: what leaves a level rests on the fields that are drawn around it.
#include <gtest/gtest.h>

#include "runtime/world/impacts/impact_damage.h"
#include "runtime/world/state/level_ground.h"
#include "tests/physics/physics_scene.h"

namespace rubble {
namespace {

/// A floor of 20 x 20 m around the origin, 1 m thick, whose top is at 0.
struct Island : PhysicsScene {
    explicit Island(BoundsRule rule = BoundsRule::Ground) {
        addFloor();
        WorldSettings settings;
        settings.bounds.rule = rule;
        world.setSettings(settings);
    }
    /// A cube of 0.6 m, awake. Returns its number in the level.
    int addCube(glm::dvec3 corner, glm::dvec3 velocity = {0.0, -0.1, 0.0}) {
        add(solidGrid({6, 6, 6}, 7), corner, false).velocity = velocity;
        return int(level.bodies.size()) - 1;
    }
    void fall(double seconds) {
        for (int i = stepsIn(seconds); i; --i) stepWith({});
    }
    double height(int index) const { return body(index).pose.position.y; }
};

TEST(Ground, CarriesWhatFallsOffALevelAtTheHeightOfTheDrawnFields) {
    Island scene;
    const int cube = scene.addCube({9.9, 0.5, 0.0}, {3.0, 0.0, 0.0}), beside = scene.addCube({-14.0, 2.0, -14.0});
    scene.load();
    scene.fall(8.0);
    EXPECT_GT(scene.body(cube).pose.position.x, 10.0) << "it is off the level";
    EXPECT_NEAR(scene.center(cube).y - 0.3, kFieldsHeight, 0.01);
    EXPECT_NEAR(scene.center(beside).y - 0.3, kFieldsHeight, 0.01);
    EXPECT_TRUE(scene.body(cube).asleep && scene.body(beside).asleep) << "they rest, and cost nothing";
    EXPECT_EQ(scene.physics.stats().awake, 0);
}

TEST(Ground, IsThereOnlyWhereTheSettingAsksForIt) {
    for (const BoundsRule rule : {BoundsRule::Dust, BoundsRule::Keep}) {
        Island scene(rule);
        const int cube = scene.addCube({12.0, 0.5, 0.0});
        scene.load();
        scene.fall(2.0);
        EXPECT_LT(scene.height(cube), -10.0);
        EXPECT_TRUE(groundSlabs(scene.world.data()).empty());
    }
}

TEST(Ground, LetsNothingThroughHoweverFast) {
    Island scene;
    std::vector<int> cubes;
    for (int i = 0; i < 8; ++i)
        cubes.push_back(scene.addCube({20.0 + 3.0 * i, 30.0, 7.0 * i}, {10.0, -60.0 - 30.0 * i, 5.0 * i}));
    scene.load();
    for (int& cube : cubes) cube = int(scene.handle(cube).slot());
    scene.fall(10.0);
    for (const int slot : cubes) {
        const BodyHandle cube = scene.world.bodies().handleAt(uint32_t(slot));
        ASSERT_TRUE(scene.world.bodies().find(cube)) << "it is dust: " << slot;
        EXPECT_GT(scene.world.bodies().at(cube).pose.transformPoint(glm::dvec3(0.3)).y, kFieldsHeight + 0.2) << slot;
    }
}

TEST(Ground, LiesBelowAHoleAsDeepAsTheLevelGoes) {
    Island scene;
    const int cube = scene.addCube({0.0, 3.0, 0.0});
    scene.load();
    CarveEdit hole{.position = {0.3, -0.5, 0.3}};
    hole.radii.fill(1.5);
    scene.stepWith({hole});
    scene.fall(4.0);
    EXPECT_NEAR(scene.center(cube).y - 0.3, -1.0, 0.15) << "on the ground below the floor, or its last crumbs";
}

TEST(Ground, EndsAtTheBounds) {
    Island scene;
    scene.addCube({12.0, 0.5, 0.0}, {40.0, 0.0, 0.0});
    SetBoundsEdit edit;
    edit.bounds = {BoundsRule::Ground, {-20.0, -5.0, -20.0}, {20.0, 20.0, 20.0}};
    scene.load();
    scene.stepWith({edit});
    scene.fall(4.0);
    EXPECT_EQ(scene.world.bodies().size(), 1u) << "beyond them it is dust";
}

TEST(Ground, ThatIsTakenAwayWakesWhatLayOnIt) {
    Island scene;
    const int cube = scene.addCube({14.0, 0.0, 0.0});
    scene.load();
    scene.fall(4.0);
    ASSERT_TRUE(scene.body(cube).asleep);
    scene.stepWith({SetBoundsEdit{}});
    scene.fall(1.0);
    EXPECT_LT(scene.height(cube), -2.0);
}

TEST(Ground, CarriesCharacters) {
    Island scene;
    scene.level.characters.emplace_back();
    scene.level.characters[0].position = {9.0, 0.01, 0.0};
    scene.load();
    const CharacterHandle who = scene.world.characters().handleAt(0);
    scene.stepWith({MoveCharacterEdit{who, {3.0, 0.0, 0.0}, false, false}});
    scene.fall(2.0);
    const Character& character = scene.world.characters().at(who);
    EXPECT_GT(character.position.x, 12.0);
    EXPECT_NEAR(character.position.y, kFieldsHeight, 0.02);
    EXPECT_TRUE(character.grounded);
    EXPECT_FALSE(character.ground) << "it stands on no body";
    scene.stepWith({MoveCharacterEdit{who, {-3.0, 0.0, 0.0}, false, false}});
    scene.fall(2.0);
    EXPECT_NEAR(character.position.y, 0.0, 0.02) << "back on the level";
}

TEST(Ground, BreaksWhatFallsOnItFromHigh) {
    Island scene;
    scene.add(solidGrid({10, 10, 10}, 7), {15.0, 12.0, 0.0}, false).velocity = {0.0, -0.1, 0.0};
    scene.load();
    uint64_t broken = 0, onGround = 0;
    for (int i = 0; i < 240; ++i) {
        const Edits damage = impactDamage(scene.world.data(), scene.physics.impacts());
        for (const Impact& impact : scene.physics.impacts()) {
            onGround += !impact.other;  // World has no such body; pieces may hit each other
            EXPECT_TRUE(!impact.other || scene.world.bodies().find(impact.other));
        }
        broken += damage.size();
        scene.stepWith(damage);
    }
    EXPECT_GT(broken, 0u);
    EXPECT_GT(onGround, 0u);
}

/// Whether slabs cover a place; their tops, the highest.
double topAt(const GroundSlabs& slabs, double x, double z) {
    double top = -1e9;
    for (const GroundSlab& slab : slabs) {
        const glm::dvec3 high = slab.low + slab.side * glm::dvec3(slab.cubes.x, 1.0, slab.cubes.y);
        if (x >= slab.low.x && x < high.x && z >= slab.low.z && z < high.z) top = std::max(top, high.y);
    }
    return top;
}

TEST(Ground, LeavesOutTheLevelAndNothingElse) {
    for (const double scale : {1.0, 0.01, 300.0}) {
        WorldState world;
        world.settings.bounds.rule = BoundsRule::Ground;
        world.footprint = {{-10.0 * scale, -4.0, 3.0}, {30.0 * scale, 5.0, 80.0}};
        world.bounds = {world.footprint.low - 128.0, world.footprint.high + 128.0};
        const GroundSlabs slabs = groundSlabs(world);
        for (double x = world.bounds.low.x + 0.1; x < world.bounds.high.x; x += 6.4 * scale)
            for (double z = world.bounds.low.z + 0.1; z < world.bounds.high.z; z += 6.4) {
                const bool isLevel = x > -10.0 * scale && x < 30.0 * scale && z > 3.0 && z < 80.0;
                if (std::abs(x - 10.0 * scale) >= 4096.0) continue;
                ASSERT_NEAR(topAt(slabs, x, z), isLevel ? -4.0 : kFieldsHeight, 1e-9) << x << " " << z;
            }
        for (const GroundSlab& slab : slabs) {
            EXPECT_LE(std::max(slab.cubes.x, slab.cubes.y), kMaxGroundCubes);
            EXPECT_GE(slab.side, 3.95) << "as thick as the level is deep";
        }
    }
}

}  // namespace
}  // namespace rubble
