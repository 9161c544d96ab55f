// Each estimator of light, with white noise and before any filter, against the reference and against closed forms.
#include <algorithm>
#include <cmath>

#include "tests/golden/drawing.h"
#include "tests/reference/path_tracer.h"
#include "tests/reference/sampling.h"

namespace rubble::reference {
namespace {

using glm::dvec3;

const glm::dquat kLevel(1, 0, 0, 0);
constexpr glm::ivec2 kSize(40, 28);

PaletteRef palette(uint8_t gray, uint8_t roughness, uint8_t reflectivity) {
    auto made = std::make_shared<Palette>();
    PaletteEntry& e = (*made)[1];
    e.red = e.green = e.blue = gray;
    e.roughness = roughness, e.reflectivity = reflectivity, e.material = 1;
    return made;
}

uint8_t solid(glm::ivec3) {
    return 1;
}

/// A floor, a wall with a window, a step and a canopy: everything on the grid, as levels are before they break.
LitScene yard(PaletteRef look) {
    LitScene scene(std::move(look));
    Environment& air = scene.environment;
    air.sunDirection = {-0.5f, 0.7f, 0.4f};
    air.sunAngle = 0.12f;
    air.fogDistance = 1e6f;
    scene.add({80, 2, 80}, {{-4, -0.2, -4}, kLevel}, solid);
    scene.add({40, 24, 2}, {{-2, 0, -1}, kLevel},
              [](glm::ivec3 c) { return uint8_t(c.x < 12 || c.x > 20 || c.y < 6 || c.y > 14); });
    scene.add({8, 8, 8}, {{0.4, 0, 0.2}, kLevel}, solid);
    scene.add({14, 1, 12}, {{-1.8, 1.2, -0.2}, kLevel}, solid);
    return scene;
}

Camera yardCamera() {
    Camera camera;
    camera.position = {0.7, 1.9, 3.4};
    camera.lookAt({-0.1, 0.5, -0.3});
    return camera;
}

/// Mean and variance of the mean, for each pixel, of what the renderer has drawn in some pictures.
struct Drawn {
    FloatImage mean, variance;
    FloatImage largest;  ///< of the pictures, in each channel
    double count = 0.0;
    int rays = 1;  ///< a picture
};

class EstimatorTest : public Drawing {
protected:
    static RenderSettings bare(Noise noise = Noise::White) {
        RenderSettings settings;
        settings.noise = noise;
        settings.temporal = settings.bounce = settings.bevel = settings.detail = settings.fog = settings.glare = false;
        settings.sun = settings.sky = settings.localLights = settings.reflections = false;
        settings.filterPasses = 0;
        settings.bloom = 0.0f;
        settings.skyDistance = 1000.0f;
        return settings;
    }
    Drawn drawMany(const Camera& camera, const char* name, int pictures, int rays = 1) {
        Drawn drawn{FloatImage(target->size()), FloatImage(target->size()), FloatImage(target->size()),
                    double(pictures), rays};
        std::vector<glm::dvec4> sum(drawn.mean.pixels.size()), squares(sum.size());
        for (int i = 0; i < pictures; ++i) {
            renderer->draw(camera.view(target->size(), target->framebuffer()), 1.0f);
            const FloatImage image = read(name);
            for (size_t p = 0; p < sum.size(); ++p)
                sum[p] += glm::dvec4(image.pixels[p]), squares[p] += glm::dvec4(image.pixels[p] * image.pixels[p]);
            for (size_t p = 0; p < sum.size(); ++p)
                drawn.largest.pixels[p] = glm::max(drawn.largest.pixels[p], image.pixels[p]);
        }
        for (size_t p = 0; p < sum.size(); ++p) {
            const glm::dvec4 mean = sum[p] / drawn.count;
            drawn.mean.pixels[p] = mean;
            drawn.variance.pixels[p] =
                glm::max(squares[p] / drawn.count - mean * mean, glm::dvec4(0)) / (drawn.count - 1.0);
        }
        return drawn;
    }
    /// 1 where renderer and reference see the same face at the centre of the pixel.
    std::vector<bool> comparable(const Scene& scene, const Camera& camera) {
        const FloatImage depth = read("depth"), normal = read("normal");
        std::vector<bool> same(depth.pixels.size());
        size_t differ = 0;
        for (int y = 0; y < depth.size.y; ++y)
            for (int x = 0; x < depth.size.x; ++x) {
                const glm::dvec2 p = (glm::dvec2(x, y) + 0.5) / glm::dvec2(depth.size) * 2.0 - 1.0;
                const double tanY = std::tan(camera.verticalFov * 0.5), tanX = tanY * depth.size.x / depth.size.y;
                const dvec3 ray = camera.rotation() * dvec3(p.x * tanX, p.y * tanY, -1.0);
                const Surface s = scene.closest({camera.position, glm::normalize(ray)});
                const bool equal = s.hit ? std::abs(s.t / glm::length(ray) - depth.at(x, y).x) < 1e-3 &&
                                               glm::dot(glm::vec3(s.normal), glm::vec3(normal.at(x, y))) > 0.99f
                                         : depth.at(x, y).x > 1e4f;
                same[size_t(y) * size_t(depth.size.x) + size_t(x)] = equal && s.hit;
                differ += !equal;
            }
        EXPECT_LT(differ, same.size() / 50);
        return same;
    }
};

/// Two-sided twoSidedTail of the normal distribution.
double twoSidedTail(double z) {
    return std::erfc(std::abs(z) / std::sqrt(2.0));
}

/// Every pixel is one test of "both have one mean"; Sidak: with n of them each may fail with 1 - (1 - 0.01)^(1/n) only.
/// channel of the drawn against x of the reference, or rgb each against its own.
void expectSameMeans(const Drawn& drawn, const Estimate& reference, const std::vector<bool>& comparable,
                     bool alpha = false) {
    struct Test {
        double z, drawn, reference;
        glm::ivec2 pixel;
    };
    std::vector<Test> tests;
    double sum = 0.0, sumReference = 0.0, mean = 0.0;
    for (const glm::vec4& p : reference.mean.pixels) mean += p[alpha ? 0 : 1] / double(reference.mean.pixels.size());
    for (size_t p = 0; p < comparable.size(); ++p) {
        if (!comparable[p]) continue;
        const int channel = alpha ? 3 : 1;  // green: colours share their paths
        const double a = drawn.mean.pixels[p][channel], b = reference.mean.pixels[p][alpha ? 0 : 1];
        // Where few paths find light, a handful of them says little of the variance: that of one more is added.
        const double own = reference.variance.pixels[p][alpha ? 0 : 1], samples = drawn.count * drawn.rays;
        // And rays leave a face a millimetre over it: half a percent of the picture's mean is granted for what that
        // hides in corners.
        const double floor = std::pow(0.005 * mean, 2.0) +
                             std::pow(std::max(double(drawn.largest.pixels[p][channel]), b) / samples, 2.0) +
                             std::pow(5e-4 * b, 2.0);
        const double variance =
            std::max(double(drawn.variance.pixels[p][channel]), own / samples) + own / reference.samples + floor;
        tests.push_back(
            {(a - b) / std::sqrt(variance + 1e-20), a, b, {int(p) % drawn.mean.size.x, int(p) / drawn.mean.size.x}});
        sum += a, sumReference += b;
    }
    ASSERT_GT(tests.size(), 300u);
    EXPECT_GT(sumReference, 0.0) << "nothing is compared";
    std::sort(tests.begin(), tests.end(), [](const Test& a, const Test& b) { return std::abs(a.z) > std::abs(b.z); });
    const double allowed = 1.0 - std::pow(1.0 - 0.01, 1.0 / double(tests.size()));
    int failed = 0;
    for (const Test& test : tests) failed += twoSidedTail(test.z) < allowed;
    const Test& worst = tests[0];
    EXPECT_EQ(failed, 0) << "of " << tests.size() << " pixels; worst: z " << worst.z << " at " << worst.pixel.x << ", "
                         << worst.pixel.y << ": " << worst.drawn << " drawn, " << worst.reference << " true; means "
                         << sum / double(tests.size()) << ", " << sumReference / double(tests.size());
    EXPECT_NEAR(sum / sumReference, 1.0, 0.01);
}

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

/// The lamps of a scene, one ray a pixel, against the reference.
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
    // The brightest, which is asked first, sends nothing to what is seen.
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

/// The reference's highlights, by samples of light and lobe together, against samples of the light alone.
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

/// A glowing panel on a floor that mirrors: its light comes by highlights on rough floors, by the glowing voxels that
/// mirror rays meet on smooth ones, by some of both between.
class LightInAMirrorTest : public EstimatorTest {
protected:
    /// Mean radiance of the floor, drawn over true. Without bounces highlights alone are seen.
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
        if (roughness > 25) {  // below, lamps have no highlights
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

/// Without filter, the error of a mean of n pictures must fall as n^-0.5 with white noise, and no slower in production.
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

/// Mean radiance of what is seen of a white thing that mirrors a little, under a sky that is the same everywhere: it
/// cannot be seen.
class FurnaceTest : public EstimatorTest {
protected:
    static LitScene furnace(uint8_t roughness, glm::dquat turned) {
        LitScene scene(palette(255, roughness, 60));
        Environment& air = scene.environment;
        air.sunColor = glm::vec3(0.0f);
        air.skyColor = air.horizonColor = air.groundColor = air.fogColor = glm::vec3(1.0f);
        air.fogDistance = 1e6f;
        air.clouds = 0.0f;
        scene.add({12, 12, 12}, {glm::dvec3(0, 1.6, 0) - turned * glm::dvec3(0.6), turned}, solid);
        return scene;
    }
    /// Of the faces that look at a camera on this side. What is smooth shows the hills on its sides: only its top and
    /// bottom are asked.
    double meanRadiance(glm::dvec3 from, bool smooth) {
        Camera camera;
        camera.position = glm::dvec3(0, 1.6, 0) + from;
        camera.lookAt({0, 1.6, 0});
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
        // Three faces each: all six.
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

/// A square plate over a floor, under an even sky: seen from the point below its middle it takes the form factor
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
    Camera camera;  // so near over the floor that the whole picture is one place
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

/// A sphere of even radiance gives I cos / d^2 whatever its size, as long as all of it is over the horizon.
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

/// Behind the edge of a roof at height d the sun's share goes from none to all within d x 2 tan(angle); between, it is
/// the disc cut by a line: 1 - (acos(c) - c sqrt(1 - c^2)) / pi. The rays from beyond the edge meet its upper rim, one
/// voxel higher.
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
