// What the level's box of the shadow volume holds, and what lies outside of it, cast the same shadows.
#include <cstdlib>

#include "tests/golden/drawing.h"

namespace rubble {
namespace {

class ShadowPartsTest : public Drawing {
protected:
    /// The first frame of the street.
    Image drawStreet() { return draw(streetCamera(0)); }
    static double shareOfOtherBytes(const Image& a, const Image& b) {
        size_t other = 0;
        for (size_t i = 0; i < a.rgb.size(); ++i) other += std::abs(int(a.rgb[i]) - int(b.rgb[i])) > 8;
        return double(other) / double(a.rgb.size());
    }
};

TEST_F(ShadowPartsTest, AStreetOutsideOfTheLevelsBoxLooksAsOneInside) {
    const LitScene street = streetScene();
    start(street, {160, 90});
    const Image inside = drawStreet();

    // More bricks than the street's, far away: the box stays with them.
    FrameSnapshot level = street.snapshot(), step;
    step.version = step.newestStep = level.version + 1;
    step.shadow.swap(level.shadow);
    ShadowWords cells{};
    cells.fill(1);
    for (int i = 0; i <= int(step.shadow.size()); ++i)
        level.shadow.push_back({{4000 + i % 8, 0, i / 8}, makeShadowBrick(cells)});
    start(street, {160, 90});
    renderer->apply(FrameSnapshot(level));
    EXPECT_GT(shareOfOtherBytes(inside, drawStreet()), 0.05) << "without the street's shadow volume";
    start(street, {160, 90});
    renderer->apply(std::move(level));
    renderer->apply(std::move(step));
    EXPECT_LT(shareOfOtherBytes(inside, drawStreet()), 0.002);
}

}  // namespace
}  // namespace rubble
