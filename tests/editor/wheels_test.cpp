// Wheels: a car that is made by commands, driven in play, and changed afterwards.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "editor/core/joints.h"
#include "editor/core/rotation.h"
#include "tests/editor/editor_level.h"

namespace editor {
namespace {

/// A plate on four wheels, which drives towards +z: x is its left.
void makeCar(Editor& editor) {
    runAll(editor, {"create 200,2,400 0,-0.2,0 index=6 name=ground static=yes", "create 14,3,28 0,0.3,0 name=car",
                    "create 3,8,8 0.9,0,0.9 form=cylinder_x index=19 name=front_left",
                    "create 3,8,8 -0.9,0,0.9 form=cylinder_x index=19 name=front_right",
                    "create 3,8,8 0.9,0,-0.9 form=cylinder_x index=19 name=back_left",
                    "create 3,8,8 -0.9,0,-0.9 form=cylinder_x index=19 name=back_right",
                    "wheel car front_left steer=30 name=axle_front_left",
                    "wheel car front_right steer=30 name=axle_front_right", "wheel car back_left name=axle_back_left",
                    "wheel car back_right name=axle_back_right"});
}

glm::dvec3 placeOfCar(Editor& editor) {
    return vectorOf(editor.world().get_body_state(editor.world().find_by_name(RUBBLE_KIND_BODY, "car").at(0)).position);
}

rubble_joint axleOf(Editor& editor, const char* name) {
    return editor.world().find_by_name(RUBBLE_KIND_JOINT, name).at(0);
}

TEST(Wheels, MakeACarThatDrivesAndSteersInPlay) {
    Editor editor;
    makeCar(editor);
    const uint64_t before = editor.document().hash();
    runAll(editor, {"play", "drive 0.5 what=car", "step 180"});
    const glm::dvec3 straight = placeOfCar(editor);
    EXPECT_GT(straight.z, 3.0);
    EXPECT_LT(std::abs(straight.x), 0.2 * straight.z);
    EXPECT_NEAR(straight.y, 0.3, 0.1) << "it stands on its wheels";
    runAll(editor, {"stop"});
    EXPECT_EQ(editor.document().hash(), before);
    runAll(editor, {"play", "drive 0.5 1 what=car", "step 180"});
    EXPECT_GT(placeOfCar(editor).x, 0.5) << "to the left";
    runAll(editor, {"drive 0 0 1 what=car", "step 120"});
    const glm::dvec3 stopped = placeOfCar(editor);
    runAll(editor, {"step 30"});
    EXPECT_LT(glm::length(placeOfCar(editor) - stopped), 0.05) << "the brake holds";
    runAll(editor, {"stop"});
    EXPECT_EQ(editor.document().hash(), before);
}

TEST(Wheels, TurnByTheirMotorsAndKeepTheirSteering) {
    Editor editor;
    makeCar(editor);
    runAll(editor, {"motor speed 300 force=500 steer=20 what=axle_front_left,axle_front_right",
                    "motor speed 300 force=500 what=axle_front_left,axle_front_right", "play", "step 150"});
    EXPECT_GT(placeOfCar(editor).z, 1.0);
    EXPECT_GT(placeOfCar(editor).x, 0.1) << "the second command forgot the steering";
}

TEST(Wheels, AreChangedAndMovedWithAllThatTheyAre) {
    Editor editor;
    makeCar(editor);
    runAll(editor, {"tag spare no axle_front_left"});
    const uint64_t before = editor.document().hash();
    const rubble_joint_settings was = settingsOf(editor.world(), axleOf(editor, "axle_front_left"));
    EXPECT_NEAR(was.position[0], 0.9, 1e-6) << "in the middle of the wheel";
    EXPECT_NEAR(was.position[1], 0.4, 1e-6);
    EXPECT_NEAR(was.lower_limit, -0.12, 1e-9);
    runAll(editor, {"set_joint high=0.3 drive=700 steer=20 spin=5 what=axle_front_left"});
    const rubble_joint axle = axleOf(editor, "axle_front_left");
    const rubble_joint_settings now = settingsOf(editor.world(), axle);
    EXPECT_NEAR(now.upper_limit, 0.3, 1e-9);
    EXPECT_NEAR(now.lower_limit, -0.12, 1e-9) << "the other limit stays";
    EXPECT_EQ(now.drive_torque, 700.0);
    EXPECT_EQ(now.brake_torque, was.brake_torque);
    EXPECT_NEAR(now.max_steer_angle, glm::radians(20.0), 1e-9);
    EXPECT_NEAR(now.max_spin, glm::radians(5.0 * 360.0), 1e-6);
    EXPECT_EQ(now.steer_rate, was.steer_rate);
    EXPECT_EQ(now.spring_hertz, 8.0);
    EXPECT_FALSE(editor.world().get_tag(axle, "spare").empty());
    runAll(editor, {"undo"});
    EXPECT_EQ(editor.document().hash(), before);
    runAll(editor, {"move 0,0.05,0 axle_front_left", "set_joint axis=1,0,1 what=axle_front_left"});
    const rubble_joint_settings turned = settingsOf(editor.world(), axleOf(editor, "axle_front_left"));
    EXPECT_NEAR(turned.position[1], 0.45, 1e-6);
    const glm::dquat frame = quaternionOf(turned.rotation);
    EXPECT_NEAR((frame * glm::dvec3(1, 0, 0)).z, std::sqrt(0.5), 1e-9);
    EXPECT_NEAR((frame * glm::dvec3(0, 1, 0)).y, 1.0, 1e-9) << "the suspension stays upright";
}

TEST(Wheels, ThatAreNotRoundAreToldOf) {
    Editor editor;
    makeCar(editor);
    runAll(editor, {"create 3,8,8 0.9,0,0 name=square", "create 8,3,8 -0.9,0.2,0 form=cylinder_y name=lying"});
    for (const char* name : {"square", "lying"}) {
        const std::string wheel = fmt::format("wheel car {}", name);
        EXPECT_EQ(
            editor.run(wheel).text,
            fmt::format("{} is not round about its axle: it rolls on its voxels, as with round=no, if at all", name));
        EXPECT_EQ(editor.run(wheel + " round=no").text, "");
    }
    EXPECT_EQ(editor.run(std::string("wheel car front_left")).text, "");
}

TEST(Wheels, OfAllBodiesThatHaveSomeAreDriven) {
    Editor editor;
    makeCar(editor);
    runAll(editor, {"play", "drive 0.5 what=all", "step 120"});
    EXPECT_GT(placeOfCar(editor).z, 1.0);
    runAll(editor, {"stop", "create 4,4,4 9,0,9"});
    const Outcome refused = editor.run(std::string("drive"));
    EXPECT_EQ(refused.text, fmt::format("drive: what: expected bodies with wheels, found #{} without",
                                        editor.selection().objects.at(0)));
}

TEST(Wheels, SayWhatIsWrong) {
    Editor editor;
    makeCar(editor);
    runAll(editor, {"joint hinge car world 0,0.4,0 search=1 name=hinge"});
    const std::pair<const char*, const char*> cases[] = {
        {"wheel car front_left axis=0,1,0", "wheel: axis: expected a direction across that of the suspension"},
        {"wheel car car", "wheel"},
        {"set_joint drive=3 what=hinge", "set_joint: drive: expected a wheel, found another joint"},
        {"motor off steer=3 what=hinge", "motor: steer: expected a wheel, found another joint"},
        {"drive 1 what=ground", "drive: what: expected bodies with wheels, found ground without"},
        {"drive 2 what=car", "drive: throttle: expected a number from -1 to 1, found '2'"},
    };
    for (const auto& [line, message] : cases) {
        const Outcome outcome = editor.run(std::string(line));
        EXPECT_FALSE(outcome.isDone) << line;
        EXPECT_EQ(outcome.text.rfind(message, 0), 0u) << outcome.text;
    }
    runAll(editor, {"play", "drive 0 1 what=car", "step 60", "keep"});
    const Outcome outcome = editor.run(std::string("set_joint drive=3 what=axle_front_left"));
    EXPECT_NE(outcome.text.find("steered wheels"), std::string::npos) << "its axle is not that of its frame";
}

TEST(Wheels, OfALockedCarAreDrivenInPlayAlone) {
    Editor editor;
    makeCar(editor);
    runAll(editor, {"lock car"});
    EXPECT_FALSE(editor.run(std::string("drive 1 what=car")).isDone);
    runAll(editor, {"play", "drive 1 what=car", "step 90"});
    EXPECT_GT(placeOfCar(editor).z, 1.0);
}

}  // namespace
}  // namespace editor
