// Joints that are moved, turned and limited after they were made.
#include "editor/core/joints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "editor/core/rotation.h"
#include "tests/editor/editor_level.h"
#include "tests/support/temp_folder.h"

namespace editor {
namespace {

rubble_joint jointOf(Editor& editor, const char* name) {
    return editor.world().find_by_name(RUBBLE_KIND_JOINT, name).at(0);
}

glm::dvec3 axisOf(Editor& editor, const char* name) {
    return quaternionOf(settingsOf(editor.world(), jointOf(editor, name)).rotation) * glm::dvec3(1, 0, 0);
}

/// A door in the air, on a hinge about y at its left edge.
void makeDoor(Editor& editor) {
    runAll(editor, {"create 8,20,1 0,0,0 name=door", "create 2,20,2 -0.65,0,0 name=post static=yes",
                    "joint hinge door post -0.45,1,0 0,1,0 low=-30 high=60 speed=10 friction=2 breaks_at=5000 "
                    "search=0.5 name=hinge",
                    "tag creaks loud hinge", "tag old \"\" hinge"});
}

TEST(Joints, AreMovedWithAllThatTheyAre) {
    Editor editor;
    makeDoor(editor);
    const uint64_t before = editor.document().hash();
    const rubble_joint_settings was = settingsOf(editor.world(), jointOf(editor, "hinge"));
    runAll(editor, {"select hinge", "move 0,0.3,0"});
    const rubble_joint moved = jointOf(editor, "hinge");
    const rubble_joint_settings now = settingsOf(editor.world(), moved);
    EXPECT_NEAR(now.position[1], was.position[1] + 0.3, 1e-9);
    EXPECT_EQ(now.shapes[0], was.shapes[0]);
    EXPECT_EQ(now.shapes[1], was.shapes[1]);
    EXPECT_EQ(now.flags, was.flags);
    EXPECT_NEAR(now.lower_limit, glm::radians(-30.0), 1e-9);
    EXPECT_NEAR(now.upper_limit, glm::radians(60.0), 1e-9);
    EXPECT_EQ(now.motor, uint32_t(RUBBLE_MOTOR_SPEED));
    EXPECT_EQ(now.motor_target, was.motor_target);
    EXPECT_EQ(now.friction, 2.0);
    EXPECT_EQ(now.break_force, 5000.0);
    EXPECT_EQ(now.anchor_radius, 0.5);
    EXPECT_STREQ(editor.world().get_tag(moved, "creaks").data(), "loud");
    EXPECT_FALSE(editor.world().get_tag(moved, "old").empty());
    EXPECT_EQ(editor.selection().objects, std::vector<uint64_t>{moved}) << "it stays selected";
    EXPECT_EQ(editor.world().get_objects(RUBBLE_KIND_JOINT).size(), 1u);
    const uint64_t after = editor.document().hash();
    runAll(editor, {"undo"});
    EXPECT_EQ(editor.document().hash(), before);
    runAll(editor, {"redo"});
    EXPECT_EQ(editor.document().hash(), after);
    const ExampleFolder folder;
    runAll(editor, {"save door.rubble", "open door.rubble"});
    EXPECT_EQ(editor.document().hash(), after);
    EXPECT_NEAR(settingsOf(editor.world(), jointOf(editor, "hinge")).position[1], was.position[1] + 0.3, 1e-9);
}

TEST(Joints, AreTurnedAndLimited) {
    Editor editor;
    makeDoor(editor);
    runAll(editor, {"rotate 0,0,90 what=hinge"});
    EXPECT_NEAR(std::abs(axisOf(editor, "hinge").x), 1.0, 1e-9) << "from y to x";
    runAll(editor, {"set_joint axis=0,0,2 high=10 what=hinge"});
    EXPECT_NEAR(axisOf(editor, "hinge").z, 1.0, 1e-9);
    rubble_joint_settings now = settingsOf(editor.world(), jointOf(editor, "hinge"));
    EXPECT_NEAR(now.lower_limit, glm::radians(-30.0), 1e-9) << "the other limit stays";
    EXPECT_NEAR(now.upper_limit, glm::radians(10.0), 1e-9);
    runAll(editor, {"set_joint limited=no what=hinge"});
    EXPECT_FALSE(settingsOf(editor.world(), jointOf(editor, "hinge")).flags & RUBBLE_JOINT_LIMITED);
    EXPECT_NE(editor.run(std::string("set_joint high=10 what=hinge")).text.find("low: expected both limits, found one"),
              std::string::npos);
}

TEST(Joints, OfADoorThatWasOpenedKeepTheirLimitsInTheWorld) {
    Editor editor;
    makeDoor(editor);
    runAll(editor, {"body gravity=0 what=door", "play", "step 60", "keep"});
    const double opened = editor.world().get_joint_properties(jointOf(editor, "hinge")).movement;
    ASSERT_GT(std::abs(opened), 0.05) << "its motor turns it";
    runAll(editor, {"set_joint friction=3 what=hinge"});
    const rubble_joint_properties now = editor.world().get_joint_properties(jointOf(editor, "hinge"));
    EXPECT_NEAR(now.movement, 0.0, 1e-6) << "it counts from where it is now";
    EXPECT_NEAR(now.lower_limit, glm::radians(-30.0) - opened, 1e-6);
    EXPECT_NEAR(now.upper_limit, glm::radians(60.0) - opened, 1e-6);
}

TEST(Joints, ThatFindNoVoxelsStayAsTheyAre) {
    Editor editor;
    makeDoor(editor);
    const uint64_t before = editor.document().hash();
    const rubble_joint joint = jointOf(editor, "hinge");
    const Outcome outcome = editor.run(std::string("move 0,9,0 hinge"));
    EXPECT_FALSE(outcome.isDone);
    EXPECT_EQ(editor.document().hash(), before);
    EXPECT_EQ(jointOf(editor, "hinge"), joint);
}

TEST(Joints, OfMovedBodiesGoWithThemAndRopesAreRefused) {
    Editor editor;
    makeDoor(editor);
    const rubble_joint joint = jointOf(editor, "hinge");
    runAll(editor, {"move 0,2,0 door,post,hinge"});
    EXPECT_EQ(jointOf(editor, "hinge"), joint) << "it was not made again";
    EXPECT_NEAR(settingsOf(editor.world(), joint).position[1], 3.0, 1e-9);
    runAll(editor, {"rope door world 0,4,0 0,6,0 name=line"});
    for (const char* line : {"move 0,1,0 line", "set_joint 0,4,0 what=line"}) {
        const Outcome outcome = editor.run(std::string(line));
        EXPECT_FALSE(outcome.isDone) << line;
        EXPECT_NE(outcome.text.find("found line"), std::string::npos) << outcome.text;
    }
}

}  // namespace
}  // namespace editor
