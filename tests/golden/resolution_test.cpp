// Fewer pixels traced than displayed: TAA reconstructs the image.
#include "tests/golden/compare.h"
#include "tests/golden/drawing.h"

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

TEST_F(ResolutionTest, AnInvalidScaleTracesEveryPixel) {
    for (const float scale : {0.0f, -1.0f, 3.0f, std::numeric_limits<float>::quiet_NaN()}) {
        street(scale, 1);
        EXPECT_EQ(traced(), kSize.x * kSize.y) << scale;
    }
}

}  // namespace
}  // namespace rubble
