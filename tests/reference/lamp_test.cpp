// A floor under one lamp, as the whole renderer shows it, against the truth: its diffuse light and its highlight.
#include "tests/golden/drawing.h"
#include "tests/reference/path_tracer.h"
#include "tests/reference/views.h"

namespace rubble::reference {
namespace {

constexpr glm::ivec2 kSize(48, 32);

class FloorUnderALamp : public Drawing {
protected:
    static LitScene scene(uint8_t roughness, float radius) {
        auto palette = std::make_shared<Palette>();
        PaletteEntry& e = (*palette)[1];
        e.red = e.green = e.blue = 120;
        e.roughness = roughness, e.reflectivity = 20, e.material = 1;
        LitScene made(palette);
        Environment& air = made.environment;
        air.sunColor = air.skyColor = air.horizonColor = air.groundColor = air.fogColor = glm::vec3(0.0f);
        air.fogDistance = 1e6f;
        made.add({60, 1, 60}, {{-3, -0.1, -3}}, [](glm::ivec3) { return uint8_t(1); });
        made.addLight({LightKind::Sphere, {0.3, 1.2, -1.0}, {0, -1, 0}, {4, 4, 4}, radius, 100.0f, 0.6f, 1.1f});
        return made;
    }
    /// Mean radiance of the floor, drawn over true.
    double ratio(uint8_t roughness, float radius) {
        const LitScene floor = scene(roughness, radius);
        Camera camera;
        camera.position = {0.0, 1.6, 2.2};
        camera.lookAt({0, 0, -0.6});
        start(floor, kSize, comparedSettings());
        draw(camera, 24);
        const FloatImage drawn = read("resolved"), depth = read("depth");
        const FloatImage truth = render(Scene(floor.snapshot()), camera.view(kSize, 0), {.samples = 128, .filterPixels = true}).mean;
        double sum = 0.0, sumTruth = 0.0;
        for (size_t p = 0; p < truth.pixels.size(); ++p)
            if (depth.pixels[p].x < 1e3f) sum += drawn.pixels[p].y, sumTruth += truth.pixels[p].y;
        return sum / sumTruth;
    }
};

TEST_F(FloorUnderALamp, IsAsBrightAsTheTruth) {
    EXPECT_NEAR(ratio(10, 0.05f), 1.0, 0.01) << "smooth";
    EXPECT_NEAR(ratio(80, 0.8f), 1.0, 0.01) << "half smooth, a wide lamp";
    EXPECT_NEAR(ratio(255, 0.05f), 1.0, 0.01) << "rough";
}

}  // namespace
}  // namespace rubble::reference
