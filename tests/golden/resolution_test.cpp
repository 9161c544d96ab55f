// Fewer pixels traced than displayed: TAA reconstructs the image.
#include "render/frame/view_histories.h"
#include "runtime/core/log.h"
#include "tests/golden/compare.h"
#include "tests/golden/drawing.h"
#include "tests/render/gl_calls.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(96, 54);

class ResolutionTest : public Drawing {
protected:
    /// The street after some frames at this resolution scale.
    Image street(float scale, int frames) {
        RenderSettings settings;
        settings.resolutionScale = scale;
        start(streetScene(), kSize, settings);
        return draw(streetCamera(0), frames);
    }
    int64_t traced() const {
        const auto depth = renderer->readTarget("depth");
        EXPECT_TRUE(depth) << depth.error();
        return int64_t(depth->pixels.size());
    }
};

TEST_F(ResolutionTest, HalfResolutionConvergesToFull) {
    const Image whole = street(1.0f, 32);
    const int64_t all = traced();
    EXPECT_EQ(all, kSize.x * kSize.y);
    const double soft = compare(street(0.5f, 1), whole).mean, converged = compare(street(0.5f, 64), whole).mean;
    EXPECT_EQ(traced() * 4, all);
    EXPECT_LT(converged, 0.6 * soft) << "more frames must add detail";
    EXPECT_LT(converged, 4.0) << "of 255";
    EXPECT_GT(soft, 1.0) << "one frame at half resolution must differ";
}

TEST_F(ResolutionTest, FractionalScalesKeepPositions) {
    const Image whole = street(1.0f, 32);
    for (const float scale : {0.9f, 0.67f, 0.34f}) EXPECT_LT(compare(street(scale, 48), whole).mean, 7.0) << scale;
}

TEST_F(ResolutionTest, AScaleOutOfItsRangeCountsAsTheNearestAndIsLogged) {
    int lines = 0;
    setLogSink([](void* count, LogLevel, std::string_view) { ++*static_cast<int*>(count); }, &lines);
    const glm::ivec2 least(glm::round(glm::vec2(kSize) * RenderSettings::kMinScale));
    for (const auto& [scale, size] :
         {std::pair(0.15f, least), std::pair(0.0f, least), std::pair(-1.0f, least), std::pair(3.0f, kSize),
          std::pair(std::numeric_limits<float>::quiet_NaN(), kSize), std::pair(1.0f, kSize)}) {
        const int before = lines;
        street(scale, 1);
        EXPECT_EQ(renderer->readTarget("depth")->size, size) << scale;
        EXPECT_EQ(lines - before, scale == 1.0f ? 0 : 1) << scale;
    }
    setLogSink(nullptr, nullptr);
}

/// At 0.15 and below the image was white.
TEST_F(ResolutionTest, TheLeastScaleShowsTheSameLight) {
    const Image whole = street(1.0f, 32);
    EXPECT_LT(compare(street(RenderSettings::kMinScale, 32), whole).mean, 20.0) << "of 255";
}

/// A GL with textures of 128 x 128 pixels.
class SizesTest : public ResolutionTest {
protected:
    void startSmall() {
        RenderSettings settings;
        settings.limits = GlLimits::ofContext();
        settings.limits->textureSide = 128;
        start(streetScene(), kSize, settings);
    }
    void drawAt(glm::ivec2 size, int slot = 0) {
        View view = streetCamera(0).view(size, target->framebuffer());
        view.slot = slot;
        renderer->draw(view, 1.0f);
        EXPECT_EQ(renderer->lastError(), "");
    }
};

TEST_F(SizesTest, AHugeViewLeavesTheNextOneItsPixels) {
    startSmall();
    drawAt({1000, 500});
    EXPECT_EQ(traced(), 125 * 62);
    drawAt(kSize);
    EXPECT_EQ(traced(), kSize.x * kSize.y);
    drawAt({1000, 500});
    EXPECT_EQ(traced(), 125 * 62);
}

TEST_F(SizesTest, ViewsOfTwoSizesInTurnMakeNoTargetsAnew) {
    startSmall();
    for (int i = 0; i < 4; ++i) drawAt(kSize), drawAt({48, 48});
    const uint64_t bytes = renderer->stats().textureBytes;
    const GlCalls<&glad_glTexImage2D> textures;
    const GlCalls<&glad_glGenFramebuffers> framebuffers;
    for (int i = 0; i < 5; ++i) drawAt(kSize), drawAt({48, 48});
    EXPECT_EQ(textures.count(), 0);
    EXPECT_EQ(framebuffers.count(), 0);
    EXPECT_EQ(renderer->stats().textureBytes, bytes);
}

TEST_F(SizesTest, AWindowThatIsResizedKeepsFewTargets) {
    startSmall();
    drawAt({64, 64});
    const uint64_t bytes = renderer->stats().textureBytes;
    for (int i = 0; i < 40; ++i) drawAt({64 - i, 64});
    EXPECT_LE(renderer->stats().textureBytes, 2 * bytes);
}

TEST_F(SizesTest, ASizeThatIsNoLongerDrawnIsFreed) {
    startSmall();
    for (int i = 0; i < 4; ++i) drawAt(kSize);
    const uint64_t bytes = renderer->stats().textureBytes;
    drawAt({48, 48});
    EXPECT_GT(renderer->stats().textureBytes, bytes);
    for (uint64_t i = 0; i <= ViewHistories::kIdleDraws; ++i) drawAt(kSize);
    EXPECT_EQ(renderer->stats().textureBytes, bytes);
}

/// Two cameras of a split screen, each with its history: the same as two renderers.
TEST_F(SizesTest, SlotsOfOneSizeDoNotSeeEachOther) {
    const auto drawFrames = [&](std::initializer_list<int> cameras) {
        LitScene scene = streetScene();
        RenderSettings settings;
        start(scene, kSize, settings);
        for (int frame = 0; frame < 4; ++frame) {
            if (frame) {
                scene.move(ShapeHandle::make(1, 1, 1), {{0.1 * frame, 1.0, 0.0}, {1, 0, 0, 0}});
                renderer->apply(scene.step());
            }
            for (const int camera : cameras) {
                View view = streetCamera(camera).view(kSize, target->framebuffer());
                view.slot = camera;
                renderer->draw(view, 1.0f);
            }
        }
        return target->readRgb();
    };
    EXPECT_EQ(drawFrames({3, 0}), drawFrames({0}));
    EXPECT_EQ(drawFrames({0, 3}), drawFrames({3}));
}

}  // namespace
}  // namespace rubble
