#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/runtime/script/yard_fixture.h"

namespace rubble::script {
namespace {

rubble_view viewOf(uint32_t width, uint32_t height) {
    auto view = sized<rubble_view>();
    view.width = width, view.height = height;
    view.rotation[3] = 1.0;
    return view;
}

/// What a script with this draw() has drawn in a view of 960 x 540 pixels.
std::vector<UiItem> drawn(Yard& yard, const std::string& text) {
    Script& script = yard.host().add("ui.lua", "function draw(dt)\n" + text + "\nend");
    EXPECT_EQ(yard.host().draw(0, viewOf(960, 540), 1.0 / 60.0), RUBBLE_OK);
    EXPECT_EQ(script.error(), "");
    return yard.host().shared().ui.items;
}

TEST(ScriptDrawing, TheCanvasIs1080High) {
    Yard yard;
    const auto items = drawn(yard, "assert(UiWidth() == 1920 and UiHeight() == 1080 and dt > 0) UiRect(10, 20)");
    ASSERT_EQ(items.size(), 1u);
    EXPECT_EQ(items[0].row.kind, uint32_t(RUBBLE_OVERLAY_BOX));
    EXPECT_EQ(items[0].row.transform[0], 0.5);
    EXPECT_EQ(items[0].row.size[1], 20.0);
}

TEST(ScriptDrawing, PlacesAreThoseOfNestedFrames) {
    Yard yard;
    const auto items =
        drawn(yard,
              "UiTranslate(100, 200) UiPush() UiRotate(90) UiTranslate(40, 0) UiRect(1, 1) UiPop() "
              "UiScale(2, 3) UiTranslate(1, 1) UiColor(1, 0, 0) UiColorFilter(1, 1, 1, 0.5) UiRect(1, 1)");
    ASSERT_EQ(items.size(), 2u);
    EXPECT_NEAR(items[0].row.transform[4], 50.0, 1e-9);
    EXPECT_NEAR(items[0].row.transform[5], 80.0, 1e-9) << "to the right became up";
    EXPECT_NEAR(items[1].row.transform[4], 51.0, 1e-9);
    EXPECT_NEAR(items[1].row.transform[5], 101.5, 1e-9);
    EXPECT_EQ(items[1].row.color[0], 1.0);
    EXPECT_EQ(items[1].row.color[3], 0.5);
}

TEST(ScriptDrawing, WindowsClip) {
    Yard yard;
    const auto items = drawn(yard,
                             "UiTranslate(100, 100) UiWindow(200, 200, true) UiTranslate(150, 0) "
                             "UiWindow(200, 50, true) assert(UiWidth() == 200) UiRect(1, 1)");
    ASSERT_EQ(items.size(), 1u);
    const double expected[4] = {125, 50, 150, 75};
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(items[0].row.clip[i], expected[i], 1e-9) << i;
}

TEST(ScriptDrawing, EachFrameBeginsAnew) {
    Yard yard;
    drawn(yard, "UiPush() UiTranslate(10, 10) UiRect(1, 1)");
    for (int i = 0; i < 300; ++i) EXPECT_EQ(yard.host().draw(0, viewOf(1920, 1080), 0.01), RUBBLE_OK);
    ASSERT_EQ(yard.host().shared().ui.items.size(), 1u);
    EXPECT_EQ(yard.host().shared().ui.items[0].row.transform[4], 10.0);
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING), "");
}

TEST(ScriptDrawing, MistakesAreErrors) {
    Yard yard;
    EXPECT_EQ(yard.draw("UiPop()"), "test:2: UiPop: expected an UiPush() before it, found none");
    EXPECT_EQ(
        yard.draw("UiAlign('centre')"),
        "test:2: UiAlign: alignment: expected words of left, center, right, top, middle, bottom, found \"centre\"");
    EXPECT_NE(yard.draw("UiImage('../secret.png')").find("inside of the folder"), std::string::npos);
    EXPECT_NE(yard.draw("UiImage('post.vox')").find("expected a PNG file"), std::string::npos);
    EXPECT_NE(yard.draw("UiFont('/etc/passwd', 20)").find("inside of the folder"), std::string::npos);
    EXPECT_NE(yard.draw("UiFont('post.vox', 20)").find("font"), std::string::npos);
    EXPECT_NE(yard.draw("for i = 1, 1e6 do UiPush() end").find("at most 200"), std::string::npos);
}

TEST(ScriptDrawing, AFrameIsBounded) {
    Yard yard;
    Script& script = yard.host().add("many.lua", "function draw() while true do UiRect(1, 1) end end");
    yard.host().draw(0, viewOf(960, 540), 0.01);
    EXPECT_NE(script.error(), "");
    EXPECT_LE(yard.host().shared().ui.items.size(), 20'000u);
}

TEST(ScriptDrawing, DebugLinesAndWatchesAreShown) {
    Yard yard;
    yard.host().add("debug.lua", "function tick() DebugLine({0, 0, 0}, {1, 1, 1}, 1, 0, 0) DebugWatch('x', 5) end");
    yard.host().tick(0.01);
    yard.host().draw(0, viewOf(960, 540), 0.01);
    const auto& items = yard.host().shared().ui.items;
    ASSERT_EQ(items.size(), 2u);
    EXPECT_EQ(items[0].row.kind, uint32_t(RUBBLE_OVERLAY_WORLD_LINE));
    EXPECT_EQ(items[1].text, "x: 5");
}

TEST(ScriptDrawing, LinesLiveUntilAFrameShowsThem) {
    Yard yard;
    yard.host().add("lines.lua",
                    "function tick() DrawLine({0, 0, 0}, {1, 1, 1}) end\n"
                    "function update() DrawLine({0, 0, 0}, {2, 2, 2}) end\n"
                    "function draw() DrawLine({0, 0, 0}, {3, 3, 3}) end");
    const auto& items = yard.host().shared().ui.items;
    for (int i = 0; i < 5; ++i) {
        yard.host().tick(0.01);
        yard.host().draw(0, viewOf(960, 540), 0.01);
        EXPECT_EQ(items.size(), i ? 3u : 2u) << "that of update() comes in the next frame";
        yard.host().draw(0, viewOf(960, 540), 0.01);
        EXPECT_EQ(items.size(), i ? 4u : 3u) << "a second view has those of the first, and draw() one more";
        EXPECT_TRUE(items[0].row.flags & RUBBLE_OVERLAY_OCCLUDED);
        yard.host().step();
    }
}

TEST(ScriptDrawing, NothingPilesUpWhereNobodyDraws) {
    Yard yard;
    Script& script = yard.host().add(
        "lines.lua", "function tick() for i = 1, 100 do DrawLine({0, 0, 0}, {1, 1, 1}) UiRect(1, 1) end end");
    for (int i = 0; i < 300; ++i) yard.host().tick(0.01);
    EXPECT_EQ(script.error(), "");
    EXPECT_EQ(yard.host().shared().debugLines.size(), 100u);
    EXPECT_EQ(yard.host().shared().ui.items.size(), 0u);
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING),
              "lines.lua:1: UiRect: expected a call from draw(): elsewhere it draws nothing\n");
}

TEST(ScriptDrawing, TooManyLinesAreAnError) {
    Yard yard;
    EXPECT_EQ(yard.run("for i = 1, 10001 do DebugLine({0, 0, 0}, {1, 1, 1}) end"),
              "test:2: DebugLine: expected at most 10000 lines in a frame");
}

TEST(ScriptDrawing, ImagesHaveABudget) {
    Yard yard;
    for (int i = 0; i < 5; ++i)
        ASSERT_TRUE(writePng((yard.folder() / ("large" + std::to_string(i) + ".png")).string(), Image(4096, 4096)));
    EXPECT_EQ(yard.draw("for i = 0, 4 do UiImage('large' .. i .. '.png') end"),
              "test:2: UiImage: path: expected at most 256 MiB of images, found 320 MiB with large4.png");
}

}  // namespace
}  // namespace rubble::script
