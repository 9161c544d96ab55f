// Local lights and fog against closed forms, read as numbers before any filter.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "runtime/core/constants.h"
#include "tests/golden/drawing.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(48, 32);
constexpr glm::vec3 kDown(0, -1, 0);

PaletteRef gray(uint8_t roughness = 230) {
    auto palette = std::make_shared<Palette>();
    PaletteEntry& e = (*palette)[1];
    e.red = e.green = e.blue = 186;
    e.roughness = roughness;
    e.reflectivity = 100;
    e.material = 1;
    return palette;
}

/// A floor with its top at height 0, under a black sky.
LitScene floorScene(uint8_t roughness = 230) {
    LitScene scene(gray(roughness));
    scene.add({120, 2, 120}, {{-6, -0.2, -6}}, [](glm::ivec3) { return uint8_t(1); });
    Environment& air = scene.environment;
    air.sunColor = air.skyColor = air.horizonColor = air.groundColor = air.fogColor = glm::vec3(0.0f);
    air.fogDistance = 1e6f;
    return scene;
}

SnapshotLight lightAt(LightKind kind, glm::dvec3 place, float intensity) {
    SnapshotLight light{kind, place, kDown, glm::vec3(intensity), 0.02f, 1000.0f, 0.3f, 0.5f};
    light.right = {1, 0, 0};
    return light;
}

class LocalLightsTest : public Drawing {
protected:
    void start(const LitScene& scene) {
        RenderSettings settings;
        settings.temporal = false;
        settings.noise = Noise::White;
        settings.sky = settings.sun = false;
        Drawing::start(scene, kSize, settings);
    }
    /// Sees a few centimetres of the floor from straight above, so that every pixel has the light of one point.
    static Camera above(glm::dvec3 point) {
        Camera camera;
        camera.position = point + glm::dvec3(0, 5, 0.001);
        camera.lookAt(point);
        camera.verticalFov = 0.005f;
        return camera;
    }
    /// Irradiance / pi at a point of the floor, as rgb: the mean over all pixels of some frames.
    glm::dvec3 lightOn(glm::dvec3 point, int frames = 8) {
        glm::dvec3 sum(0.0);
        for (int i = 0; i < frames; ++i) {
            draw(above(point));
            const auto light = renderer->readTarget("noisyLight");
            for (const glm::vec4& pixel : light->pixels) sum += glm::dvec3(pixel);
        }
        return sum / double(frames * kSize.x * kSize.y);
    }
    double lightOf(const SnapshotLight& light, glm::dvec3 point = {0, 0, 0}, int frames = 8) {
        LitScene scene = floorScene();
        scene.addLight(light);
        start(scene);
        return lightOn(point, frames).g;
    }
    bool hasPass(const char* name) const {
        const auto& passes = renderer->stats().passes;
        return std::find(passes.begin(), passes.end(), std::string_view(name)) != passes.end();
    }
};

TEST_F(LocalLightsTest, FallOffWithTheSquareOfTheDistance) {
    for (const double height : {0.5, 1.0, 2.0, 4.0}) {
        const double expected = 3.0 / (height * height) / kPi;
        EXPECT_NEAR(lightOf(lightAt(LightKind::Sphere, {0, height, 0}, 3.0f)), expected, 0.01 * expected) << height;
    }
    // To the side the cosine counts too.
    const double expected = 3.0 * 2.0 / std::pow(2.0 * 2.0 + 1.5 * 1.5, 1.5) / kPi;
    EXPECT_NEAR(lightOf(lightAt(LightKind::Sphere, {0, 2, 0}, 3.0f), {1.5, 0, 0}), expected, 0.01 * expected);
}

TEST_F(LocalLightsTest, ALargeBallShinesLikeASmallOneOfTheSameIntensity) {
    SnapshotLight light = lightAt(LightKind::Sphere, {0, 2, 0}, 3.0f);
    light.radius = 1.0f;
    EXPECT_NEAR(lightOf(light), 3.0 / 4.0 / kPi,
                0.01 * 3.0 / 4.0 / kPi);  // exact for a Lambertian sphere above the horizon
}

TEST_F(LocalLightsTest, AreaHasTheFormFactorOfAParallelRectangle) {
    for (const double height : {0.7, 1.5, 3.0}) {
        SnapshotLight light = lightAt(LightKind::Area, {0, height, 0}, 6.0f);
        light.width = 2.0f;
        light.height = 1.2f;
        const double x = 1.0 / height, y = 0.6 / height, rx = std::sqrt(1 + x * x), ry = std::sqrt(1 + y * y);
        const double factor = 4.0 / (2.0 * kPi) * (x / rx * std::atan(y / rx) + y / ry * std::atan(x / ry));
        const double expected = 6.0 / (2.0 * 1.2) * factor;
        EXPECT_NEAR(lightOf(light, {0, 0, 0}, 24), expected, 0.01 * expected) << height;
        light.direction = -kDown;
        EXPECT_EQ(lightOf(light), 0.0) << "its back emits";
        light.twoSided = true;
        EXPECT_NEAR(lightOf(light, {0, 0, 0}, 24), expected, 0.01 * expected);
    }
}

/// Under a ceiling that shines and goes far beyond what is seen, all samples of a point are about alike.
TEST_F(LocalLightsTest, AHugeAreaNearAFloorIsSmooth) {
    for (const float side : {10.0f, 100.0f, 1000.0f}) {
        SnapshotLight light = lightAt(LightKind::Area, {0, 3, 0}, side * side);
        light.width = light.height = side;
        light.reach = 1e6f;
        const double x = 0.5 * side / 3.0, r = std::sqrt(1 + x * x), expected = 4.0 / kPi * x / r * std::atan(x / r);
        EXPECT_NEAR(lightOf(light), expected, 0.02 * expected) << side;
        float most = 0.0f;
        for (const glm::vec4& pixel : read("noisyLight").pixels) most = std::max(most, pixel.g);
        EXPECT_LT(most, 4.0 * expected) << side << ": a speck";
    }
}

TEST_F(LocalLightsTest, CapsuleIsALineOfBalls) {
    SnapshotLight light = lightAt(LightKind::Capsule, {0, 1, 0}, 4.0f);
    light.width = 3.0f;
    const double expected = 4.0 / (1.0 * std::sqrt(1.0 + 1.5 * 1.5)) / kPi;
    EXPECT_NEAR(lightOf(light, {0, 0, 0}, 24), expected, 0.01 * expected);
}

TEST_F(LocalLightsTest, ConeIsFullInsideAndDarkOutside) {
    const double height = 3.0;
    const SnapshotLight light = lightAt(LightKind::Cone, {0, height, 0}, 3.0f);
    const auto at = [&](double angle) {
        return lightOf(light, {height * std::tan(angle), 0, 0}) /
               (3.0 * std::pow(std::cos(angle), 3.0) / (height * height) / kPi);
    };
    EXPECT_NEAR(at(0.0), 1.0, 0.01);
    EXPECT_NEAR(at(0.27), 1.0, 0.01);
    const double edge = (std::cos(0.4) - std::cos(0.5)) / (std::cos(0.3) - std::cos(0.5));
    EXPECT_NEAR(at(0.4), edge * edge, 0.03);
    EXPECT_EQ(at(0.53), 0.0);
}

TEST_F(LocalLightsTest, NothingArrivesBeyondTheReach) {
    SnapshotLight light = lightAt(LightKind::Sphere, {0, 2, 0}, 3.0f);
    light.reach = 4.0f;
    const double window = std::pow(1.0 - std::pow(0.5, 4.0), 2.0);
    EXPECT_NEAR(lightOf(light) / (3.0 / 4.0 / kPi), window, 0.02);
    EXPECT_EQ(lightOf(light, {3.6, 0, 0}), 0.0);
}

TEST_F(LocalLightsTest, ScreenEmitsItsImagesColors) {
    SnapshotLight light = lightAt(LightKind::Screen, {0, 1, 0}, 6.0f);
    light.width = 4.0f;
    light.height = 1.0f;
    light.image = {2, {0xff0000, 0x0000ff}};
    LitScene scene = floorScene();
    scene.addLight(light);
    start(scene);
    // It faces down with its x along the world's: a viewer below with the head toward +z has +x on the left.
    const glm::dvec3 left = lightOn({1.5, 0, 0}, 16), right = lightOn({-1.5, 0, 0}, 16);
    EXPECT_GT(left.r, 3.0 * left.b);
    EXPECT_GT(right.b, 3.0 * right.r);
    EXPECT_NEAR(left.r, right.b, 0.03 * left.r);
    EXPECT_EQ(left.g, 0.0);
}

TEST_F(LocalLightsTest, HalfHiddenByAnEdgeGivesHalf) {
    LitScene scene = floorScene();
    scene.add({40, 2, 60}, {{-4, 1, -3}},
              [](glm::ivec3) { return uint8_t(1); });  // a shelf from x = -4 to 0, 1 to 1.2 m high
    SnapshotLight panel = lightAt(LightKind::Area, {0, 2.6, 0}, 3.0f);
    panel.width = panel.height = 1.0f;
    scene.addLight(panel);
    start(scene);
    Camera camera = above({0, 0, 0});
    camera.position = {0.5, 0.5, 0};
    camera.lookAt({0, 0, 0.001});
    double sum = 0;
    const int frames = 16;
    for (int i = 0; i < frames; ++i) {
        draw(camera);
        const auto light = renderer->readTarget("noisyLight");
        for (const glm::vec4& pixel : light->pixels) sum += double(pixel.g);
    }
    const double shade = sum / double(frames * kSize.x * kSize.y), open = lightOf(panel, {0, 0, 0}, 16);
    EXPECT_NEAR(shade / open, 0.5, 0.06);
}

TEST_F(LocalLightsTest, HundredsAreUnbiased) {
    const auto withLights = [&](int count) {
        LitScene scene = floorScene();
        double expected = 0.0;
        for (int i = 0; i < count; ++i) {
            const glm::dvec3 place(std::cos(2.4 * i) * 0.004 * i, 1.0 + 0.01 * (i % 50), std::sin(2.4 * i) * 0.004 * i);
            const double intensity = 0.05 * (1 + i % 7), range2 = glm::dot(place, place);
            scene.addLight(lightAt(LightKind::Sphere, place, float(intensity)));
            expected += intensity * place.y / std::pow(range2, 1.5) / kPi;
        }
        start(scene);
        return expected;
    };
    const double expected = withLights(300);
    EXPECT_NEAR(lightOn({0, 0, 0}, 32).g, expected, 0.02 * expected);
    const int draws = renderer->stats().drawCalls;
    withLights(8);
    lightOn({0, 0, 0}, 1);
    EXPECT_EQ(renderer->stats().drawCalls, draws) << "more lights take no more draws";
}

TEST_F(LocalLightsTest, SmoothFloorsShineBack) {
    const auto brightest = [&](uint8_t roughness) {
        LitScene scene = floorScene(roughness);
        scene.addLight(lightAt(LightKind::Sphere, {0, 2, -2}, 20.0f));
        start(scene);
        Camera camera;
        camera.position = {0, 2, 2};
        camera.lookAt({0, 0, 0});
        draw(camera);
        float best = 0.0f;
        const auto specular = renderer->readTarget("specular");
        for (const glm::vec4& pixel : specular->pixels) best = std::max(best, pixel.g);
        return best;
    };
    const float rough = brightest(240), smooth = brightest(90);
    EXPECT_GT(rough, 0.01f);
    EXPECT_GT(smooth, 5.0f * rough);
}

/// A floor with a history, whose lights are replaced between two frames.
class LightChangeTest : public LocalLightsTest {
protected:
    void SetUp() override {
        LocalLightsTest::SetUp();
        m_camera.position = {0, 2, 2};
        m_camera.lookAt({0, 0, 0});
    }
    static SnapshotLight named(uint32_t slot, glm::dvec3 place, float intensity) {
        SnapshotLight light = lightAt(LightKind::Sphere, place, intensity);
        light.light = LightHandle::make(1, 1, slot);
        return light;
    }
    LitScene sceneOf(std::initializer_list<SnapshotLight> lights) const {
        LitScene scene = floorScene(90);
        scene.environment.fogDensity = m_fog;
        for (const SnapshotLight& light : lights) scene.addLight(light);
        return scene;
    }
    /// Brightest pixel of a target after some frames.
    float brightest(const char* name, int frames) {
        draw(m_camera, frames);
        float best = 0.0f;
        for (const glm::vec4& pixel : read(name).pixels) best = std::max(best, pixel.g);
        return best;
    }
    /// How much of a target's brightest pixel is left some frames after the change.
    float leftOf(const char* name, LitScene before, LitScene after, int frames) {
        Drawing::start(before, kSize);
        const float lit = brightest(name, 24);
        EXPECT_GT(lit, 0.01f);
        renderer->apply(after.step());
        return brightest(name, frames) / lit;
    }
    Camera m_camera;
    float m_fog = 0.0f;
};

TEST_F(LightChangeTest, ALightThatGoesOutTakesItsHighlightAlong) {
    const SnapshotLight bright = named(0, {0, 2, -2}, 20.0f), faint = named(1, {3, 2, -3}, 0.05f),
                        other = named(2, {3, 2, -3}, 0.05f);
    EXPECT_LT(leftOf("specular", sceneOf({bright, faint}), sceneOf({faint}), 1), 0.1f);
    EXPECT_LT(leftOf("specular", sceneOf({bright, faint}), sceneOf({other, faint}), 1), 0.1f)
        << "another light was added at once";
}

/// When a light far away goes out, the averaged highlight of another one must not become noisier.
TEST_F(LightChangeTest, ALightThatGoesOutKeepsTheHighlightsOfOthers) {
    const auto reaching = [](SnapshotLight light) {
        light.reach = 2.0f;
        return light;
    };
    const SnapshotLight here = reaching(named(0, {0, 1.2, -0.5}, 20.0f)),
                        away = reaching(named(1, {30, 1, -30}, 20.0f));
    const auto changeBy = [&](int frames) {
        const FloatImage before = read("specular");
        draw(m_camera, frames);
        const FloatImage after = read("specular");
        double sum = 0.0, all = 0.0;
        for (size_t p = 0; p < before.pixels.size(); ++p)
            sum += std::abs(double(after.pixels[p].g - before.pixels[p].g)), all += double(before.pixels[p].g);
        return sum / all;
    };
    Drawing::start(sceneOf({here, away}), kSize);
    draw(m_camera, 24);
    const double usual = changeBy(1);
    renderer->apply(sceneOf({here}).step());
    EXPECT_LT(changeBy(1), 1.5 * usual);
}

TEST_F(LightChangeTest, TheFloorUnderARemovedLightIsDark) {
    const SnapshotLight bright = named(0, {0, 1, 0}, 20.0f), faint = named(1, {3, 2, -3}, 0.05f);
    EXPECT_LT(leftOf("denoisedLight", sceneOf({bright}), sceneOf({}), 1), 0.02f);
    EXPECT_LT(leftOf("denoisedLight", sceneOf({bright, faint}), sceneOf({faint}), 1), 0.05f);
}

/// The final image includes glare, bloom and the history of the temporal pass.
TEST_F(LightChangeTest, AnImageWithoutItsLightIsBlackAndWithANewOneLit) {
    const SnapshotLight bright = named(0, {0, 1, -1}, 20.0f), next = named(1, {0, 1, -1}, 20.0f);
    for (const float fog : {0.0f, 0.2f}) {
        m_fog = fog;
        const auto meanAfter = [&](int frames) {
            const Image image = draw(m_camera, frames);
            return std::accumulate(image.rgb.begin(), image.rgb.end(), 0.0) / double(image.rgb.size());
        };
        Drawing::start(sceneOf({bright}), kSize);
        const double lit = meanAfter(24);
        EXPECT_GT(lit, 50.0);
        renderer->apply(sceneOf({}).step());
        EXPECT_LT(meanAfter(1), 0.01 * lit);
        renderer->apply(sceneOf({next}).step());
        const double litAgain = meanAfter(1);
        Drawing::start(sceneOf({next}), kSize);
        const double fresh = meanAfter(1);
        EXPECT_NEAR(litAgain, fresh, 0.05 * fresh);
    }
}

TEST_F(LightChangeTest, FogForgetsARemovedLight) {
    m_fog = 0.2f;
    EXPECT_LT(leftOf("fogLight", sceneOf({named(0, {0, 1, 0}, 20.0f)}), sceneOf({}), 1), 0.02f);
}

TEST_F(LocalLightsTest, UnusedLightsAndFogCostNothing) {
    LitScene scene = floorScene();
    start(scene);
    draw(above({0, 0, 0}));
    const uint64_t bytes = renderer->stats().textureBytes;
    EXPECT_FALSE(hasPass("local lights"));
    EXPECT_FALSE(hasPass("fog"));
    for (const char* name : {"specular", "fogLight", "fog"}) EXPECT_FALSE(renderer->readTarget(name)) << name;
    scene.environment.fogDensity = 0.05f;
    scene.addLight(lightAt(LightKind::Sphere, {0, 2, 0}, 3.0f));
    renderer->apply(scene.step());
    draw(above({0, 0, 0}));
    EXPECT_TRUE(hasPass("local lights"));
    EXPECT_TRUE(hasPass("fog"));
    EXPECT_GT(renderer->stats().textureBytes, bytes);
}

TEST_F(LocalLightsTest, FogMatchesItsClosedForms) {
    LitScene scene(gray());
    scene.add({2, 2, 2}, {{-0.1, 40, -0.1}}, [](glm::ivec3) { return uint8_t(1); });
    Environment& air = scene.environment;
    air.sunColor = glm::vec3(0.0f);
    air.skyColor = air.horizonColor = air.groundColor = glm::vec3(0.5f);
    air.fogDensity = 0.03f;
    air.fogHeight = 1e6f;
    start(scene);
    Camera camera;
    camera.position = {0, 40.1, 20};
    camera.lookAt({0, 40.1, 0});
    glm::dvec3 sum(0.0);
    for (int i = 0; i < 16; ++i) {
        draw(camera);
        const auto fog = renderer->readTarget("fogLight");
        for (const glm::vec4& pixel : fog->pixels) sum += glm::dvec3(pixel) / double(16 * fog->pixels.size());
    }
    EXPECT_NEAR(sum.g, 0.5, 0.005) << "in uniform light fog is invisible";

    // In-scattering from a light along a ray that passes it at about a metre, by a sum of small steps.
    air.skyColor = air.horizonColor = air.groundColor = glm::vec3(0.0f);
    scene.environment.fogForward = 0.0f;
    scene.addLight(lightAt(LightKind::Sphere, {1, 40.1, 10}, 8.0f));
    start(scene);
    camera.verticalFov = 0.004f;
    camera.lookAt({0, 41.0, 0});  // beside the cube
    const glm::dvec3 ahead = glm::normalize(glm::dvec3(0, 41.0, 0) - camera.position);
    double expected = 0.0;
    const double step = 0.01;
    for (double t = 0.5 * step; t < 400.0; t += step) {
        const glm::dvec3 away = camera.position + ahead * t - glm::dvec3(1, 40.1, 10);
        const double range2 = glm::dot(away, away);
        expected += step * 0.03 * std::exp(-0.03 * (t + std::sqrt(range2))) * 8.0 / range2 / (4.0 * kPi);
    }
    expected /= 1.0 - std::exp(-0.03 * 400.0);
    double mean = 0.0;
    for (int i = 0; i < 32; ++i) {
        draw(camera);
        const auto fog = renderer->readTarget("fogLight");
        for (const glm::vec4& pixel : fog->pixels) mean += double(pixel.g) / double(32 * fog->pixels.size());
    }
    EXPECT_NEAR(mean, expected, 0.03 * expected);
}

}  // namespace
}  // namespace rubble
