// Glass: panes one behind the other, of one body and of several, their tint and their refraction.
#include <algorithm>
#include <cmath>

#include "tests/golden/drawing.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(96, 64);
constexpr uint8_t kWall = 1, kDark = 2, kGlow = 3, kFirstPane = 4;
const glm::dquat kLevel(1, 0, 0, 0);

struct Tint {
    uint8_t red, green, blue, opacity;
};
constexpr Tint kTints[] = {{255, 90, 60, 40}, {80, 240, 90, 90}, {70, 90, 250, 20}, {250, 240, 100, 120}};

PaletteRef wallAndPanes() {
    auto palette = std::make_shared<Palette>();
    const auto set = [&](int index, Tint tint) {
        PaletteEntry& e = (*palette)[size_t(index)];
        e.red = tint.red, e.green = tint.green, e.blue = tint.blue, e.opacity = tint.opacity, e.material = 1;
    };
    set(kWall, {200, 200, 200, 255});
    set(kDark, {50, 50, 50, 255});
    set(kGlow, {255, 255, 255, 255});
    (*palette)[kGlow].emission = 20.0f;
    for (size_t i = 0; i < std::size(kTints); ++i) set(kFirstPane + int(i), kTints[i]);
    return palette;
}

/// Transmittance of one pane, as in lib/glass_walk.glsl.
glm::vec3 paneTransmittance(int pane) {
    const Tint t = kTints[pane];
    const glm::vec3 linear = glm::pow(glm::vec3(t.red, t.green, t.blue) / 255.0f, glm::vec3(2.2f));
    return (1.0f - float(t.opacity) / 255.0f) *
           glm::mix(glm::vec3(1.0f), linear / std::max({linear.x, linear.y, linear.z}), 0.7f);
}

class GlassTest : public Drawing {
protected:
    static Camera camera() {
        Camera camera;
        camera.position = {0, 0, 4};
        camera.lookAt({0, 0, 0});
        return camera;
    }
};

/// Panes 0 and 2 belong to one body, pane 1 to another between them, and pane 3 is behind a wall.
TEST_F(GlassTest, PanesOfInterleavedBodiesTintOnceAndTheNearestIsTheSurface) {
    LitScene scene(wallAndPanes());
    scene.add({20, 20, 21}, {{-1, -1, 0}, kLevel}, [](glm::ivec3 c) {
        return uint8_t(c.z == 20 ? kFirstPane : c.z == 0 ? kFirstPane + 2 : 0);
    });
    scene.add({20, 20, 1}, {{-1, -1, 1}, kLevel}, [](glm::ivec3) { return uint8_t(kFirstPane + 1); });
    scene.add({160, 60, 10}, {{-8, -3, -5}, kLevel}, [](glm::ivec3 c) {
        return uint8_t(c.z == 9 ? kWall : c.z == 2 ? kFirstPane + 3 : 0);
    });
    RenderSettings settings;
    settings.temporal = false;
    start(scene, kSize, settings);
    draw(camera());
    const glm::vec3 expected = paneTransmittance(0) * paneTransmittance(1) * paneTransmittance(2);
    const FloatImage tint = read("glassTint"), surface = read("glassSurface");
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(tint.at(48, 32)[i], expected[i], 0.006f) << "channel " << i;
    EXPECT_NEAR(surface.at(48, 32).w, 4.0f - 2.1f, 0.01f);
    EXPECT_NEAR(surface.at(48, 32).z, 1.0f, 0.01f);
    EXPECT_EQ(surface.at(8, 32).w, 0.0f) << "a pane behind the wall is visible";
}

TEST_F(GlassTest, BeforeTheSkyThereIsNoSurface) {
    LitScene scene(wallAndPanes());
    scene.add({20, 20, 1}, {{-1, -1, 0}, kLevel}, [](glm::ivec3) { return uint8_t(kFirstPane); });
    RenderSettings settings;
    settings.temporal = false;
    start(scene, kSize, settings);
    draw(camera());
    EXPECT_GT(read("glassTint").at(48, 32).r, 0.0f);
    EXPECT_EQ(read("glassMask").at(48, 32).r, 1.0f);
    EXPECT_GT(read("depth").at(48, 32).r, 60000.0f);
    for (const char* name : {"albedo", "normal", "material", "motion"}) {
        const glm::vec4 found = read(name).at(48, 32);
        EXPECT_EQ(found.r + found.g + found.b, 0.0f) << name;
    }
}

/// An edge from dark to light on a wall behind a slanted pane: where it appears with and without refraction.
TEST_F(GlassTest, RefractsLikeAParallelPlate) {
    const auto edgeAt = [&](bool refraction) {
        LitScene scene(wallAndPanes());
        scene.environment.sunDirection = {0.1f, 0.3f, 1.0f};
        scene.add({60, 60, 2}, {{-3, -3, -0.2}, kLevel},
                  [](glm::ivec3 c) { return uint8_t(c.x < 30 ? kDark : kWall); });
        scene.add({60, 30, 1},
                  {glm::dvec3(0, -1.5, 1) - glm::angleAxis(0.9, glm::dvec3(0, 1, 0)) * glm::dvec3(3, 0, 0),
                   glm::angleAxis(0.9, glm::dvec3(0, 1, 0))},
                  [](glm::ivec3) { return uint8_t(kFirstPane + 2); });
        RenderSettings settings;
        settings.temporal = false;
        settings.refraction = refraction;
        start(scene, {384, 256}, settings);
        Camera near = camera();
        near.position.z = 2.5;
        draw(near, 2);
        const FloatImage image = read("radiance");
        float largestStep = 0.0f;
        int edge = 0;
        for (int x = 150; x < 234; ++x) {
            const float step = image.at(x + 1, 128).y - image.at(x, 128).y;
            if (step > largestStep) largestStep = step, edge = x;
        }
        return edge;
    };
    // Snell's law: a plate of index n displaces a ray by d (tan a - tan b) along itself, which is that times cos a
    // along the wall.
    const double a = 0.9, b = std::asin(std::sin(a) / 1.5), across = 0.06 * (std::tan(a) - std::tan(b)) * std::cos(a);
    const double pixels = across / (2.0 * std::tan(0.5 * camera().verticalFov) * 2.5) * 256.0;
    const int shift = edgeAt(true) - edgeAt(false);
    EXPECT_GT(pixels, 2.0);
    EXPECT_NEAR(std::abs(shift), pixels, 1.1);
}

TEST_F(GlassTest, DoesNotSmearWhatStandsInFront) {
    LitScene scene(wallAndPanes());
    scene.add({60, 60, 2}, {{-3, -3, -3.2}, kLevel}, [](glm::ivec3) { return kDark; });
    scene.add({60, 30, 1}, {{-2, -1.5, 1}, glm::angleAxis(0.8, glm::dvec3(0, 1, 0))},
              [](glm::ivec3) { return uint8_t(kFirstPane + 2); });
    scene.add({2, 40, 2}, {{-0.1, -2, 2.4}, kLevel}, [](glm::ivec3) { return kGlow; });  // a bright bar in front
    RenderSettings settings;
    settings.temporal = settings.reflections = settings.fog = settings.glare = false;
    settings.bloom = 0.0f;
    start(scene, {192, 128}, settings);
    draw(camera(), 2);
    const FloatImage image = read("radiance"), surface = read("glassSurface");
    int panes = 0;
    for (int x = 0; x < 192; ++x) {
        if (surface.at(x, 64).w <= 0.0f) continue;
        ++panes;
        EXPECT_LT(image.at(x, 64).y, 5.0f) << "at column " << x;
    }
    EXPECT_GT(panes, 60);
}

/// A pane shows  t (T B' + F M) + a  of what is behind it, B', and what it mirrors, M, if the haze before it leaves the
/// share t and adds a. The wall behind it is far beyond it, in thicker haze.
TEST_F(GlassTest, HazeCoversPanesAsItCoversWhatIsBesideThem) {
    const auto drawn = [&](float fogDistance, bool isPane) {
        LitScene scene(wallAndPanes());
        scene.environment.fogDistance = fogDistance;
        scene.environment.fogColor = {0.3f, 0.4f, 0.6f};
        scene.environment.sunDirection = {0.1f, -1.0f, 0.0f};
        scene.environment.sunColor = glm::vec3(0.0f);
        scene.add({20, 20, 1}, {{-2, -1, 0}, kLevel}, [](glm::ivec3) { return kWall; });
        if (isPane) scene.add({20, 20, 1}, {{0, -1, 0}, kLevel}, [](glm::ivec3) { return uint8_t(kFirstPane); });
        scene.add({160, 60, 2}, {{-8, -3, -4}, kLevel}, [](glm::ivec3) { return kWall; });
        RenderSettings settings;
        settings.temporal = settings.fog = settings.refraction = settings.reflections = false;
        start(scene, kSize, settings);
        draw(camera());
        return read("radiance");
    };
    const glm::ivec2 pane(60, 32);
    const auto at = [&](const FloatImage& image) { return glm::vec3(image.at(pane.x, pane.y)); };
    const FloatImage clear = drawn(1e6f, true), dense = drawn(0.5f, true);
    const glm::vec3 haze(dense.at(20, 32));  // of the wall beside it
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(at(dense)[c], haze[c], 0.01f) << "channel " << c;
    const float fogDistance = 5.0f, ratio = 3.9f / fogDistance, hidden = 1.0f - std::exp2(-ratio * std::sqrt(ratio));
    const glm::vec3 behind = at(drawn(fogDistance, false)), tint = paneTransmittance(0);
    const glm::vec3 mirrored = at(clear) - 0.92f * tint * at(drawn(1e6f, false));
    const glm::vec3 expected = 0.92f * tint * (behind - hidden * haze) + (1.0f - hidden) * mirrored + hidden * haze;
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(at(drawn(fogDistance, true))[c], expected[c], 0.02f * expected[c]) << "channel " << c;
}

}  // namespace
}  // namespace rubble
