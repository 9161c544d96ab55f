// Palettes as wholes, and what images become.
#include "editor/core/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "editor/core/cells.h"
#include "editor/core/image.h"
#include "tests/editor/editor_level.h"

namespace editor {
namespace {

using Look = std::array<int, 5>;  ///< colour, material, opacity

/// What is seen in each cell.
std::vector<Look> looksOf(Editor& editor, const char* name) {
    const rubble_shape shape = shapeOf(editor, name);
    const std::vector<rubble_palette_entry> entries = paletteOf(editor.world(), shape);
    std::vector<Look> looks;
    for (const uint8_t index : readCells(editor.world(), shape, gridOf(editor.world(), shape))) {
        const rubble_palette_entry& e = entries[index];
        looks.push_back(index ? Look{e.color[0], e.color[1], e.color[2], e.material, e.opacity} : Look{});
    }
    return looks;
}

std::set<int> usedEntries(Editor& editor, const char* name) {
    const rubble_shape shape = shapeOf(editor, name);
    const std::vector<uint8_t> voxels = readCells(editor.world(), shape, gridOf(editor.world(), shape));
    std::set<int> used(voxels.begin(), voxels.end());
    used.erase(0);
    return used;
}

void makePainted(Editor& editor) {
    runAll(editor,
           {"create 8,8,8 name=crate index=5", "box 0,0,0 3,3,3 paint 9 shape=crate",
            "box 4,4,4 7,7,7 paint 12 shape=crate", "voxel 0,7,0 erase shape=crate",
            "entry 5 color=#202020 material=wood shape=crate", "entry 9 color=#e0e0e0 material=wood shape=crate",
            "entry 12 color=#202020 material=wood shape=crate"});
}

TEST(PaletteTools, SortAndMergeLeaveAllLooks) {
    Editor editor;
    makePainted(editor);
    const std::vector<Look> before = looksOf(editor, "crate");
    runAll(editor, {"sort_entries brightness crate"});
    EXPECT_EQ(looksOf(editor, "crate"), before);
    EXPECT_EQ(usedEntries(editor, "crate"), (std::set<int>{1, 2, 3}));
    runAll(editor, {"merge_entries crate"});
    EXPECT_EQ(looksOf(editor, "crate"), before);
    EXPECT_EQ(usedEntries(editor, "crate"), (std::set<int>{1, 3}));
    runAll(editor, {"undo 2"});
    EXPECT_EQ(usedEntries(editor, "crate"), (std::set<int>{5, 9, 12}));
}

TEST(PaletteTools, ReduceGivesTheRarestTheNearestOther) {
    Editor editor;
    makePainted(editor);
    runAll(editor, {"voxel 3,7,3 paint 20 shape=crate", "entry 20 color=#d0d0d0 material=wood shape=crate",
                    "reduce_entries 3 crate"});
    EXPECT_EQ(usedEntries(editor, "crate"), (std::set<int>{5, 9, 12}));
    const rubble_shape shape = shapeOf(editor, "crate");
    EXPECT_EQ(readCells(editor.world(), shape, between({3, 7, 3}, {3, 7, 3})), std::vector<uint8_t>{9});
}

TEST(Images, BecomePalettesAndPlatesOfTheirColours) {
    rubble::TempFolder folder;
    const std::string file = folder / "image.png";
    writePng(file, 3, 2,
             {10, 20, 30, 255, 10, 20, 30, 255, 0, 0, 0, 0, 200, 100, 50, 255, 10, 20, 30, 255, 7, 8, 9, 255});
    Editor editor;
    runAll(editor, {"create 4,4,4 name=crate"});
    const Outcome palette = editor.run("palette_image " + file + " first=100 shape=crate");
    EXPECT_EQ(palette.text, "3 colours: entries 100 to 102");
    std::set<int> reds;
    for (size_t i = 100; i < 103; ++i) reds.insert(paletteOf(editor.world(), shapeOf(editor, "crate"))[i].color[0]);
    EXPECT_EQ(reds, (std::set<int>{7, 10, 200}));
    const Outcome plate = editor.run("extrude_image " + file + " 2 name=plate");
    EXPECT_EQ(plate.text, "3 x 2 pixels: 10 voxels, 3 colours");
    const std::vector<Look> looks = looksOf(editor, "plate");
    const auto redAt = [&](size_t x, size_t y) { return looks.at(y * 3 + x)[0]; };
    EXPECT_EQ(redAt(0, 0), 200) << "rows of images begin above";
    EXPECT_EQ(redAt(2, 0), 7);
    EXPECT_EQ(redAt(0, 1), 10);
    EXPECT_EQ(redAt(2, 1), 0) << "what is transparent is empty";
}

TEST(Images, ManyColoursBecomeFewNearOnes) {
    Image image;
    image.size = {64, 64};
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) image.pixels.push_back({uint8_t(4 * x), uint8_t(4 * y), 128, 255});
    const std::vector<Rgb> colors = reduceColors(image, 64);
    EXPECT_EQ(colors.size(), 64u);
    int worst = 0;
    for (const auto& pixel : image.pixels) {
        const Rgb& near = colors[nearestColor(colors, pixel)];
        for (size_t a = 0; a < 3; ++a) worst = std::max(worst, std::abs(near[a] - pixel[a]));
    }
    EXPECT_LE(worst, 32) << "64 colours in a square of 256 x 256: parts of 32 x 32";
}

TEST(Images, AHeightMapIsAsHighAsItIsBright) {
    rubble::TempFolder folder;
    const std::string file = folder / "image.png";
    writePng(file, 2, 2, {0, 0, 0, 255, 128, 128, 128, 255, 255, 255, 255, 255, 9, 9, 9, 0});
    Editor editor;
    const Outcome made = editor.run("height_map " + file + " 20 name=hills");
    EXPECT_EQ(made.text, "2 x 2 pixels: 31 voxels") << "1, 10 and 20";
    EXPECT_FALSE(editor.run(std::string("height_map nowhere.png")).isDone);
}

TEST(Images, AreRegularFiles) {
    Editor editor;
    for (const char* path : {"/dev/zero", "."}) {
        const Outcome outcome = editor.run(std::string("height_map ") + path);
        EXPECT_NE(outcome.text.find("expected a regular file"), outcome.text.npos) << outcome.text;
    }
}

TEST(Images, OfSixteenBitsGiveHeightsBetweenThoseOfEight) {
    rubble::TempFolder folder;
    const std::string file = folder / "slope.png";
    std::vector<uint16_t> slope;
    for (int i = 0; i < 1000; ++i) slope.push_back(uint16_t(20000 + i));  // 4 of 256 levels
    writeDeepPng(file, 1000, 1, 1, slope);
    Editor editor;
    runAll(editor, {("height_map " + file + " 4000 name=hills").c_str()});
    const rubble_shape hills = shapeOf(editor, "hills");
    const auto heightAt = [&](int x) {
        const std::vector<uint8_t> column = readCells(editor.world(), hills, {{x, 0, 0}, {1, 4000, 1}});
        return 4000 - std::count(column.begin(), column.end(), uint8_t(0));
    };
    for (const int x : {0, 100, 500, 999}) EXPECT_EQ(heightAt(x), std::lround((20000 + x) / 65535.0 * 4000.0)) << x;
    writeDeepPng(file, 2, 1, 2, {20000, 65535, 20000, 40000});
    runAll(editor, {"delete hills", ("height_map " + file + " 4000 name=hills").c_str()});
    const rubble_shape_state state = editor.world().get_shape_state(shapeOf(editor, "hills"));
    EXPECT_NEAR(double(state.voxel_count), 2 * 1221, 1) << "opacity makes nothing lower";
}

TEST(Images, OfSixteenBitsAreAsBrightAsOfEight) {
    rubble::TempFolder folder;
    const std::string file = folder / "deep.png";
    for (const double gamma : {0.0, 1.0, 0.45455}) {
        SCOPED_TRACE(gamma);
        writeDeepPng(file, 3, 1, 1, {0, 32896, 65535}, gamma);
        Editor editor;
        EXPECT_EQ(editor.run("height_map " + file + " 20 name=hills").text, "3 x 1 pixels: 31 voxels") << "1, 10, 20";
        writeDeepPng(file, 3, 1, 2, {32896, 65535, 51400, 65535, 7, 0}, gamma);
        EXPECT_EQ(editor.run("extrude_image " + file + " name=plate").text, "3 x 1 pixels: 2 voxels, 2 colours");
        const std::vector<Look> looks = looksOf(editor, "plate");
        EXPECT_EQ(looks.at(0)[0], 128);
        EXPECT_EQ(looks.at(1)[0], 200);
    }
}

}  // namespace
}  // namespace editor
