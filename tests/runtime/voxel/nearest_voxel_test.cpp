#include "runtime/voxel/nearest_voxel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "runtime/core/random.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

/// Of all cells, the solid one whose centre is nearest; the first in the order z, y, x.
std::optional<glm::ivec3> bruteForce(const VoxelGrid& grid, glm::dvec3 point, const CellBox& range, double* squared) {
    std::optional<glm::ivec3> nearest;
    *squared = std::numeric_limits<double>::infinity();
    for (int z = range.low.z; z < range.high.z; ++z)
        for (int y = range.low.y; y < range.high.y; ++y)
            for (int x = range.low.x; x < range.high.x; ++x) {
                const glm::dvec3 offset = glm::dvec3(x, y, z) + 0.5 - point;
                if (!grid.at({x, y, z}) || glm::dot(offset, offset) >= *squared) continue;
                *squared = glm::dot(offset, offset);
                nearest = {x, y, z};
            }
    return nearest;
}

TEST(NearestVoxel, MatchesBruteForce) {
    Random random(3);
    const VoxelGrid grid = noiseGrid({70, 40, 50}, 1, 9);
    const CellBox all{glm::ivec3(0), grid.size()};
    for (int i = 0; i < 50; ++i) {
        const float x = random.unit(), y = random.unit(), z = random.unit();
        const glm::dvec3 point = glm::dvec3(x, y, z) * glm::dvec3(grid.size()) * 1.4 - 10.0;
        double squared = 0.0, near = 0.0;
        const auto expected = bruteForce(grid, point, all, &squared);
        ASSERT_EQ(nearestVoxel(grid, point, all), expected) << i;
        ASSERT_EQ(nearestVoxelSquared(grid, point), squared) << i;
        EXPECT_EQ(nearestVoxel(grid, point, all, squared), std::nullopt) << "the limit itself does not count";
        const glm::ivec3 middle(glm::floor(point));
        const CellBox cube{middle - 3, middle + 4};  // reaches out of the grid for some points
        ASSERT_EQ(nearestVoxel(grid, point, cube), bruteForce(grid, point, cube, &near)) << i;
    }
}

TEST(NearestVoxel, AnEmptyGridHasNone) {
    const VoxelGrid grid({20, 20, 20});
    EXPECT_FALSE(nearestVoxel(grid, {3.0, 3.0, 3.0}, {{0, 0, 0}, {20, 20, 20}}));
    EXPECT_TRUE(std::isinf(nearestVoxelSquared(grid, {3.0, 3.0, 3.0})));
}

}  // namespace
}  // namespace rubble
