#pragma once
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <vector>

#include "editor/core/cells.h"
#include "editor/core/palette.h"
#include "tests/editor/editor_level.h"

namespace editor {

/// A chair of two shapes; after the lines it looks otherwise.
inline void writeChair(const char* file, std::initializer_list<const char*> lines = {}) {
    Editor editor;
    runAll(editor, {"create 8,2,8 0,0.4,0 index=5 name=seat static=yes",
                    "create 8,8,2 0,0.6,0.3 index=5 name=back static=yes", "name seat seat"});
    for (const char* name : {"seat", "back"}) editor.world().set_name(shapeOf(editor, name), name);
    editor.world().apply_edits();
    for (const char* line : lines) runAll(editor, {line});
    runAll(editor, {fmt::format("save {} force=yes", file).c_str()});
}

/// All shapes of a name.
inline std::vector<rubble_shape> shapesOf(Editor& editor, const char* name) {
    return editor.world().find_by_name(RUBBLE_KIND_SHAPE, name);
}

/// What a line that must work has to say.
inline std::string answerOf(Editor& editor, const std::string& line) {
    const Outcome outcome = editor.run(line);
    EXPECT_TRUE(outcome.isDone) << line << "\n" << outcome.text;
    return outcome.text;
}

/// That a line is refused, says why, and changes nothing.
inline void expectRefused(Editor& editor, const std::string& line, const std::string& why) {
    const uint64_t before = editor.document().hash();
    const size_t steps = editor.document().done().size();
    const Outcome outcome = editor.run(line);
    EXPECT_FALSE(outcome.isDone) << line;
    EXPECT_NE(outcome.text.find(why), std::string::npos) << outcome.text;
    EXPECT_EQ(editor.document().hash(), before);
    EXPECT_EQ(editor.document().done().size(), steps);
}

/// Equal voxels, looks and pose.
inline void expectEqualShapes(Editor& a, rubble_shape first, Editor& b, rubble_shape second) {
    const rubble_shape_state one = a.world().get_shape_state(first), other = b.world().get_shape_state(second);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(one.size[i], other.size[i]);
        EXPECT_NEAR(one.position[i], other.position[i], 1e-6);
    }
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(one.rotation[i], other.rotation[i], 1e-6);
    EXPECT_EQ(readCells(a.world(), first, gridOf(a.world(), first)),
              readCells(b.world(), second, gridOf(b.world(), second)));
    const auto looks = [](Editor& editor, rubble_shape shape) {
        std::string all;
        for (const rubble_palette_entry& each : paletteOf(editor.world(), shape))
            all += fmt::format("{} {} {} {} {} {},", each.color[0], each.color[1], each.color[2], each.opacity,
                               each.emission, each.material);
        return all;
    };
    EXPECT_EQ(looks(a, first), looks(b, second));
}

/// The seat grows at three of its sides, loses a corner, and has another colour.
inline constexpr std::initializer_list<const char*> kChanges = {"box -3,-1,0 9,2,7 index=7 shape=seat",
                                                                "voxel 0,0,0 erase shape=seat",
                                                                "entry 5 color=#204060 material=metal shape=seat"};

}  // namespace editor
