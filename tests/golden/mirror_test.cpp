// What mirrors show of surfaces that are off screen.
#include <glm/gtc/constants.hpp>

#include "tests/golden/drawing.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(96, 64);
constexpr uint8_t kSteel = 1, kRed = 2, kBlue = 3, kGlow = 4;

PaletteRef steelAndPaints(bool mirrors = true) {
    auto palette = std::make_shared<Palette>();
    const auto entry = [&](int index, glm::ivec3 color) -> PaletteEntry& {
        PaletteEntry& e = (*palette)[size_t(index)];
        e.red = uint8_t(color.x);
        e.green = uint8_t(color.y);
        e.blue = uint8_t(color.z);
        e.material = 1;
        return e;
    };
    PaletteEntry& steel = entry(kSteel, {255, 255, 255});
    steel.metallic = 255;
    steel.roughness = mirrors ? 0 : 255;
    entry(kRed, {200, 60, 40});
    entry(kBlue, {40, 60, 200});
    entry(kGlow, {200, 200, 60}).emission = 0.9f;
    return palette;
}

/// A mirror in front of the camera, and behind the camera a sunlit wall.
class MirrorTest : public Drawing {
protected:
    static constexpr float kSunHeight = 0.8f;
    ShapeHandle wall;

    static uint8_t steel(glm::ivec3) { return kSteel; }

    LitScene mirrorAndWall(uint8_t entry, glm::dquat turn = {1, 0, 0, 0}) {
        LitScene scene(steelAndPaints());
        Environment& air = scene.environment;
        air.sunDirection = {0.0f, kSunHeight, -1.0f};
        air.sunColor = glm::vec3(4.0f);
        air.skyColor = air.horizonColor = air.groundColor = glm::vec3(0.0f);
        air.fogDistance = 1e6f;
        scene.add({60, 40, 2}, {{-3, -0.5, -2.2}, {1, 0, 0, 0}}, steel);
        wall = scene.add({80, 60, 4}, {turn * glm::dvec3(-4, -1, 3.0), turn}, [=](glm::ivec3) { return entry; });
        return scene;
    }
    static Camera camera() {
        Camera camera;
        camera.position = {0, 1, 0};
        camera.lookAt({0, 1, -2});
        return camera;
    }
    /// Mean reflected radiance in the middle of the image.
    glm::vec3 mirrored(const Camera& from = camera()) {
        draw(from, 3);
        return middleOf("reflection");
    }
    glm::vec3 middleOf(const char* name) {
        const FloatImage image = read(name);
        glm::vec3 sum(0.0f);
        for (int y = 28; y < 36; ++y)
            for (int x = 40; x < 56; ++x) sum += glm::vec3(image.at(x, y));
        return sum / (8.0f * 16.0f);
    }
    /// Radiance of a Lambertian face of this colour in the sun.
    static glm::vec3 lit(uint8_t red, uint8_t green, uint8_t blue) {
        const glm::vec3 albedo(srgbToLinear(red), srgbToLinear(green), srgbToLinear(blue));
        return albedo * (4.0f / glm::pi<float>() / std::sqrt(1.0f + kSunHeight * kSunHeight));
    }
    /// The hue must agree, and the brightness but for the sun's white highlight and what the steel reflects to the
    /// wall.
    static void expectNear(glm::vec3 value, glm::vec3 expected) {
        EXPECT_GT(value.r, 0.95f * expected.r);
        EXPECT_LT(value.r, 1.22f * expected.r);
        for (int i = 1; i < 3; ++i) EXPECT_NEAR(value[i] / value.r, expected[i] / expected.r, 0.03f) << "channel " << i;
    }
};

TEST_F(MirrorTest, AWallBehindTheCameraShowsItsOwnColourInTheSun) {
    LitScene scene = mirrorAndWall(kRed);
    start(scene, kSize);
    expectNear(mirrored(), lit(200, 60, 40));
    scene.edit(wall, [](glm::ivec3) { return kBlue; });
    renderer->apply(scene.step());
    const glm::vec3 blue = lit(40, 60, 200);
    const glm::vec3 after = mirrored();
    expectNear({after.b, after.g, after.r}, {blue.b, blue.g, blue.r});
}

TEST_F(MirrorTest, AWallThatHasMovedIsMirroredWhereItIs) {
    LitScene scene = mirrorAndWall(kRed);
    start(scene, kSize);
    const glm::dquat turn = glm::angleAxis(0.2, glm::dvec3(0, 0, 1));
    scene.move(wall, {turn * glm::dvec3(-4, -1, 4.03), turn});
    renderer->apply(scene.step());
    expectNear(mirrored(), lit(200, 60, 40));
    scene.move(wall, {{-4, -1, -60}, turn});  // behind the mirror
    renderer->apply(scene.step());
    const glm::vec3 hills = mirrored();
    EXPECT_LT(hills.r, 2.0f * hills.b);
}

TEST_F(MirrorTest, AWallSixtyMetresAwayIsMirrored) {
    LitScene scene = mirrorAndWall(kRed);
    scene.move(wall, {{-4, -1, 60.0}, {1, 0, 0, 0}});
    start(scene, kSize);
    Camera narrow = camera();
    narrow.verticalFov = 0.05f;
    expectNear(mirrored(narrow), lit(200, 60, 40));
}

/// What lies below the horizon in a mirror must be what the camera sees there.
TEST_F(MirrorTest, BelowTheHorizonAMirrorShowsTheFields) {
    LitScene scene = mirrorAndWall(kRed);
    scene.environment.skyColor = scene.environment.horizonColor = glm::vec3(0.5f, 0.6f, 0.8f);
    scene.environment.groundColor = glm::vec3(0.3f, 0.1f, 0.0f);
    scene.move(wall, {{-4, -1, -60}, {1, 0, 0, 0}});
    start(scene, kSize);
    Camera down = camera();
    down.lookAt({0, 0.85, -2});
    const glm::vec3 reflected = mirrored(down);
    down.lookAt({0, 0.85, 2});  // the same direction, mirrored
    draw(down, 3);
    const glm::vec3 direct = middleOf("radiance");
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(reflected[i], direct[i], 0.15f * direct[i]) << "channel " << i;
}

/// The fields are as deep in the fog in a mirror as they are beside it.
TEST_F(MirrorTest, FogHidesTheFieldsInAMirrorAsItHidesThem) {
    for (const bool isFoggy : {false, true}) {
        LitScene scene = mirrorAndWall(kRed);
        Environment& air = scene.environment;
        air.skyColor = {0.3f, 0.5f, 0.9f}, air.horizonColor = {0.8f, 0.7f, 0.6f};
        air.groundColor = glm::vec3(0.3f);
        air.fogDensity = isFoggy ? 0.05f : 0.0f;
        air.fogHeight = 10.0f;
        air.fogTint = glm::vec3(0.9f);
        scene.move(wall, {{-4, -1, -60}, {1, 0, 0, 0}});
        start(scene, kSize);
        Camera low = camera();
        low.lookAt({0, 0.97, -2});
        const glm::vec3 reflected = mirrored(low);
        low.lookAt({0, 0.97, 2});
        draw(low, 24);
        const glm::vec3 direct = middleOf("radiance");
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(reflected[i] / direct[i], 1.0f, 0.25f) << "channel " << i;
        std::printf("mirrored over direct: %.2f %.2f %.2f\n", double(reflected.r / direct.r),
                    double(reflected.g / direct.g), double(reflected.b / direct.b));
    }
}

TEST_F(MirrorTest, WhatGlowsBehindTheCameraGlowsInTheMirror) {
    LitScene scene = mirrorAndWall(kGlow);
    scene.environment.sunColor = glm::vec3(0.0f);
    start(scene, kSize);
    expectNear(mirrored(), 0.9f * glm::vec3(srgbToLinear(200), srgbToLinear(200), srgbToLinear(60)));
}

/// A glossy floor under posts of two colours, as a polished floor or car paint is.
TEST_F(MirrorTest, GlossyReflectionsAreSmoothAndTrue) {
    auto palette = std::make_shared<Palette>(*steelAndPaints());
    (*palette)[kSteel].roughness = 70;
    LitScene scene(palette);
    scene.environment.sunDirection = {0.4f, 0.8f, 0.5f};
    scene.add({80, 2, 80}, {{-4, -0.2, -6}, {1, 0, 0, 0}}, steel);
    scene.add({70, 30, 2}, {{-3.5, 0, -5}, {1, 0, 0, 0}}, [](glm::ivec3 c) { return c.x / 6 % 2 ? kRed : kBlue; });
    Camera over = camera();
    over.lookAt({0, 0.2, -2});
    RenderSettings still;
    still.temporal = false;
    start(scene, kSize, still);
    constexpr int kReferenceFrames = 256;
    FloatImage mean(kSize);
    for (int i = 0; i < kReferenceFrames; ++i) {
        draw(over, 1);
        const FloatImage one = read("accumulatedReflection");
        for (size_t p = 0; p < one.pixels.size(); ++p) mean.pixels[p] += one.pixels[p] / float(kReferenceFrames);
    }
    const auto errorOf = [&](const char* name) {
        const FloatImage image = read(name);
        double error = 0.0, sum = 0.0;
        for (int y = 2; y < 26; ++y)  // the floor
            for (int x = 8; x < 88; ++x) {
                const glm::vec3 off = glm::vec3(image.at(x, y)) - glm::vec3(mean.at(x, y));
                error += double(glm::dot(off, off)), sum += double(glm::dot(mean.at(x, y), mean.at(x, y)));
            }
        return std::sqrt(error / sum);
    };
    const double noisy = errorOf("accumulatedReflection"), filtered = errorOf("reflection");
    start(scene, kSize);
    draw(over, 16);
    const double denoised = errorOf("reflection");
    std::printf("relative error: one ray %.3f, filtered %.3f, after 16 frames %.3f\n", noisy, filtered, denoised);
    EXPECT_LT(filtered, 0.5 * noisy);
    EXPECT_LT(denoised, 0.2 * noisy);
}

TEST_F(MirrorTest, WithoutMirrorsNothingIsAllocatedForThem) {
    const auto bytes = [&](bool mirrors) {
        LitScene scene(steelAndPaints(mirrors));
        scene.add({60, 40, 2}, {{-3, -0.5, -2.2}, {1, 0, 0, 0}}, steel);
        RenderSettings settings;
        settings.reflections = false;  // so that neither has targets for them
        settings.bounceColors = false;
        start(scene, kSize, settings);
        draw(camera(), 2);
        return renderer->stats().textureBytes;
    };
    EXPECT_GT(bytes(true), bytes(false)) << "the body grid of mirror rays is not counted";
}

}  // namespace
}  // namespace rubble
