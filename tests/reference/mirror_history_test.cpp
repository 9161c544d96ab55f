// What moves leaves no trail in mirrors: jitter makes the edges of a bright image uncertain, and there anti-aliasing
// keeps more history than elsewhere.
#include <optional>

#include "runtime/plugin/frame_loop.h"
#include "samples/scenes/canvas.h"
#include "samples/scenes/surface_styles.h"
#include "tests/golden/drawing.h"

namespace rubble {
namespace {

using scenes::Canvas;
using scenes::SurfaceStyle;

constexpr glm::ivec2 kSize(240, 135);
constexpr SurfaceStyle kGlossy{"generic", {0x96968c}, 10, 0, 120, 255, 0},
    kGlow{"generic", {0xffa03c}, 200, 0, 10, 255, 0, 30.0f};

LevelBody block(const char* name, glm::ivec3 size, glm::dvec3 place, const SurfaceStyle& style) {
    Canvas canvas(size);
    canvas.box(glm::ivec3(0), size, canvas.addSurface(style));
    LevelBody body{.name = name, .pose = {place, glm::dquat(1, 0, 0, 0)}};
    body.shapes.push_back(canvas.finish(name));
    return body;
}

class MirrorHistory : public Drawing {
protected:
    void SetUp() override {
        Level level;
        level.bodies = {block("floor", {120, 3, 120}, {-6.0, -0.3, -6.0}, kGlossy),
                        block("wall", {80, 30, 2}, {-4.0, 0.0, -4.0}, scenes::kPlaster),
                        block("cube", {6, 6, 6}, {-1.0, 0.5, -2.0}, kGlow)};
        level.environment.sunDirection = {0.2f, 0.8f, 0.3f};
        FrameLoopSettings settings;
        settings.shadow = ShadowWorker::Mode::Inline;
        settings.waitForShadow = true;
        m_loop.emplace(settings);
        m_loop->load(level);
        m_loop->world().bodies().forEach([&](BodyHandle handle, const Body& body) {
            if (body.name == "cube") m_cube = handle;
        });
        auto made = Renderer::create(testContext().loader(), shaderFolder(), {});
        ASSERT_TRUE(made);
        renderer = std::move(made).value();
        target = std::make_unique<Offscreen>(kSize);
        Camera camera;
        camera.position = {0.0, 1.5, 4.5};
        camera.lookAt({0.0, 1.2, 0.5});
        m_view = camera.view(kSize, target->framebuffer());
        drawFrames(26);
    }
    void drawFrames(int count) {
        for (int i = 0; i < count; ++i) {
            m_loop->step();
            m_loop->draw(*renderer, m_view, 1.0f);
            m_view.cut = false;
        }
    }
    void moveCube(double x) {
        m_loop->edits().push(
            SetBodyEdit{.body = m_cube, .setsPose = true, .pose = {{x, 0.5, -2.0}, glm::dquat(1, 0, 0, 0)}});
    }
    std::optional<FrameLoop> m_loop;
    BodyHandle m_cube;
    View m_view;
};

TEST_F(MirrorHistory, WhatSlidesAwayLeavesNoTrail) {
    for (int i = 1; i <= 20; ++i) {
        moveCube(-1.0 + 0.1 * i);
        drawFrames(1);
    }
    drawFrames(2);
    const FloatImage found = read("resolved");
    m_view.cut = true;
    drawFrames(16);
    const FloatImage expected = read("resolved");
    long brighter = 0;
    for (size_t i = 0; i < found.pixels.size(); ++i) brighter += found.pixels[i].x > expected.pixels[i].x + 0.25f;
    EXPECT_LT(brighter, 100) << "pixels; with a trail 350";
}

}  // namespace
}  // namespace rubble
