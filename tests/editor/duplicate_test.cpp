// Copies of bodies: they are what their originals are, with what is on them and among them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <string>

#include "editor/core/joints.h"
#include "editor/core/rotation.h"
#include "tests/editor/model_level.h"

namespace editor {
namespace {

uint64_t last(Editor& editor, uint32_t kind, const char* name) {
    return editor.world().find_by_name(kind, name).back();
}
std::string tagsOf(Editor& editor, uint64_t object) {
    std::string all;
    for (const char c : editor.world().get_tags(object)) all += c ? c : ' ';
    return all;
}

TEST(Duplicate, OfACarDrivesAsTheCarDoes) {
    Editor editor;
    runAll(editor,
           {"create 300,2,400 0,-0.2,0 index=6 name=ground static=yes", "create 14,3,28 0,0.3,0 name=car",
            "create 3,8,8 0.9,0,0.9 form=cylinder_x index=19 name=w1",
            "create 3,8,8 -0.9,0,0.9 form=cylinder_x index=19 name=w2",
            "create 3,8,8 0.9,0,-0.9 form=cylinder_x index=19 name=w3",
            "create 3,8,8 -0.9,0,-0.9 form=cylinder_x index=19 name=w4", "wheel car w1 steer=30 name=a1 drive=300",
            "wheel car w2 steer=30 name=a2", "wheel car w3 name=a3", "wheel car w4 name=a4", "tag axle front a1"});
    const uint64_t before = editor.document().hash();
    EXPECT_EQ(answerOf(editor, "duplicate -5,0,0 2 car,w1,w2,w3,w4"), "");
    EXPECT_EQ(editor.world().get_joint_states().size(), 12u);
    EXPECT_EQ(tagsOf(editor, last(editor, RUBBLE_KIND_JOINT, "a1")), "axle=front ");
    EXPECT_EQ(editor.selection().objects.size(), 10u);
    const uint64_t after = editor.document().hash();
    runAll(editor, {"save cars.rubble", "play", "step 30", "drive 0.5 0.3 what=car", "step 120"});
    const auto cars = editor.world().find_by_name(RUBBLE_KIND_BODY, "car");
    ASSERT_EQ(cars.size(), 3u);
    const auto placeOf = [&](size_t i) { return vectorOf(editor.world().get_body_state(cars[i]).position); };
    EXPECT_GT(placeOf(0).z, 1.0);
    for (size_t i = 1; i < 3; ++i)
        EXPECT_LT(glm::length(placeOf(i) - placeOf(0) + glm::dvec3(5.0 * double(i), 0, 0)), 0.05) << i;
    runAll(editor, {"stop"});
    EXPECT_EQ(editor.document().hash(), after);
    runAll(editor, {"undo"});
    EXPECT_EQ(editor.document().hash(), before);
    runAll(editor, {"redo"});
    EXPECT_EQ(editor.document().hash(), after);
    runAll(editor, {"open cars.rubble"});
    EXPECT_EQ(editor.document().hash(), after);
}

TEST(Duplicate, HasTagsLightsAndWhatIsSetOfItsBody) {
    Editor editor;
    runAll(editor, {"create 4,4,4 name=crate", "create 4,4,4 1,0,0 name=beside", "tag old x crate", "tag both 1 crate",
                    "save crate.rubble", "open crate.rubble", "untag old crate", "tag both 2 crate",
                    "layer props crate", "body gravity=0.5 damping=2 what=crate", "light_group street",
                    "light sphere 0.2,0.6,0.2 shape=crate group=street name=glow", "tag bulb warm glow"});
    runAll(editor, {"duplicate 0,0,3 1 crate"});
    const rubble_body made = last(editor, RUBBLE_KIND_BODY, "crate");
    EXPECT_EQ(tagsOf(editor, made), "both=2 layer=props ");
    const rubble_body_properties now = editor.world().get_body_properties(made);
    EXPECT_EQ(now.gravity_scale, 0.5);
    EXPECT_EQ(now.linear_damping, 2.0);
    ASSERT_EQ(editor.world().get_lights().size(), 2u);
    const rubble_light light = last(editor, RUBBLE_KIND_LIGHT, "glow");
    const rubble_light_settings settings = editor.world().get_light_settings(light);
    EXPECT_EQ(settings.shape, editor.world().get_objects_of(made, RUBBLE_KIND_SHAPE).at(0));
    EXPECT_EQ(settings.group, editor.world().find_by_name(RUBBLE_KIND_LIGHT_GROUP, "street").at(0));
    EXPECT_EQ(settings.position[1], 0.6);
    EXPECT_EQ(tagsOf(editor, light), "bulb=warm ");
}

TEST(Duplicate, HasTagsOfShapesThatALevelBroughtOrTook) {
    Editor editor;
    runAll(editor, {"create 4,4,4 name=crate", "add_shape crate 2,2,2 0.1,0.4,0.1 name=knob", "tag old x knob",
                    "tag both 1 knob", "save crate.rubble", "open crate.rubble", "untag old knob", "tag both 2 knob",
                    "tag new yes knob", "duplicate 0,0,3 1 crate"});
    EXPECT_EQ(shapesOf(editor, "knob").size(), 2u);
    EXPECT_EQ(tagsOf(editor, shapesOf(editor, "knob").back()), "both=2 new=yes ");
}

TEST(Duplicate, HasTheJointsAmongItsBodiesOrToTheWorld) {
    Editor editor;
    runAll(editor, {"create 2,20,2 0,0,0 name=post static=yes", "create 8,20,1 0.5,0,0 name=door",
                    "create 4,4,4 0.5,2,0 name=crate", "joint hinge door post 0.1,1,0 0,1,0 low=-90 high=45 name=hinge",
                    "joint ball crate door 0.5,2,0 name=glue", "joint hinge door world 0.9,1,0 0,1,0 name=latch",
                    "rope crate post 0.5,2.4,0 0,2,0 name=line", "rotate 0,30,0 about=0,0,0 what=post,door,crate"});
    const auto namesOf = [&] {
        std::string all;
        for (const rubble_joint_state& each : editor.world().get_joint_states())
            all += nameOf(editor.world(), each.joint) + " ";
        return all;
    };
    EXPECT_EQ(answerOf(editor, "duplicate 0,0,4 1 door,post"), "");
    EXPECT_EQ(namesOf(), "hinge glue latch line hinge latch ");
    const rubble_joint_properties one = editor.world().get_joint_properties(
                                      editor.world().find_by_name(RUBBLE_KIND_JOINT, "hinge").at(0)),
                                  other = editor.world().get_joint_properties(last(editor, RUBBLE_KIND_JOINT, "hinge"));
    EXPECT_NEAR(one.lower_limit, other.lower_limit, 1e-9);
    EXPECT_NEAR(one.upper_limit, other.upper_limit, 1e-9);
    const auto anchorOf = [&](rubble_joint joint) {
        return vectorOf(editor.world().get_joint_state(joint).first_anchor);
    };
    const auto latches = editor.world().find_by_name(RUBBLE_KIND_JOINT, "latch");
    EXPECT_LT(glm::length(anchorOf(latches.at(1)) - anchorOf(latches.at(0)) - glm::dvec3(0, 0, 4)), 1e-6);
    runAll(editor, {"undo"});
    EXPECT_EQ(answerOf(editor, "duplicate 0,0,4 1 crate,door,post"),
              "line is not copied: ropes and steered wheels are not");
    EXPECT_EQ(namesOf(), "hinge glue latch line hinge glue latch ");
    EXPECT_EQ(answerOf(editor, "duplicate 0,0,4 3 crate,door,post"),
              "line is not copied: ropes and steered wheels are not")
        << "once, not three times";
}

}  // namespace
}  // namespace editor
