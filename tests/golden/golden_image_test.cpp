#include <cstdlib>
#include <filesystem>

#include "generated/paths.h"
#include "tests/golden/compare.h"
#include "tests/golden/drawing.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;

/// Compares with tests/golden/images/NAME.png. On failure it writes actual, expected and difference under the build
/// folder. RUBBLE_UPDATE_GOLDEN=1 writes the golden image instead: look at it before you commit it.
void expectGoldenImage(const Image& actual, const std::string& name) {
    const std::string golden = RUBBLE_SOURCE_DIR "/tests/golden/images/" + name + ".png";
    if (std::getenv("RUBBLE_UPDATE_GOLDEN")) {
        fs::create_directories(fs::path(golden).parent_path());
        ASSERT_TRUE(writePng(golden, actual));
        GTEST_SKIP() << "wrote " << golden;
    }
    const auto expected = readPng(golden);
    ASSERT_TRUE(expected) << expected.error();
    ASSERT_EQ(expected->width, actual.width);
    ASSERT_EQ(expected->height, actual.height);
    const Difference difference = compare(actual, *expected);
    if (looksAlike(difference)) return;
    const std::string folder = RUBBLE_BINARY_DIR "/golden/";
    fs::create_directories(folder);
    EXPECT_TRUE(writePng(folder + name + "_actual.png", actual));
    EXPECT_TRUE(writePng(folder + name + "_expected.png", *expected));
    EXPECT_TRUE(writePng(folder + name + "_difference.png", difference.image));
    ADD_FAILURE() << name << ": " << difference.share * 100 << " % of the pixels differ clearly, " << difference.mean
                  << " of 255 on average; see " << folder << name << "_{actual,expected,difference}.png";
}

class GoldenImageTest : public Drawing {
protected:
    Image street(int camera) {
        RenderSettings settings;
        settings.warmUpFrames = 7;
        start(streetScene(), {320, 180}, settings);
        return draw(streetCamera(camera));
    }
};

TEST_F(GoldenImageTest, TheStreetInTheEvening) {
    expectGoldenImage(street(0), "street");
}
TEST_F(GoldenImageTest, TheRoomBehindTheHole) {
    expectGoldenImage(street(2), "room");
}

TEST_F(GoldenImageTest, ADifferentImageIsNoticed) {
    Image a(64, 64), b(64, 64);
    for (int y = 20; y < 26; ++y)
        for (int x = 20; x < 26; ++x) b.at(x, y)[0] = 90;
    EXPECT_FALSE(looksAlike(compare(a, b)));
    for (uint8_t& v : b.rgb) v = 2;
    EXPECT_FALSE(looksAlike(compare(a, b)));
}

}  // namespace
}  // namespace rubble
