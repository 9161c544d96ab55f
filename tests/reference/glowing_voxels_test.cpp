// Light of voxels that glow, by night, against the reference: of many small ones without a light, and of a lone cube
// that gets one (runtime/frame/glow_lights.h).
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "runtime/core/random.h"
#include "tests/golden/drawing.h"
#include "tests/reference/brightness.h"
#include "tests/reference/path_tracer.h"
#include "tests/reference/views.h"
#include "tests/support/grids.h"
#include "tests/support/level_snapshot.h"

namespace rubble::reference {
namespace {

constexpr glm::ivec2 kSize(96, 54);
constexpr uint8_t kStone = 1, kGlow = 2;

PaletteRef glowingPalette() {
    auto palette = std::make_shared<Palette>();
    for (const uint8_t entry : {kStone, kGlow}) {
        PaletteEntry& e = (*palette)[entry];
        e.red = e.green = e.blue = entry == kGlow ? 255 : 186;
        e.roughness = 255, e.material = 1;
    }
    (*palette)[kGlow].emission = 2.5f;
    return palette;
}

/// Cubes of 0.2 m scattered over a dark floor. Their radiance is below what a hit may send (lib/bounce.glsl).
LitScene glowingCubes() {
    LitScene scene(glowingPalette());
    Environment& air = scene.environment;
    air.sunDirection = {0.3f, -0.4f, 0.2f};
    air.sunColor = air.fogColor = glm::vec3(0.0f);
    air.skyColor = air.horizonColor = air.groundColor = glm::vec3(0.01f, 0.012f, 0.02f);
    scene.add({240, 2, 240}, {{-12, -0.2, -12}}, [](glm::ivec3) { return kStone; });
    scene.add({240, 2, 240}, {{-12, 0, -12}},
              [](glm::ivec3 cell) { return hashCell(cell.x / 2, cell.z / 2, 3) % 97 == 0 ? kGlow : uint8_t(0); });
    return scene;
}

class GlowingVoxels : public Drawing {
protected:
    static Camera camera() {
        Camera camera;
        camera.position = {0, 1.7, 6.0};
        camera.lookAt({0, 1.0, 0});
        return camera;
    }
    /// Of the floor a pixel and more beside the cubes: its mean light over the true one, and the root mean square of
    /// the differences over that.
    struct Match {
        double light = 0.0, error = 0.0;
    };
    Match match(const FloatImage& found, const FloatImage& traced) const {
        const FloatImage normal = read("normal"), depth = read("depth");
        const auto isFloor = [&](int x, int y) {
            return normal.at(x, y).y > 0.9f && normal.at(x, y).w == 0.0f && depth.at(x, y).x < 12.0f;
        };
        double sum = 0.0, all = 0.0, squares = 0.0;
        int pixels = 0;
        for (int y = 2; y < kSize.y - 2; ++y)
            for (int x = 2; x < kSize.x - 2; ++x) {
                bool isOpen = true;
                for (int i = 0; i < 25; ++i) isOpen = isOpen && isFloor(x + i % 5 - 2, y + i / 5 - 2);
                if (!isOpen) continue;
                const double there = double(found.at(x, y).g), expected = double(traced.at(x, y).g);
                sum += there, all += expected, squares += (there - expected) * (there - expected), ++pixels;
            }
        return {sum / all, std::sqrt(squares * pixels) / all};
    }
};

/// The clamps against fireflies take a quarter of the light here (lib/bounce.glsl). The filter takes no more of it;
/// early it brings light from beside the cubes, and half of the differences are gone. After many frames it is narrower.
TEST_F(GlowingVoxels, TheFilterTakesNoLightFromTheGround) {
    const LitScene scene = glowingCubes();
    const FloatImage traced =
        render(Scene(scene.snapshot()), camera().view(kSize, 0), {.term = Term::Sky, .samples = 2048}).mean;
    start(scene, kSize, comparedSettings());
    const auto filtered = [&](int frames) {
        draw(camera(), frames);
        const Match before = match(read("accumulatedLight"), traced), after = match(read("denoisedLight"), traced);
        std::printf("%d frames more: light %.3f, filtered %.3f; error %.3f, filtered %.3f\n", frames, before.light,
                    after.light, before.error, after.error);
        EXPECT_GT(after.light, before.light - 0.02);
        EXPECT_LT(after.error, before.error) << "a filter must be better than none";
        return after;
    };
    const Match early = filtered(8), late = filtered(56);
    EXPECT_NEAR(early.light, 1.0, 0.2);
    EXPECT_LT(early.error, 0.85);
    EXPECT_LT(late.error, 0.58);
}

/// A closed room of 8x3x8 m by night. A cube of 0.6 m in a corner of it glows, without a light and without a group.
class GlowingRoom : public Drawing {
protected:
    static constexpr glm::ivec2 kRoomSize{64, 36};
    static FrameSnapshot room() {
        Level level;
        LevelBody body;
        body.isStatic = true;
        LevelShape shape{.name = "room", .grid = VoxelGrid({84, 34, 84}), .palette = glowingPalette()};
        fillBox(shape.grid, {{0, 0, 0}, {84, 34, 84}}, kStone);
        fillBox(shape.grid, {{2, 2, 2}, {82, 32, 82}}, 0);
        fillBox(shape.grid, {{60, 2, 20}, {66, 8, 26}}, kGlow);
        body.shapes.push_back(std::move(shape));
        level.bodies.push_back(std::move(body));
        level.environment = glowingCubes().environment;
        return levelSnapshot(level);
    }
    FloatImage drawn(const FrameSnapshot& snapshot, const View& view, int frames) {
        auto made = Renderer::create(testContext().loader(), shaderFolder(), comparedSettings());
        EXPECT_TRUE(made) << made.error();
        renderer = std::move(made).value();
        renderer->apply(FrameSnapshot(snapshot));
        target = std::make_unique<Offscreen>(kRoomSize);
        View drawnTo = view;
        drawnTo.framebuffer = target->framebuffer();
        for (int i = 0; i < frames; ++i) renderer->draw(drawnTo, 1.0f);
        return read("resolved");
    }
};

TEST_F(GlowingRoom, IsAsBrightAsTheReferenceFromTheFirstFramesOn) {
    const FrameSnapshot snapshot = room();
    ASSERT_EQ(snapshot.lights.size(), 8u) << "five faces; three of them lie in two directory nodes";
    Camera camera;
    camera.position = {1.2, 1.7, 7.2};
    camera.lookAt({5.0, 1.2, 2.6});
    const View view = camera.view(kRoomSize, 0);
    FrameSnapshot withoutLight = snapshot;  // the reference meets the glowing voxels by its rays
    withoutLight.lights.clear();
    const FloatImage traced = render(Scene(withoutLight), view, {.samples = 512}).mean;
    for (const int frames : {4, 60}) {
        const FloatImage image = drawn(snapshot, view, frames);
        const glm::dvec3 ratio = brightnessRatio(image, traced, [&](size_t p) { return traced.pixels[p].x < 1.5f; });
        std::printf("after %d frames: %.3f of the reference\n", frames, ratio.y);
        EXPECT_NEAR(ratio.y, 1.0, 0.1) << frames;
    }
}

}  // namespace
}  // namespace rubble::reference
