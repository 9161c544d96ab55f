// Panes, water, fog and particles over what a host has drawn with depth before the renderer draws.
// RUBBLE_IMAGES=FOLDER writes images of a host's wall behind and before them.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/golden/drawing.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(160, 96);
constexpr uint8_t kStone = 1, kRedGlass = 2;
constexpr double kFar = 8.0, kNear = 3.0;  // metres of a wall behind the pane and in the water, and before both
constexpr int kFrames = 8;                 // in which the light settles
constexpr glm::vec4 kGrey(0.5f, 0.5f, 0.5f, 0.75f);

PaletteRef palette(bool withGlass) {
    auto made = std::make_shared<Palette>();
    PaletteEntry& stone = (*made)[kStone];
    stone.red = stone.green = stone.blue = 150;
    stone.roughness = 230;
    if (!withGlass) return made;
    PaletteEntry& glass = (*made)[kRedGlass];
    glass.red = 220, glass.green = glass.blue = 20;
    glass.opacity = 60;
    glass.roughness = 10;
    return made;
}

/// A floor, on the left a red pane and on the right a basin without walls, six metres away.
struct Around {
    bool hasPane = false, hasWater = false, hasSmoke = false;
    float fog = 0.0f;
};
FrameSnapshot sceneOf(const Around& around) {
    LitScene scene(palette(around.hasPane));
    const glm::dquat level(1, 0, 0, 0);
    scene.environment.fogDistance = 1e6f;
    scene.environment.fogDensity = around.fog;
    scene.environment.fogHeight = 1e4f;  // the same at all heights
    scene.add({160, 2, 80}, {{-8.0, -0.2, -6.0}, level}, [](glm::ivec3) { return kStone; });
    if (around.hasPane) scene.add({30, 26, 1}, {{-4.0, 0.0, 0.0}, level}, [](glm::ivec3) { return kRedGlass; });
    FrameSnapshot snapshot = scene.snapshot();
    if (around.hasWater) {
        Water water;
        water.outline = {{0.5, -3.0}, {4.0, -3.0}, {4.0, 1.0}, {0.5, 1.0}};
        water.surface = 1.0;
        water.depth = 1.0;
        snapshot.waters = {water};
        snapshot.watersChanged = true;
    }
    if (around.hasSmoke) {
        snapshot.particles.push_back(
            {ParticleKind::Smoke, {0.0, 1.6, 0.0}, glm::vec3(0.0f), glm::vec3(0.1f), 0.8f, 1.0f, 0.3f, 7});
        snapshot.particlesChanged = true;
    }
    return snapshot;
}

/// A host's framebuffer.
class HostTarget {
public:
    HostTarget()
        : m_color(GL_RGBA16F, kSize), m_depth(GL_DEPTH_COMPONENT32F, kSize), m_framebuffer({&m_color}, &m_depth) {}
    GLuint name() const { return m_framebuffer.name(); }
    /// Clears it, and draws a wall over the rows from `low` on.
    void drawWall(const View& view, double metres, glm::vec4 color, int low = 0) const {
        const auto fill = [](glm::vec4 with, double depth) {
            glClearColor(with.r, with.g, with.b, with.a);
            glClearDepth(depth);
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            glClearDepth(1.0);
        };
        glBindFramebuffer(GL_FRAMEBUFFER, name());
        fill(glm::vec4(0.0f), view.projection->isReversed() ? 0.0 : 1.0);
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, low, kSize.x, kSize.y - low);
        fill(color, view.projection->windowDepth(metres));
        glDisable(GL_SCISSOR_TEST);
    }
    /// Rows from the bottom up.
    std::vector<glm::vec4> pixels() const {
        std::vector<glm::vec4> read(size_t(kSize.x * kSize.y));
        glBindFramebuffer(GL_FRAMEBUFFER, name());
        glReadPixels(0, 0, kSize.x, kSize.y, GL_RGBA, GL_FLOAT, read.data());
        return read;
    }

private:
    Texture m_color, m_depth;
    Framebuffer m_framebuffer;
};

class HostLayersTest : public Drawing {
protected:
    void startWith(const Around& around, RenderSettings settings = {}) {
        auto made = Renderer::create(testContext().loader(), shaderFolder(), settings);
        ASSERT_TRUE(made) << made.error();
        renderer = std::move(made).value();
        renderer->apply(sceneOf(around));
        host = std::make_unique<HostTarget>();
    }
    View view() const {
        Camera camera;
        camera.position = {0.0, 1.5, 6.0};
        camera.lookAt({0.0, 1.2, 0.0});
        View made = camera.view(kSize, host->name());
        made.projection = View::Projection{glm::perspective(0.8, double(kSize.x) / kSize.y, 0.1, 100.0)};
        made.projection->composesDepth = true;
        return made;
    }
    /// Draws over a wall of the host, after some frames in which the light has settled.
    std::vector<glm::vec4> drawnOver(View seen, double metres, glm::vec4 color, int low = 0) {
        for (int i = 0; i < kFrames; ++i) {
            host->drawWall(seen, metres, color, low);
            renderer->draw(seen, 1.0f);
            EXPECT_EQ(renderer->lastError(), "");
        }
        return host->pixels();
    }
    void write(const std::string& name, const std::vector<glm::vec4>& pixels) const {
        const char* folder = std::getenv("RUBBLE_IMAGES");
        if (!folder) return;
        Image image(kSize.x, kSize.y);
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x)
                for (int i = 0; i < 3; ++i)
                    image.at(x, kSize.y - 1 - y)[i] =
                        uint8_t(std::clamp(pixels[size_t(y * kSize.x + x)][i], 0.0f, 1.0f) * 255.0f + 0.5f);
        EXPECT_TRUE(writePng(std::string(folder) + "/host_" + name + ".png", image));
    }
    bool hasRun(std::string_view pass) const { return std::ranges::count(renderer->stats().passes, pass) > 0; }
    std::unique_ptr<HostTarget> host;
};

const glm::vec4& at(const std::vector<glm::vec4>& pixels, glm::ivec2 pixel) {
    return pixels[size_t(pixel.y * kSize.x + pixel.x)];
}
constexpr glm::ivec2 kInPane(40, 50), kInWater(110, 34), kBetween(80, 80);

TEST_F(HostLayersTest, EverythingIsSeenOverWhatItStandsBeforeAndNothingElse) {
    startWith({.hasPane = true, .hasWater = true, .hasSmoke = true, .fog = 0.03f});
    const View seen = view();
    write("far", drawnOver(seen, kFar, kGrey, 30));
    write("near", drawnOver(seen, kNear, kGrey, 30));
    View flipped = seen;
    flipped.isFlipped = true;
    write("flipped", drawnOver(flipped, kFar, kGrey));
    EXPECT_TRUE(hasRun("host layers"));
}

TEST_F(HostLayersTest, APaneTintsWhatStandsBehindIt) {
    startWith({.hasPane = true});
    for (const bool isLinear : {false, true}) {
        View seen = view();
        seen.isLinear = isLinear;
        const std::vector<glm::vec4> behind = drawnOver(seen, kFar, kGrey), before = drawnOver(seen, kNear, kGrey);
        const glm::vec4 tinted = at(behind, kInPane);
        EXPECT_LT(tinted.g, 0.75f * kGrey.g) << "red glass takes green";
        EXPECT_LT(tinted.b, 0.75f * kGrey.b);
        EXPECT_GT(tinted.r, tinted.g + 0.1f);
        EXPECT_EQ(tinted.a, kGrey.a);
        EXPECT_EQ(at(behind, kBetween), kGrey) << "no pane lies before it";
        for (const glm::vec4& pixel : before) ASSERT_EQ(pixel, kGrey) << "the wall stands before everything";
    }
}

TEST_F(HostLayersTest, WaterCoversWhatStandsInIt) {
    startWith({.hasWater = true});
    const std::vector<glm::vec4> behind = drawnOver(view(), kFar, kGrey), before = drawnOver(view(), kNear, kGrey);
    EXPECT_GT(glm::distance(at(behind, kInWater), kGrey), 0.05f);
    EXPECT_GT(at(behind, kInWater).b, at(behind, kInWater).r) << "water takes red first";
    EXPECT_EQ(at(behind, kBetween), kGrey) << "above the water";
    for (const glm::vec4& pixel : before) ASSERT_EQ(pixel, kGrey);
}

TEST_F(HostLayersTest, FogTakesTheShareOfLightThatItsLengthTakes) {
    constexpr float kDensity = 0.05f;
    startWith({.fog = kDensity});
    View seen = view();
    seen.isLinear = true;
    for (const double metres : {kNear, kFar}) {
        const std::vector<glm::vec4> dark = drawnOver(seen, metres, {0.0f, 0.0f, 0.0f, 1.0f}, kSize.y / 2),
                                     light = drawnOver(seen, metres, glm::vec4(1.0f), kSize.y / 2);
        const double left = double(at(light, kBetween).g - at(dark, kBetween).g);
        const double tangent = std::tan(0.4) * (2.0 * (kBetween.y + 0.5) / kSize.y - 1.0);
        EXPECT_NEAR(left, std::exp(-double(kDensity) * metres * std::sqrt(1.0 + tangent * tangent)), 0.01) << metres;
        EXPECT_GT(at(dark, kBetween).g, 0.01f) << "fog is lit";
    }
}

TEST_F(HostLayersTest, SmokeCoversWhatStandsBehindIt) {
    startWith({.hasSmoke = true});
    const std::vector<glm::vec4> behind = drawnOver(view(), kFar, glm::vec4(1.0f)),
                                 before = drawnOver(view(), kNear, glm::vec4(1.0f));
    EXPECT_LT(at(behind, kSize / 2).g, 0.9f);
    for (const glm::vec4& pixel : before) ASSERT_EQ(pixel, glm::vec4(1.0f));
}

TEST_F(HostLayersTest, ReversedOrthographicAndUpscaledViewsHaveThemToo) {
    RenderSettings settings;
    settings.resolutionScale = 0.75f;
    startWith({.hasPane = true}, settings);
    View perspective = view(), reversed = view(), orthographic = view();
    reversed.projection->clipFromEye = glm::perspectiveZO(0.8, double(kSize.x) / kSize.y, 100.0, 0.1);
    reversed.projection->isZeroToOne = true;
    orthographic.projection->clipFromEye = glm::ortho(-5.0, 5.0, -3.0, 3.0, -20.0, 100.0);
    for (const View& each : {perspective, reversed, orthographic}) {
        const std::vector<glm::vec4> behind = drawnOver(each, kFar, kGrey), before = drawnOver(each, kNear, kGrey);
        EXPECT_LT(at(behind, kInPane).g, 0.75f * kGrey.g);
        EXPECT_EQ(at(behind, kBetween), kGrey);
        EXPECT_EQ(at(before, kInPane), kGrey);
    }
}

TEST_F(HostLayersTest, WhatIsNotThereCostsNothing) {
    startWith({});
    drawnOver(view(), kFar, kGrey);
    EXPECT_FALSE(hasRun("host layers")) << "nothing can cover the host's image";
    const uint64_t bytes = renderer->stats().textureBytes;
    const auto drawAlone = [&] {
        View alone = view();
        alone.projection->composesDepth = false;
        for (int i = 0; i < kFrames; ++i) renderer->draw(alone, 1.0f);
    };
    startWith({.hasPane = true, .hasWater = true, .fog = 0.03f});
    drawAlone();
    EXPECT_FALSE(hasRun("host layers")) << "the host gave no depth";
    EXPECT_FALSE(hasRun("exact depth"));
    EXPECT_FALSE(renderer->readTarget("hostColor"));
    startWith({});
    drawAlone();
    EXPECT_EQ(renderer->stats().textureBytes, bytes);
}

}  // namespace
}  // namespace rubble
