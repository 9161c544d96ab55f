// Ghosting behind glass: a camera that strafes past windows must see what a still camera sees.
#include <cstdio>
#include <cstdlib>

#include "tests/golden/drawing.h"
#include "tests/reference/display.h"
#include "tests/reference/flip.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(400, 225);
constexpr uint8_t kPlaster = 1, kBrick = 2, kDark = 3, kClear = 4, kTinted = 5, kFrame = 6;

PaletteRef palette(bool glass) {
    auto palette = std::make_shared<Palette>();
    const auto entry = [&](int index, uint8_t red, uint8_t green, uint8_t blue, uint8_t opacity = 255) {
        PaletteEntry& e = (*palette)[size_t(index)];
        e.red = red, e.green = green, e.blue = blue, e.opacity = opacity, e.material = 1;
    };
    entry(kPlaster, 210, 205, 190);
    entry(kBrick, 150, 80, 60);
    entry(kDark, 60, 62, 70);
    entry(kFrame, 225, 225, 220);
    entry(kClear, 223, 238, 238, glass ? 40 : 255);
    entry(kTinted, 90, 170, 110, glass ? 110 : 255);
    return palette;
}

/// A front with framed windows, high contrast behind it, and a free-standing tinted pane before it.
LitScene shopFront(bool glass) {
    LitScene scene(palette(glass));
    scene.environment.sunDirection = {0.4f, 0.6f, 0.5f};
    scene.add({160, 2, 120}, {{-8, -0.2, -8}, {1, 0, 0, 0}},
              [](glm::ivec3 c) { return (c.x / 8 + c.z / 8) % 2 ? kPlaster : kDark; });
    scene.add({120, 30, 1}, {{-6, 0, 0}, {1, 0, 0, 0}}, [=](glm::ivec3 c) -> uint8_t {
        const int x = c.x % 20;
        if (c.y < 4 || c.y > 24 || x < 3) return kBrick;
        if (c.y == 4 || c.y == 24 || x == 3 || x == 19) return kFrame;
        return glass ? kClear : 0;
    });
    scene.add({120, 30, 2}, {{-6, 0, -3}, {1, 0, 0, 0}}, [](glm::ivec3 c) { return c.x / 5 % 2 ? kPlaster : kDark; });
    for (int i = 0; i < 6; ++i)
        scene.add({4, 14 + i % 3 * 4, 4}, {{-5.0 + 2.0 * i, 0, -1.6}, glm::angleAxis(0.3 * i, glm::dvec3(0, 1, 0))},
                  [](glm::ivec3) { return kBrick; });
    if (glass)
        scene.add({24, 18, 1}, {{-0.6, 0, 1.2}, glm::angleAxis(0.2, glm::dvec3(0, 1, 0))},
                  [](glm::ivec3) { return kTinted; });
    return scene;
}

class GlassTrail : public Drawing {
protected:
    static Camera at(double x) {
        Camera camera;
        camera.position = {x, 1.6, 4.0};
        camera.lookAt({x - 0.6, 1.3, 0});
        return camera;
    }
    /// The last of some frames at a fixed exposure, so that adaptation does not matter.
    FloatImage last(const Camera& camera, int frames) {
        draw(camera, frames);
        const auto resolved = renderer->readTarget("resolved");
        EXPECT_TRUE(resolved) << resolved.error();
        const FloatImage shown = reference::displayed(*resolved, 1.0f);
        EXPECT_TRUE(writePng(testing::TempDir() + "trail_" + std::to_string(m_imageCount++) + ".png",
                             reference::toImage(shown)));
        return shown;
    }
    /// FLIP between the last frame of a moving camera and a camera that has long stood at the same place.
    double trail(bool glass, double metresPerFrame, glm::ivec2 size = kSize) {
        constexpr int kFrames = 8;
        start(shopFront(glass), size);
        draw(at(-kFrames * metresPerFrame), 4);
        for (int i = 1 - kFrames; i < 0; ++i) draw(at(i * metresPerFrame));
        const FloatImage moving = last(at(0.0), 1);
        const FloatImage standing = last(at(0.0), 16);
        EXPECT_TRUE(writePng(testing::TempDir() + "trail_" + std::to_string(m_imageCount++) + ".png",
                             reference::toImage(reference::flipMap(standing, moving))));
        return reference::flip(standing, moving);
    }
    int m_imageCount = 0;
};

TEST_F(GlassTrail, IsNotSeenBehindACameraThatStrafes) {
    const double running = trail(true, 0.05);  // 3 m/s
    RecordProperty("flip", std::to_string(running));
    EXPECT_LE(running, 0.05);
    if (std::getenv("RUBBLE_LONG")) {
        EXPECT_LE(trail(true, 0.025), 0.05);
        for (const double metresPerFrame : {0.05, 0.1}) {
            const double large = trail(true, metresPerFrame, {640, 360});
            printf("640x360, %.0f m/s: FLIP %.4f\n", metresPerFrame * 60.0, large);
            EXPECT_LE(large, 0.05);
        }
        const double fast = trail(true, 0.1), bare = trail(false, 0.1);
        printf("400x225, 6 m/s: FLIP %.4f, without glass %.4f\n", fast, bare);
        EXPECT_LE(fast, 0.05);
    }
}

}  // namespace
}  // namespace rubble
