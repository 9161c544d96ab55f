// What is far away is drawn as what is near: to 65 km, by every projection.
// RUBBLE_IMAGES=FOLDER writes the images of all distances beside each other.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/golden/compare.h"
#include "tests/golden/drawing.h"
#include "tests/support/grids.h"
#include "tests/support/level_snapshot.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(96, 96);
constexpr double kDistances[] = {1990.0, 2010.0, 2500.0, 10000.0, 50000.0};
constexpr double kWidth = 40.0, kHeight = 120.0, kEyeHeight = 60.0;  // metres: of the tower, of the camera
constexpr double kNear = 0.1;
constexpr uint8_t kGray = 1, kGlass = 2;

struct Projected {
    const char* name;
    /// tangent: of half the field of view, whose width at the tower is the same.
    std::optional<glm::dmat4> (*clipFromEye)(double tangent, double distance);
};
constexpr Projected kProjections[] = {
    {"field of view", [](double, double) { return std::optional<glm::dmat4>(); }},
    {"infinite", [](double tangent,
                    double) { return std::optional(glm::infinitePerspective(2.0 * std::atan(tangent), 1.0, kNear)); }},
    {"far plane at 1,000 km",
     [](double tangent, double) { return std::optional(glm::perspective(2.0 * std::atan(tangent), 1.0, kNear, 1e6)); }},
    {"orthographic", [](double tangent, double distance) {
         const double half = tangent * distance;
         return std::optional(glm::ortho(-half, half, -half, half, 0.0, 1e6));
     }}};

LevelBody standing(glm::dvec3 low, glm::ivec3 voxels, uint8_t entry, const PaletteRef& palette) {
    LevelBody body;
    body.pose.position = low;
    LevelShape shape;
    shape.voxelSize = 4.0f;
    shape.grid = solidGrid(voxels, entry);
    shape.palette = palette;
    body.shapes.push_back(std::move(shape));
    return body;
}

/// A tower whose upper half is in the shadow of its roof, and a pane beside it.
Level towerAt(double distance) {
    auto palette = std::make_shared<Palette>();
    for (const uint8_t entry : {kGray, kGlass}) {
        PaletteEntry& e = (*palette)[entry];
        e.red = e.green = e.blue = 120, e.roughness = 255;
    }
    (*palette)[kGlass].opacity = 100;
    Level level;
    level.environment.fogDistance = 1e7f;
    level.environment.sunDirection = {0.0f, 1.0f, 0.5f};
    level.bodies.push_back(standing({-0.5 * kWidth, 0.0, -distance}, {10, 30, 1}, kGray, palette));
    level.bodies.push_back(standing({-0.5 * kWidth, kHeight, -distance}, {10, 1, 8}, kGray, palette));
    level.bodies.push_back(standing({0.75 * kWidth, 0.0, -distance}, {4, 30, 1}, kGlass, palette));
    return level;
}

class FarSightTest : public Drawing {
protected:
    static double tangentAt(double distance) { return std::max(0.6 * kHeight / distance, 0.005); }
    void start(const Level& level, const RenderSettings& settings = {}) {
        auto made = Renderer::create(testContext().loader(), shaderFolder(), settings);
        ASSERT_TRUE(made) << made.error();
        renderer = std::move(made).value();
        renderer->apply(levelSnapshot(level));
        target = std::make_unique<Offscreen>(kSize);
    }
    Image drawn(double distance, const Projected& projection, int frames = 8) {
        const double tangent = tangentAt(distance);
        View view;
        view.position = {0.0, kEyeHeight, 0.0};
        view.verticalFov = float(2.0 * std::atan(tangent));
        view.size = kSize;
        view.framebuffer = target->framebuffer();
        if (const auto matrix = projection.clipFromEye(tangent, distance)) view.projection = View::Projection{*matrix};
        for (int i = 0; i < frames; ++i) {
            view.cut = i == 0;
            renderer->draw(view, 1.0f);
        }
        Image image(kSize.x, kSize.y);
        image.rgb = target->readRgb();
        return image;
    }
    /// The pixel of a place in the plane of the tower's front.
    static glm::ivec2 pixelOf(double x, double y, double distance) {
        const double half = tangentAt(distance) * distance;
        return glm::ivec2(glm::floor((glm::dvec2(x, y - kEyeHeight) / half * 0.5 + 0.5) * glm::dvec2(kSize)));
    }
    /// The front of the tower is there to its edges, lit below and in shadow above, and before the sky.
    void expectTower(double distance) {
        const FloatImage depth = read("depth"), radiance = read("radiance");
        const auto at = [&](const FloatImage& image, double x, double y) {
            const glm::ivec2 p = pixelOf(x, y, distance);
            return image.at(p.x, p.y);
        };
        const glm::ivec2 low = pixelOf(-0.5 * kWidth, 0.0, distance), high = pixelOf(0.5 * kWidth, kHeight, distance);
        for (int y = low.y + 2; y <= high.y - 2; ++y)
            for (int x = low.x + 2; x <= high.x - 2; ++x)
                ASSERT_NEAR(depth.at(x, y).x, distance, 45.0) << x << ", " << y;
        const glm::ivec2 beside(low.x - 2, (low.y + high.y) / 2);
        EXPECT_GT(depth.at(beside.x, beside.y).x, 64000.0f) << "the tower is too wide";
        const float lit = at(radiance, 0.0, 0.2 * kHeight).g, shadow = at(radiance, 0.0, 0.85 * kHeight).g;
        EXPECT_GT(lit, 1.5f * shadow);
        EXPECT_GT(shadow, 0.01f);
        EXPECT_GT(std::abs(at(radiance, 0.0, 0.3 * kHeight).b - at(radiance, -0.7 * kWidth, 0.3 * kHeight).b), 0.02f)
            << "what is behind shows through";
    }
};

TEST_F(FarSightTest, ATowerIsSeenWithItsShadowToFiftyKilometres) {
    std::vector<Image> images;
    for (const Projected& projection : kProjections)
        for (const double distance : kDistances) {
            SCOPED_TRACE(std::string(projection.name) + ", " + std::to_string(distance) + " m");
            start(towerAt(distance));
            images.push_back(drawn(distance, projection));
            expectTower(distance);
        }
    if (const char* folder = std::getenv("RUBBLE_IMAGES"))
        EXPECT_TRUE(writePng(std::string(folder) + "/far_sight.png", tile(images, int(std::size(kDistances)))));
}

/// Haze hides far things by the environment's distance alone.
TEST_F(FarSightTest, ATowerFadesIntoTheHaze) {
    std::vector<Image> images;
    for (const double distance : kDistances) {
        Level level = towerAt(distance);
        level.environment.fogDistance = float(distance);
        start(level);
        images.push_back(drawn(distance, kProjections[0]));
        const FloatImage half = read("radiance");
        level.environment.fogDistance = 1e7f;
        start(level);
        drawn(distance, kProjections[0]);
        const FloatImage clear = read("radiance");
        level.environment.fogDistance = float(distance / 20.0);
        start(level);
        images.push_back(drawn(distance, kProjections[0]));
        const FloatImage hidden = read("radiance");
        const glm::ivec2 p = pixelOf(0.0, 0.2 * kHeight, distance);
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(half.at(p.x, p.y)[channel], 0.5f * (hidden.at(p.x, p.y)[channel] + clear.at(p.x, p.y)[channel]),
                        0.03f)
                << distance << " m";
    }
    if (const char* folder = std::getenv("RUBBLE_IMAGES"))
        EXPECT_TRUE(writePng(std::string(folder) + "/far_haze.png", tile(images, 2)));
}

/// Where the haze has hidden a tower, no hills and fields stand out behind it; the usual haze leaves them.
TEST_F(FarSightTest, HillsAndFieldsAreHiddenWithWhatStandsBeforeThem) {
    std::vector<Image> images;
    for (const float fogDistance : {50.0f, 150.0f}) {
        Level level = towerAt(1990.0);
        level.environment.fogColor = {0.2f, 0.6f, 0.3f};
        level.environment.fogDistance = fogDistance;
        start(level);
        images.push_back(drawn(1990.0, kProjections[0]));
        const FloatImage radiance = read("radiance");
        const glm::ivec2 p = pixelOf(0.0, 0.2 * kHeight, 1990.0);
        float most = 0.0f;
        for (int y = 0; y < kSize.y * 9 / 10; ++y)
            for (int x = 0; x < kSize.x; ++x) {
                const glm::vec3 off = glm::abs(glm::vec3(radiance.at(x, y) - radiance.at(p.x, p.y)));
                most = std::max({most, off.x, off.y, off.z});
            }
        if (fogDistance < 100.0f)
            EXPECT_LT(most, 0.01f);
        else
            EXPECT_GT(most, 0.1f);
    }
    if (const char* folder = std::getenv("RUBBLE_IMAGES"))
        EXPECT_TRUE(writePng(std::string(folder) + "/far_hills.png", tile(images, 2)));
}

}  // namespace
}  // namespace rubble
