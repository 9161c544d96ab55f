#include <gtest/gtest.h>

#include "tests/physics/physics_scene.h"

namespace rubble {
namespace {

/// A crate of 0.4 m a little above the floor.
struct Drop : PhysicsScene {
    Drop(uint8_t layer, uint8_t mask, uint8_t floorLayer = 1, uint8_t floorMask = 255) {
        addFloor();
        LevelShape& floor = level.bodies[0].shapes[0];
        floor.collisionLayer = floorLayer, floor.collisionMask = floorMask;
        LevelShape& crate = add(solidGrid({4, 4, 4}, 5), {0.0, 0.1, 0.0}, false).shapes[0];
        crate.collisionLayer = layer, crate.collisionMask = mask;
    }
    void load() {
        PhysicsScene::load();
        world.applyEdits({});  // takes out the change that loaded the level
    }
    double height() const { return body(1).pose.position.y; }
    void edit(const Edits& edits) { physics.apply(world.applyEdits(edits), world); }
};

TEST(Layers, TwoCollideOnlyIfEachMaskHasTheOthersLayer) {
    struct Case {
        uint8_t layer, mask, floorLayer, floorMask;
        bool touches;
    };
    for (const Case& c : {Case{1, 255, 1, 255, true}, Case{2, 255, 4, 255, true}, Case{2, 2, 1, 255, false},
                          Case{2, 255, 1, 1, false}, Case{2, 1, 1, 2, true}, Case{0, 255, 1, 255, false}}) {
        Drop scene(c.layer, c.mask, c.floorLayer, c.floorMask);
        scene.load();
        scene.seconds(1.0);
        if (c.touches)
            EXPECT_GT(scene.height(), -0.01);
        else
            EXPECT_LT(scene.height(), -2.0);
    }
}

TEST(Layers, EachShapeOfABodyHasItsOwnFilter) {
    Drop scene(2, 2);  // it falls through the floor, but its second shape, a metre higher, does not
    LevelShape top = scene.level.bodies[1].shapes[0];
    top.local.position = {0.0, 1.0, 0.0};
    top.collisionLayer = 1, top.collisionMask = 255;
    scene.level.bodies[1].shapes.push_back(top);
    scene.load();
    scene.seconds(2.0);
    EXPECT_NEAR(scene.body(1).pose.position.y, -1.0, 0.1);
}

TEST(Layers, AnEditTakesEffectAtOnceAndWakesSleepers) {
    Drop scene(1, 255);
    scene.load();
    scene.seconds(3.0);
    ASSERT_TRUE(scene.body(1).asleep);
    ShapeHandle crate = scene.body(1).shapes[0];
    scene.edit({SetCollisionFilterEdit{crate, 2, 2}});
    scene.seconds(1.0);
    EXPECT_LT(scene.height(), -2.0);

    Drop other(1, 255);
    other.load();
    other.seconds(3.0);
    ASSERT_TRUE(other.body(1).asleep);
    other.edit({SetCollisionFilterEdit{other.body(0).shapes[0], 4, 4}});
    other.seconds(1.0);
    EXPECT_LT(other.height(), -2.0) << "a changed filter of the floor lets the crate fall";
}

TEST(Layers, PiecesInheritTheFilter) {
    Drop scene(2, 2, 4, 4);
    scene.load();
    const glm::dvec3 middle = scene.center(1);
    scene.edit({CarveEdit{.kind = BrushKind::Box, .position = middle, .halfSize = {0.09, 1.0, 1.0}}});
    int pieces = 0;
    scene.world.shapes().forEach([&](ShapeHandle, const Shape& shape) {
        if (!shape.isPiece) return;
        ++pieces;
        EXPECT_EQ(shape.collisionLayer, 2);
        EXPECT_EQ(shape.collisionMask, 2);
    });
    EXPECT_EQ(pieces, 1);
}

}  // namespace
}  // namespace rubble
