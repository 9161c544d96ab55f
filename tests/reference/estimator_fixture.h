#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "tests/golden/drawing.h"
#include "tests/reference/path_tracer.h"

namespace rubble::reference {

using glm::dvec3;

inline const glm::dquat kLevel(1, 0, 0, 0);  ///< no rotation
inline constexpr glm::ivec2 kSize(40, 28);   ///< of the images, pixels

/// A palette with one material, entry 1. Numbers of 255.
inline PaletteRef palette(uint8_t gray, uint8_t roughness, uint8_t reflectivity) {
    auto made = std::make_shared<Palette>();
    PaletteEntry& e = (*made)[1];
    e.red = e.green = e.blue = gray;
    e.roughness = roughness, e.reflectivity = reflectivity, e.material = 1;
    return made;
}

/// Every voxel is of entry 1.
inline uint8_t solid(glm::ivec3) {
    return 1;
}

/// A floor, a wall with a window, a step and a canopy, all aligned with the grid.
inline LitScene yard(PaletteRef look) {
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

/// Sees all of yard().
inline Camera yardCamera() {
    Camera camera;
    camera.position = {0.7, 1.9, 3.4};
    camera.lookAt({-0.1, 0.5, -0.3});
    return camera;
}

/// Statistics over some frames of a target, for each pixel.
struct Drawn {
    FloatImage mean, variance;  ///< variance: of the mean
    FloatImage largest;         ///< of each channel
    double count = 0.0;         ///< frames
    int rays = 1;               ///< a pixel and frame
};

/// Draws estimators of light alone, before any filter.
class EstimatorTest : public Drawing {
protected:
    /// Everything off but the noise.
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
    /// Reads the target `name` after each of the frames.
    Drawn drawMany(const Camera& camera, const char* name, int frames, int rays = 1) {
        Drawn drawn{FloatImage(target->size()), FloatImage(target->size()), FloatImage(target->size()), double(frames),
                    rays};
        std::vector<glm::dvec4> sum(drawn.mean.pixels.size()), squares(sum.size());
        for (int i = 0; i < frames; ++i) {
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
    /// True where renderer and reference see the same face at the centre of the pixel.
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

/// Probability that a standard normal number is farther from 0 than z.
inline double twoSidedTail(double z) {
    return std::erfc(std::abs(z) / std::sqrt(2.0));
}

/// Tests for each pixel that both have the same mean, by the z score of the difference. With n tests, each may reject
/// at the level 1 - (1 - 0.01)^(1/n) (Sidak), so that all together reject equal means in 1 % of the runs. Compares
/// green with green, or the drawn alpha with the reference's x if `alpha`.
inline void expectSameMeans(const Drawn& drawn, const Estimate& reference, const std::vector<bool>& comparable,
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
        const int channel = alpha ? 3 : 1;  // green alone: the colours share their paths
        const double a = drawn.mean.pixels[p][channel], b = reference.mean.pixels[p][alpha ? 0 : 1];
        // Where few paths find light, the estimated variance is poor: that of one more path is added.
        const double own = reference.variance.pixels[p][alpha ? 0 : 1], samples = drawn.count * drawn.rays;
        // Rays start a millimetre above a face, which matters in corners: half a percent of the image's mean is added.
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
    EXPECT_GT(sumReference, 0.0) << "the reference is black";
    std::sort(tests.begin(), tests.end(), [](const Test& a, const Test& b) { return std::abs(a.z) > std::abs(b.z); });
    const double allowed = 1.0 - std::pow(1.0 - 0.01, 1.0 / double(tests.size()));
    int failed = 0;
    for (const Test& test : tests) failed += twoSidedTail(test.z) < allowed;
    const Test& worst = tests[0];
    EXPECT_EQ(failed, 0) << "of " << tests.size() << " pixels; worst: z " << worst.z << " at " << worst.pixel.x << ", "
                         << worst.pixel.y << ": " << worst.drawn << " drawn, " << worst.reference
                         << " in the reference; means " << sum / double(tests.size()) << ", "
                         << sumReference / double(tests.size());
    EXPECT_NEAR(sum / sumReference, 1.0, 0.01);
}

}  // namespace rubble::reference
