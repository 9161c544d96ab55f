// Full-screen passes by fragments and by compute programs: the same numbers in every target.
#include <cmath>
#include <cstring>

#include "tests/golden/drawing.h"

namespace rubble {
namespace {

/// In the order drawn: the first that differs names the pass.
constexpr const char* kTargets[] = {"albedo",      "material", "light",    "specular",   "lightPulse", "lightTrusted",
                                    "accumulated", "surface",  "lighting", "reflection", "radiance",   "fogLight",
                                    "fog",         "resolved", "bloom0",   "exposure",   "final"};

/// All that full-screen passes draw: sun, sky, lamps, wet ground, glass, mirrors, fog, a water.
FrameSnapshot everything(LitScene scene, bool withWater = false) {
    scene.environment.wetness = 0.8f;
    scene.environment.fogDensity = 0.02f;
    scene.addLight({LightKind::Sphere, {-1.0, 2.0, -3.0}, {0, -1, 0}, {4.0f, 9.0f, 14.0f}, 0.1f, 6.0f, 0.0f, 0.0f});
    FrameSnapshot snapshot = scene.snapshot();
    Water water;
    water.outline = {{0.5, -8.0}, {6.0, -8.0}, {6.0, -4.5}, {0.5, -4.5}};
    water.surface = 0.15;
    if (withWater) snapshot.waters = {water};
    snapshot.watersChanged = true;
    return snapshot;
}

struct Difference {
    int count = 0;  ///< of numbers
    float most = 0.0f;
};

Difference difference(const FloatImage& a, const FloatImage& b) {
    Difference found;
    for (size_t i = 0; i < a.pixels.size(); ++i)
        for (int c = 0; c < 4; ++c) {
            if (std::memcmp(&a.pixels[i][c], &b.pixels[i][c], sizeof(float)) == 0) continue;
            ++found.count;
            found.most = std::max(found.most, std::abs(a.pixels[i][c] - b.pixels[i][c]));
        }
    return found;
}

class FullscreenTest : public GlTest {
protected:
    struct Drawn {
        std::unique_ptr<Renderer> renderer;
        void apply(FrameSnapshot snapshot) { renderer->apply(std::move(snapshot)); }
    };
    std::unique_ptr<Renderer> make(Fullscreen fullscreen, RenderSettings settings = {}) {
        settings.fullscreen = fullscreen;
        auto made = Renderer::create(testContext().loader(), shaderFolder(), settings);
        EXPECT_TRUE(made) << made.error();
        return std::move(made).value();
    }
    /// Draws the same pictures with both and compares every target after each.
    void expectSame(Renderer& a, Renderer& b, glm::ivec2 size, int frames) {
        const Offscreen target(size);
        for (int frame = 0; frame < frames; ++frame) {
            Camera camera = streetCamera(0);
            camera.position.x += 0.02 * frame;
            for (Renderer* each : {&a, &b}) each->draw(camera.view(size, target.framebuffer()), 1.0f);
            for (const char* name : kTargets) {
                const auto first = a.readTarget(name), second = b.readTarget(name);
                ASSERT_EQ(bool(first), bool(second)) << name;
                if (!first) continue;
                const Difference found = difference(*first, *second);
                EXPECT_EQ(found.count, 0) << name << " in frame " << frame << " differs by up to " << found.most;
            }
        }
    }
};

TEST_F(FullscreenTest, ComputeDrawsWhatFragmentsDraw) {
    const auto a = make(Fullscreen::Fragment), b = make(Fullscreen::Compute);
    for (Renderer* each : {a.get(), b.get()}) each->apply(everything(streetScene()));
    expectSame(*a, *b, {96, 64}, 6);
    expectSame(*a, *b, {61, 37}, 3);
    expectSame(*a, *b, {256, 192}, 3);
    EXPECT_EQ(a->figures().computePrograms, 0);
    EXPECT_TRUE(a->figures().computePasses.empty());
    EXPECT_EQ(a->figures().textureBytes, b->figures().textureBytes);
    EXPECT_GE(b->figures().computePasses.size(), 13u);
}

}  // namespace
}  // namespace rubble
