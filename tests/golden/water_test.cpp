// Water from above, from below and half under, and what water out of view costs.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "render/frame/pixel_rect.h"
#include "tests/golden/drawing.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(160, 90);
constexpr double kSurface = 1.8, kRim = 2.0, kHalfLength = 5.0, kHalfWidth = 3.0;  // of the pool, metres
constexpr uint8_t kTile = 1, kLine = 2, kRed = 3, kStone = 4, kPane = 5;

PaletteRef poolPalette(bool withGlass) {
    auto palette = std::make_shared<Palette>();
    const auto entry = [&](int index, glm::ivec3 color) -> PaletteEntry& {
        PaletteEntry& e = (*palette)[size_t(index)];
        e.red = uint8_t(color.x), e.green = uint8_t(color.y), e.blue = uint8_t(color.z);
        e.roughness = 200;
        return e;
    };
    entry(kTile, {210, 205, 195}).emission = 0.02f;  // hardly seen by day
    entry(kLine, {60, 90, 150});
    entry(kRed, {190, 60, 45});
    entry(kStone, {150, 145, 135});
    if (withGlass) entry(kPane, {200, 40, 30}).opacity = 100;
    return palette;
}

/// A pool of 10 x 6 m, 1.8 m deep, whose floor lies at height 0; a red post stands in it and reaches into the air, and
/// a tower stands beside it.
LitScene poolScene(bool withGlass = false) {
    LitScene scene(poolPalette(withGlass));
    scene.environment.sunDirection = {0.5f, 0.9f, 0.4f};
    scene.add({140, 24, 100}, {{-7, -0.4, -5}, {1, 0, 0, 0}}, [](glm::ivec3 c) {
        const bool isInside = c.x >= 20 && c.x < 120 && c.z >= 20 && c.z < 80 && c.y >= 4;
        if (isInside) return uint8_t(0);
        const bool isLine = (c.x % 10 == 4) + (c.z % 10 == 4) + (c.y % 10 == 8) > 0;
        return c.y == 23 ? kStone : isLine ? kLine : kTile;
    });
    scene.add({3, 30, 3}, {{2, 0, -1}, {1, 0, 0, 0}}, [](glm::ivec3) { return kRed; });
    scene.add({8, 60, 8}, {{-1, 2, -4.5}, {1, 0, 0, 0}}, [](glm::ivec3 c) { return c.y / 6 % 2 ? kRed : kTile; });
    return scene;
}

Water poolWater() {
    Water water;
    water.outline = {
        {-kHalfLength, -kHalfWidth}, {kHalfLength, -kHalfWidth}, {kHalfLength, kHalfWidth}, {-kHalfLength, kHalfWidth}};
    water.surface = kSurface;
    water.depth = kSurface;
    water.color = {0.25f, 0.6f, 0.65f};
    water.clarity = 4.0f;
    water.waves.height = 0.02f;
    return water;
}

Camera lookingAt(glm::dvec3 from, glm::dvec3 at, float fov = 1.05f) {
    Camera camera;
    camera.position = from;
    camera.lookAt(at);
    camera.verticalFov = fov;
    return camera;
}

class WaterTest : public Drawing {
protected:
    void start(const std::vector<Water>& waters, RenderSettings settings = {}, glm::ivec2 size = kSize,
               const Environment& environment = poolScene().environment) {
        LitScene scene = poolScene();
        scene.environment = environment;
        Drawing::start(scene, size, settings);
        FrameSnapshot step;
        step.version = step.newestStep = 60;
        step.waters = waters;
        step.watersChanged = true;
        renderer->apply(std::move(step));
    }
    /// Mean radiance of a box of pixels; y counts from the bottom.
    glm::dvec3 mean(glm::ivec2 low, glm::ivec2 high) {
        const FloatImage image = read("radiance");
        glm::dvec3 sum(0.0);
        for (int y = low.y; y < high.y; ++y)
            for (int x = low.x; x < high.x; ++x) sum += glm::dvec3(image.at(x, y));
        return sum / double((high.x - low.x) * (high.y - low.y));
    }
    int drawCalls(const Camera& camera) {
        draw(camera, 2);
        return renderer->stats().drawCalls;
    }
};

const Camera kFromTheRim = lookingAt({-6.0, 3.6, 4.4}, {0, 1, 0});

TEST_F(WaterTest, OutOfViewCostsNothing) {
    start({});
    const int without = drawCalls(kFromTheRim);
    std::vector<Water> ponds(32, poolWater());
    for (size_t i = 0; i < ponds.size(); ++i)
        for (GroundPoint& p : ponds[i].outline) p.x = 0.1 * p.x - 40.0, p.z += 10.0 * double(i) - 160.0;
    start(ponds);
    EXPECT_EQ(drawCalls(kFromTheRim), without);
    EXPECT_EQ(renderer->stats().waters, 0);
    EXPECT_EQ(renderer->stats().imageCopies, 0);
    EXPECT_FALSE(renderer->readTarget("behindWater")) << "a target that nothing needs";
}

TEST_F(WaterTest, CoversItsRectangleOnTheScreenAndCopiesTheImageOnce) {
    std::vector<Water> puddles(16, poolWater());
    for (size_t i = 0; i < puddles.size(); ++i)
        for (GroundPoint& p : puddles[i].outline)
            p.x = 0.02 * p.x + 1.2 * double(i % 4), p.z = 0.02 * p.z + 1.2 * double(i / 4);
    start(puddles);
    const Camera above = lookingAt({2.0, 16.0, 2.0}, {2.0, 0.0, 1.99});
    drawCalls(above);
    EXPECT_EQ(renderer->stats().waters, 16);
    EXPECT_EQ(renderer->stats().imageCopies, 1);
    EXPECT_LT(renderer->stats().waterPixels, uint64_t(kSize.x * kSize.y / 4));
    start({poolWater()});
    draw(lookingAt({0, 1, 0}, {5, 1, 0}), 1);
    EXPECT_EQ(renderer->stats().waterPixels, uint64_t(kSize.x * kSize.y)) << "under water it is everywhere";
}

/// Strips side by side, seen along their diagonal: their rectangles on the screen cover one another, they hardly do.
TEST_F(WaterTest, ManyWatersCostWhatTheyCover) {
    RenderSettings settings;
    settings.temporal = false;
    constexpr int kStrips = 12;
    const Camera camera = lookingAt({-4.5, 3.0, -2.6}, {3.0, 1.0, 1.5});
    const auto strip = [](int i) {
        Water water = poolWater();
        for (GroundPoint& p : water.outline) p.x = (p.x + kHalfLength) / kStrips - kHalfLength + 10.0 * i / kStrips;
        water.depth = 0.1;
        return water;
    };
    start({}, settings);
    draw(camera);
    const FloatImage dry = read("radiance");
    uint64_t shown = 0, rectangles = 0;
    std::vector<Water> strips;
    for (int i = 0; i < kStrips; ++i) {
        strips.push_back(strip(i));
        start({strips.back()}, settings);  // so that frames have the same noise
        draw(camera);
        const FloatImage wet = read("radiance");
        PixelRect around;
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x) {
                if (glm::vec3(wet.at(x, y)) == glm::vec3(dry.at(x, y))) continue;
                ++shown;
                around = around.merged({{x, y}, {x + 1, y + 1}});
            }
        rectangles += around.pixels();
    }
    start(strips, settings);
    draw(camera);
    const RenderStats& stats = renderer->stats();
    RecordProperty("shown", std::to_string(shown));
    RecordProperty("rectangles", std::to_string(rectangles));
    RecordProperty("drawn", std::to_string(stats.waterPixels));
    RecordProperty("copied", std::to_string(stats.copiedPixels));
    EXPECT_GT(shown, 3000u);
    EXPECT_LE(stats.waterPixels, 2 * shown) << "a pixel around each thin strip";
    EXPECT_LE(3 * stats.waterPixels, 2 * rectangles);
    EXPECT_LE(stats.imageCopies, kStrips);
    EXPECT_LE(stats.copiedPixels, 2 * rectangles);
}

/// What is drawn over must hold all that the water changes, from anywhere.
TEST_F(WaterTest, ChangesNothingOutsideOfItsArea) {
    RenderSettings settings;
    settings.temporal = false;
    for (const Camera& camera :
         {kFromTheRim, lookingAt({-6.0, 2.5, 0}, {0, 2.2, 1}), lookingAt({0, 8, 0.01}, {0, 0, 0}, 2.2f)}) {
        start({}, settings);
        draw(camera);
        const FloatImage dry = read("radiance");
        start({poolWater()}, settings);
        draw(camera);
        const FloatImage wet = read("radiance");
        size_t changed = 0;
        for (size_t i = 0; i < wet.pixels.size(); ++i) changed += glm::vec3(wet.pixels[i]) != glm::vec3(dry.pixels[i]);
        EXPECT_GT(changed, 500u);
        EXPECT_LE(changed, renderer->stats().waterPixels);
        RenderSettings byCompute = settings;  // which draws all of the rectangle around the area
        byCompute.fullscreen = Fullscreen::Compute;
        start({poolWater()}, byCompute);
        draw(camera);
        const FloatImage whole = read("radiance");
        size_t differing = 0;
        for (size_t i = 0; i < wet.pixels.size(); ++i)
            differing += glm::distance(glm::vec3(whole.pixels[i]), glm::vec3(wet.pixels[i])) >
                         0.1f * glm::length(glm::vec3(whole.pixels[i]));
        EXPECT_LE(differing, 5u) << "of pixels whose rays meet something else by rounding";
    }
}

/// Under water a wall that glows at d metres keeps color^(d / clarity) of its light. Without other light the water
/// scatters nothing.
TEST_F(WaterTest, AbsorbsLightByDistanceUnderTheSurface) {
    Environment dark;
    dark.sunColor = dark.skyColor = dark.horizonColor = dark.groundColor = dark.fogColor = glm::vec3(0.0f);
    dark.fogDistance = 1e6f;
    for (const double metres : {0.5, 2.0, 8.0}) {
        const Camera camera = lookingAt({kHalfLength - metres, 0.85, 0.55}, {kHalfLength, 0.85, 0.55}, 0.02f);
        start({}, {}, kSize, dark);
        draw(camera);
        const glm::dvec3 dry = mean({70, 40}, {90, 50});
        start({poolWater()}, {}, kSize, dark);
        draw(camera);
        const glm::dvec3 left = mean({70, 40}, {90, 50}) / dry;
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(left[channel], std::pow(double(poolWater().color[channel]), metres / 4.0), 0.01) << metres;
    }
}

/// Where two waters are in one place, light passes one: the pool as two halves that share its middle, or with another
/// inside of it, looks as it does as one.
TEST_F(WaterTest, AbsorbsLightOnceWhereWatersOverlap) {
    const Water pool = poolWater();
    Water left = pool, right = pool, inside = pool;
    left.outline[1].x = left.outline[2].x = 1.5;
    right.outline[0].x = right.outline[3].x = -1.5;
    for (GroundPoint& p : inside.outline) p.x *= 0.5, p.z *= 0.5;
    inside.surface -= 0.5, inside.depth -= 0.7;
    RenderSettings settings;
    settings.temporal = false;
    const Camera cameras[] = {kFromTheRim, lookingAt({-4.0, 0.9, 2.0}, {4.0, 0.8, -1.0}, 1.2f),
                              lookingAt({-2.0, 0.3, 1.5}, {0.0, 1.8, -0.5}, 1.2f)};
    std::vector<Image> images;
    for (const Camera& camera : cameras) {
        start({pool}, settings);
        images.push_back(draw(camera));
        const FloatImage one = read("radiance");
        for (const std::vector<Water>& waters :
             {std::vector{left, right}, {right, left}, {pool, pool}, {pool, inside}}) {
            start(waters, settings);
            images.push_back(draw(camera));
            const FloatImage found = read("radiance");
            double sum = 0.0, difference = 0.0;
            for (size_t p = 0; p < one.pixels.size(); ++p) {
                sum += double(one.pixels[p].g);
                difference += std::abs(double(found.pixels[p].g - one.pixels[p].g));
            }
            std::printf("differs by %.4f\n", difference / sum);
            EXPECT_LT(difference, 0.02 * sum);
        }
    }
    if (const char* folder = std::getenv("RUBBLE_SHEETS"))
        EXPECT_TRUE(writePng(std::string(folder) + "/water_overlaps.png", tile(images, 5)));
}

/// From below, light from the air comes through a round window of 48.6 degrees around the zenith alone.
TEST_F(WaterTest, ShowsSnellsWindowFromBelow) {
    RenderSettings settings;
    settings.temporal = settings.fog = false;
    Water water = poolWater();
    water.color = {0.9f, 0.9f, 0.9f};
    water.clarity = 10.0f;
    water.waves.height = 0.0f;
    Environment sky;
    sky.sunColor = sky.groundColor = glm::vec3(0.0f);
    sky.skyColor = sky.horizonColor = glm::vec3(1.0f);
    sky.clouds = 0.0f;
    start({water}, settings, {129, 129}, sky);
    const Camera up = lookingAt({-3.0, 1.4, 0.0}, {-3.0, 3.0, 0.001}, glm::radians(130.0f));
    draw(up, 1);
    const FloatImage image = read("radiance");
    const auto at = [&](double degrees) {  // toward +x, where nothing stands beyond the pool's edge
        const double place = 64.5 + 64.5 * std::tan(glm::radians(degrees)) / std::tan(glm::radians(65.0));
        return double(image.at(int(place), 64).g);
    };
    const double open = at(5.0);
    EXPECT_GT(open, 0.5);
    EXPECT_GT(at(-44.0), 0.8 * open);
    EXPECT_LT(at(-53.0), 0.6 * open) << "the surface must mirror the pool";
    EXPECT_LT(at(-60.0), 0.6 * open);
}

/// Neither in it nor, beyond its surface, straight before a camera in it.
TEST_F(WaterTest, HasNoFogInIt) {
    const Camera down = lookingAt({-3.0, 1.0, 0.5}, {4.0, 0.2, 0.0}),
                 mirrored = lookingAt({-3.0, 1.0, 0.5}, {4.0, 2.6, 0.0});
    glm::dvec3 light[2][2];
    for (const bool isFoggy : {false, true}) {
        Environment environment = poolScene().environment;
        environment.fogDensity = isFoggy ? 0.2f : 0.0f;
        start({poolWater()}, {}, kSize, environment);
        draw(down, 12);
        light[0][isFoggy] = mean({60, 5}, {100, 35});
        draw(mirrored, 12);
        light[1][isFoggy] = mean({60, 60}, {100, 80});
    }
    EXPECT_NEAR(light[0][1].g, light[0][0].g, 0.05 * light[0][0].g) << "looking down";
    EXPECT_NEAR(light[1][1].g, light[1][0].g, 0.05 * light[1][0].g) << "where the surface mirrors the pool";
}

TEST_F(WaterTest, IsVeiledByHazeAsWhatIsBesideIt) {
    Environment environment = poolScene().environment;
    environment.fogDistance = 0.7f;
    start({poolWater()}, {}, kSize, environment);
    draw(lookingAt({-9.0, 6.0, 0.0}, {0.0, 1.8, 0.0}), 4);
    const glm::dvec3 water = mean({60, 40}, {100, 50}), beside = mean({2, 40}, {12, 50});
    EXPECT_NEAR(water.g, beside.g, 0.03 * beside.g);
    EXPECT_NEAR(water.r, beside.r, 0.03 * beside.r);
}

/// From under water no particle above the surface is seen straight through it, and those in the water are.
TEST_F(WaterTest, HidesParticlesAboveACameraInIt) {
    const Camera under = lookingAt({-3.0, 1.0, 0.5}, {4.0, 2.0, 0.5});
    const auto drawn = [&](double height) {
        start({poolWater()});
        FrameSnapshot step;
        step.version = step.newestStep = 61;
        SnapshotParticle smoke{
            ParticleKind::Smoke, {1.0, height, 0.5}, glm::vec3(0.0f), glm::vec3(0.01f), 0.6f, 1.0f, 0.1f, 7u};
        step.particles = {smoke};
        step.particlesChanged = true;
        renderer->apply(std::move(step));
        draw(under, 8);
        return mean({70, 30}, {90, 65}).g;
    };
    const double none = drawn(-50.0);
    EXPECT_NEAR(drawn(kSurface + 0.3), none, 0.02 * none);
    EXPECT_LT(drawn(kSurface - 0.4), 0.9 * none);
}

/// A camera that dips into the water sees the pool before and after: neither an empty pool nor a smear.
TEST_F(WaterTest, ChangesLittleWhileTheCameraDipsIn) {
    RenderSettings settings;
    settings.temporal = false;
    settings.skyRays = 4;  // so that noise is not what differs
    start({poolWater()}, settings);
    const auto drawnAt = [&](double over) {
        draw(lookingAt({-4.0, kSurface + over, 1.0}, {5.0, kSurface - 1.5 + over, 0.0}), 1);
        return read("radiance");
    };
    const FloatImage above = drawnAt(0.002), below = drawnAt(-0.002);
    double difference = 0.0, sum = 0.0;
    for (int y = 0; y < 40; ++y)  // the lower part looks down into the pool
        for (int x = 0; x < kSize.x; ++x) {
            difference += std::abs(double(above.at(x, y).g - below.at(x, y).g));
            sum += double(below.at(x, y).g);
        }
    EXPECT_LT(difference, 0.03 * sum);
}

/// Water that nothing can be seen through hides panes in it, from inside and from above, and none before it.
TEST_F(WaterTest, CoversPanesAsItCoversWhatIsBesideThem) {
    RenderSettings settings;
    settings.temporal = settings.fog = false;
    settings.bounce = false;  // bounced sun has the colours of panes, also beside the water
    const auto drawn = [&](const Camera& camera, double paneHeight, float clarity) {
        LitScene scene = poolScene(true);
        if (paneHeight >= 0.0)
            scene.add({20, 8, 2}, {{-1, paneHeight, 1.0}, {1, 0, 0, 0}}, [](glm::ivec3) { return kPane; });
        Drawing::start(scene, kSize, settings);
        FrameSnapshot step;
        step.version = step.newestStep = 60;
        Water water = poolWater();
        water.clarity = clarity;
        water.waves.height = 0.0f;
        step.waters = {water};
        step.watersChanged = true;
        renderer->apply(std::move(step));
        draw(camera);
        return read("radiance");
    };
    const auto changed = [&](const FloatImage& a, const FloatImage& b) {
        int count = 0;
        for (size_t i = 0; i < a.pixels.size(); ++i)
            count += glm::distance(glm::vec3(a.pixels[i]), glm::vec3(b.pixels[i])) >
                     0.02f * glm::length(glm::vec3(b.pixels[i])) + 1e-4f;
        return count;
    };
    const Camera under = lookingAt({0.2, 0.5, 2.8}, {0, 0.4, 0}, 0.6f), above = lookingAt({0, 4.5, 4.5}, {0, 1.2, 0.5});
    for (const Camera& camera : {under, above}) {
        EXPECT_EQ(changed(drawn(camera, 0.2, 0.01f), drawn(camera, -1.0, 0.01f)), 0) << "water like ink";
        EXPECT_GT(changed(drawn(camera, 0.2, 8.0f), drawn(camera, -1.0, 8.0f)), 100) << "clear water";
    }
    EXPECT_GT(changed(drawn(above, 1.9, 0.01f), drawn(above, -1.0, 0.01f)), 100) << "a pane over the water";
}

/// From above, each pixel shows water where its point of the surface is inside the outline.
TEST_F(WaterTest, ReachesToItsOutlineHoweverManyCornersThatHas) {
    RenderSettings settings;
    settings.temporal = false;
    const Camera above = lookingAt({0.0, 12.0, 0.01}, {0.0, 0.0, 0.0}, 0.5f);
    start(std::vector<Water>{}, settings);
    draw(above);
    const FloatImage dry = read("radiance"), depth = read("depth");
    for (const int corners : {5, 16, 17, 65, 257, 1001, 10000}) {
        Water water = poolWater();
        water.outline.clear();
        for (int i = 0; i < corners; ++i) {
            const double angle = glm::two_pi<double>() * i / corners, spikes = corners % 2 ? 0.0 : 0.7 * (i % 2);
            const double radius = 2.7 - spikes + 0.2 * std::sin(9.0 * angle);
            water.outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
        start({water}, settings);
        draw(above);
        const FloatImage wet = read("radiance");
        const double perPixel = 2.0 * std::tan(0.25) * (12.0 - kSurface) / kSize.y;
        int inside = 0, wrong = 0;
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x) {
                const glm::dvec2 place = glm::dvec2(x + 0.5 - 0.5 * kSize.x, 0.5 * kSize.y - y - 0.5) * perPixel;
                // Thousands of spikes are finer than the samples that find the border.
                if (corners == 10000 && glm::length(place) > 1.7 && glm::length(place) < 3.0) continue;
                const auto isIn = [&](double dx, double dy) {
                    return contains(water.outline, place.x + dx * perPixel, place.y - dy * perPixel);
                };
                const bool isInside = isIn(0, 0);
                bool isBorder = false;
                for (int i = 0; i < 25; ++i) isBorder |= isIn(0.5 * (i % 5 - 2), 0.5 * (i / 5 - 2)) != isInside;
                if (isBorder || depth.at(x, y).r < 12.0 - kSurface) continue;  // the post stands out of the water
                inside += isInside;
                wrong += (glm::vec3(wet.at(x, y)) != glm::vec3(dry.at(x, y))) != isInside;
            }
        EXPECT_EQ(wrong, 0) << corners << " corners";
        EXPECT_GT(inside, corners == 10000 ? 1500 : 3000) << corners << " corners";
    }
}

TEST_F(WaterTest, WavesOfNoLengthAreDrawn) {
    for (const auto& [length, height] : {std::pair(0.0f, 0.03f), std::pair(1e-30f, 0.03f), std::pair(0.0f, 0.0f)}) {
        Water water = poolWater();
        water.waves.length = length;
        water.waves.height = height;
        start({water});
        draw(kFromTheRim, 2);
        const FloatImage image = read("radiance");
        int lit = 0;
        for (const glm::vec4& pixel : image.pixels) lit += pixel.r + pixel.g + pixel.b > 0.01f;
        EXPECT_EQ(lit, kSize.x * kSize.y) << length << " m long, " << height << " m high";
    }
}

/// Writes the pool from many places to the folder RUBBLE_SHEETS, to look at.
TEST_F(WaterTest, SheetOfThePool) {
    const char* folder = std::getenv("RUBBLE_SHEETS");
    if (!folder) GTEST_SKIP() << "set RUBBLE_SHEETS to a folder";
    struct Place {
        const char* name;
        glm::dvec3 from, at;
    };
    const Place places[] = {{"rim", {-6.0, 3.6, 4.4}, {0, 1, 0}},
                            {"grazing", {-4.8, kSurface + 0.3, 2.0}, {3.0, kSurface, -0.5}},
                            {"two_centimetres", {-4.0, kSurface + 0.02, 1.0}, {5.0, kSurface - 0.5, 0.0}},
                            {"half_under", {-4.0, kSurface, 1.0}, {5.0, kSurface - 0.1, 0.0}},
                            {"two_below", {-4.0, kSurface - 0.02, 1.0}, {5.0, kSurface + 0.5, 0.0}},
                            {"under", {-4.0, 0.9, 2.0}, {4.0, 0.8, -1.0}},
                            {"up", {-2.0, 0.3, 1.5}, {0.0, 1.8, -0.5}},
                            {"zenith", {0.0, 0.3, 0.0}, {0.0, 2.0, -0.5}},
                            {"side", {-4.0, 0.3, 0.0}, {3.0, 1.8, -0.5}}};
    start({poolWater()}, {}, {640, 360});
    for (const Place& place : places)
        ASSERT_TRUE(writePng(std::string(folder) + "/water_" + place.name + ".png",
                             draw(lookingAt(place.from, place.at, 1.2f), 12)));
}

}  // namespace
}  // namespace rubble
