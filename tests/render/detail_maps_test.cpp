#include "render/scene/detail_maps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "runtime/voxel/material.h"

namespace rubble {
namespace {

TEST(DetailMaps, KeepTheMeanColourAndVary) {
    const auto texels = DetailMaps::make();
    constexpr size_t kTexels = size_t(DetailMaps::kSide) * DetailMaps::kSide;
    ASSERT_EQ(texels.size(), kTexels * 4 * size_t(DetailMaps::count()));
    for (int map = 0; map < DetailMaps::count(); ++map) {
        double sum = 0.0, squares = 0.0;
        for (size_t i = 0; i < kTexels; ++i) {
            const double color = (texels[(size_t(map) * kTexels + i) * 4] - 128.0) / 254.0;  // share brighter or darker
            sum += color;
            squares += color * color;
        }
        const double mean = sum / kTexels, deviation = std::sqrt(squares / kTexels - mean * mean);
        EXPECT_NEAR(mean, 0.0, 0.02) << "map " << map;
        EXPECT_GT(deviation, 0.008) << "map " << map;
        EXPECT_LT(deviation, 0.12) << "map " << map << " is noisy";
    }
    EXPECT_EQ(texels, DetailMaps::make()) << "the maps are not deterministic";
}

TEST(DetailMaps, ExistOnlyForMaterialsWithGrain) {
    const MaterialTable& materials = defaultMaterials();
    const auto maps = DetailMaps::mapsOf({});
    EXPECT_NE(maps[materials.find("brick")], 0);
    EXPECT_NE(maps[materials.find("wood")], maps[materials.find("brick")]);
    EXPECT_EQ(maps[materials.find("glass")], 0);
    EXPECT_EQ(maps[materials.find("plastic")], 0);
    EXPECT_EQ(maps[0], 0);
}

TEST(DetailMaps, FollowTheNamesOfALevelsOwnMaterials) {
    const auto usual = DetailMaps::mapsOf({});
    const auto own = DetailMaps::mapsOf(std::vector<std::string>{"", "glass", "brick", "cheese"});
    EXPECT_EQ(own[1], 0);
    EXPECT_EQ(own[2], usual[defaultMaterials().find("brick")]);
    EXPECT_EQ(own[3], 0);
    EXPECT_EQ(own[200], 0);
}

}  // namespace
}  // namespace rubble
