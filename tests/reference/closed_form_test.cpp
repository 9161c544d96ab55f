// Estimators of light, and the path tracer, against closed forms.
#include "runtime/core/constants.h"
#include "tests/reference/estimator_fixture.h"

namespace rubble::reference {
namespace {

/// The white furnace test: under a uniform sky a white object that reflects all light is invisible. It is below the
/// plane of the fields, which mirrors would show.
class FurnaceTest : public EstimatorTest {
protected:
    static constexpr double kHeight = -20.0;
    static LitScene furnace(uint8_t roughness, glm::dquat turned) {
        LitScene scene(palette(255, roughness, 60));
        Environment& air = scene.environment;
        air.sunColor = glm::vec3(0.0f);
        air.skyColor = air.horizonColor = air.groundColor = air.fogColor = glm::vec3(1.0f);
        air.fogDistance = 1e6f;
        air.clouds = 0.0f;
        scene.add({12, 12, 12}, {glm::dvec3(0, kHeight, 0) - turned * glm::dvec3(0.6), turned}, solid);
        return scene;
    }
    /// Mean over the faces toward a camera on this side. Smooth sides reflect hills, so that only top and bottom count.
    double meanRadiance(glm::dvec3 from, bool smooth) {
        Camera camera;
        camera.position = glm::dvec3(0, kHeight, 0) + from;
        camera.lookAt({0, kHeight, 0});
        const Drawn drawn = drawMany(camera, "radiance", 16);
        const FloatImage depth = read("depth"), normal = read("normal");
        double sum = 0.0;
        int pixels = 0;
        for (size_t p = 0; p < depth.pixels.size(); ++p) {
            if (depth.pixels[p].x > 1e3f || (smooth && std::abs(normal.pixels[p].y) < 0.9f)) continue;
            sum += drawn.mean.pixels[p].y, ++pixels;
        }
        EXPECT_GT(pixels, 100);
        return sum / pixels;
    }
    void expectHidden(uint8_t roughness, glm::dquat turned) {
        RenderSettings settings = bare();
        settings.sky = settings.reflections = settings.bounce = true;
        settings.skyRays = 4;
        start(furnace(roughness, turned), kSize, settings);
        // Three faces each, so all six.
        EXPECT_NEAR(meanRadiance({0.9, 2.2, 1.3}, roughness < 255), 1.0, 0.01)
            << "from above, roughness " << int(roughness);
        EXPECT_NEAR(meanRadiance({-0.9, -2.2, -1.3}, roughness < 255), 1.0, 0.01)
            << "from below, roughness " << int(roughness);
    }
};

TEST_F(FurnaceTest, HidesWhatIsInIt) {
    for (const uint8_t roughness : {uint8_t(0), uint8_t(25), uint8_t(51), uint8_t(90), uint8_t(128), uint8_t(255)})
        expectHidden(roughness, kLevel);
}

TEST_F(FurnaceTest, HidesWhatIsTurned) {
    expectHidden(255, glm::angleAxis(0.7, glm::normalize(dvec3(0.3, 1.0, -0.4))));
}

/// A square plate over a floor under a uniform sky. From the point below its centre it hides the form factor
/// F = 4 / (2 pi) (2 x / sqrt(1 + x^2)) atan(x / sqrt(1 + x^2)), x = half side / height (Siegel & Howell, B-4 four
/// times).
TEST_F(EstimatorTest, APlateOverheadTakesItsFormFactor) {
    LitScene scene(palette(186, 255, 0));
    Environment& air = scene.environment;
    air.sunColor = glm::vec3(0.0f);
    air.skyColor = air.horizonColor = air.groundColor = glm::vec3(1.0f);
    scene.add({60, 1, 60}, {{-3, -0.1, -3}, kLevel}, solid);
    scene.add({20, 1, 20}, {{-1, 1, -1}, kLevel}, solid);
    const Scene reference(scene.snapshot());
    Camera camera;  // so close to the floor that the whole image is one place
    camera.position = {0.0, 0.08, 0.0001};
    camera.lookAt({0, 0, 0});
    camera.verticalFov = 0.5f;
    const double x = 1.0, r = std::sqrt(1.0 + x * x);
    const double expected = 1.0 - 4.0 / (2.0 * kPi) * (2.0 * x / r * std::atan(x / r));
    const glm::ivec2 size(16, 16);
    double traced = 0.0, drawnMean = 0.0;
    for (const glm::vec4& p :
         render(reference, camera.view(size, 0), {.term = Term::Sky, .samples = 1024, .bounces = 0}).mean.pixels)
        traced += p.y / 256.0;
    EXPECT_NEAR(traced, expected, 0.01 * expected);
    RenderSettings settings = bare();
    settings.sky = true;
    settings.skyRays = 16;
    start(scene, size, settings);
    for (const glm::vec4& p : drawMany(camera, "noisyLight", 24).mean.pixels) drawnMean += p.y / 256.0;
    EXPECT_NEAR(drawnMean, expected, 0.01 * expected);
}

/// A sphere of even radiance gives I cos / d^2 whatever its size, if all of it is above the horizon.
TEST_F(EstimatorTest, ASphereLightGivesTheInverseSquare) {
    LitScene scene(palette(186, 255, 0));
    scene.add({60, 1, 60}, {{-3, -0.1, -3}, kLevel}, solid);
    scene.addLight({LightKind::Sphere, {0.4, 0.9, 0.3}, {0, -1, 0}, {1, 1, 1}, 0.5f, 1000.0f, 0.6f, 1.1f});
    Camera camera;
    camera.position = {0.0, 0.08, 0.0001};
    camera.lookAt({0, 0, 0});
    camera.verticalFov = 0.5f;
    const double d2 = 0.4 * 0.4 + 0.9 * 0.9 + 0.3 * 0.3, expected = 0.9 / std::sqrt(d2) / d2 / kPi;
    const glm::ivec2 size(16, 16);
    const Scene reference(scene.snapshot());
    double traced = 0.0, drawnMean = 0.0;
    for (const glm::vec4& p :
         render(reference, camera.view(size, 0), {.term = Term::LocalLights, .samples = 512}).mean.pixels)
        traced += p.y / 256.0;
    EXPECT_NEAR(traced, expected, 0.01 * expected);
    RenderSettings settings = bare();
    settings.localLights = true;
    start(scene, size, settings);
    for (const glm::vec4& p : drawMany(camera, "noisyLight", 40).mean.pixels) drawnMean += p.y / 256.0;
    EXPECT_NEAR(drawnMean, expected, 0.01 * expected);
}

/// Below the edge of a roof at height d the sun's share rises from 0 to 1 within d 2 tan(angle). In between the edge
/// cuts the disc along a line, and its visible share is 1 - (acos(c) - c sqrt(1 - c^2)) / pi. From beyond the edge, the
/// upper rim of the roof counts, one voxel higher.
TEST_F(EstimatorTest, APenumbraIsAsWideAsTheSun) {
    LitScene scene(palette(186, 255, 0));
    scene.environment.sunDirection = {0, 1, 0};
    scene.environment.sunAngle = 0.05f;
    const double height = 8.0;
    scene.add({60, 1, 60}, {{-3, -0.1, -3}, kLevel}, solid);
    scene.add({30, 1, 60}, {{-3, height, -3}, kLevel}, solid);  // its edge: x = 0
    Camera camera;
    camera.position = {0, 0.9, 0.0001};
    camera.lookAt({0, 0, 0});
    const glm::ivec2 size(48, 8);
    camera.verticalFov = 2.0f * std::atan(0.6f * 8 / 48 / 0.9f);  // 1.2 m from left to right
    RenderSettings settings = bare();
    settings.sun = true;
    settings.sunRays = 128;
    start(scene, size, settings);
    const Drawn drawn = drawMany(camera, "noisyLight", 32);
    for (int x = 0; x < size.x; ++x) {
        double share = 0.0;
        for (int y = 0; y < size.y; ++y) share += drawn.mean.at(x, y).a / size.y;
        const double place = ((x + 0.5) / size.x - 0.5) * 1.2;  // metres from the edge
        const double c = std::clamp(place / ((place > 0.0 ? height + 0.1 : height) * std::tan(0.05)), -1.0, 1.0);
        const double expected = 1.0 - (std::acos(c) - c * std::sqrt(1.0 - c * c)) / kPi;
        EXPECT_NEAR(share, expected, 0.01) << "at " << place << " m";
    }
}

}  // namespace
}  // namespace rubble::reference
