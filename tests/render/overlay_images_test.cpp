#include <gtest/gtest.h>

#include "render/overlay/overlay.h"

namespace rubble {
namespace {

OverlayImage imageOf(int width) {
    return {{width, 1}, std::vector<uint8_t>(size_t(width) * 4)};
}

/// The pixels count also when a draw has taken them, and no longer when their image is replaced or taken away.
TEST(OverlayImages, HaveSoManyPixelsAndNoMore) {
    Overlay overlay(40);
    ASSERT_TRUE(overlay.setImage("a", imageOf(6)));
    overlay.images().at("a").pixels.clear();
    const Result<Done> refused = overlay.setImage("b", imageOf(5));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error(),
              "the pixels of all images would take 44 bytes, expected at most 40; take other images away first");
    EXPECT_EQ(overlay.images().count("b"), 0u);
    EXPECT_TRUE(overlay.setImage("b", imageOf(4))) << "all of it";
    EXPECT_FALSE(overlay.setImage("a", imageOf(7)));
    EXPECT_EQ(overlay.images().at("a").size.x, 6) << "as before";
    EXPECT_TRUE(overlay.setImage("a", imageOf(2)));
    EXPECT_TRUE(overlay.setImage("a", imageOf(6)));
    EXPECT_TRUE(overlay.setImage("b", {}));
    EXPECT_TRUE(overlay.setImage("b", {})) << "it is away already";
    EXPECT_TRUE(overlay.setImage("a", imageOf(10)));
}

}  // namespace
}  // namespace rubble
