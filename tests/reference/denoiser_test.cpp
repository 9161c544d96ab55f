// The denoised image against the reference, and how soon it follows changes of light.
#include <cmath>
#include <cstdlib>

#include "generated/paths.h"
#include "tests/golden/drawing.h"
#include "tests/reference/display.h"
#include "tests/reference/exr_file.h"
#include "tests/reference/flip.h"
#include "tests/reference/views.h"

namespace rubble::reference {
namespace {

constexpr int kFrames = 16;

class DenoiserTest : public Drawing {
protected:
    /// FLIP of the view after 16 frames of one ray a pixel with a camera that stands still.
    double flipOf(SceneView& each, glm::ivec2 size, int samples) {
        each.view.size = size;
        const Estimate reference =
            cachedRender(Scene(each.snapshot), each.view, {.samples = samples, .filterPixels = true},
                         RUBBLE_BINARY_DIR "/reference", "the reference of " + each.name);
        auto made = Renderer::create(testContext().loader(), shaderFolder(), comparedSettings());
        EXPECT_TRUE(made) << made.error();
        (*made)->apply(FrameSnapshot(each.snapshot));
        const Offscreen offscreen(size);
        each.view.framebuffer = offscreen.framebuffer();
        for (int i = 0; i < kFrames; ++i) (*made)->draw(each.view, 1.0f);
        const auto drawn = (*made)->readTarget("resolved");
        EXPECT_TRUE(drawn) << drawn.error();
        const float exposure = exposureFor(reference.mean, each.snapshot.environment.exposure);
        return flip(displayed(reference.mean, exposure), displayed(*drawn, exposure));
    }
};

TEST_F(DenoiserTest, OneRayPerPixelComesNearTheReference) {
    if (!std::getenv("RUBBLE_LONG")) GTEST_SKIP() << "takes minutes: set RUBBLE_LONG=1";
    for (SceneView& each : heldOutViews()) {
        const double difference = flipOf(each, {640, 360}, 1024);
        printf("%s: FLIP %.4f\n", each.name.c_str(), difference);
        EXPECT_LE(difference, 0.035) << each.name;
    }
}

/// A floor under a weak sky, seen from above, whose light changes.
class ChangeTest : public Drawing {
protected:
    static constexpr glm::ivec2 kSize{96, 64};
    static PaletteRef gray() {
        auto palette = std::make_shared<Palette>();
        PaletteEntry& e = (*palette)[1];
        e.red = e.green = e.blue = 186;
        e.roughness = 255, e.material = 1;
        return palette;
    }
    static LitScene floorScene() {
        LitScene scene(gray());
        scene.environment.fogDistance = 1e6f;
        scene.add({120, 2, 120}, {{-6, -0.2, -6}}, [](glm::ivec3) { return uint8_t(1); });
        return scene;
    }
    void begin(const LitScene& scene) { start(scene, kSize, comparedSettings()); }
    static Camera above() {
        Camera camera;
        camera.position = {0.0, 5.0, 3.0};
        camera.lookAt({0, 0, 0});
        return camera;
    }
    FloatImage next() {
        renderer->draw(above().view(kSize, target->framebuffer()), 1.0f);
        return std::move(*renderer->readTarget("resolved"));
    }
    /// Mean of the next frames.
    FloatImage meanOf(int frames) {
        FloatImage sum(kSize);
        for (int i = 0; i < frames; ++i) {
            const FloatImage image = next();
            for (size_t p = 0; p < sum.pixels.size(); ++p) sum.pixels[p] += image.pixels[p] / float(frames);
        }
        return sum;
    }
    /// Calls change() and expects 90 % of the new light within 12 frames, and less than 2 % of the old light after 30,
    /// over the pixels that change by more than half of the largest change.
    template <class F>
    void expectToFollow(F&& change) {
        for (int i = 0; i < 40; ++i) next();
        const FloatImage before = meanOf(24);
        change();
        std::vector<FloatImage> after;
        for (int i = 0; i < 30; ++i) after.push_back(next());
        for (int i = 0; i < 40; ++i) next();
        const FloatImage converged = meanOf(24);
        const auto old = [&](size_t p) { return before.pixels[p].g - converged.pixels[p].g; };
        float largest = 0.0f;
        for (size_t p = 0; p < before.pixels.size(); ++p) largest = std::max(largest, std::abs(old(p)));
        const auto left = [&](const FloatImage& image) {
            double sum = 0.0, all = 0.0;
            for (size_t p = 0; p < before.pixels.size(); ++p) {
                if (std::abs(old(p)) < 0.5f * largest) continue;
                sum += (image.pixels[p].g - converged.pixels[p].g) * (old(p) > 0.0f ? 1.0 : -1.0),
                    all += std::abs(old(p));
            }
            return sum / all;
        };
        ASSERT_GT(largest, 0.1f) << "the change has no effect on the light";
        RecordProperty("left_after_12", std::to_string(left(after[11])));
        RecordProperty("left_after_30", std::to_string(left(after[29])));
        EXPECT_LT(std::abs(left(after[11])), 0.1);
        EXPECT_LT(std::abs(left(after[29])), 0.02) << "a ghost";
    }
};

TEST_F(ChangeTest, ALightThatGoesOutLeavesNoGlow) {
    LitScene scene = floorScene();
    scene.environment.sunColor = glm::vec3(0.0f);
    scene.addLight({LightKind::Sphere, {0, 1.2, 0}, {0, -1, 0}, {6, 5, 4}, 0.15f, 12.0f, 0.6f, 1.1f});
    begin(scene);
    expectToFollow([&] {
        FrameSnapshot dark = scene.step();
        dark.lightsChanged = true;
        dark.lights.clear();
        renderer->apply(std::move(dark));
    });
}

TEST_F(ChangeTest, ABodyThatIsGoneTakesItsShadowAlong) {
    LitScene scene = floorScene();
    scene.environment.sunDirection = {-0.8f, 0.9f, 0.1f};
    const ShapeHandle box = scene.add({12, 12, 12}, {{-1.6, 0, -0.6}}, [](glm::ivec3) { return uint8_t(1); });
    begin(scene);
    expectToFollow([&] {
        scene.move(box, {{-1.6, 0, -30.0}});
        renderer->apply(scene.step());
        renderer->apply(scene.step());  // the second one says that it rests
    });
}

/// A quick version with small images, whose reference has noise of its own.
TEST_F(DenoiserTest, ASmallImageComesNearTheReference) {
    SceneView each = std::move(tuningViews(false)[0]);
    const double difference = flipOf(each, {96, 54}, 48);
    RecordProperty("flip", std::to_string(difference));
    EXPECT_LE(difference, 0.06);
}

}  // namespace
}  // namespace rubble::reference
