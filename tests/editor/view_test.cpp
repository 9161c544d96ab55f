// What the view shows is no part of the level: what is hidden, overlays. And what tells which parts of a shape hold.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "editor/core/components.h"
#include "tests/editor/editor_level.h"
#include "tests/support/temp_folder.h"

namespace editor {
namespace {

/// Whether the view leaves out the only shape of a body.
bool isHidden(Editor& editor, const char* name) {
    return editor.view().hides(shapeOf(editor, name));
}

void makeThree(Editor& editor) {
    runAll(editor, {"create 8,8,8 0,0,0 name=crate", "create 20,20,2 0,0,2 name=wall static=yes",
                    "create 20,2,20 0,2.1,0 name=roof static=yes", "layer upper roof"});
}

TEST(Hidden, ShapesAreNoStepOfTheHistory) {
    Editor editor;
    makeThree(editor);
    const uint64_t before = editor.document().hash();
    const size_t steps = editor.document().done().size();
    EXPECT_EQ(editor.run(std::string("hide crate")).text, "1 of 3 shapes hidden");
    EXPECT_TRUE(isHidden(editor, "crate"));
    EXPECT_FALSE(isHidden(editor, "wall"));
    EXPECT_EQ(editor.document().hash(), before);
    EXPECT_EQ(editor.document().done().size(), steps);
    EXPECT_NE(editor.run(std::string("list")).text.find("512 voxels, hidden"), std::string::npos);
    runAll(editor, {"move 1,0,0 crate", "undo", "redo"});
    EXPECT_TRUE(isHidden(editor, "crate")) << "what becomes of it, it stays hidden";
    runAll(editor, {"show crate"});
    EXPECT_FALSE(isHidden(editor, "crate"));
}

TEST(Hidden, LayersAndOthersAreNamedAsObjects) {
    Editor editor;
    makeThree(editor);
    runAll(editor, {"hide tag:layer=upper"});
    EXPECT_TRUE(isHidden(editor, "roof"));
    EXPECT_FALSE(isHidden(editor, "wall"));
    runAll(editor, {"hide_others wall"});
    EXPECT_TRUE(isHidden(editor, "crate"));
    EXPECT_FALSE(isHidden(editor, "wall"));
    runAll(editor, {"show"});
    EXPECT_TRUE(editor.view().hidden.empty());
    runAll(editor, {"lock crate", "hide crate"});
    EXPECT_TRUE(isHidden(editor, "crate")) << "a lock keeps from edits, and this is none";
}

TEST(Hidden, ShapesStayHiddenThroughPlayThatStops) {
    Editor editor;
    makeThree(editor);
    runAll(editor, {"hide crate", "play", "explode 0.4,0.4,0.4 1.5", "step 60"});
    runAll(editor, {"stop"});
    EXPECT_TRUE(isHidden(editor, "crate")) << "it is as before";
    runAll(editor, {"delete crate"});
    EXPECT_TRUE(editor.view().hidden.empty()) << "it is gone";
    runAll(editor, {"hide wall", "new", "create 4,4,4 name=other"});
    EXPECT_TRUE(editor.view().hidden.empty()) << "another level hides nothing";
}

TEST(Overlays, AreShownByACommand) {
    Editor editor;
    for (const OverlayName& each : kOverlays) {
        ASSERT_TRUE(editor.run("overlay " + std::string(each.name)).isDone) << each.name;
        EXPECT_TRUE(editor.view().overlays.*each.shown) << each.name;
        ASSERT_TRUE(editor.run("overlay " + std::string(each.name) + " no").isDone);
        EXPECT_FALSE(editor.view().overlays.*each.shown) << each.name;
    }
    EXPECT_NE(editor.run(std::string("overlay heat")).text.find("expected one of: grid anchors components"),
              std::string::npos);
}

TEST(Components, AreAnchoredOrLoose) {
    Editor editor;
    runAll(editor, {"create 10,20,4 static=yes name=wall", "box 0,12,0 9,12,3 erase shape=wall"});
    const Components components(editor.world(), shapeOf(editor, "wall"));
    const std::vector<Component>& all = components.all();
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].voxels, 10u * 12 * 4);
    EXPECT_EQ(all[0].anchored, 10u * 4);
    EXPECT_EQ(all[1].voxels, 10u * 7 * 4);
    EXPECT_FALSE(all[1].isAnchored());
    EXPECT_EQ(components.at({0, 0, 0}), 0);
    EXPECT_EQ(components.at({0, 12, 0}), -1);
    EXPECT_EQ(components.at({9, 19, 3}), 1);
    EXPECT_EQ(components.at({10, 0, 0}), -1) << "beyond the grid";
    EXPECT_TRUE(components.isAnchored({3, 0, 2}));
    EXPECT_FALSE(components.isAnchored({3, 1, 2}));
    EXPECT_EQ(editor.run(std::string("components wall")).text,
              "2 components: 1 anchored, 1 loose\n  480 voxels from 0,0,0: anchored by 40\n  280 voxels from 0,13,0: "
              "loose");
}

/// A frame stands around a post that alone is anchored: the box around the frame holds the anchor, no voxel of it does.
TEST(Components, AreLooseWhereTheirBoxAloneTouchesAnAnchor) {
    Editor editor;
    runAll(editor, {"create 9,9,1 static=yes name=frame", "box 1,0,0 7,7,0 erase shape=frame",
                    "box 4,0,0 4,5,0 add shape=frame"});
    rubble_cell_box foot{};
    foot.low[0] = 4, foot.size[0] = foot.size[1] = foot.size[2] = 1;
    rubble_shape_change change{};
    change.shape = shapeOf(editor, "frame"), change.fields = RUBBLE_SHAPE_ANCHORS;
    change.anchors = &foot, change.anchor_count = 1;
    editor.world().set_shape(change);
    editor.document().carryOut("anchors");
    const std::vector<Component> all = Components(editor.world(), shapeOf(editor, "frame")).all();
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].voxels, 25u) << "the frame";
    EXPECT_EQ(all[0].low, glm::ivec3(0));
    EXPECT_FALSE(all[0].isAnchored());
    EXPECT_EQ(all[1].anchored, 1u);
    runAll(editor, {"box 1,0,0 3,0,0 add shape=frame"});
    const std::vector<Component> joined = Components(editor.world(), shapeOf(editor, "frame")).all();
    ASSERT_EQ(joined.size(), 1u);
    EXPECT_TRUE(joined[0].isAnchored());
}

}  // namespace
}  // namespace editor
