#include "runtime/world/world.h"

#include <gtest/gtest.h>

#include "runtime/world/queries/query.h"
#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

/// What is near decides what burns and breaks, so it must depend on where a shape is and not on how it came there.
TEST(World, ShapesNearDoesNotDependOnPastMotion) {
    Level level;
    LevelBody body;
    body.name = "cube";
    body.isStatic = false;
    LevelShape shape;
    shape.name = "cube";
    shape.palette = std::make_shared<Palette>();
    shape.grid = VoxelGrid({4, 4, 4});
    GridWriter(shape.grid).set({0, 0, 0}, 1);
    body.shapes.push_back(std::move(shape));
    level.bodies.push_back(std::move(body));
    World moved;
    moved.load(level);
    const BodyHandle handle = moved.bodies().handleAt(0);
    for (int i = 1; i <= 40; ++i) moved.setPoses(std::vector<BodyPose>{{handle, {{0.01 * i, 0, 0}, {1, 0, 0, 0}}}});
    World loaded;
    loaded.load(toLevel(moved));
    for (int i = -30; i <= 120; ++i)
        for (const double reach : {0.0, 0.1}) {
            const glm::dvec3 point(0.01 * i + 0.005, 0.2, 0.2);
            EXPECT_EQ(shapesNear(moved, point, reach).size(), shapesNear(loaded, point, reach).size())
                << point.x << " " << reach;
            EXPECT_EQ(shapesNear(moved, point, reach).size(), size_t(point.x + reach >= 0.4 && point.x - reach <= 0.8))
                << point.x << " " << reach;
        }
}

}  // namespace
}  // namespace rubble
