// Each estimator of light is unbiased: its mean, before any filter, is that of the path tracer.
#include "tests/reference/estimator_fixture.h"

namespace rubble::reference {
namespace {

TEST_F(EstimatorTest, SunShareIsUnbiased) {
    const LitScene scene = yard(palette(186, 255, 0));
    RenderSettings settings = bare();
    settings.sun = true;
    settings.sunRays = 16;
    start(scene, kSize, settings);
    const Drawn drawn = drawMany(yardCamera(), "noisyLight", 32, 16);
    const Scene reference(scene.snapshot());
    const Estimate estimate = render(reference, yardCamera().view(kSize, 0), {.term = Term::SunShare, .samples = 1024});
    expectSameMeans(drawn, estimate, comparable(reference, yardCamera()), true);
}

TEST_F(EstimatorTest, SkyIsUnbiased) {
    const LitScene scene = yard(palette(186, 255, 0));
    RenderSettings settings = bare();
    settings.sky = true;
    settings.skyRays = 16;
    start(scene, kSize, settings);
    const Drawn drawn = drawMany(yardCamera(), "noisyLight", 32, 16);
    const Scene reference(scene.snapshot());
    const Estimate estimate =
        render(reference, yardCamera().view(kSize, 0), {.term = Term::Sky, .samples = 1024, .bounces = 0});
    expectSameMeans(drawn, estimate, comparable(reference, yardCamera()));
}

/// Local lights with one ray a pixel.
class LocalLightEstimatorTest : public EstimatorTest {
protected:
    void expectUnbiased(const LitScene& scene) {
        RenderSettings settings = bare();
        settings.localLights = true;
        start(scene, kSize, settings);
        const Drawn drawn = drawMany(yardCamera(), "noisyLight", 256);
        const Scene reference(scene.snapshot());
        const Estimate estimate =
            render(reference, yardCamera().view(kSize, 0), {.term = Term::LocalLights, .samples = 1024});
        expectSameMeans(drawn, estimate, comparable(reference, yardCamera()));
    }
};

TEST_F(LocalLightEstimatorTest, LocalLightsAreUnbiased) {
    LitScene scene = yard(palette(186, 255, 0));
    scene.addLight({LightKind::Sphere, {-0.9, 0.55, 0.7}, {0, -1, 0}, {4, 3, 2}, 0.2f, 30.0f, 0.6f, 1.1f});
    scene.addLight({LightKind::Cone, {1.2, 2.2, 1.2}, {0, -1, 0}, {3, 4, 5}, 0.15f, 30.0f, 0.5f, 0.9f});
    // The brightest light, which is weighed first, sends nothing to what is visible.
    scene.addLight({LightKind::Cone, {0.2, 2.0, 1.0}, {0, 1, 0}, {90, 90, 90}, 0.15f, 30.0f, 0.5f, 0.9f});
    expectUnbiased(scene);
}

TEST_F(LocalLightEstimatorTest, WideLightsAreUnbiased) {
    for (const LightKind kind : {LightKind::Capsule, LightKind::Area, LightKind::Screen}) {
        LitScene scene = yard(palette(186, 255, 0));
        SnapshotLight light{
            kind, {-0.7, 1.05, 0.8}, glm::normalize(glm::vec3(0.3f, -1.0f, -0.2f)), {4, 3, 2}, 0.08f, 30.0f, 0.6f,
            1.1f};
        light.right = glm::normalize(glm::cross(light.direction, glm::vec3(0, 0, 1)));
        light.width = 1.4f, light.height = 0.5f;
        light.twoSided = kind == LightKind::Area;
        if (kind == LightKind::Screen) light.image = {3, {0xff8020, 0x2040ff, 0x00ff00, 0x101010, 0xffffff, 0x808080}};
        scene.addLight(light);
        scene.addLight({LightKind::Sphere, {1.6, 0.7, 1.0}, {0, -1, 0}, {1, 2, 3}, 0.1f, 30.0f, 0.6f, 1.1f});
        SCOPED_TRACE(int(kind));
        expectUnbiased(scene);
    }
}

/// The reference's highlights: multiple importance sampling must have the mean of samples of the light alone.
TEST(PathTracerHighlights, BothKindsOfSamplesHaveOneMean) {
    for (const LightKind kind :
         {LightKind::Sphere, LightKind::Cone, LightKind::Capsule, LightKind::Area, LightKind::Screen}) {
        LitScene scene(palette(60, 100, 80));
        Environment& air = scene.environment;
        air.sunColor = air.skyColor = air.horizonColor = air.groundColor = air.fogColor = glm::vec3(0.0f);
        scene.add({60, 1, 60}, {{-3, -0.1, -3}, kLevel}, solid);
        scene.add({4, 12, 4}, {{0.4, 0, -0.6}, kLevel}, solid);
        SnapshotLight light{
            kind, {0.1, 0.9, -1.0}, glm::normalize(glm::vec3(0.2f, -0.7f, 0.7f)), {4, 3, 2}, 0.3f, 30.0f, 0.6f, 1.1f};
        light.right = glm::normalize(glm::cross(light.direction, glm::vec3(0.3f, 1, 0)));
        light.width = 1.2f, light.height = 0.5f;
        if (kind == LightKind::Area) light.direction = -light.direction, light.twoSided = true;
        if (kind == LightKind::Screen) light.image = {3, {0xff8020, 0x2040ff, 0x00ff00, 0x101010, 0xffffff, 0x808080}};
        scene.addLight(light);
        const Scene reference(scene.snapshot());
        Camera camera;
        camera.position = {0.0, 1.0, 1.4};
        camera.lookAt({0.1, 0.0, -0.1});
        const View view = camera.view({24, 16}, 0);
        const Estimate both = render(reference, view, {.samples = 512, .bounces = 0});
        const Estimate plain = render(reference, view, {.samples = 2048, .bounces = 0, .lobeSamples = false});
        double sum = 0.0, sumPlain = 0.0, variance = 0.0, variancePlain = 0.0;
        for (size_t p = 0; p < both.mean.pixels.size(); ++p) {
            sum += both.mean.pixels[p].y, sumPlain += plain.mean.pixels[p].y;
            variance += both.variance.pixels[p].y / both.samples,
                variancePlain += plain.variance.pixels[p].y / plain.samples;
        }
        EXPECT_LT(std::abs(sum - sumPlain), 3.5 * std::sqrt(variance + variancePlain))
            << int(kind) << ": " << sum << ", " << sumPlain;
        EXPECT_NEAR(sum / sumPlain, 1.0, 0.03) << int(kind);
    }
}

/// An emissive panel over a floor that mirrors. Rough floors show its light by analytic highlights, smooth ones by
/// mirror rays that hit its emissive voxels, and those between by shares of both.
class LightInAMirrorTest : public EstimatorTest {
protected:
    /// Mean radiance of the floor over that of the reference. Without bounces only highlights are visible.
    double ratio(uint8_t roughness, bool bounces) {
        auto look = std::make_shared<Palette>(*palette(60, roughness, 80));
        (*look)[2] = (*look)[1];
        (*look)[2].red = (*look)[2].green = (*look)[2].blue = 255, (*look)[2].roughness = 255,
        (*look)[2].reflectivity = 0;
        (*look)[2].emission = 2.5f, (*look)[2].lightGroup = 1;
        LitScene scene(look);
        Environment& air = scene.environment;
        air.sunColor = air.skyColor = air.horizonColor = air.groundColor = air.fogColor = glm::vec3(0.0f);
        air.fogDistance = 1e6f;
        scene.add({60, 1, 60}, {{-3, -0.1, -3}, kLevel}, solid);
        scene.add({8, 8, 1}, {{-0.4, 0.3, -1.2}, kLevel}, [](glm::ivec3) { return uint8_t(2); });
        SnapshotLight light{LightKind::Area, {0, 0.7, -1.1}, {0, 0, 1}, glm::vec3(2.5f * 0.8f * 0.8f),
                            0.01f,           100.0f,         0.6f,      1.1f};
        light.right = {-1, 0, 0}, light.width = light.height = 0.8f;
        scene.addLight(light);
        RenderSettings settings = bare();
        settings.localLights = settings.reflections = true;
        settings.bounce = bounces;
        start(scene, kSize, settings);
        Camera camera;
        camera.position = {0.0, 1.2, 2.0};
        camera.lookAt({0, 0.35, -1});
        const Drawn drawn = drawMany(camera, "radiance", 192);
        const Scene reference(scene.snapshot());
        const Estimate estimate =
            render(reference, camera.view(kSize, 0), {.samples = 512, .bounces = bounces ? 1 : 0});
        const std::vector<bool> same = comparable(reference, camera);
        const FloatImage normal = read("normal");
        double sum = 0.0, sumReference = 0.0;
        for (size_t p = 0; p < same.size(); ++p)
            if (same[p] && normal.pixels[p].y > 0.9f && normal.pixels[p].w == 0.0f)
                sum += drawn.mean.pixels[p].y, sumReference += estimate.mean.pixels[p].y;
        return sum / sumReference;
    }
};

TEST_F(LightInAMirrorTest, ALightInAMirrorShinesOnce) {
    for (const int roughness : {12, 35, 45, 60, 85}) {
        if (roughness > 25) {  // smoother ones have no analytic highlights
            EXPECT_NEAR(ratio(uint8_t(roughness), false), 1.0, 0.02)
                << "highlights, roughness " << roughness << " of 255";
        }
        EXPECT_NEAR(ratio(uint8_t(roughness), true), 1.0, 0.02) << "roughness " << roughness << " of 255";
    }
}

TEST_F(EstimatorTest, ReflectionsAreUnbiased) {
    const LitScene scene = yard(palette(186, 90, 40));
    RenderSettings settings = bare();
    settings.reflections = true;
    start(scene, kSize, settings);
    const Drawn drawn = drawMany(yardCamera(), "reflection", 192);
    const Scene reference(scene.snapshot());
    const Estimate estimate = render(reference, yardCamera().view(kSize, 0),
                                     {.term = Term::Reflection, .samples = 1024, .bounces = 0, .maxDistance = 1000});
    std::vector<bool> same = comparable(reference, yardCamera());
    for (size_t i = 0; i < same.size(); ++i) same[i] = same[i] && drawn.mean.pixels[i].a > 0.5f;
    expectSameMeans(drawn, estimate, same);
}

/// The error of a mean of n unfiltered frames must fall as n^-0.5 with white noise, and no slower with blue noise.
TEST_F(EstimatorTest, ErrorFallsWithTheSamples) {
    const LitScene scene = yard(palette(186, 255, 0));
    const Scene reference(scene.snapshot());
    const Estimate estimate =
        render(reference, yardCamera().view(kSize, 0), {.term = Term::Sky, .samples = 2048, .bounces = 0});
    for (const Noise noise : {Noise::White, Noise::Blue}) {
        RenderSettings settings = bare(noise);
        settings.sky = true;
        settings.skyRays = 1;
        start(scene, kSize, settings);
        std::vector<double> sum(estimate.mean.pixels.size(), 0.0);
        std::vector<bool> same;
        double meanX = 0, meanY = 0, xx = 0, xy = 0;
        int points = 0;
        for (int i = 1; i <= 64; ++i) {
            renderer->draw(yardCamera().view(kSize, target->framebuffer()), 1.0f);
            const FloatImage image = read("noisyLight");
            for (size_t p = 0; p < sum.size(); ++p) sum[p] += image.pixels[p].y;
            if ((i & (i - 1)) != 0) continue;
            if (same.empty()) same = comparable(reference, yardCamera());
            double error = 0.0;
            for (size_t p = 0; p < sum.size(); ++p)
                if (same[p])
                    error += std::pow(sum[p] / i - estimate.mean.pixels[p].y, 2.0) -
                             estimate.variance.pixels[p].y / estimate.samples;
            const double x = std::log(double(i)), y = 0.5 * std::log(error);
            meanX += x, meanY += y, xx += x * x, xy += x * y;
            ++points;
        }
        const double slope = (xy - meanX * meanY / points) / (xx - meanX * meanX / points);
        RecordProperty(noise == Noise::White ? "slope_white" : "slope_blue", std::to_string(slope));
        if (noise == Noise::White) {
            EXPECT_NEAR(slope, -0.5, 0.05);
        } else {
            EXPECT_LE(slope, -0.45);
        }
    }
}

}  // namespace
}  // namespace rubble::reference
