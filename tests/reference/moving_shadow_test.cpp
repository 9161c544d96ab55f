// Shadows of bodies that move: each frame is that of a renderer that has seen that moment for long.
// RUBBLE_IMAGES=FOLDER writes for each case the sun's share (rays, denoised, converged), and the frame, the converged
// one and their FLIP map.
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "runtime/plugin/frame_loop.h"
#include "samples/scenes/canvas.h"
#include "samples/scenes/surface_styles.h"
#include "tests/golden/drawing.h"
#include "tests/reference/display.h"
#include "tests/reference/flip.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(240, 135);
constexpr int kConvergedFrames = 24;

using scenes::Canvas;

struct Case {
    const char* name;
    LevelBody (*body)();
    int steps;    ///< before the first frame that is compared
    float alpha;  ///< of the frames that are drawn
    double maxFlip;
};

LevelBody box() {
    Canvas canvas({12, 8, 10});
    canvas.box(glm::ivec3(0), canvas.size(), canvas.addSurface(scenes::kBrick));
    LevelBody body{.name = "box",
                   .pose = {{-3.0, 1.6, -0.5}, glm::angleAxis(0.5, glm::normalize(glm::dvec3(1, 2, 3)))}};
    body.velocity = {4.0f, 3.0f, 0.0f}, body.angularVelocity = {1.0f, 2.0f, 0.5f};
    body.shapes.push_back(canvas.finish("box"));
    return body;
}

LevelBody wheel() {
    Canvas canvas({18, 18, 4});
    const auto steel = canvas.addSurface(scenes::kBrick);
    canvas.ring(2, 0, 4, {18, 18, 0}, 13, 17, steel);
    canvas.box({8, 1, 1}, {10, 17, 3}, steel);
    canvas.box({1, 8, 1}, {17, 10, 3}, steel);
    LevelBody body{.name = "wheel", .pose = {{-3.5, 0.02, -0.5}, glm::dquat(1, 0, 0, 0)}};
    body.velocity = {4.0f, 0.0f, 0.0f}, body.angularVelocity = {0.0f, 0.0f, -4.5f};
    body.shapes.push_back(canvas.finish("wheel"));
    return body;
}

Level levelWith(LevelBody body) {
    Level level;
    Canvas canvas({160, 2, 120});
    canvas.box(glm::ivec3(0), canvas.size(), canvas.addSurface(scenes::kPlaster));
    LevelBody floor{.name = "floor", .pose = {{-8.0, -0.2, -6.0}, glm::dquat(1, 0, 0, 0)}};
    floor.shapes.push_back(canvas.finish("floor"));
    level.bodies.push_back(std::move(floor));
    body.isStatic = false;
    level.bodies.push_back(std::move(body));
    level.environment.sunDirection = {-0.5f, 0.6f, 0.4f};
    return level;
}

/// Of the floor: pixels in shadow by this frame's own rays, and those denoised to something else than they and all
/// their neighbours see.
std::pair<int, int> countShadow(const FloatImage& sun, const FloatImage& noisy, const FloatImage& material,
                                const FloatImage& albedo) {
    int shadow = 0, wrong = 0;
    for (int y = 1; y < kSize.y - 1; ++y)
        for (int x = 1; x < kSize.x - 1; ++x) {
            const float seen = noisy.at(x, y).a;
            bool isEven = true;
            for (int i = 0; i < 9; ++i) {
                const int u = x + i % 3 - 1, v = y + i / 3 - 1;
                const bool isFloor = material.at(u, v).a < 0.5f && albedo.at(u, v).a > 0.0f;
                isEven = isEven && isFloor && noisy.at(u, v).a == seen;
            }
            shadow += isEven && seen < 0.5f;
            wrong += isEven && std::abs(sun.at(x, y).a - seen) > 0.2f;
        }
    return {shadow, wrong};
}

class MovingShadow : public Drawing, public testing::WithParamInterface<Case> {};

TEST_P(MovingShadow, IsThatOfAStillOne) {
    const Case& now = GetParam();
    FrameLoopSettings settings;
    settings.shadow = ShadowWorker::Mode::Inline;
    settings.waitForShadow = true;
    FrameLoop loop(settings);
    loop.load(levelWith(now.body()));
    auto made = Renderer::create(testContext().loader(), shaderFolder(), {});
    ASSERT_TRUE(made);
    renderer = std::move(made).value();
    target = std::make_unique<Offscreen>(kSize);
    Camera camera;
    camera.position = {0.0, 2.2, 4.0};
    camera.lookAt({0.0, 0.4, -0.5});
    View view = camera.view(kSize, target->framebuffer());
    const char* folder = std::getenv("RUBBLE_IMAGES");
    std::vector<Image> sheet;
    for (int i = 0; i < now.steps; ++i) {
        loop.step();
        loop.draw(*renderer, view, now.alpha);
    }
    const FloatImage moving = read("resolved"), sun = read("denoisedLight"), noisy = read("noisyLight"),
                     material = read("material"), albedo = read("albedo");
    const auto sunOf = [](const FloatImage& light) {
        FloatImage out(light.size);
        for (size_t i = 0; i < out.pixels.size(); ++i) out.pixels[i] = glm::vec4(glm::vec3(light.pixels[i].a), 1.0f);
        return reference::toImage(out);
    };
    View again = view;
    again.cut = true;
    for (int i = 0; i < kConvergedFrames; ++i) {
        renderer->draw(again, now.alpha);
        again.cut = false;
    }
    const FloatImage still = read("resolved"), stillSun = read("denoisedLight");
    const float exposure = reference::exposureFor(still, 1.0f);
    const FloatImage shown = reference::displayed(moving, exposure), expected = reference::displayed(still, exposure);
    const auto [shadow, wrong] = countShadow(sun, noisy, material, albedo);
    const double flip = reference::flip(expected, shown);
    std::printf("%s: FLIP %.4f, %d pixels wrong, %d in shadow\n", now.name, flip, wrong, shadow);
    EXPECT_LE(wrong, shadow / 20);
    EXPECT_LE(flip, now.maxFlip);
    if (folder) {
        sheet = {sunOf(noisy),
                 sunOf(sun),
                 sunOf(stillSun),
                 reference::toImage(shown),
                 reference::toImage(expected),
                 reference::toImage(reference::flipMap(expected, shown))};
        EXPECT_TRUE(writePng(std::string(folder) + "/" + now.name + ".png", tile(sheet, 3)));
    }
}

INSTANTIATE_TEST_SUITE_P(Each, MovingShadow,
                         testing::Values(Case{"box", box, 30, 1.0f, 0.018}, Case{"box_half", box, 30, 0.5f, 0.018},
                                         Case{"wheel", wheel, 40, 1.0f, 0.018}),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace rubble
