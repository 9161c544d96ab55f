#include "render/scene/detail_maps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "runtime/voxel/material.h"

namespace rubble {
namespace {

TEST(DetailMaps, LeaveTheMeanOfAColourAsItIsAndAreNeverFlat) {
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
    EXPECT_EQ(texels, DetailMaps::make()) << "chance";
}

TEST(DetailMaps, AreThereForMaterialsWithGrainAlone) {
    const MaterialTable& materials = defaultMaterials();
    EXPECT_NE(DetailMaps::mapOf(materials.find("brick")), 0);
    EXPECT_NE(DetailMaps::mapOf(materials.find("wood")), DetailMaps::mapOf(materials.find("brick")));
    EXPECT_EQ(DetailMaps::mapOf(materials.find("glass")), 0);
    EXPECT_EQ(DetailMaps::mapOf(materials.find("plastic")), 0);
    EXPECT_EQ(DetailMaps::mapOf(0), 0);
}

}  // namespace
}  // namespace rubble
