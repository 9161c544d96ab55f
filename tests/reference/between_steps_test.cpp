// Bodies that are drawn between two steps, while the shadow volume holds the newest one: nothing beside them is black.
// RUBBLE_IMAGES=FOLDER writes the image at rest and those in motion.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "tests/golden/drawing.h"
#include "tests/reference/display.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(240, 150);
constexpr glm::dquat kLevel(1, 0, 0, 0);
enum Entry : uint8_t { kGround = 1, kCrate };

PaletteRef palette() {
    auto palette = std::make_shared<Palette>();
    for (const auto& [index, red, green, blue] : {std::array{1, 190, 188, 180}, std::array{2, 200, 60, 50}}) {
        PaletteEntry& e = (*palette)[size_t(index)];
        e.red = uint8_t(red), e.green = uint8_t(green), e.blue = uint8_t(blue), e.material = 1;
    }
    return palette;
}

float luminance(const glm::vec4& p) {
    return 0.2126f * p.r + 0.7152f * p.g + 0.0722f * p.b;
}

class BetweenSteps : public Drawing {
protected:
    void SetUp() override {
        Drawing::SetUp();
        m_scene.environment.sunDirection = {-0.6f, 0.5f, 0.3f};
        m_scene.add({200, 2, 200}, {{-10, -0.2, -12}, kLevel}, [](glm::ivec3) { return kGround; });
        m_crate = m_scene.add({10, 10, 10}, {kAt, kLevel}, [](glm::ivec3) { return kCrate; });
        m_camera.position = {0.5, 2.0, 3.0};
        m_camera.lookAt({0.4, 0.4, 0.0});
        RenderSettings settings;
        settings.temporal = false, settings.skyRays = 16, settings.sunRays = 2;
        start(m_scene, kSize, settings);
    }
    FloatImage drawAt(float alpha) {
        renderer->draw(m_camera.view(kSize, target->framebuffer()), alpha);
        return read("radiance");
    }
    /// Moves the crate in one step; no pixel may get much darker than the darkest one at rest.
    void expectNothingBlack(const char* name, glm::dvec3 by, double turn, int most = 0) {
        const FloatImage rest = drawAt(1.0f);
        float darkest = 1e9f;
        for (const glm::vec4& pixel : rest.pixels) darkest = std::min(darkest, luminance(pixel));
        m_scene.move(m_crate, {kAt + by, glm::angleAxis(turn, glm::dvec3(0, 1, 0))});
        renderer->apply(m_scene.step());
        std::vector<Image> sheet{reference::toImage(reference::displayed(rest, 1.0f))};
        for (const float alpha : {0.0f, 0.5f}) {
            const FloatImage moving = drawAt(alpha);
            const auto black = std::ranges::count_if(
                moving.pixels, [&](const glm::vec4& pixel) { return luminance(pixel) < 0.5f * darkest; });
            printf("%s at %.1f: %d pixels are black\n", name, double(alpha), int(black));
            EXPECT_LE(black, most) << name << " at " << alpha;
            sheet.push_back(reference::toImage(reference::displayed(moving, 1.0f)));
        }
        if (const char* folder = std::getenv("RUBBLE_IMAGES")) {
            EXPECT_TRUE(writePng(std::string(folder) + "/between_" + name + ".png", tile(sheet, 3)));
        }
    }
    static constexpr glm::dvec3 kAt{-0.5, 0.0, -0.5};
    LitScene m_scene{palette()};
    ShapeHandle m_crate;
    Camera m_camera;
};

TEST_F(BetweenSteps, ABodyThatSlidesDarkensNothing) {
    expectNothingBlack("slide", {0.2, 0, 0}, 0.0);
}

TEST_F(BetweenSteps, ABodyThatComesNearerDarkensNothing) {
    expectNothingBlack("nearer", {0.05, 0, 0.2}, 0.0);
}

TEST_F(BetweenSteps, ABodyThatTurnsDarkensNothing) {
    expectNothingBlack("turn", {0.1, 0, 0.05}, 0.2);
}

TEST_F(BetweenSteps, ABodyThatFallsDarkensNothing) {
    m_scene.move(m_crate, {kAt + glm::dvec3(0, 0.3, 0), kLevel});
    renderer->apply(m_scene.step());
    expectNothingBlack("fall", {0, 0.1, 0}, 0.0, 6);  // the gap below it gets narrow
}

}  // namespace
}  // namespace rubble
