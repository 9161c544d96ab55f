#include <gtest/gtest.h>

#include "tests/runtime/world/undo_world.h"

namespace rubble {
namespace {

using namespace test;

TEST(UndoMarks, GoesToTheMarkBeforeUnlessSomethingHasChangedSinceTheLastUndo) {
    World world = smallWorld();
    std::vector<uint64_t> atMark;
    for (int i = 0; i < 3; ++i) {
        atMark.push_back(resolvedHash(world));
        world.applyEdits({kMark, sphereCarve({0.5 + i, 1.2, 0.3}, 0.4)});
    }
    const auto undone = [&] {
        world.applyEdits({kUndo});
        return resolvedHash(world);
    };
    EXPECT_EQ(undone(), atMark[2]);
    world.applyEdits({sphereCarve({3.5, 1.2, 0.3}, 0.4)});
    EXPECT_EQ(undone(), atMark[2]) << "a change since then is undone first";
    move(world, 0.5);
    world.applyEdits({});
    EXPECT_EQ(undone(), atMark[1]) << "motion is no change";
    EXPECT_EQ(undone(), atMark[0]);
    EXPECT_EQ(undone(), atMark[0]) << "there is no mark before";
}

TEST(UndoMarks, AMarkSinceWhichNothingHasChangedIsReturnedToAsWell) {
    World world = smallWorld();
    const auto afterStep = [&](Edits edits) {
        world.applyEdits(std::move(edits));
        return resolvedHash(world);
    };
    const uint64_t first = resolvedHash(world), second = afterStep({kMark, sphereCarve({0.5, 1.2, 0.3}, 0.4)});
    afterStep({kMark});
    afterStep({kMark});
    EXPECT_EQ(afterStep({kUndo}), second) << "the change before the last mark stays";
    EXPECT_EQ(afterStep({kUndo}), first);
    EXPECT_EQ(afterStep({kRedo}), second);
    EXPECT_EQ(afterStep({kRedo}), second);
}

TEST(UndoMarks, TheWorldDiffersFromItsMarkWhereItsHashDoes) {
    World world = smallWorld();
    world.applyEdits({kMark});
    const uint64_t atMark = resolvedHash(world);
    EXPECT_FALSE(differsFromMark(world).value());
    BodyHandle crate;
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (body.name == "crate") crate = handle;
    });
    const Pose before = world.bodies().at(crate).pose;
    world.applyEdits({sphereCarve({50.5, 1.2, 0.3}, 0.4)});
    EXPECT_FALSE(differsFromMark(world).value()) << "it hit nothing";
    world.setPoses(std::vector<BodyPose>{{crate, {before.position + 1.0, before.rotation}, {}, {}, false}});
    EXPECT_TRUE(differsFromMark(world).value());
    EXPECT_NE(resolvedHash(world), atMark);
    world.applyEdits({kUndo});
    EXPECT_FALSE(differsFromMark(world).value());
    world.applyEdits({kMark, sphereCarve({0.5, 1.2, 0.3}, 0.4)});
    EXPECT_TRUE(differsFromMark(world).value());
    EXPECT_NE(resolvedHash(world), atMark);
}

TEST(UndoMarks, WithoutAMarkNothingIsUndone) {
    World world = smallWorld();
    world.applyEdits({sphereCarve({0.5, 1.2, 0.3}, 0.4)});
    const uint64_t carved = resolvedHash(world);
    world.applyEdits({kUndo});
    EXPECT_EQ(resolvedHash(world), carved);
    world.applyEdits({kMark, sphereCarve({1.5, 1.2, 0.3}, 0.4)});
    world.applyEdits({kUndo});
    EXPECT_EQ(resolvedHash(world), carved);
    world.applyEdits({kUndo});
    EXPECT_EQ(resolvedHash(world), carved) << "nor beyond the first one";
}

}  // namespace
}  // namespace rubble
