#include "tests/reference/path_tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "tests/golden/lit_scene.h"
#include "tests/reference/exr_file.h"
#include "tests/support/temp_folder.h"

namespace rubble::reference {
namespace {

const glm::dquat kLevel(1, 0, 0, 0);

/// A closed emissive room of one grey, 0.5 linear.
LitScene furnace() {
    auto palette = std::make_shared<Palette>();
    PaletteEntry& e = (*palette)[1];
    e.red = e.green = e.blue = 188;
    e.roughness = 255, e.reflectivity = 0, e.material = 1, e.emission = 1.0f;
    LitScene scene(palette);
    scene.environment.fogDistance = 1e9f;
    scene.add({24, 24, 24}, {{0, 0, 0}, kLevel}, [](glm::ivec3 c) {
        return uint8_t(c.x == 0 || c.y == 0 || c.z == 0 || c.x == 23 || c.y == 23 || c.z == 23);
    });
    return scene;
}

View insideView(glm::ivec2 size) {
    Camera camera;
    camera.position = {1.1, 1.3, 1.2};
    camera.lookAt({2, 0.4, 2});
    return camera.view(size, 0);
}

double meanOf(const FloatImage& image) {
    double sum = 0.0;
    for (const glm::vec4& p : image.pixels) sum += p.y;
    return sum / double(image.pixels.size());
}

/// Where every face emits e and reflects the share a, L = e (1 - a^(b + 1)) / (1 - a) after b bounces.
TEST(PathTracer, AClosedFurnaceGlowsAsItsSeriesSays) {
    const Scene scene(furnace().snapshot());
    const double albedo = std::pow((188.0 / 255.0 + 0.055) / 1.055, 2.4);
    for (const int bounces : {1, 2, 4, 64}) {
        const double expected = albedo * (1.0 - std::pow(albedo, bounces + 1)) / (1.0 - albedo);
        // A path of b bounces meets b + 1 surfaces.
        const Estimate estimate = render(scene, insideView({16, 16}), {.samples = 256, .bounces = bounces});
        EXPECT_NEAR(meanOf(estimate.mean), expected, 0.01 * expected) << bounces;
    }
}

TEST(PathTracer, TheVarianceItReportsIsThatOfItsRuns) {
    const Scene scene(streetScene().snapshot());
    const View view = streetCamera(3).view({24, 16}, 0);
    constexpr int kRuns = 8, kSamples = 128;
    double between = 0.0, reported = 0.0;
    std::vector<double> sum(size_t(view.size.x * view.size.y)), squares(sum.size());
    for (int run = 0; run < kRuns; ++run) {
        const Estimate estimate =
            render(scene, view, {.term = Term::Sky, .samples = kSamples, .seed = uint64_t(run + 1)});
        for (size_t i = 0; i < sum.size(); ++i) {
            const double value = estimate.mean.pixels[i].y;
            sum[i] += value, squares[i] += value * value;
            reported += estimate.variance.pixels[i].y / kSamples / kRuns;
        }
    }
    for (size_t i = 0; i < sum.size(); ++i) between += (squares[i] - sum[i] * sum[i] / kRuns) / (kRuns - 1);
    EXPECT_NEAR(between / reported, 1.0, 0.25);
}

TEST(PathTracer, RaysMeetTurnedVoxelsWhereTheyAre) {
    LitScene given(streetPalette());
    const glm::dquat turn = glm::angleAxis(0.7, glm::normalize(glm::dvec3(0.3, 1.0, -0.2)));
    given.add({10, 10, 10}, {{5, 5, 5}, turn}, [](glm::ivec3) { return uint8_t(1); });
    const Scene scene(given.snapshot());
    const glm::dvec3 middle = glm::dvec3(5.0) + turn * glm::dvec3(0.5), axis = turn * glm::dvec3(1, 0, 0);
    const Surface s = scene.closest({middle + axis * 3.0, -axis});
    ASSERT_TRUE(s.hit);
    EXPECT_NEAR(s.t, 2.5, 1e-7);  // a voxel's size is a float
    EXPECT_NEAR(glm::dot(s.normal, axis), 1.0, 1e-9);
    EXPECT_EQ(scene.transmittance({middle + axis * 3.0, -axis}), glm::vec3(0.0f));
    EXPECT_EQ(scene.transmittance({middle + axis * 3.0, axis}), glm::vec3(1.0f));
    EXPECT_EQ(scene.transmittance({middle + axis * 3.0, -axis, 2.4}), glm::vec3(1.0f))
        << "the ray ends before the voxel";
}

TEST(ExrFile, KeepsEveryNumber) {
    Estimate estimate{FloatImage({5, 3}), FloatImage({5, 3}), 17};
    for (int i = 0; i < 15; ++i) {
        estimate.mean.pixels[size_t(i)] = glm::vec4(0.1f * float(i), -1.5f, 1e-20f, 1.0f);
        estimate.variance.pixels[size_t(i)] = glm::vec4(float(i * i), 3e30f, 0.25f, 0.0f);
    }
    const TempFolder folder;
    const std::string path = folder / "estimate.exr";
    ASSERT_TRUE(writeExr(path, estimate));
    const auto back = readExr(path);
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(back->mean.pixels, estimate.mean.pixels);
    EXPECT_EQ(back->variance.pixels, estimate.variance.pixels);
    EXPECT_EQ(back->samples, 17);
    EXPECT_FALSE(readExr("/nowhere/at/all.exr"));
}

TEST(ExrFile, ASceneThatDiffersHasAnotherKey) {
    LitScene one = furnace(), other = furnace();
    other.environment.sunColor.x += 0.001f;
    EXPECT_EQ(Scene(one.snapshot()).hash(), Scene(furnace().snapshot()).hash());
    EXPECT_NE(Scene(one.snapshot()).hash(), Scene(other.snapshot()).hash());
}

}  // namespace
}  // namespace rubble::reference
