// The denoised picture against the truth, and how soon it follows what changes.
#include <cstdlib>

#include "tests/golden/drawing.h"
#include "tests/reference/display.h"
#include "tests/reference/flip.h"
#include "tests/reference/picture_file.h"
#include "tests/reference/views.h"

namespace rubble::reference {
namespace {

constexpr int kFrames = 16;

class DenoiserTest : public Drawing {
protected:
    /// FLIP of the view after 16 pictures of one ray a pixel, standing still.
    double flipOf(SceneView& each, glm::ivec2 size, int samples) {
        each.view.size = size;
        const Picture truth = cachedRender(Scene(each.snapshot), each.view, {.samples = samples, .filterPixels = true},
                                           RUBBLE_BINARY_DIR "/reference", "the truth of " + each.name);
        auto made = Renderer::create(testContext().loader(), shaderFolder(), comparedSettings());
        EXPECT_TRUE(made) << made.error();
        (*made)->apply(FrameSnapshot(each.snapshot));
        const Offscreen offscreen(size);
        each.view.framebuffer = offscreen.framebuffer();
        for (int i = 0; i < kFrames; ++i) (*made)->draw(each.view, 1.0f);
        const auto drawn = (*made)->readTarget("resolved");
        EXPECT_TRUE(drawn) << drawn.error();
        const float exposure = exposureFor(truth.mean, each.snapshot.environment.exposure);
        return flip(displayed(truth.mean, exposure), displayed(*drawn, exposure));
    }
};

TEST_F(DenoiserTest, OneRayAPixelComesNearTheTruth) {
    if (!std::getenv("RUBBLE_LONG")) GTEST_SKIP() << "minutes; set RUBBLE_LONG=1";
    for (SceneView& each : judgingViews()) {
        const double difference = flipOf(each, {240, 135}, 256);
        printf("%s: FLIP %.4f\n", each.name.c_str(), difference);
        EXPECT_LE(difference, 0.035) << each.name;
    }
}

/// The same small, where the truth has noise of its own.
TEST_F(DenoiserTest, ASmallPictureComesNearTheTruth) {
    SceneView each = std::move(tuningViews(false)[0]);
    const double difference = flipOf(each, {96, 54}, 48);
    RecordProperty("flip", std::to_string(difference));
    EXPECT_LE(difference, 0.06);
}

}  // namespace
}  // namespace rubble::reference
