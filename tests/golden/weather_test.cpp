// Wet ground and sunlight through glass: where they must be, and where they must not.
#include <filesystem>
#include <fstream>

#include "tests/golden/drawing.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(96, 64);
constexpr uint8_t kStone = 1, kRedGlass = 2;

PaletteRef stoneAndGlass(bool withGlass = true) {
    auto palette = std::make_shared<Palette>();
    PaletteEntry& stone = (*palette)[kStone];
    stone.red = stone.green = stone.blue = 186;
    stone.roughness = 230;
    if (!withGlass) return palette;
    PaletteEntry& glass = (*palette)[kRedGlass];
    glass.red = 220;
    glass.green = glass.blue = 20;
    glass.opacity = 60;
    glass.roughness = 10;
    return palette;
}

Camera lookingAt(glm::dvec3 from, glm::dvec3 at) {
    Camera camera;
    camera.position = from;
    camera.lookAt(at);
    return camera;
}

class WeatherTest : public Drawing {
protected:
    bool ran(std::string_view pass) const {
        const auto& all = renderer->stats().passes;
        return std::find(all.begin(), all.end(), pass) != all.end();
    }
};

/// Mean of a channel over a box of pixels; y counts from the bottom.
double meanOf(const FloatImage& image, glm::ivec2 low, glm::ivec2 high, int channel) {
    double sum = 0;
    for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x) sum += image.at(x, y)[channel];
    return sum / ((high.x - low.x) * (high.y - low.y));
}

/// A floor whose left half, seen from above, is under a roof.
LitScene halfUnderRoof(float wetness) {
    LitScene scene(stoneAndGlass());
    scene.environment.wetness = wetness;
    scene.add({120, 2, 80}, {{-6, -0.2, -4}, {1, 0, 0, 0}}, [](glm::ivec3) { return kStone; });
    scene.add({60, 2, 80}, {{-6, 3.0, -4}, {1, 0, 0, 0}}, [](glm::ivec3) { return kStone; });
    return scene;
}
// From below the roof's edge toward -z: x grows to the right.
const Camera kUnderTheEdge = lookingAt({0, 1.6, 3.5}, {0, 0.0, 0.0});

TEST_F(WeatherTest, RainWetsOpenGroundOnly) {
    start(halfUnderRoof(1.0f), kSize);
    draw(kUnderTheEdge, 2);
    const FloatImage wet = read("material"), wetColor = read("albedo");
    start(halfUnderRoof(0.0f), kSize);
    draw(kUnderTheEdge, 2);
    EXPECT_FALSE(ran("wetness")) << "the pass runs in a dry level";
    const FloatImage dry = read("material"), dryColor = read("albedo");
    const glm::ivec2 leftLow(4, 6), leftHigh(30, 28), rightLow(66, 6), rightHigh(92, 28);
    EXPECT_NEAR(meanOf(wet, leftLow, leftHigh, 0), meanOf(dry, leftLow, leftHigh, 0), 0.01)
        << "it rains through the roof";
    EXPECT_LT(meanOf(wet, rightLow, rightHigh, 0), 0.6 * meanOf(dry, rightLow, rightHigh, 0))
        << "the open floor is not smooth";
    EXPECT_LT(meanOf(wetColor, rightLow, rightHigh, 1), 0.9 * meanOf(dryColor, rightLow, rightHigh, 1))
        << "the open floor is not darker";
    EXPECT_NEAR(meanOf(wetColor, rightLow, rightHigh, 3), meanOf(dryColor, rightLow, rightHigh, 3), 1e-6)
        << "palette indices were blended";
}

/// A floor, and an upright pane of red glass with the sun behind it at -z.
LitScene paneInTheSun(bool glass) {
    LitScene scene(stoneAndGlass(glass));
    scene.environment.sunDirection = {0.0f, 1.0f, -1.0f};
    scene.add({120, 2, 120}, {{-6, -0.2, -6}, {1, 0, 0, 0}}, [](glm::ivec3) { return kStone; });
    if (glass) scene.add({20, 20, 1}, {{-1, 0, 0}, {1, 0, 0, 0}}, [](glm::ivec3) { return kRedGlass; });
    return scene;
}

TEST_F(WeatherTest, SunThroughRedGlassIsRedAndOnlyThere) {
    const Camera above = lookingAt({0, 6.0, 0.02}, {0, 0, 0});
    RenderSettings settings;
    settings.sky = false;
    settings.bounce = false;
    start(paneInTheSun(true), kSize, settings);
    draw(above, 4);
    EXPECT_TRUE(ran("glass shadow"));
    const FloatImage tinted = read("radiance");
    start(paneInTheSun(false), kSize, settings);
    draw(above, 4);
    EXPECT_FALSE(ran("glass shadow"));
    const FloatImage clear = read("radiance");
    // Seen from above with -z up. The pane is in the middle; its tinted light reaches two metres toward the lower edge.
    const auto share = [&](glm::ivec2 low, glm::ivec2 high, int channel) {
        return meanOf(tinted, low, high, channel) / meanOf(clear, low, high, channel);
    };
    const glm::ivec2 litLow(44, 20), litHigh(52, 26), besideLow(4, 20), besideHigh(12, 26), beforeLow(44, 42),
        beforeHigh(52, 50);
    const double opacity = 60.0 / 255.0;
    EXPECT_NEAR(share(litLow, litHigh, 0), 1.0 - opacity, 0.05);
    EXPECT_LT(share(litLow, litHigh, 1), 0.5 * share(litLow, litHigh, 0));
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(share(besideLow, besideHigh, channel), 1.0, 0.02);
        EXPECT_NEAR(share(beforeLow, beforeHigh, channel), 1.0, 0.02);
    }
}

/// The pane's light falls on the floor as soon as what stood in the sun's way is gone.
TEST_F(WeatherTest, LightThroughGlassFollowsWhatStandsBeforeIt) {
    LitScene scene = paneInTheSun(true);
    const ShapeHandle roof = scene.add({60, 2, 60}, {{-3, 4, -3}, {1, 0, 0, 0}}, [](glm::ivec3) { return kStone; });
    RenderSettings settings;
    settings.temporal = settings.sky = false;
    start(scene, kSize, settings);
    const auto red = [&] {
        const Camera camera = lookingAt({0, 3.5, 3.0}, {0, 0, 0.5});
        draw(camera);
        const FloatImage image = read("radiance");
        double most = 0.0;
        for (const glm::vec4& pixel : image.pixels) most = std::max(most, double(pixel.r - pixel.g));
        return most;
    };
    red();
    scene.edit(roof, [](glm::ivec3) { return uint8_t(0); });
    renderer->apply(scene.step());
    const double after = red();
    start(scene, kSize, settings);
    EXPECT_NEAR(after, red(), 0.01 * after);
}

/// A map that was never drawn must not be read.
TEST_F(WeatherTest, LightThroughGlassIsNotTintedWhereItsShaderDoesNotBuild) {
    const TempFolder folder;
    std::filesystem::copy(shaderFolder(), folder.path(), std::filesystem::copy_options::recursive);
    std::ofstream(folder.path() / "passes/glass_shadow.frag") << "oops";
    RenderSettings settings;
    settings.sky = settings.bounce = false;
    auto made = Renderer::create(testContext().loader(), folder.path().string(), settings);
    ASSERT_TRUE(made) << made.error();
    renderer = std::move(made).value();
    renderer->apply(paneInTheSun(true).snapshot());
    target = std::make_unique<Offscreen>(kSize);
    draw(lookingAt({0, 6.0, 0.02}, {0, 0, 0}), 2);
    const FloatImage image = read("radiance");
    const glm::ivec2 low(44, 20), high(52, 26);
    EXPECT_GT(meanOf(image, low, high, 0), 0.1);
    EXPECT_NEAR(meanOf(image, low, high, 1) / meanOf(image, low, high, 0),
                meanOf(image, {4, 20}, {12, 26}, 1) / meanOf(image, {4, 20}, {12, 26}, 0), 0.02);
}

}  // namespace
}  // namespace rubble
