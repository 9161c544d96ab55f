// A floor under one light, drawn by the whole renderer, against the reference: diffuse light and highlight.
#include "tests/golden/drawing.h"
#include "tests/reference/brightness.h"
#include "tests/reference/path_tracer.h"
#include "tests/reference/views.h"

namespace rubble::reference {
namespace {

constexpr glm::ivec2 kSize(48, 32);
constexpr int kJitterPeriod = 16;  // frames

class FloorUnderALight : public Drawing {
protected:
    struct Floor {
        uint8_t gray = 120, roughness = 255, reflectivity = 20;
        glm::vec3 sky = glm::vec3(0.0f), light = glm::vec3(4.0f);
        float radius = 0.05f;
    };
    static LitScene scene(const Floor& floor) {
        auto palette = std::make_shared<Palette>();
        PaletteEntry& e = (*palette)[1];
        e.red = e.green = e.blue = floor.gray;
        e.roughness = floor.roughness, e.reflectivity = floor.reflectivity, e.material = 1;
        LitScene made(palette);
        Environment& air = made.environment;
        air.sunColor = air.groundColor = air.fogColor = glm::vec3(0.0f);
        air.skyColor = air.horizonColor = floor.sky;
        air.fogDistance = 1e6f;
        made.add({60, 1, 60}, {{-3, -0.1, -3}}, [](glm::ivec3) { return uint8_t(1); });
        made.addLight({LightKind::Sphere, {0.3, 1.2, -1.0}, {0, -1, 0}, floor.light, floor.radius, 100.0f, 0.6f, 1.1f});
        return made;
    }
    /// Mean radiance of the floor over that of the reference.
    glm::dvec3 ratio(const Floor& floor, glm::dvec3 eye = {0.0, 1.6, 2.2}) {
        const LitScene made = scene(floor);
        Camera camera;
        camera.position = eye;
        camera.lookAt({0, 0, -0.6});
        start(made, kSize, comparedSettings());
        draw(camera, 48);
        const FloatImage depth = read("depth");
        FloatImage drawn(kSize);
        for (int i = 0; i < kJitterPeriod; ++i) {
            draw(camera, 1);
            const FloatImage image = read("resolved");
            for (size_t p = 0; p < drawn.pixels.size(); ++p) drawn.pixels[p] += image.pixels[p] / float(kJitterPeriod);
        }
        const FloatImage reference =
            render(Scene(made.snapshot()), camera.view(kSize, 0), {.samples = 512, .filterPixels = true}).mean;
        return brightnessRatio(drawn, reference, [&](size_t p) { return depth.pixels[p].x < 1e3f; });
    }
};

TEST_F(FloorUnderALight, IsAsBrightAsTheReference) {
    EXPECT_NEAR(ratio({.roughness = 10}).y, 1.0, 0.01) << "smooth";
    EXPECT_NEAR(ratio({.roughness = 80, .radius = 0.8f}).y, 1.0, 0.01) << "half smooth, a wide light";
    EXPECT_NEAR(ratio({.roughness = 255}).y, 1.0, 0.01) << "rough";
}

/// A dark floor reflects as much as it scatters. It must reflect the sky, as local lights have highlights of their own.
TEST_F(FloorUnderALight, MirrorsTheSkyAndNotTheLightsColor) {
    const glm::dvec3 found = ratio({.gray = 60,
                                    .roughness = 200,
                                    .reflectivity = 128,
                                    .sky = {0.15f, 0.2f, 0.3f},
                                    .light = {4.0f, 2.4f, 1.0f},
                                    .radius = 0.3f},
                                   {0.0, 0.7, 2.8});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], 1.0, 0.02) << c;
}

/// A steel post of one voxel close to a light, in front of a dark wall far away: its highlight must not blur onto the
/// wall.
class PostByALight : public Drawing {
protected:
    FloatImage image(uint8_t metallic) {
        auto palette = std::make_shared<Palette>();
        PaletteEntry &wall = (*palette)[1], &steel = (*palette)[2];
        wall.red = wall.green = wall.blue = 40;
        wall.roughness = 255, wall.material = 1;
        steel.red = steel.green = steel.blue = metallic ? 200 : 0;
        steel.roughness = 110, steel.metallic = metallic, steel.material = 1;
        LitScene made(palette);
        Environment& air = made.environment;
        air.sunColor = air.skyColor = air.horizonColor = air.groundColor = air.fogColor = glm::vec3(0.0f);
        air.fogDistance = 1e6f;
        made.add({200, 100, 1}, {{-10, -5, -8}}, [](glm::ivec3) { return uint8_t(1); });
        made.add({1, 30, 1}, {{-0.05, -1.5, 0}}, [](glm::ivec3) { return uint8_t(2); });
        made.addLight({LightKind::Sphere, {0.5, 0.4, 0.8}, {0, -1, 0}, {6, 6, 6}, 0.1f, 100.0f, 0.6f, 1.1f});
        Camera camera;
        camera.position = {0.0, 0.0, 4.0};
        camera.lookAt({0, 0, 0});
        RenderSettings settings = comparedSettings();
        settings.bounce = settings.reflections = false;
        start(made, kSize, settings);
        draw(camera, 40);
        return read("radiance");
    }
};

TEST_F(PostByALight, KeepsItsHighlightToItself) {
    const FloatImage shining = image(255), black = image(0), depth = read("depth");
    double onWall = 0.0, onPost = 0.0;
    for (size_t p = 0; p < depth.pixels.size(); ++p) {
        const double more = double(shining.pixels[p].y - black.pixels[p].y);
        double& largest = depth.pixels[p].x > 6.0f ? onWall : onPost;
        largest = std::max(largest, more);
    }
    EXPECT_GT(onPost, 0.1);
    EXPECT_LT(onWall, 0.01 * onPost);
}

}  // namespace
}  // namespace rubble::reference
