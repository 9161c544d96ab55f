// How much noise still frames keep: fog by night, and voxels that glow without a light.
#include "runtime/core/random.h"
#include "tests/golden/drawing.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(160, 90);
constexpr uint8_t kStone = 1, kGlow = 2;

PaletteRef stoneAndGlow() {
    auto palette = std::make_shared<Palette>();
    const auto entry = [&](int index, uint8_t gray) -> PaletteEntry& {
        PaletteEntry& e = (*palette)[size_t(index)];
        e.red = e.green = e.blue = gray;
        e.roughness = 230;
        return e;
    };
    entry(kStone, 186);
    entry(kGlow, 255).emission = 20.0f;
    return palette;
}

/// A floor with some posts, at night.
LitScene nightScene() {
    LitScene scene(stoneAndGlow());
    scene.add({240, 2, 240}, {{-12, -0.2, -12}, {1, 0, 0, 0}}, [](glm::ivec3) { return kStone; });
    for (const double x : {-3.0, 0.4, 2.6})
        scene.add({3, 30, 3}, {{x, 0, -3.0 - x}, {1, 0, 0, 0}}, [](glm::ivec3) { return kStone; });
    Environment& air = scene.environment;
    air.sunDirection = {0.3f, -0.4f, 0.2f};
    air.sunColor = glm::vec3(0.0f);
    air.skyColor = air.horizonColor = air.groundColor = glm::vec3(0.01f, 0.012f, 0.02f);
    air.fogColor = glm::vec3(0.0f);
    return scene;
}

class StillNoiseTest : public Drawing {
protected:
    /// The mean of a target over frames that know nothing of each other.
    FloatImage meanOf(const LitScene& scene, const char* name, Noise noise, int frames, glm::ivec2 size = kSize) {
        RenderSettings independent;
        independent.temporal = false;
        independent.noise = noise;
        start(scene, size, independent);
        FloatImage mean;
        for (int i = 0; i < frames; ++i) {
            draw(camera());
            const FloatImage one = read(name);
            if (i == 0) mean = FloatImage(one.size);
            for (size_t p = 0; p < one.pixels.size(); ++p) mean.pixels[p] += one.pixels[p] / float(frames);
        }
        return mean;
    }
    /// Root of the mean squared difference of green, relative to that of `expected`.
    static double relativeDifference(const FloatImage& found, const FloatImage& expected) {
        double error = 0.0, light = 0.0;
        for (size_t p = 0; p < found.pixels.size(); ++p) {
            const double off = double(found.pixels[p].g - expected.pixels[p].g), there = double(expected.pixels[p].g);
            error += off * off;
            light += there * there;
        }
        return std::sqrt(error / light);
    }
    /// How much the light of the floor differs from its mean over 5 x 5 pixels.
    struct Speckles {
        double deviation = 0.0, worst = 0.0;  ///< relative: root of the mean square; the brightest pixel
    };
    Speckles specklesOf(const FloatImage& light) const {
        const FloatImage normal = read("normal"), depth = read("depth");
        Speckles out;
        double off = 0.0, sum = 0.0;
        for (int y = 2; y < kSize.y - 2; ++y)
            for (int x = 2; x < kSize.x - 2; ++x) {
                double around = 0.0;
                int floor = 0;
                for (int i = 0; i < 25; ++i) {
                    const glm::ivec2 p(x + i % 5 - 2, y + i / 5 - 2);
                    floor += normal.at(p.x, p.y).y > 0.9f && depth.at(p.x, p.y).r < 12.0f;
                    around += double(light.at(p.x, p.y).g) / 25.0;
                }
                if (floor < 25) continue;
                const double there = double(light.at(x, y).g);
                out.worst = std::max(out.worst, there / around);
                off += (there - around) * (there - around);
                sum += around * around;
            }
        out.deviation = std::sqrt(off / sum);
        return out;
    }
    static Camera camera() {
        Camera camera;
        camera.position = {0, 1.7, 6.0};
        camera.lookAt({0, 1.0, 0});
        return camera;
    }
};

TEST_F(StillNoiseTest, FogByNightIsSmoothAfterFortyFrames) {
    LitScene scene = nightScene();
    scene.environment.fogDensity = 0.06f;
    for (uint32_t i = 0; i < 4; ++i)
        scene.addLight({.kind = LightKind::Sphere,
                        .position = {-5.0 + 3.3 * i, 2.4, -1.0 - 1.7 * i},
                        .direction = {0, -1, 0},
                        .color = glm::vec3(6.0f, 4.4f, 2.6f),
                        .radius = 0.08f,
                        .reach = 14.0f,
                        .coneInner = 0.0f,
                        .coneOuter = 0.0f,
                        .light = LightHandle::make(1, 1, i)});
    start(scene, kSize);
    draw(camera(), 40);
    const FloatImage fog = read("fog");
    const double noise = relativeDifference(fog, meanOf(scene, "fog", Noise::White, 300));
    std::printf("noise %.4f\n", noise);
    EXPECT_LT(noise, 0.09);
}

TEST_F(StillNoiseTest, ManyFramesBringEachPixelToTheTrueLight) {
    constexpr glm::ivec2 kSmall(64, 36);
    LitScene scene = nightScene();
    for (uint32_t i = 0; i < 4; ++i)
        scene.addLight({.kind = LightKind::Sphere,
                        .position = {-3.0 + 2.0 * i, 1.6, -1.0 + 0.7 * i},
                        .direction = {0, -1, 0},
                        .color = glm::vec3(6.0f, 4.4f, 2.6f),
                        .radius = 0.3f,
                        .reach = 14.0f,
                        .coneInner = 0.0f,
                        .coneOuter = 0.0f,
                        .light = LightHandle::make(1, 1, i)});
    const FloatImage blue = meanOf(scene, "noisyLight", Noise::Blue, 400, kSmall),
                     white = meanOf(scene, "noisyLight", Noise::White, 1600, kSmall);
    const double difference = relativeDifference(blue, white);
    std::printf("difference %.4f\n", difference);
    EXPECT_LT(difference, 0.01);
}

TEST_F(StillNoiseTest, AVoxelThatGlowsWithoutALightLeavesNoSpeckles) {
    LitScene scene = nightScene();
    scene.add({2, 2, 2}, {{-1.0, 0.9, 1.0}, {1, 0, 0, 0}}, [](glm::ivec3) { return kGlow; });
    start(scene, kSize);
    draw(camera(), 24);
    const Speckles found = specklesOf(read("denoisedLight"));
    std::printf("deviation %.4f, worst %.4f\n", found.deviation, found.worst);
    EXPECT_LT(found.deviation, 0.06);
    EXPECT_LT(found.worst, 1.6);
}

TEST_F(StillNoiseTest, ManyVoxelsThatGlowWithoutALightLeaveTheGroundSmooth) {
    LitScene scene = nightScene();
    const auto glows = [](glm::ivec3 cell) { return hashCell(cell.x / 2, cell.z / 2, 3) % 97 == 0; };  // 0.2 m wide
    scene.add({240, 2, 240}, {{-12, 0, -12}, {1, 0, 0, 0}},
              [&](glm::ivec3 cell) { return glows(cell) ? kGlow : uint8_t(0); });
    start(scene, kSize);
    draw(camera(), 8);
    const FloatImage filtered = read("denoisedLight"), before = read("accumulatedLight");
    const Speckles found = specklesOf(filtered);
    std::printf("deviation %.4f, worst %.4f\n", found.deviation, found.worst);
    EXPECT_LT(found.deviation, 0.6);
    EXPECT_LT(found.worst, 7.0);
    double light = 0.0, was = 0.0;
    for (size_t p = 0; p < filtered.pixels.size(); ++p)
        light += double(filtered.pixels[p].g), was += double(before.pixels[p].g);
    std::printf("light %.4f\n", light / was);
    EXPECT_NEAR(light / was, 1.0, 0.03) << "the filter moves light and takes none";
}

}  // namespace
}  // namespace rubble
