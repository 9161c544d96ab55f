// Ghosts: two frames after a change the image is that of a renderer that has never seen what was before. Beside that
// is printed how far two images are apart that have nothing to remember: no image can be expected to be nearer.
// RUBBLE_IMAGES=FOLDER writes for each case: the drawn image, the expected one and their FLIP map, side by side, and
// below them the frames after the change. RUBBLE_WIDTH=PIXELS draws wider images than 240x135: in small ones edges,
// which are never alike after two frames, are a large share.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "render/frame/shader_constants.h"
#include "tests/golden/drawing.h"
#include "tests/reference/display.h"
#include "tests/reference/flip.h"

namespace rubble {
namespace {

constexpr int kFramesAfter = 2, kFramesShown = 6, kFramesBefore = 16, kFreshFrames = 32;
constexpr int kOtherJitter = 17;  ///< frames later, jitter and random numbers are others
const glm::ivec2 kSize = [] {
    const char* width = std::getenv("RUBBLE_WIDTH");
    const int pixels = width ? std::clamp(std::atoi(width), 240, 1920) : 240;
    return glm::ivec2(pixels, pixels * 9 / 16);
}();
constexpr double kAway = 1.58;  ///< radians to turn by, to see nothing of what was seen

enum Entry : uint8_t { kGround = 1, kPlaster, kBrick, kDark, kSteel, kBulb, kTinted, kPolished, kEntries };
constexpr glm::dquat kLevel(1, 0, 0, 0);

PaletteRef palette(bool bulbShines = true) {
    auto palette = std::make_shared<Palette>();
    const auto entry = [&](int index, uint32_t rgb, uint8_t roughness = 230) -> PaletteEntry& {
        PaletteEntry& e = (*palette)[size_t(index)];
        e.red = uint8_t(rgb >> 16), e.green = uint8_t(rgb >> 8), e.blue = uint8_t(rgb);
        e.roughness = roughness, e.reflectivity = 10, e.material = 1;
        return e;
    };
    entry(kGround, 0x6d6a60), entry(kPlaster, 0xd2cdbe), entry(kBrick, 0x96503c), entry(kDark, 0x3c3e46);
    entry(kSteel, 0x6f7780), entry(kPolished, 0x60544a, 60).reflectivity = 20;
    entry(kTinted, 0x5aaa6e, 10).opacity = 110;
    entry(kBulb, 0xffd9a0).emission = bulbShines ? 12.0f : 0.0f;
    return palette;
}

uint8_t checks(glm::ivec3 c) {
    return (c.x / 8 + c.z / 8) % 2 ? kGround : kDark;
}
std::function<uint8_t(glm::ivec3)> all(uint8_t entry) {
    return [=](glm::ivec3) { return entry; };
}

/// A scene with what may change in it.
struct Stage {
    std::string name;
    LitScene scene{palette()};
    Camera camera;
    std::vector<SnapshotLight> lights;  ///< the first one may change
    std::vector<SnapshotRope> wires;
    std::vector<SnapshotParticle> particles;
    ShapeHandle roof, bulb;
    glm::dvec3 spark{0.0};  ///< where sparks fly by

    void look(glm::dvec3 from, glm::dvec3 at) {
        camera.position = from;
        camera.lookAt(at);
    }
    void addBulb(glm::dvec3 place, float intensity) {
        SnapshotLight light{
            LightKind::Sphere, place, {0, -1, 0}, glm::vec3(1.0f, 0.72f, 0.43f) * intensity, 0.1f, 12.0f, 0.6f, 1.1f};
        light.light = LightHandle::make(1, 1, uint32_t(lights.size()));
        lights.push_back(light);
        const ShapeHandle cube = scene.add({2, 2, 2}, {place - 0.1, kLevel}, all(kBulb));
        if (lights.size() == 1) bulb = cube;
    }
    FrameSnapshot with(FrameSnapshot snapshot) const {
        snapshot.lights = lights, snapshot.ropes = wires, snapshot.particles = particles;
        snapshot.lightsChanged = snapshot.ropesChanged = snapshot.particlesChanged = true;
        return snapshot;
    }
};

Stage street() {
    Stage s{.name = "street", .scene = LitScene(palette())};
    Environment& air = s.scene.environment;
    air.sunDirection = {-0.5f, 0.45f, 0.6f};
    air.sunColor = {11.5f, 8.7f, 5.7f};
    s.scene.add({240, 2, 240}, {{-12, -0.2, -18}, kLevel}, checks);
    s.scene.add({60, 40, 4}, {{-6, 0, -6}, kLevel}, [](glm::ivec3 c) { return c.y / 3 % 2 ? kBrick : kPlaster; });
    for (int i = 0; i < 5; ++i)
        s.scene.add({3, 22, 3}, {{-4.0 + 2.0 * i, 0, -1.5}, glm::angleAxis(0.3 * i, glm::dvec3(0, 1, 0))}, all(kSteel));
    s.roof = s.scene.add({50, 2, 20}, {{-2.0, 2.4, -3}, kLevel}, all(kBrick));
    s.addBulb({2.0, 1.4, -1.0}, 16.0f);
    s.look({0, 1.7, 5}, {0.5, 1.6, -3});
    s.spark = {0, 1.8, 1.0};
    return s;
}

Stage hall() {
    Stage s{.name = "hall", .scene = LitScene(palette())};
    s.scene.environment.sunDirection = {-0.3f, 0.8f, 0.3f};
    s.scene.add({90, 34, 90}, {{-4.5, -0.2, -6}, kLevel}, [](glm::ivec3 c) -> uint8_t {
        if (c.y < 2) return checks(c);
        const bool wall = c.x < 2 || c.z < 2 || c.x >= 88 || c.z >= 88,
                   window = c.z < 2 && c.x / 12 % 2 && c.y / 10 == 1;
        return wall && !window ? kPlaster : 0;
    });
    s.roof = s.scene.add({90, 2, 90}, {{-4.5, 3.2, -6}, kLevel}, all(kBrick));
    s.scene.add({8, 9, 14}, {{-1.0, 0, -2.5}, glm::angleAxis(0.4, glm::dvec3(0, 1, 0))}, all(kBrick));
    s.addBulb({0.6, 2.4, -2.0}, 8.0f);
    s.addBulb({-2.6, 2.4, 1.0}, 3.0f);
    s.look({1.5, 1.7, 2.4}, {-0.5, 1.1, -3});
    s.spark = {0.5, 1.6, 0.0};
    return s;
}

Stage night() {
    Stage s{.name = "night", .scene = LitScene(palette())};
    Environment& air = s.scene.environment;
    air.sunDirection = {0.3f, -0.5f, 0.3f};
    air.sunColor = glm::vec3(0.0f);
    air.skyColor = {0.012f, 0.016f, 0.035f}, air.horizonColor = {0.03f, 0.03f, 0.04f};
    air.groundColor = air.fogColor = {0.012f, 0.012f, 0.014f};
    air.clouds = 0.0f, air.stars = 6.0f;
    s.scene.add({240, 2, 240}, {{-12, -0.2, -18}, kLevel}, checks);
    s.scene.add({30, 24, 20}, {{-5, 0, -5}, kLevel}, all(kPlaster));
    s.roof = s.scene.add({34, 2, 40}, {{-0.5, 2.2, -4}, kLevel}, all(kBrick));
    for (const double x : {-2.2, 0.4, 3.2}) {
        s.scene.add({1, 30, 1}, {{x, 0, -1.0}, kLevel}, all(kSteel));
        s.addBulb({x + 0.2, 2.9, -0.8}, 10.0f);
    }
    for (int i = 0; i < 3; ++i) {
        SnapshotRope wire;
        for (int k = 0; k <= 8; ++k)
            wire.current.emplace_back(-8.0 + 2.0 * k, 4.4 + 0.3 * i - 0.02 * k * (8 - k), -3.0 - 0.4 * i);
        wire.previous = wire.current, wire.radius = 0.012f, wire.color = glm::vec3(0.5f);
        s.wires.push_back(wire);
    }
    s.look({0, 1.6, 5}, {0.3, 2.3, -2});
    s.spark = {0, 2.4, 1.0};
    return s;
}

Stage greenhouse() {
    Stage s{.name = "greenhouse", .scene = LitScene(palette())};
    s.scene.environment.sunDirection = {0.3f, 0.7f, 0.5f};
    s.scene.add({200, 2, 200}, {{-10, -0.2, -14}, kLevel}, checks);
    s.scene.add({80, 26, 1}, {{-4, 0, 0}, kLevel},
                [](glm::ivec3 c) { return c.x % 16 < 2 || c.y < 3 || c.y > 23 ? kPlaster : kTinted; });
    s.scene.add({80, 1, 30}, {{-4, 2.6, -3}, kLevel}, [](glm::ivec3 c) { return c.x % 16 < 2 ? kPlaster : kTinted; });
    s.scene.add({80, 26, 2}, {{-4, 0, -3}, kLevel}, [](glm::ivec3 c) { return c.x / 5 % 2 ? kPlaster : kBrick; });
    s.scene.add({6, 14, 6}, {{-1.2, 0, -1.6}, kLevel}, all(kBrick));
    s.roof = s.scene.add({50, 2, 34}, {{-2, 3.2, -2.4}, kLevel}, all(kBrick));
    s.addBulb({1.4, 1.9, -1.2}, 8.0f);
    s.look({0.4, 1.6, 4}, {-0.1, 1.3, 0});
    s.spark = {0, 1.6, 1.4};
    return s;
}

Stage polished() {
    Stage s{.name = "polished", .scene = LitScene(palette())};
    Environment& air = s.scene.environment;
    air.sunDirection = {-0.8f, 0.25f, -0.3f};
    air.sunColor = {6.0f, 3.6f, 1.8f};
    s.scene.add({200, 2, 200}, {{-10, -0.2, -14}, kLevel}, all(kPolished));
    for (int i = 0; i < 6; ++i)
        s.scene.add({5, 16 + 3 * (i % 3), 5}, {{-4.0 + 1.6 * i, 0, -2.0 - 0.5 * (i % 2)}, kLevel},
                    all(i % 2 ? kBrick : kPlaster));
    s.roof = s.scene.add({40, 2, 30}, {{-4.2, 2.4, -3.4}, kLevel}, all(kDark));
    s.addBulb({1.0, 1.2, -1.0}, 6.0f);
    s.look({0.4, 1.5, 4}, {0, 1.0, -1});
    s.spark = {0, 1.5, 1.4};
    return s;
}

class StageTest : public Drawing {
protected:
    void begin(Stage stage) {
        m_stage = std::move(stage);
        start(m_stage.scene, kSize);
        renderer->apply(m_stage.with(m_stage.scene.step()));
        draw(m_stage.camera, kFramesBefore);
    }
    void apply() { renderer->apply(m_stage.with(m_stage.scene.step())); }
    Stage m_stage;
};

class Ghosts : public StageTest, public testing::WithParamInterface<Stage (*)()> {
protected:
    void SetUp() override {
        Drawing::SetUp();
        begin(GetParam()());
    }
    /// The last frames, without adaptation of the exposure.
    FloatImage resolvedAfter(int frames) {
        draw(m_stage.camera, frames);
        return read("resolved");
    }
    /// FLIP between what is drawn kFramesAfter frames after the change and the same drawn fresh.
    void expectNoGhost(const char* change, double limit) {
        const char* folder = std::getenv("RUBBLE_IMAGES");
        std::vector<FloatImage> after;
        for (int i = 0; i < (folder ? kFramesShown : kFramesAfter); ++i) after.push_back(resolvedAfter(1));
        const FloatImage& found = after[kFramesAfter - 1];
        FrameSnapshot now = m_stage.with(m_stage.scene.snapshot());
        if (m_isLightOut) now.palettes.push_back({m_stage.bulb, palette(false), nullptr});
        renderer->apply(std::move(now));
        cutTo(m_stage.camera);
        const FloatImage started = resolvedAfter(kFramesAfter - 1);
        const FloatImage expected = resolvedAfter(kFreshFrames);
        const FloatImage expectedLater = resolvedAfter(kOtherJitter);
        Camera away = m_stage.camera;
        away.yaw += kAway;
        cutTo(away);
        const FloatImage startedLater = resolvedAfter(kFramesAfter);
        const float exposure = reference::exposureFor(expected, m_stage.scene.environment.exposure);
        const FloatImage shown = reference::displayed(found, exposure),
                         fresh = reference::displayed(expected, exposure);
        const double difference = reference::flip(fresh, shown);
        const std::string name = m_stage.name + "_" + change;
        if (folder) {
            std::vector<Image> sheet{reference::toImage(shown), reference::toImage(fresh),
                                     reference::toImage(reference::flipMap(fresh, shown))};
            for (const FloatImage& each : after)
                sheet.push_back(reference::toImage(reference::displayed(each, exposure)));
            EXPECT_TRUE(writePng(std::string(folder) + "/" + name + ".png", tile(sheet, 3)));
        }
        const auto flipOf = [&](const FloatImage& a, const FloatImage& b) {
            return reference::flip(reference::displayed(a, exposure), reference::displayed(b, exposure));
        };
        printf(
            "%s: FLIP %.4f of a converged image (another such image: %.4f; one begun with the change: %.4f), "
            "%.4f of one begun with the change (another such image: %.4f)\n",
            name.c_str(), difference, flipOf(expected, expectedLater), flipOf(expected, started),
            flipOf(started, found), flipOf(started, startedLater));
        EXPECT_LE(difference, limit) << name;
    }
    /// One frame, of which nothing is known.
    void cutTo(const Camera& camera) {
        View view = camera.view(kSize, target->framebuffer());
        view.cut = true;
        renderer->draw(view, 1.0f);
    }
    bool m_isLightOut = false;
};

TEST_P(Ghosts, ASparkLeavesNoTrace) {
    for (int i = 0; i < 8; ++i) {
        SnapshotParticle spark{ParticleKind::Spark,
                               m_stage.spark + glm::dvec3(0.2 * i - 0.8, 0.05 * i, 0.0),
                               {12, 3, 0},
                               {1.0f, 0.6f, 0.25f},
                               0.02f,
                               1.0f,
                               0.1f,
                               7u};
        SnapshotParticle dust = spark, crumb = spark;
        dust.kind = ParticleKind::Dust, dust.position.y -= 0.5, dust.radius = 0.3f, dust.color = glm::vec3(0.5f);
        crumb.kind = ParticleKind::Crumb, crumb.position.y += 0.4, crumb.radius = 0.05f, crumb.color = glm::vec3(0.4f);
        m_stage.particles = {spark, dust, crumb};
        apply();
        draw(m_stage.camera);
    }
    m_stage.particles.clear();
    apply();
    expectNoGhost("spark", 0.026);
}

TEST_P(Ghosts, ACameraThatStrafedLeavesNoTrace) {
    const Camera last = m_stage.camera;
    for (int i = 12; i > 0; --i) {
        m_stage.camera.position = last.position - glm::dvec3(0.05 * i, 0, 0);
        draw(m_stage.camera);
    }
    m_stage.camera = last;
    expectNoGhost("strafe", 0.041);
}

TEST_P(Ghosts, ARecolouredLightHasItsNewColour) {
    m_stage.lights[0].color = glm::vec3(0.2f, 0.5f, 1.0f) * m_stage.lights[0].color.r;
    apply();
    expectNoGhost("recolour", 0.04);
}

TEST_P(Ghosts, AFlickeringLightHasLittleNoise) {
    const glm::vec3 color = m_stage.lights[0].color;
    for (int i = 0; i < 24; ++i) {
        m_stage.lights[0].color = color * (0.7f + 0.3f * float(std::sin(2.1 * i)));
        apply();
        draw(m_stage.camera);
    }
    m_stage.lights[0].color = color * 0.6f;
    apply();
    expectNoGhost("flicker", m_stage.name == "hall" ? 0.049 : 0.04);
}

TEST_P(Ghosts, ARemovedRoofLetsTheLightIn) {
    m_stage.scene.edit(m_stage.roof, all(0));
    apply();
    // Two jittered samples by night are that far from many. A room's light comes from all around, by many bounces.
    expectNoGhost("roof", m_stage.name == "hall" ? 0.03 : 0.041);
}

TEST_P(Ghosts, ALightThatGoesOutLeavesNoGlow) {
    m_stage.lights.erase(m_stage.lights.begin());
    FrameSnapshot now = m_stage.with(m_stage.scene.step());
    now.palettes.push_back({m_stage.bulb, palette(false), nullptr});
    renderer->apply(std::move(now));
    m_isLightOut = true;
    expectNoGhost("out", m_stage.name == "night" ? 0.03 : 0.04);
}

TEST_P(Ghosts, AStillImageStaysStill) {
    constexpr int kFrames = 32;
    draw(m_stage.camera, 24);
    std::vector<FloatImage> frames;
    for (int i = 0; i < kFrames; ++i) frames.push_back(resolvedAfter(1));
    const float exposure = reference::exposureFor(frames[0], m_stage.scene.environment.exposure);
    for (FloatImage& each : frames) each = reference::displayed(each, exposure);
    double all = 0.0, worst = 0.0, sharp = 0.0;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 1; x < kSize.x; ++x) {
            double sum = 0.0, squares = 0.0;
            for (const FloatImage& each : frames) {
                const double v = each.at(x, y).y;
                sum += v / kFrames, squares += v * v / kFrames;
            }
            const double variance = std::max(squares - sum * sum, 0.0);
            all += variance, worst = std::max(worst, variance);
            sharp += std::abs(frames.back().at(x, y).y - frames.back().at(x - 1, y).y);
        }
    const double pixels = double(kSize.x * kSize.y);
    printf("%s_still: deviation %.5f, worst %.4f, gradient %.5f\n", m_stage.name.c_str(), std::sqrt(all / pixels),
           std::sqrt(worst), sharp / pixels);
    EXPECT_LE(std::sqrt(all / pixels), 0.006) << "of 1: it flickers";
}

/// Rays after a change (shaders/lib/change_rays.glsl).
class ChangeRays : public StageTest {
protected:
    bool asks() const { return std::ranges::count(renderer->stats().passes, std::string_view("history left")) == 1; }
    /// The share of pixels that are sent more rays than one.
    double shareWithMore() {
        draw(m_stage.camera);
        if (!asks()) return 0.0;
        const FloatImage left = read("historyLeft");
        return double(std::ranges::count_if(left.pixels, [](glm::vec4 pixel) { return pixel.w > 0.5f; })) /
               double(left.pixels.size());
    }
    void recolour(glm::vec3 color) {
        m_stage.lights[0].color = color;
        apply();
    }
};

TEST_F(ChangeRays, ComeForTwoFramesAfterAChange) {
    begin(night());
    EXPECT_LT(shareWithMore(), 0.002) << "nothing has changed but the jitter";
    recolour({2, 5, 10});
    EXPECT_GT(shareWithMore(), 0.2);
    EXPECT_GT(shareWithMore(), 0.2);
    for (int i = 0; i < 3; ++i) EXPECT_LT(shareWithMore(), 0.02) << i + 3 << " frames after the change";
}

TEST_F(ChangeRays, DoNotComeWhereEachFrameChanges) {
    begin(night());
    for (int i = 0; i < 6; ++i) {
        recolour(i % 2 ? glm::vec3(10, 5, 2) : glm::vec3(2, 5, 10));
        const double share = shareWithMore();
        if (i >= 2) {
            // At the rim of what has changed much, tiles say otherwise than pixels.
            EXPECT_LT(share, 0.05) << "change " << i;
        }
    }
}

TEST_F(ChangeRays, HistoryIsAskedForOnlyAfterAChange) {
    const auto nextAsks = [&] {
        draw(m_stage.camera);
        return asks();
    };
    begin(night());
    EXPECT_FALSE(nextAsks()) << "nothing has changed";
    recolour({2, 5, 10});
    EXPECT_TRUE(nextAsks() && nextAsks());
    EXPECT_FALSE(nextAsks()) << "two frames after a light's change";
    m_stage.scene.edit(m_stage.roof, all(0));
    apply();
    EXPECT_TRUE(nextAsks() && nextAsks());
    EXPECT_FALSE(nextAsks()) << "two frames after the roof has gone";
}

/// What anti-aliasing keeps of the sky after a bulb has other colours, with and without a pane in the level.
class SkyHistory : public StageTest {
protected:
    /// Of the tiles that show nothing but sky: the share whose history is not kept whole.
    double shareDropped() {
        FrameSnapshot now = m_stage.with(m_stage.scene.step());
        now.palettes.push_back({m_stage.bulb, palette(false), nullptr});
        renderer->apply(std::move(now));
        draw(m_stage.camera);
        const FloatImage kept = read("historyConfidence"), depth = read("depth");
        int sky = 0, dropped = 0;
        for (int y = 1; y + 2 < kept.size.y; ++y)
            for (int x = 1; x + 2 < kept.size.x; ++x) {
                bool isSky = true;
                for (int i = 0; i < 36; ++i)
                    isSky = isSky && depth.at(4 * x + i % 6 - 1, 4 * y + i / 6 - 1).x >= shared::kSkyDepth;
                sky += isSky, dropped += isSky && kept.at(x, y).z < 0.99f;
            }
        return dropped / double(sky);
    }
};

TEST_F(SkyHistory, OutlastsAPaletteByNight) {
    begin(night());
    EXPECT_LT(shareDropped(), 0.01) << "these tiles show no part of the bulb";
}
TEST_F(SkyHistory, OutlastsAPaletteBehindPanes) {
    begin(greenhouse());
    EXPECT_LT(shareDropped(), 0.01);
}

INSTANTIATE_TEST_SUITE_P(EachScene, Ghosts, testing::Values(street, hall, night, greenhouse, polished),
                         [](const auto& each) { return each.param().name; });

}  // namespace
}  // namespace rubble
