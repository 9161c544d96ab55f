#include "runtime/frame/ripples.h"

#include <gtest/gtest.h>

#include "samples/scenes/test_scenes.h"

namespace rubble {
namespace {

/// A single cube of half a metre, and water whose surface cuts through it.
class RipplesTest : public testing::Test {
protected:
    void SetUp() override { world.load(makeSingleCube(2, 0.5)); }
    BodyPose cube(glm::dvec3 velocity) {
        BodyPose pose{};
        world.bodies().forEach([&](BodyHandle handle, const Body& body) {
            if (!body.isStatic) pose = {handle, body.pose, velocity};
        });
        return pose;
    }
    void addWater() {
        const WorldBox box = cubeBox();
        Level level = makeSingleCube(2, 0.5);
        level.waters.push_back({.name = "pond",
                                .outline = {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}},
                                .surface = 0.5 * (box.low.y + box.high.y),
                                .depth = 1.0});
        world.load(level);
    }
    WorldBox cubeBox() {
        WorldBox box{glm::dvec3(1e30), glm::dvec3(-1e30)};
        for (const ShapeHandle shape : world.bodies().at(cube({}).body).shapes) {
            const glm::dvec3 low = shapeToWorld(world, shape).position;
            const Shape& s = world.shapes().at(shape);
            box = box.merged({low, low + glm::dvec3(s.grid.size()) * double(s.voxelSize)});
        }
        return box;
    }
    World world;
};

TEST_F(RipplesTest, MovingBodiesMakeRingsThatFade) {
    addWater();
    Ripples ripples;
    const BodyPose moving = cube({2.0, 0.0, 0.0}), resting = cube(glm::dvec3(0.0));
    ripples.step({&resting, 1}, world);
    EXPECT_TRUE(ripples.empty()) << "a body at rest makes none";
    ripples.step({&moving, 1}, world);
    ripples.step({&moving, 1}, world);
    ASSERT_EQ(ripples.snapshot().size(), 1u) << "one ring, not one per step";
    EXPECT_GT(ripples.snapshot()[0].strength, 0.005f);
    EXPECT_LE(ripples.snapshot()[0].strength, 0.1f);
    for (int i = 0; i < int(Ripples::kLife * 60) + 2; ++i) ripples.step({}, world);
    EXPECT_TRUE(ripples.empty());
}

TEST_F(RipplesTest, NeverMoreThanSixtyFour) {
    addWater();
    Ripples ripples;
    BodyPose moving = cube({5.0, 0.0, 0.0});
    for (int i = 0; i < 30; ++i) {
        for (int k = 0; k < 9; ++k) ripples.step({}, world);
        for (int twin = 0; twin < 9; ++twin) ripples.step({&moving, 1}, world);
    }
    EXPECT_LE(ripples.snapshot().size(), Ripples::kMaxRipples);
    EXPECT_GT(ripples.snapshot().size(), 8u);
}

TEST_F(RipplesTest, WithoutWaterThereAreNone) {
    Ripples ripples;
    const BodyPose moving = cube({2.0, 0.0, 0.0});
    ripples.step({&moving, 1}, world);
    EXPECT_TRUE(ripples.empty());
}

}  // namespace
}  // namespace rubble
