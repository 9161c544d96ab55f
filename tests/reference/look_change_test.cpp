// Changes of palettes, sun and air, and of the whole world: what was seen before leaves no trace, and what changes
// slowly stays smooth.
// RUBBLE_IMAGES=FOLDER writes for each case the first frames after the change and the converged one.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "runtime/core/constants.h"
#include "tests/golden/drawing.h"
#include "tests/reference/display.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(240, 150);
constexpr int kFramesBefore = 32, kConvergedFrames = 48, kFramesAfter = 3;
constexpr glm::dquat kLevel(1, 0, 0, 0);
constexpr float kVisible = 24.0f / 255.0f;  ///< of a channel of the display

enum Entry : uint8_t { kGround = 1, kLight, kDark, kWood, kEntries };

PaletteRef palette(uint32_t light = 0xf0f0eb, uint32_t dark = 0xc8c8c0) {
    auto palette = std::make_shared<Palette>();
    const uint32_t colors[kEntries] = {0, 0x8a8780, light, dark, 0x8c5a32};
    for (size_t i = 1; i < kEntries; ++i) {
        PaletteEntry& e = (*palette)[i];
        e.red = uint8_t(colors[i] >> 16), e.green = uint8_t(colors[i] >> 8), e.blue = uint8_t(colors[i]);
        e.roughness = 230, e.reflectivity = 10, e.material = 1;
    }
    return palette;
}

class LookChange : public Drawing {
protected:
    void SetUp() override {
        Drawing::SetUp();
        const auto all = [](uint8_t entry) { return [=](glm::ivec3) { return entry; }; };
        m_scene.environment.sunDirection = {-0.6f, 0.5f, 0.5f};
        m_scene.environment.clouds = 0.0f;
        m_scene.add({200, 2, 200}, {{-10, -0.2, -12}, kLevel}, all(kGround));
        m_wall = m_scene.add({40, 25, 2}, {{-2, 0, -3}, kLevel},
                             [](glm::ivec3 c) -> uint8_t { return (c.x / 3 + c.y / 3) % 2 ? kLight : kDark; });
        m_cube = m_scene.add({10, 10, 10}, {{0.6, 0, -1.4}, kLevel}, all(kWood));
        m_camera.position = {1.0, 2.0, 3.0};
        m_camera.lookAt({0.0, 1.1, -3.0});
        start(m_scene, kSize);
        draw(m_camera, kFramesBefore);
    }
    void recolour(PaletteRef palette) {
        m_palette = std::move(palette);
        FrameSnapshot now = m_scene.step();
        now.palettes.push_back({m_wall, m_palette, nullptr});
        renderer->apply(std::move(now));
    }
    FloatImage next() {
        draw(m_camera);
        return read("resolved");
    }
    void cut() {
        View view = m_camera.view(kSize, target->framebuffer());
        view.cut = true;
        renderer->draw(view, 1.0f);
    }
    FloatImage converged() {
        cut();
        draw(m_camera, kConvergedFrames - 1);
        return next();
    }
    /// Shares of pixels that visibly differ from the converged image, in each of the next frames.
    std::vector<double> wrongShares(const char* name, int frames = kFramesAfter) {
        std::vector<FloatImage> after;
        for (int i = 0; i < frames; ++i) after.push_back(next());
        const FloatImage expected = converged();
        const float exposure = reference::exposureFor(expected, 1.0f);
        const FloatImage shown = reference::displayed(expected, exposure);
        std::vector<double> shares;
        std::vector<Image> sheet;
        for (const FloatImage& each : after) {
            const FloatImage frame = reference::displayed(each, exposure);
            size_t wrong = 0;
            for (size_t i = 0; i < frame.pixels.size(); ++i) {
                const glm::vec3 off = glm::abs(glm::vec3(frame.pixels[i]) - glm::vec3(shown.pixels[i]));
                wrong += std::max({off.x, off.y, off.z}) > kVisible;
            }
            shares.push_back(double(wrong) / double(frame.pixels.size()));
            sheet.push_back(reference::toImage(frame));
        }
        sheet.push_back(reference::toImage(shown));
        printf("%s: share of pixels off by frame:", name);
        for (const double share : shares) printf(" %.4f", share);
        printf("\n");
        if (const char* folder = std::getenv("RUBBLE_IMAGES")) {
            EXPECT_TRUE(writePng(std::string(folder) + "/look_" + name + ".png", tile(sheet, 2)));
        }
        return shares;
    }
    /// kFramesAfter frames after the change hardly more is off than in an image that begins with it.
    void expectNoTrace(const char* name) {
        const double after = wrongShares(name).back(), fresh = freshShare();
        EXPECT_LE(after, 1.2 * fresh + 0.002);
    }
    double freshShare() {
        cut();
        draw(m_camera, kFramesAfter - 2);
        return wrongShares("fresh", 1).back();
    }
    LitScene m_scene{palette()};
    ShapeHandle m_wall, m_cube;
    Camera m_camera;
    PaletteRef m_palette;
};

TEST_F(LookChange, ARecolouredShapeLeavesNoOutlines) {
    recolour(palette(0x143cdc, 0x1030a0));
    expectNoTrace("recolour");
}

TEST_F(LookChange, AColourThatFadesKeepsItsHistory) {
    for (uint32_t i = 1; i <= 8; ++i) {
        recolour(palette(0xf0f0eb - 0x010101 * i, 0xc8c8c0 - 0x010101 * i));
        draw(m_camera);
        const FloatImage confidence = read("historyConfidence"), surface = read("surface");
        EXPECT_GE(confidence.at(20, 15).z, 0.89f);
        EXPECT_GE(surface.at(120, 70).z, float(kFramesBefore) - 1.0f);
    }
}

TEST_F(LookChange, AReplacedWorldLeavesNothing) {
    m_scene.move(m_cube, {{-1.6, 0, -1.4}, kLevel});
    renderer->apply(m_scene.snapshot());
    expectNoTrace("replaced");
}

TEST_F(LookChange, ASunThatJumpsLightsAnew) {
    m_scene.environment.sunDirection = {0.6f, 0.5f, 0.5f};
    renderer->apply(m_scene.step());
    expectNoTrace("sun");
}

TEST_F(LookChange, ASunThatTurnsALittleLightsAnew) {
    m_scene.environment.sunDirection = {-0.5f, 0.5f, 0.5f};
    renderer->apply(m_scene.step());
    expectNoTrace("turn");
}

TEST_F(LookChange, NightFallsAtOnce) {
    Environment& air = m_scene.environment;
    air.sunDirection = {-0.6f, -0.5f, 0.5f};
    air.sunColor = glm::vec3(0.0f);
    air.skyColor = {0.03f, 0.04f, 0.08f}, air.horizonColor = air.fogColor = {0.04f, 0.04f, 0.05f};
    air.groundColor = {0.02f, 0.02f, 0.02f};
    renderer->apply(m_scene.step());
    expectNoTrace("night");
}

TEST_F(LookChange, FogComesAtOnce) {
    m_scene.environment.fogDistance = 6.0f;
    renderer->apply(m_scene.step());
    expectNoTrace("fog");
}

TEST_F(LookChange, ASlowSunKeepsItsHistory) {
    float least = 1e9f, colors = 1.0f;
    for (int i = 0; i < 32; ++i) {  // a day of ten minutes
        const double angle = double(i) * 2.0 * kPi / 36000.0;
        m_scene.environment.sunDirection =
            glm::vec3(glm::angleAxis(angle, glm::dvec3(0, 0, 1)) * glm::dvec3(-0.6, 0.5, 0.5));
        renderer->apply(m_scene.step());
        draw(m_camera);
        const FloatImage surface = read("surface"), confidence = read("historyConfidence");
        least = std::min(least, surface.at(60, 12).z);
        for (const glm::vec4& tile : confidence.pixels) colors = std::min(colors, tile.z);
    }
    EXPECT_GE(least, 24.0f) << "frames of history of the ground";
    EXPECT_GE(colors, 0.89f) << "of anti-aliasing's history";
    EXPECT_LE(wrongShares("slow", 1).back(), 0.002);
}

}  // namespace
}  // namespace rubble
