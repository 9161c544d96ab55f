// Calls of one step that build on each other.
#include <gtest/gtest.h>

#include "tests/runtime/script/yard_fixture.h"

namespace rubble::script {
namespace {

TEST(SameStep, ContentIsCopiedIntoAShapeOfAnotherSize) {
    Yard yard;
    EXPECT_EQ(
        yard.run("local wall, crate = FindShape('wall'), FindShape('crate') CopyShapeContent(wall, crate) wait(0) "
                 "local x, y, z = GetShapeSize(crate) assert(x == 40 and y == 25 and z == 3, x) "
                 "assert(GetShapeVoxelCount(crate) == 3000 and GetShapeVoxelCount(wall) == 3000)"),
        "");
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING), "");
}

TEST(SameStep, ContentIsCopiedIntoAShapeOfWhichNothingStays) {
    Yard yard;
    EXPECT_EQ(yard.run("local weight, crate = FindShape('weight'), FindShape('crate') SetBrush('cube', 1, 0) "
                       "DrawShapeBox(crate, 0, 0, 0, 7, 7, 6) DrawShapeBox(crate, 0, 0, 7, 7, 6, 7) wait(0) "
                       "assert(GetShapeVoxelCount(crate) == 8) CopyShapeContent(weight, crate) wait(0) "
                       "assert(GetShapeVoxelCount(crate) == 64)"),
              "");
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING), "");
}

TEST(SameStep, AScriptIsNotStoppedWithinACopy) {
    int stopped = 0;
    for (int64_t work = 1400; work < 4000; work += 100) {
        SandboxLimits limits;
        limits.work = work;
        Yard yard(limits);
        yard.host().add("copy.lua", "function init() CopyShapeContent(FindShape('wall'), FindShape('crate')) end");
        stopped += yard.host().scripts().front().isStopped();
        yard.host().step();
        rubble_shape crate = 0;
        uint32_t count = 0;
        ASSERT_EQ(yard.api().find_by_tag(yard.world(), RUBBLE_KIND_SHAPE, "crate", nullptr, &crate, 1, &count),
                  RUBBLE_OK);
        rubble_shape_state state = {};
        ASSERT_EQ(yard.api().get_shape_state(yard.world(), crate, &state), RUBBLE_OK) << work;
        EXPECT_EQ(state.voxel_count, state.size[0] == 8 ? 512u : 3000u) << work;
    }
    EXPECT_GT(stopped, 0);
    EXPECT_LT(stopped, 26);
}

TEST(SameStep, CellsThatMoveAreNotDrawnIn) {
    Yard yard;
    const std::string error =
        yard.run("local crate = FindShape('crate') TrimShape(crate) DrawShapeBox(crate, 0, 0, 0, 1, 1, 1)");
    EXPECT_TRUE(error.starts_with("test:2: DrawShapeBox: expected a shape whose cells are known")) << error;
    EXPECT_EQ(yard.run("local crate = FindShape('crate') TrimShape(crate) wait(0) SetBrush('cube', 1, 0) "
                       "DrawShapeBox(crate, 0, 0, 0, 0, 0, 0) wait(0) assert(GetShapeVoxelCount(crate) == 511)"),
              "");
}

TEST(SameStep, ABodyThatIsFreedMoves) {
    Yard yard;
    EXPECT_EQ(yard.run("local b = FindBody('crate') SetBodyDynamic(b, false) wait(0) SetBodyDynamic(b, true) "
                       "SetBodyActive(b, true) SetBodyVelocity(b, {0, 5, 0}) SetBodyAngularVelocity(b, {0, 2, 0}) "
                       "wait(0) assert(GetBodyVelocity(b).y > 4 and GetBodyAngularVelocity(b).y > 1)"),
              "");
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING), "");
    EXPECT_EQ(yard.run("local b = FindBody('crate') SetBodyDynamic(b, false) SetBodyVelocity(b, {0, 5, 0}) "
                       "SetBodyActive(b, true) wait(0) assert(not IsBodyDynamic(b))"),
              "");
    EXPECT_NE(yard.logged(RUBBLE_LOG_WARNING)
                  .find("test:2: SetBodyVelocity: body: expected a dynamic body, found a static one"),
              std::string::npos)
        << yard.logged(0);
}

TEST(SameStep, WhatIsHeldOrResizedStaysBroken) {
    Yard yard;
    EXPECT_EQ(yard.run("local b, s = FindBody('crate'), FindShape('crate') SetBrush('cube', 1, 0) "
                       "MakeHole({0, 0.4, -2}, 0.2) wait(0) assert(IsBodyBroken(b) and IsShapeBroken(s)) "
                       "SetBodyDynamic(b, false) wait(0) assert(IsBodyBroken(b) and IsShapeBroken(s)) "
                       "ResizeShape(s, 0, 0, 0, 9, 7, 7) wait(0) assert(IsBodyBroken(b) and IsShapeBroken(s))"),
              "");
}

TEST(SameStep, WhatIsMadeIsNotBroken) {
    Yard yard;
    EXPECT_EQ(yard.run("local s = CreateShape(FindBody('crate'), Transform({0, 2, 0}), FindShape('crate')) "
                       "assert(IsHandleValid(s) and not IsShapeBroken(s)) SetBrush('cube', 1, 1) "
                       "DrawShapeBox(s, 0, 0, 0, 3, 3, 3) wait(0) assert(not IsShapeBroken(s))"),
              "");
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING), "");
}

TEST(SameStep, ShotsNeedADirection) {
    Yard yard;
    for (const char* direction : {"{0, 0, 0}", "{0/0, 0, 0}"})
        EXPECT_NE(yard.run(std::string("Shoot({0, 9, 0}, ") + direction + ")").find("Shoot: dir: expected a direction"),
                  std::string::npos)
            << direction;
}

TEST(SameStep, ABodyThatIsPutToSleepKeepsNoVelocity) {
    Yard yard;
    EXPECT_EQ(yard.run("local b = FindBody('crate') SetBodyTransform(b, Transform({0, 9, -5})) "
                       "SetBodyVelocity(b, {0, 0, 9}) wait(0) SetBodyActive(b, false) "
                       "SetBodyAngularVelocity(b, {0, 2, 0}) wait(0) assert(math.abs(GetBodyVelocity(b).z) < 1)"),
              "");
}

TEST(SameStep, TagsAreFoundAsTheyWereSet) {
    Yard yard;
    EXPECT_EQ(yard.run("local b, s = FindBody('crate'), FindShape('crate') SetTag(b, 'red') SetTag(s, 'red') "
                       "assert(FindBody('red') == b and #FindBodies('red') == 1 and FindShape('red') == s) "
                       "RemoveTag(b, 'red') assert(FindBody('red') == 0 and FindShape('red') == s) "
                       "RemoveTag(b, 'crate') assert(FindBody('crate') == 0) "
                       "for _, find in ipairs{FindLight, FindJoint, FindTrigger} do local one = find() "
                       "SetTag(one, 'blue') assert(find('blue') == one) end assert(FindBody('blue') == 0)"),
              "");
    EXPECT_EQ(yard.run("local all = #FindBodies() local made = Spawn('post.vox', Transform({0, 9, -9})) "
                       "SetTag(made[1], 'new') assert(FindBody('new') == made[1] and #FindBodies() == all + 1) "
                       "wait(0) assert(FindBody('new') == made[1] and #FindBodies() == all + 1)"),
              "");
}

rubble_light_settings bulbOf(Yard& yard) {
    rubble_light bulb = 0;
    uint32_t count = 0;
    auto light = sized<rubble_light_settings>();
    EXPECT_EQ(yard.api().find_by_tag(yard.world(), RUBBLE_KIND_LIGHT, "bulb", nullptr, &bulb, 1, &count), RUBBLE_OK);
    EXPECT_EQ(yard.api().get_light_settings(yard.world(), bulb, &light), RUBBLE_OK);
    return light;
}

TEST(SameStep, ADarkLightKeepsItsColour) {
    Yard yard;
    EXPECT_EQ(yard.run("local l = FindLight('bulb') SetLightColor(l, 1, 0.5, 0) SetLightIntensity(l, 0) wait(0) "
                       "assert(not IsLightActive(l)) SetLightColor(l, 0, 0.5, 1) wait(0) "
                       "assert(not IsLightActive(l)) SetLightIntensity(l, 8) wait(0) assert(IsLightActive(l))"),
              "");
    const rubble_light_settings light = bulbOf(yard);
    EXPECT_NEAR(light.color[1], 4.0, 1e-4);
    EXPECT_NEAR(light.color[2], 8.0, 1e-4);
}

TEST(SameStep, ChangesOfALightAddUp) {
    Yard yard;
    EXPECT_EQ(yard.run("local l = FindLight('bulb') SetLightColor(l, 1, 0, 0) SetLightIntensity(l, 5) "
                       "SetLightEnabled(l, false) wait(0)"),
              "");
    const rubble_light_settings light = bulbOf(yard);
    EXPECT_NEAR(light.color[0], 5.0, 1e-4);
    EXPECT_EQ(light.color[1], 0.0);
    EXPECT_FALSE(light.flags & RUBBLE_LIGHT_ENABLED);
}

}  // namespace
}  // namespace rubble::script
