// Boxes of thickness 0, as the query of a pane or a doorway, are those of a thickness that is next to nothing.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "runtime/core/random.h"
#include "runtime/voxel/grid_cast.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

CellShape makeBox(glm::dvec3 centre, glm::dquat rotation, glm::dvec3 half) {
    CellShape box;
    box.isBox = true;
    box.a = centre;
    for (int i = 0; i < 3; ++i) box.halfAxes[size_t(i)] = rotation * (glm::dvec3(i == 0, i == 1, i == 2) * half[i]);
    return box;
}

TEST(FlatBox, TouchesWhatAThinOneTouches) {
    VoxelGrid grid({3, 3, 3});
    fillBox(grid, {{1, 1, 1}, {2, 2, 2}}, 1);
    Random random(5);
    const auto within = [&](double low, double high) { return low + (high - low) * random.unit(); };
    int hits = 0, casts = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto vector = [&](double size) {
            return glm::dvec3(within(-size, size), within(-size, size), within(-size, size));
        };
        const glm::dquat rotation = glm::normalize(glm::dquat(within(-1, 1), vector(1.0)));
        const glm::dvec3 centre = glm::dvec3(1.5) + vector(6.0), direction = vector(1.0);
        glm::dvec3 half(within(0.1, 9.0), within(0.1, 9.0), within(0.1, 9.0));
        const auto boxOf = [&](double thickness) {
            half[i % 3] = thickness;
            return makeBox(centre, rotation, half);
        };
        const CellShape flat = boxOf(0.0), thin = boxOf(1e-7);
        const bool isHit = findOverlap(grid, flat).has_value(), meets = castShape(grid, flat, direction, 9.0).hit;
        EXPECT_EQ(isHit, findOverlap(grid, thin).has_value()) << i;
        EXPECT_EQ(meets, castShape(grid, thin, direction, 9.0).hit) << i;
        hits += isHit, casts += meets;
    }
    EXPECT_TRUE(hits > 150 && hits < 2850) << hits;
    EXPECT_TRUE(casts > 150 && casts < 2850) << casts;
}

}  // namespace
}  // namespace rubble
