#include <algorithm>
#include <cmath>

#include "tests/golden/drawing.h"
#include "tests/golden/finite_textures.h"

namespace rubble {
namespace {

const glm::dquat kLevel(1, 0, 0, 0);
constexpr glm::ivec2 kSmall(96, 64);

PaletteRef plain() {
    auto palette = std::make_shared<Palette>();
    PaletteEntry& e = (*palette)[1];
    e.red = e.green = e.blue = 186;  // albedo one half
    e.material = 1;
    return palette;
}

uint8_t solid(glm::ivec3) {
    return 1;
}

Camera lookingAt(glm::dvec3 from, glm::dvec3 at) {
    Camera camera;
    camera.position = from;
    camera.lookAt(at);
    return camera;
}

/// Share of lit pixels among those that face the sun, from the views "normal" and "noisySun".
double litShare(const Image& normals, const Image& albedo, const Image& sun, glm::vec3 toSun) {
    int facing = 0, lit = 0;
    for (size_t i = 0; i < sun.rgb.size(); i += 3) {
        if (albedo.rgb[i] == 0) continue;
        const glm::vec3 n = glm::vec3(normals.rgb[i], normals.rgb[i + 1], normals.rgb[i + 2]) / 127.5f - 1.0f;
        if (glm::dot(n, toSun) < 0.05f) continue;
        ++facing;
        lit += sun.rgb[i] > 127;
    }
    EXPECT_GT(facing, 100);
    return double(lit) / facing;
}

class LightTest : public Drawing {};

TEST_F(LightTest, ALoneFallingCubeDoesNotShadowItself) {
    LitScene scene(plain());
    scene.environment.sunDirection = {-0.6f, 0.5f, 0.62f};
    const glm::vec3 toSun = glm::normalize(scene.environment.sunDirection);
    const ShapeHandle cube = scene.add({8, 8, 8}, {{0, 5, 0}, kLevel}, solid);
    RenderSettings settings;
    settings.temporal = false;  // no jitter: all passes see the same pixels
    start(scene, kSmall, settings);
    for (int i = 0; i < 16; ++i) {
        const glm::dquat turn =
            glm::angleAxis(0.41 * i, glm::normalize(glm::dvec3(std::sin(i), 1.0, std::cos(2.0 * i))));
        const glm::dvec3 centre(0.013 * i, 5.0 - 0.137 * i, -0.021 * i);
        scene.move(cube, {centre - turn * glm::dvec3(0.4), turn});
        renderer->apply(scene.step());
        const Camera camera = lookingAt(centre + glm::dvec3(-1.0, 0.9, 1.1), centre);
        const Image normals = draw(camera, 1, "normal"), albedo = draw(camera, 1, "albedo"),
                    sun = draw(camera, 1, "noisySun");
        EXPECT_GE(litShare(normals, albedo, sun, toSun), 0.995) << "rotation " << i;
    }
}

TEST_F(LightTest, AClosedRoomOfOneVoxelIsDark) {
    LitScene scene(plain());
    scene.add({40, 28, 40}, {{-2, 0, -2}, kLevel}, [](glm::ivec3 c) {
        return uint8_t(c.x == 0 || c.y == 0 || c.z == 0 || c.x == 39 || c.y == 27 || c.z == 39);
    });
    start(scene, kSmall);
    const Camera camera = lookingAt({1.4, 1.6, 1.5}, {-1, 0.6, -1});
    const auto brightest = [&](const char* pass) {
        const Image image = draw(camera, 8, pass);
        return int(*std::max_element(image.rgb.begin(), image.rgb.end()));
    };
    EXPECT_EQ(brightest("noisySun"), 0);
    // 4 of 255 is a radiance of 1e-4 under a sky of 0.7: the rounding error of half floats when haze is subtracted.
    EXPECT_LE(brightest("noisySky"), 4);
    EXPECT_LE(brightest("denoisedLight"), 4);
}

TEST_F(LightTest, PassesThatASceneDoesNotNeedDoNotRun) {
    LitScene scene(plain());
    scene.add({20, 2, 20}, {{-1, -0.2, -1}, kLevel}, solid);
    start(scene, kSmall);
    draw(lookingAt({0, 1.5, 2}, {0, 0, 0}));
    for (const char* pass : renderer->stats().passes) {
        EXPECT_STRNE(pass, "local lights");
        EXPECT_STRNE(pass, "reflections");
        EXPECT_STRNE(pass, "glass");
        EXPECT_STRNE(pass, "glass composite");
    }
}

/// Under a uniform sky every pixel of a floor must have the sky's radiance after the filter.
TEST_F(LightTest, AnEvenSkySurvivesTheDenoiser) {
    LitScene scene(plain());
    Environment& air = scene.environment;
    air.sunColor = glm::vec3(0.0f);
    air.skyColor = air.horizonColor = air.groundColor = glm::vec3(0.5f);
    scene.add({80, 2, 80}, {{-4, -0.2, -4}, kLevel}, solid);
    start(scene, kSmall);
    const Image light = draw(lookingAt({0, 1.5, 2}, {0, 0, 0}), 6, "denoisedLight");
    const int expected = int(std::lround(255.0 * std::pow(0.5 / 1.5, 1.0 / 2.2)));  // as passes/show_data.frag maps it
    for (int y = 20; y < 60; ++y)
        for (int x = 8; x < 88; ++x) ASSERT_NEAR(*light.at(x, y), expected, 2) << x << ", " << y;
}

TEST_F(LightTest, WhatIsTooBrightForATargetIsAsBrightAsItHolds) {
    auto palette = std::make_shared<Palette>(*plain());
    (*palette)[1].emission = 90000.0f;
    LitScene scene(palette);
    scene.add({20, 20, 2}, {{-1, -1, -2}, kLevel}, solid);
    SnapshotLight light{LightKind::Sphere, {0, 0, -1.5}, {0, 0, -1}, glm::vec3(1e9f), 0.1f, 12.0f, 0, 0};
    scene.addLight(light);
    start(scene, kSmall);
    const Image image = draw(lookingAt({0, 0, 1}, {0, 0, -2}), 3);
    for (int channel = 0; channel < 3; ++channel) EXPECT_EQ(image.at(48, 32)[channel], 255) << channel;
    EXPECT_GT(read("radiance").at(48, 32).g, 10000.0f);
    EXPECT_EQ(nonFiniteTextures(), "");
}

TEST_F(LightTest, CloudsStayWhenTheSunIsAtTheZenith) {
    const auto skyAt = [&](glm::vec3 sun) {
        LitScene scene(plain());
        scene.environment.sunDirection = glm::normalize(sun);
        scene.environment.clouds = 0.6f;
        scene.add({2, 2, 2}, {{0, 50, 0}, kLevel}, solid);
        start(scene, kSmall);
        draw(lookingAt({0, 1.5, 0}, {0, 2.2, -1}));
        return read("radiance");
    };
    const FloatImage zenith = skyAt({0, 1, 0}), beside = skyAt({1e-5f, 1, 0});
    double difference = 0.0, mean = 0.0;
    for (size_t p = 0; p < zenith.pixels.size(); ++p) {
        difference += std::abs(double(zenith.pixels[p].r - beside.pixels[p].r));
        mean += double(beside.pixels[p].r);
    }
    EXPECT_LT(difference, 0.1 * mean);
    EXPECT_EQ(nonFiniteTextures(), "");
}

TEST_F(LightTest, TheEyeAdaptsBySecondsNotByFrames) {
    const auto exposureAfterASecond = [&](int framesPerStep) {
        LitScene scene(plain());
        scene.add({80, 2, 80}, {{-4, -0.2, -4}, kLevel}, solid);
        start(scene, kSmall);
        const Camera floor = lookingAt({0, 1.5, 2}, {0, 0, 0});
        draw(floor, 2);
        scene.environment.exposure = 0.25f;
        for (int step = 0; step < 30; ++step) {
            renderer->apply(scene.step());
            for (int i = 1; i <= framesPerStep; ++i)
                renderer->draw(floor.view(kSmall, target->framebuffer()), float(i) / float(framesPerStep));
        }
        return read("exposure").at(0, 0).r;
    };
    const float slow = exposureAfterASecond(1), fast = exposureAfterASecond(4);
    EXPECT_NEAR(slow, fast, 0.02f * slow);
}

TEST_F(LightTest, NoConfidenceIsLeftOfFramesBeforeACut) {
    LitScene scene = streetScene();
    start(scene, kSmall);
    draw(streetCamera(0), 3);
    EXPECT_TRUE(renderer->readTarget("historyConfidence"));
    View view = streetCamera(1).view(kSmall, target->framebuffer());
    view.cut = true;
    renderer->draw(view, 1.0f);
    EXPECT_FALSE(renderer->readTarget("historyConfidence"));
}

TEST_F(LightTest, NoTargetHoldsNanOrInfinity) {
    LitScene scene = streetScene();
    start(scene, {160, 90});
    for (int i = 0; i < 4; ++i) draw(streetCamera(i));
    EXPECT_EQ(nonFiniteTextures(), "");
}

/// Mean of the pixels in a box of the image.
double meanOf(const Image& image, glm::ivec2 low, glm::ivec2 high) {
    double sum = 0;
    for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x) sum += image.at(x, y)[1];
    return sum / ((high.x - low.x) * (high.y - low.y));
}

TEST_F(LightTest, AWallThatOpensIsSeenInTwelveFrames) {
    LitScene scene(plain());
    scene.environment.sunDirection = {0.0f, 0.3f, 1.0f};
    const auto wall = [](glm::ivec3) { return uint8_t(1); };
    scene.add({80, 2, 80}, {{-4, -0.2, -4}, kLevel}, solid);
    const ShapeHandle screen = scene.add({80, 60, 2}, {{-4, 0, 2}, kLevel}, wall);
    start(scene, kSmall);
    const Camera camera = lookingAt({0, 3.0, -1.5}, {0, 0, 1.0});
    const glm::ivec2 low(36, 30), high(60, 42);
    const double before = meanOf(draw(camera, 40, "sun"), low, high),
                 skyBefore = meanOf(draw(camera, 1, "denoisedLight"), low, high);
    scene.edit(screen, [](glm::ivec3) { return uint8_t(0); });
    renderer->apply(scene.step());
    const double after = meanOf(draw(camera, 12, "sun"), low, high),
                 skyAfter = meanOf(draw(camera, 1, "denoisedLight"), low, high);
    const double thirty = meanOf(draw(camera, 17, "sun"), low, high),
                 skyThirty = meanOf(draw(camera, 1, "denoisedLight"), low, high);
    const double converged = meanOf(draw(camera, 60, "sun"), low, high),
                 skyConverged = meanOf(draw(camera, 1, "denoisedLight"), low, high);
    EXPECT_LT(before, 5.0);
    EXPECT_GT(converged, 250.0);
    EXPECT_GE(after - before, 0.9 * (converged - before));
    EXPECT_GT(skyConverged, skyBefore + 5.0);
    EXPECT_GE(skyAfter - skyBefore, 0.9 * (skyConverged - skyBefore));
    EXPECT_NEAR(thirty, converged, 0.02 * (converged - before)) << "a ghost";
    EXPECT_NEAR(skyThirty, skyConverged, 0.02 * (skyConverged - skyBefore)) << "a ghost";
}

/// Only the ceiling of a white room is visible. What its rays hit is off screen, so that the last bounce takes the
/// ceiling's own light as an estimate.
TEST_F(LightTest, TheBounceEstimateOfAWhiteRoomConverges) {
    auto white = std::make_shared<Palette>(*plain());
    (*white)[1].red = (*white)[1].green = (*white)[1].blue = 255;
    LitScene room(white);
    Environment& air = room.environment;
    air.sunColor = air.skyColor = air.horizonColor = air.groundColor = air.fogColor = glm::vec3(0.0f);
    room.add({60, 40, 60}, {{-3, 0, -3}, kLevel}, [](glm::ivec3 c) {
        const bool inside = c.x > 0 && c.y > 0 && c.z > 0 && c.x < 59 && c.y < 39 && c.z < 59;
        return uint8_t(inside ? 0 : 1);
    });
    room.addLight({LightKind::Sphere, {0, 2, 0}, {0, -1, 0}, {0.1f, 0.1f, 0.1f}, 0.1f, 100.0f, 0.6f, 1.1f});
    RenderSettings settings;
    settings.historyFrames = 4;
    start(room, kSmall, settings);
    const Camera up = lookingAt({0, 2.5, 0}, {0.01, 3.9, 0});
    const auto brightness = [&](int frames) {
        draw(up, frames);
        double sum = 0.0;
        const FloatImage light = read("denoisedLight");
        for (const glm::vec4& pixel : light.pixels) sum += double(pixel.g) / double(light.pixels.size());
        return sum;
    };
    const double first = brightness(1);
    EXPECT_GT(first, 1e-3);
    EXPECT_LT(brightness(300), 25.0 * first) << "all bounces that each lose a twentieth sum up to 20 times";
}

/// Under a plate close to a floor light comes from the sides only: the filter must not blur light into the dark.
TEST_F(LightTest, WhatIsUnderAPlateStaysDark) {
    LitScene scene(plain());
    scene.environment.sunColor = glm::vec3(0.0f);
    scene.environment.skyColor = scene.environment.horizonColor = glm::vec3(1.0f);
    scene.environment.groundColor = glm::vec3(0.0f);
    scene.add({120, 2, 120}, {{-6, -0.2, -6}, kLevel}, solid);
    scene.add({30, 1, 30}, {{-1.5, 0.2, -1.5}, kLevel}, solid);
    Camera camera = lookingAt({0.0, 0.13, 6.0}, {0.0, 0.1, 0.0});
    camera.verticalFov = 0.2f;  // so that several rows of pixels see the gap
    const auto mean = [&](int passes) {
        RenderSettings settings;
        settings.bounce = false, settings.filterPasses = passes;
        start(scene, {192, 128}, settings);
        draw(camera, 32);
        const FloatImage light = read("denoisedLight"), depth = read("depth"), normal = read("normal");
        double sum = 0.0;
        int count = 0;
        for (size_t p = 0; p < light.pixels.size(); ++p)
            if (normal.pixels[p].y > 0.9f && depth.pixels[p].x > 4.7f && depth.pixels[p].x < 6.0f &&
                std::abs(float(p % 192) - 96.0f) < 24.0f)
                sum += double(light.pixels[p].y), ++count;
        EXPECT_GT(count, 150);
        return sum / count;
    };
    const double raw = mean(0), filtered = mean(4);
    EXPECT_LT(raw, 0.25) << "the gap is not dark";
    EXPECT_NEAR(filtered / raw, 1.0, 0.35) << "without hit proximity as a guide it is eight times as bright";
}

}  // namespace
}  // namespace rubble
