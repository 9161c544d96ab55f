#include "runtime/voxel/mass_properties.h"

#include <gtest/gtest.h>

#include <glm/mat3x3.hpp>

#include "runtime/core/random.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

Palette paletteOf(std::initializer_list<const char*> names) {
    Palette palette{};
    uint8_t entry = 1;
    for (const char* name : names) palette[entry++].material = defaultMaterials().find(name);
    return palette;
}

VoxelGrid randomGridOfSize(glm::ivec3 size, uint64_t seed) {
    Random random(seed);
    return gridOf(size, [&](glm::ivec3) { return uint8_t(random.below(3)); });
}

TEST(MassMoments, EqualABruteForceSum) {
    const Palette palette = paletteOf({"wood", "metal"});
    const VoxelGrid grid = randomGridOfSize({19, 33, 10}, 3);
    MassMoments expected;
    for (int z = 0; z < 10; ++z)
        for (int y = 0; y < 33; ++y)
            for (int x = 0; x < 19; ++x)
                if (const uint8_t entry = grid.at({x, y, z}))
                    expected.add({x, y, z}, defaultMaterials()[palette[entry].material].density);
    EXPECT_EQ(gridMoments(grid, palette, defaultMaterials()), expected);
}

TEST(MassMoments, OfSomeVoxelsOfABrickEqualABruteForceSum) {
    Palette palette = paletteOf({"wood", "metal"});  // entry 3 weighs nothing
    Densities densities(palette, defaultMaterials());
    densities.byEntry[3] = 0;
    Random random(5);
    for (int i = 0; i < 300; ++i) {
        BrickIndices indices;
        const uint32_t kinds = 1 + random.below(4);
        for (uint8_t& index : indices) index = uint8_t(random.below(kinds + 1));
        const BrickRef brick = makeBrick(indices);
        BrickBits of;
        for (uint64_t& layer : of)
            layer = i % 3 == 0 ? ~0ull : i % 3 == 1 ? 0x0f0f0f0f0f0f0f0full : random.next() * 0x9e3779b97f4a7c15ull;
        MassMoments expected;
        for (int v = 0; v < kBrickVoxels; ++v)
            if (hasVoxel(of, v) && brick->at(v))
                expected.add(glm::ivec3(8, 16, 24) + voxelInBrick(v), densities.byEntry[brick->at(v)]);
        ASSERT_EQ(brickMoments(*brick, of, {1, 2, 3}, densities), expected);
    }
}

TEST(MassMoments, ShiftIsExactAndReversible) {
    const Palette palette = paletteOf({"wood", "metal"});
    const MassMoments moments = gridMoments(randomGridOfSize({16, 16, 16}, 4), palette, defaultMaterials());
    EXPECT_EQ(moments.shifted({1000, -24, 8}).shifted({-1000, 24, -8}), moments);
    EXPECT_NE(moments.shifted({1, 0, 0}), moments);
}

TEST(MassProperties, OfASolidBoxMatchTheFormula) {
    const Palette palette = paletteOf({"wood"});
    const glm::ivec3 size(40, 8, 24);
    const VoxelGrid grid = solidGrid(size);
    const MassProperties mass = massProperties(gridMoments(grid, palette, defaultMaterials()), 0.1);
    const glm::dvec3 side(4.0, 0.8, 2.4);
    const double kilograms = 500.0 * side.x * side.y * side.z;
    EXPECT_NEAR(mass.mass, kilograms, 1e-9 * kilograms);
    EXPECT_NEAR(glm::length(mass.center - side * 0.5), 0.0, 1e-12);
    EXPECT_NEAR(mass.inertia[0], kilograms / 12.0 * (side.y * side.y + side.z * side.z), 1e-9 * kilograms);
    EXPECT_NEAR(mass.inertia[1], kilograms / 12.0 * (side.z * side.z + side.x * side.x), 1e-9 * kilograms);
    EXPECT_NEAR(mass.inertia[2], kilograms / 12.0 * (side.x * side.x + side.y * side.y), 1e-9 * kilograms);
    for (size_t i = 3; i < 6; ++i) EXPECT_NEAR(mass.inertia[i], 0.0, 1e-9);
}

TEST(MassProperties, PrincipalAxesReproduceTheTensor) {
    const Palette palette = paletteOf({"wood", "metal"});
    VoxelGrid grid = randomGridOfSize({30, 12, 7}, 9);
    const MassProperties mass = massProperties(gridMoments(grid, palette, defaultMaterials()), 0.1);
    const glm::dmat3 axes = glm::mat3_cast(mass.principalAxes);
    const glm::dmat3 diagonal(mass.principalInertia.x, 0, 0, 0, mass.principalInertia.y, 0, 0, 0,
                              mass.principalInertia.z);
    const glm::dmat3 rebuilt = axes * diagonal * glm::transpose(axes);
    const double expected[3][3] = {{mass.inertia[0], mass.inertia[3], mass.inertia[5]},
                                   {mass.inertia[3], mass.inertia[1], mass.inertia[4]},
                                   {mass.inertia[5], mass.inertia[4], mass.inertia[2]}};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            EXPECT_NEAR(rebuilt[column][row], expected[row][column], 1e-9 * mass.principalInertia.x);
}

TEST(NodeMoments, StayKnownWhenEntriesThatNoVoxelHasChange) {
    VoxelGrid grid = solidGrid({32, 32, 32}, 1);
    MaterialTable materials;
    materials.materials.resize(3);
    materials.materials[1].density = 500, materials.materials[2].density = 900;
    Palette palette{};
    palette[1].material = 1;
    const MassMoments light = gridMoments(grid, palette, materials);
    const NodeMoments* known = grid.nodeAt({0, 0, 0})->cachedMoments.find();
    ASSERT_TRUE(known);
    palette[7].material = 2;  // as painting does
    EXPECT_TRUE(known->areFor(Densities(palette, materials)));
    EXPECT_EQ(gridMoments(grid, palette, materials), light);
    palette[1].material = 2;
    EXPECT_FALSE(known->areFor(Densities(palette, materials)));
    EXPECT_EQ(gridMoments(grid, palette, materials).weight, light.weight / 500 * 900);
}

}  // namespace
}  // namespace rubble
