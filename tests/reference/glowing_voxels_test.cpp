// Light of many small voxels that glow without a light, by night: what the filter makes of it, against the reference.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "runtime/core/random.h"
#include "tests/golden/drawing.h"
#include "tests/reference/path_tracer.h"
#include "tests/reference/views.h"

namespace rubble::reference {
namespace {

constexpr glm::ivec2 kSize(96, 54);
constexpr uint8_t kStone = 1, kGlow = 2;

/// Cubes of 0.2 m scattered over a dark floor. Their radiance is below what a hit may send (lib/bounce.glsl).
LitScene glowingCubes() {
    auto palette = std::make_shared<Palette>();
    for (const uint8_t entry : {kStone, kGlow}) {
        PaletteEntry& e = (*palette)[entry];
        e.red = e.green = e.blue = entry == kGlow ? 255 : 186;
        e.roughness = 255;
    }
    (*palette)[kGlow].emission = 2.5f;
    LitScene scene(palette);
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

}  // namespace
}  // namespace rubble::reference
