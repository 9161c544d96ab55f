#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "runtime/world/world.h"

namespace rubble::test {

/// What the shadow volume and the renderer rely on: each brick once, in its shape's grid, with what is there.
inline void expectTrueJournal(const FrameChanges& changes, const World& world) {
    std::set<std::array<uint32_t, 4>> seen;
    for (const BrickChange& each : changes.bricks) {
        const Shape* shape = world.shapes().find(each.shape);
        ASSERT_TRUE(shape);
        ASSERT_TRUE(glm::all(glm::greaterThanEqual(each.brick, glm::ivec3(0))));
        ASSERT_TRUE(glm::all(glm::lessThan(each.brick, shape->grid.sizeInBricks())));
        EXPECT_EQ(each.content.get(), shape->grid.brickAt(each.brick));
        const glm::uvec3 brick(each.brick);
        EXPECT_TRUE(seen.insert({each.shape.slot(), brick.x, brick.y, brick.z}).second) << "listed twice";
    }
    for (const ShapeHandle carved : changes.carved)
        EXPECT_EQ(std::count(changes.carved.begin(), changes.carved.end(), carved), 1);
}

}  // namespace rubble::test
