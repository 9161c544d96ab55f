#include <gtest/gtest.h>

#include <cstdlib>

#include "samples/support/image.h"
#include "tests/runtime/script/yard_fixture.h"

namespace rubble::script {
namespace {

/// What a script with this draw() has drawn in a view of 960 x 540 pixels.
std::vector<UiItem> drawn(Yard& yard, const std::string& text) {
    EXPECT_EQ(yard.draw(text), "");
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

TEST(ScriptDrawing, CallsOutsideOfDrawDoNothing) {
    Yard yard;
    Script& script = yard.host().add("hud.lua",
                                     "function tick() UiPush() UiPop() UiPop() UiText('outside') UiRect(1, 1) end\n"
                                     "function draw() UiScale(1e9) UiTranslate(1e5, 0) UiWindow(1e5, 1e5) end");
    for (int i = 0; i < 3; ++i) {
        yard.host().tick(0.01);
        EXPECT_EQ(yard.host().draw(0, viewOf(960, 540), 0.01), RUBBLE_OK);
        EXPECT_EQ(script.error(), "");
        EXPECT_TRUE(yard.host().shared().ui.items.empty());
    }
    EXPECT_NE(yard.logged(RUBBLE_LOG_WARNING).find("expected a call in draw(dt)"), std::string::npos);
}

TEST(ScriptDrawing, NumbersAreFinite) {
    Yard yard;
    for (const std::string call : {"UiTranslate(%, 0)", "UiTranslate(0, %)", "UiRotate(%)", "UiScale(%)",
                                   "UiScale(1, %)", "UiWindow(%, 1)", "UiRect(1, %)", "UiColor(1, %, 1)"})
        for (const std::string number : {"0/0", "1/0", "-1/0"}) {
            const size_t at = call.find('%');
            const std::string text = call.substr(0, at) + number + call.substr(at + 1), error = yard.draw(text);
            EXPECT_NE(error.find(call.substr(0, call.find('(')) + ": "), std::string::npos) << text << ": " << error;
            EXPECT_NE(error.find("expected a finite number"), std::string::npos) << text << ": " << error;
        }
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

TEST(ScriptDrawing, LinesOutsideOfDrawStayUntilTheNextTick) {
    Yard yard;
    Script& script = yard.host().add("lines.lua",
                                     "function tick() DrawLine({0, 0, 0}, {1, 0, 0}) end "
                                     "function update() DrawLine({0, 0, 0}, {0, 1, 0}, 1, 0, 0) end "
                                     "function draw() DrawLine({0, 0, 0}, {0, 0, 1}) end");
    const auto& items = yard.host().shared().ui.items;
    for (int frame = 0; frame < 2; ++frame) {
        yard.host().tick(0.01);
        ASSERT_EQ(yard.host().step(), RUBBLE_OK);
        for (int view = 0; view < 2; ++view) {
            EXPECT_EQ(yard.host().draw(0, viewOf(960, 540), 0.01), RUBBLE_OK);
            ASSERT_EQ(items.size(), 3u);
            for (size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(items[axis].row.end[axis], 1.0);
            EXPECT_EQ(items[1].row.flags, uint32_t(RUBBLE_OVERLAY_OCCLUDED));
        }
    }
    for (int i = 0; i < 12'000; ++i) ASSERT_EQ(yard.host().step(), RUBBLE_OK) << "a host that never draws";
    EXPECT_LE(yard.host().shared().lines.size(), 10'000u);
    EXPECT_EQ(script.error(), "");
}

TEST(ScriptDrawing, WhatIsDrawnOutsideOfDrawIsToldOfOnce) {
    Yard yard;
    yard.host().add("tick.lua", "function tick()\nUiRect(1, 1)\nend");
    for (int i = 0; i < 3; ++i) yard.host().tick(0.01);
    EXPECT_TRUE(yard.host().shared().ui.items.empty());
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING),
              "tick.lua:2: UiRect: expected a call in draw(dt), nothing is drawn by others\n");
}

TEST(ScriptDrawing, ImagesAreBounded) {
    Yard yard;
    for (int i = 0; i < 5; ++i) {
        const Image image(4096, 4096);
        ASSERT_TRUE(writePng((yard.folder() / ("big" + std::to_string(i) + ".png")).string(), image));
    }
    EXPECT_EQ(yard.draw("for i = 0, 3 do UiImage('big' .. i .. '.png') end UiImage('big0.png')"), "");
    EXPECT_NE(yard.draw("UiImage('big4.png')").find("at most 0 MiB more of images, found 64"), std::string::npos);
}

/// How often each renderer was given an overlay and images.
std::map<rubble_renderer, std::array<int, 2>> s_given;

TEST(ScriptDrawing, EachRendererGetsOverlayAndImages) {
    Yard yard;
    rubble_api api = yard.api();
    api.set_overlay = [](rubble_renderer renderer, const rubble_overlay_item*, uint32_t) {
        return ++s_given[renderer][0], rubble_result(RUBBLE_OK);
    };
    api.set_overlay_image = [](rubble_renderer renderer, const rubble_overlay_image*) {
        return ++s_given[renderer][1], rubble_result(RUBBLE_OK);
    };
    ScriptHostSettings settings;
    settings.folder = yard.folder().string();
    ScriptHost host(api, yard.world(), settings);
    host.add("two.lua", "n = 0 function draw() n = n + 1 if n < 5 then UiImage('image.png') end end");
    for (int frame = 0; frame < 4; ++frame)
        for (const rubble_renderer renderer : {1, 2}) ASSERT_EQ(host.draw(renderer, viewOf(960, 540), 0.01), RUBBLE_OK);
    for (const rubble_renderer renderer : {1, 2}) {
        EXPECT_EQ(s_given[renderer][0], 3) << "twice the image, then nothing, once";
        EXPECT_EQ(s_given[renderer][1], 1);
    }
}

}  // namespace
}  // namespace rubble::script
