// Indirect light after several bounces, against the reference.
#include "tests/golden/drawing.h"
#include "tests/reference/brightness.h"
#include "tests/reference/path_tracer.h"
#include "tests/reference/views.h"

namespace rubble::reference {
namespace {

constexpr glm::ivec2 kSize(48, 32);

/// Sunlight enters a room through a hole behind the camera: what is visible is lit by surfaces that are off screen.
class RoomBehindAHole : public Drawing {
protected:
    static LitScene scene() {
        auto palette = std::make_shared<Palette>();
        PaletteEntry& e = (*palette)[1];
        e.red = e.green = e.blue = 180;
        e.roughness = 255, e.material = 1;
        LitScene made(palette);
        Environment& air = made.environment;
        air.sunDirection = glm::normalize(glm::vec3(0.8f, 0.6f, 0.1f));
        air.fogDistance = 1e6f;
        made.add({40, 30, 60}, {{-2, 0, -3}}, [](glm::ivec3 c) {
            const bool inside = c.x > 0 && c.y > 0 && c.z > 0 && c.x < 39 && c.y < 29 && c.z < 59;
            const bool hole = c.x == 39 && c.y > 8 && c.y < 18 && c.z > 44 && c.z < 54;
            return uint8_t(inside || hole ? 0 : 1);
        });
        return made;
    }
    static Camera ahead() {
        Camera camera;
        camera.position = {0, 1.5, 1.0};
        camera.lookAt({-0.3, 1.6, -3.0});
        return camera;
    }
    /// Mean radiance of the image over that of the reference.
    double ratio(const LitScene& made, const FloatImage& reference, int bounces) {
        RenderSettings settings = comparedSettings();
        settings.bounces = bounces;
        start(made, kSize, settings);
        draw(ahead(), 96);
        return brightnessRatio(read("resolved"), reference, [](size_t) { return true; }).y;
    }
};

TEST_F(RoomBehindAHole, IsAsBrightAsTheReference) {
    const LitScene made = scene();
    const FloatImage reference =
        render(Scene(made.snapshot()), ahead().view(kSize, 0), {.samples = 1024, .filterPixels = true}).mean;
    const double one = ratio(made, reference, 1), two = ratio(made, reference, 2), three = ratio(made, reference, 3);
    RecordProperty("drawn_over_true", std::to_string(one) + " " + std::to_string(two) + " " + std::to_string(three));
    EXPECT_NEAR(two, 1.0, 0.25);
    EXPECT_NEAR(three, 1.0, 0.1);
    EXPECT_GT(std::abs(one - 1.0), 1.8 * std::abs(two - 1.0)) << "the second bounce does not help";
}

/// A wall that faces +z, on a wide floor.
class WallTest : public Drawing {
protected:
    static LitScene scene(uint8_t floorReflectivity) {
        auto palette = std::make_shared<Palette>();
        for (int i : {1, 2}) {
            PaletteEntry& e = (*palette)[size_t(i)];
            e.red = e.green = e.blue = i == 1 ? 120 : 180;
            e.roughness = i == 1 ? 150 : 255, e.reflectivity = i == 1 ? floorReflectivity : 0, e.material = 1;
        }
        LitScene made(palette);
        made.environment.fogDistance = 1e6f;
        made.add({160, 2, 160}, {{-8, -0.2, -8}}, [](glm::ivec3) { return uint8_t(1); });
        made.add({30, 8, 2}, {{-1.5, 0, 0}}, [](glm::ivec3) { return uint8_t(2); });
        return made;
    }
    /// Mean radiance of the wall over that of the reference, away from its edges.
    double ratio(const LitScene& made) {
        Camera camera;
        camera.position = {0, 1.2, 4.0};
        camera.lookAt({0, 0.2, 0});
        start(made, kSize, comparedSettings());
        draw(camera, 96);
        const FloatImage drawn = read("resolved"), normal = read("normal");
        const FloatImage reference =
            render(Scene(made.snapshot()), camera.view(kSize, 0), {.samples = 1024, .filterPixels = true}).mean;
        return brightnessRatio(drawn, reference, [&](size_t p) { return normal.pixels[p].z > 0.9f; }).y;
    }
};

/// The floor reflects the sun toward the camera. That highlight is view-dependent and must not light the wall.
TEST_F(WallTest, AHighlightLightsNobodyElse) {
    LitScene made = scene(120);
    made.environment.sunDirection = glm::normalize(glm::vec3(0.2f, 0.4f, -1.0f));
    EXPECT_NEAR(ratio(made), 1.0, 0.03);
}

TEST_F(WallTest, WhatStandsFarAwayHidesTheSky) {
    LitScene made = scene(0);
    made.environment.sunColor = glm::vec3(0.0f);
    made.add({600, 200, 2}, {{-30, 0, 40}}, [](glm::ivec3) { return uint8_t(1); });
    EXPECT_NEAR(ratio(made), 1.0, 0.03);
}

}  // namespace
}  // namespace rubble::reference
