#include "runtime/world/objects/joint.h"

#include <gtest/gtest.h>

#include "runtime/core/ranges.h"
#include "runtime/world/history/world_baseline.h"
#include "runtime/world/queries/joint_queries.h"
#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

using namespace test;

/// A free beam of 30 x 1 x 1 cells along x, and a static post beside its end.
Level beamAndPost() {
    Level level = oneShapeLevel(VoxelGrid({30, 1, 1}), false, {{0.0, 1.0, 0.0}});
    {
        GridWriter writer(level.bodies[0].shapes[0].grid);
        for (int x = 0; x < 30; ++x) writer.set({x, 0, 0}, 1);
    }
    LevelBody post{.name = "post"};
    post.shapes.push_back(levelShape("post", VoxelGrid({1, 20, 1})));
    {
        GridWriter writer(post.shapes[0].grid);
        for (int y = 0; y < 20; ++y) writer.set({0, y, 0}, 1);
    }
    post.pose.position = {3.0, 0.0, 0.0};
    level.bodies.push_back(post);
    LevelJoint hinge{{.name = "hinge", .kind = JointKind::Hinge}, {"shape", "post"}};
    hinge.joint.ends[0].frame.position = {3.0, 0.05, 0.05};
    hinge.joint.ends[1].frame.position = {0.0, 1.05, 0.05};
    level.joints.push_back(hinge);
    return level;
}

JointHandle firstJoint(const World& world) {
    return world.joints().handleAt(0);
}

TEST(Joint, ComesWithTheLevelAndHoldsOnToVoxels) {
    World world;
    world.load(beamAndPost());
    ASSERT_EQ(world.joints().size(), 1u);
    const Joint& joint = world.joints().at(firstJoint(world));
    EXPECT_EQ(joint.ends[0].cell, glm::ivec3(29, 0, 0));
    EXPECT_EQ(joint.ends[1].cell, glm::ivec3(0, 10, 0));
    EXPECT_NEAR(glm::length(jointToWorld(world, joint.ends[0]).position - jointToWorld(world, joint.ends[1]).position),
                0.0, 1e-6);
    EXPECT_EQ(world.data().jointIndex.of(joint.ends[0].shape).size(), 1u);
    EXPECT_TRUE(isJointedToStatic(world, world.shapes().at(joint.ends[0].shape).body));
    World again;
    again.load(toLevel(world));
    again.applyEdits({});
    world.applyEdits({});
    EXPECT_EQ(again.hash(), world.hash());
}

TEST(Joint, ComesBackToShapesWithoutNames) {
    for (const char* name : {"", "same"}) {
        Level level = beamAndPost();
        for (LevelBody& body : level.bodies) body.shapes[0].name = name;
        level.joints[0].shapeNames = {"#1", "#2"};
        World world, again;
        world.load(level);
        ASSERT_EQ(world.joints().size(), 1u) << name;
        again.load(toLevel(world));
        ASSERT_EQ(again.joints().size(), 1u) << name;
        for (const size_t end : {0, 1}) {
            const ShapeHandle shape = again.joints().at(firstJoint(again)).ends[end].shape;
            EXPECT_EQ(shape, world.joints().at(firstJoint(world)).ends[end].shape);
            EXPECT_EQ(again.shapes().at(shape).name, name);
        }
        EXPECT_EQ(again.hash(), world.hash()) << name;
    }
}

TEST(Joint, FollowsItsVoxelIntoAPiece) {
    World world;
    world.load(beamAndPost());
    const JointHandle joint = firstJoint(world);
    const ShapeHandle beam = world.joints().at(joint).ends[0].shape;
    const glm::dvec3 before = jointToWorld(world, world.joints().at(joint).ends[0]).position;
    const FrameChanges changes =
        world.applyEdits({sphereCarve({2.05, 1.05, 0.05}, 0.2)});  // the part with the joint is the smaller one
    ASSERT_EQ(changes.jointsMoved.size(), 1u);
    EXPECT_EQ(changes.jointsMoved[0].joint, joint);
    EXPECT_EQ(changes.jointsMoved[0].from, beam);
    const JointEnd& end = world.joints().at(joint).ends[0];
    EXPECT_EQ(end.shape, changes.jointsMoved[0].to);
    EXPECT_NE(end.shape, beam);
    EXPECT_TRUE(world.shapes().at(end.shape).grid.at(end.cell));
    EXPECT_NEAR(glm::length(jointToWorld(world, end).position - before), 0.0, 1e-6);
    EXPECT_TRUE(world.data().jointIndex.of(beam).empty());
    EXPECT_EQ(world.data().jointIndex.of(end.shape).size(), 1u);
    EXPECT_TRUE(changes.jointsBroken.empty());
}

TEST(Joint, BreaksWithItsVoxelAndWithItsShape) {
    for (const double x : {3.0, 0.3}) {  // one end of the beam, then all of it
        World world;
        world.load(beamAndPost());
        const JointHandle joint = firstJoint(world);
        const FrameChanges changes =
            world.applyEdits({x > 1.0 ? sphereCarve({3.0, 1.05, 0.05}, 0.06) : sphereCarve({1.2, 1.05, 0.05}, 1.78)});
        ASSERT_EQ(changes.jointsBroken.size(), 1u) << x;
        EXPECT_EQ(changes.jointsBroken[0].joint, joint);
        EXPECT_EQ(changes.jointsBroken[0].reason, JointBreak::VoxelGone);
        EXPECT_FALSE(world.joints().find(joint));
        EXPECT_FALSE(isJointedToStatic(world, world.bodies().handleAt(0)));
    }
}

TEST(Joint, EditsCreateRemoveAndDriveJoints) {
    World world;
    world.load(beamAndPost());
    const ShapeHandle beam = world.joints().at(firstJoint(world)).ends[0].shape;
    const AddJointEdit ball{jointAt(world, JointKind::Ball, beam, {}, {{0.05, 1.05, 0.05}})};
    AddJointEdit nowhere = ball, nonsense = ball;
    nowhere.joint.ends[0].frame.position = {0.0, 5.0, 0.0};
    nonsense.joint.breakForce = std::numeric_limits<double>::quiet_NaN();
    FrameChanges changes = world.applyEdits({ball, nowhere, nonsense, AddJointEdit{}});
    ASSERT_EQ(changes.jointsCreated.size(), 1u);
    const JointHandle made = changes.jointsCreated[0];
    EXPECT_EQ(world.joints().at(made).ends[0].cell, glm::ivec3(0));

    const uint64_t before = resolvedHash(world);
    changes = world.applyEdits({SetJointMotorEdit{made, {MotorMode::Speed, 2.0, 100.0}, 5.0},
                                SetJointMotorEdit{made, {MotorMode::Speed, 1e300, 0.0}}});
    EXPECT_EQ(changes.jointsChanged, std::vector<JointHandle>{made});
    EXPECT_EQ(world.joints().at(made).motor.target, 2.0);
    EXPECT_NE(resolvedHash(world), before);

    changes = world.applyEdits(
        {RemoveJointEdit{made, JointBreak::Force}, RemoveJointEdit{made}, DetachJointEdit{made, beam}});
    ASSERT_EQ(changes.jointsBroken.size(), 1u);
    EXPECT_EQ(changes.jointsBroken[0].reason, JointBreak::Force);
    EXPECT_EQ(world.joints().size(), 1u);
}

TEST(Joint, AHandHoldsOneBodyAndLetsGo) {
    World world;
    world.load(beamAndPost());
    const BodyHandle beam = world.bodies().handleAt(0), post = world.bodies().handleAt(1);
    GrabEdit grab{.body = beam, .point = {0.5, 1.05, 0.05}, .target = {0.5, 2.0, 0.0}};
    FrameChanges changes = world.applyEdits({grab, GrabEdit{.body = post}});
    ASSERT_EQ(changes.jointsCreated.size(), 1u);
    grab.target.y = 3.0;
    const FrameChanges moved = world.applyEdits({grab});
    EXPECT_EQ(moved.jointsChanged, changes.jointsCreated);
    EXPECT_EQ(world.joints().at(changes.jointsCreated[0]).ends[1].frame.position.y, 3.0);
    EXPECT_TRUE(world.applyEdits({grab}).jointsChanged.empty());
    changes = world.applyEdits({ReleaseEdit{{0.0, 0.0, 7.0}}});
    EXPECT_EQ(changes.jointsBroken.size(), 1u);
    ASSERT_EQ(changes.impulses.size(), 1u);
    EXPECT_EQ(changes.impulses[0].body, beam);
    EXPECT_EQ(world.joints().size(), 1u);
}

TEST(Joint, RopesSpanTheirEndsAndSurviveLosingOne) {
    World world;
    Level level = beamAndPost();
    level.joints[0].joint.kind = JointKind::Rope;
    level.joints[0].joint.rope.slack = 1.0;
    level.joints[0].joint.ends[1].frame.position = {0.0, 2.0, 0.0};
    world.load(level);
    const JointHandle rope = firstJoint(world);
    EXPECT_NEAR(world.joints().at(rope).rope.length, 1.953, 0.01);
    EXPECT_EQ(world.joints().at(rope).points.size(), 9u);
    CarveEdit carve = sphereCarve({3.0, 1.05, 0.05}, 0.06);
    carve.shape = world.joints().at(rope).ends[0].shape;  // this does not cut the rope
    const FrameChanges changes = world.applyEdits({carve});
    EXPECT_TRUE(changes.jointsBroken.empty());
    EXPECT_EQ(changes.jointsChanged, std::vector<JointHandle>{rope});
    EXPECT_TRUE(world.joints().at(rope).ends[0].isFree);
    EXPECT_FALSE(world.joints().at(rope).ends[1].isFree);
}

TEST(Joint, ARopeThatIsMadeHasALengthThatASaveCanHold) {
    World world;
    Level level = beamAndPost();
    level.joints[0].joint.kind = JointKind::Rope;
    level.joints[0].joint.rope.slack = ranges::kJointNumber.high;
    level.joints[0].joint.ends[1].frame.position = {0.0, 2.0, 0.0};
    world.load(level);
    EXPECT_EQ(jointError(world.joints().at(firstJoint(world))), "");
}

TEST(Joint, DetachingTheLastHeldEndOfARopeRemovesIt) {
    World world;
    world.load(beamAndPost());
    const ShapeHandle beam = world.joints().at(firstJoint(world)).ends[0].shape,
                      post = world.joints().at(firstJoint(world)).ends[1].shape;
    Joint rope = jointAt(world, JointKind::Rope, beam, post, {{3.0, 1.05, 0.05}});
    rope.rope.length = 2.0;
    for (const bool bothOnOneShape : {false, true}) {
        if (bothOnOneShape) rope = jointAt(world, JointKind::Rope, beam, beam, {{1.0, 1.05, 0.05}});
        rope.rope.length = 2.0;
        const JointHandle handle = world.applyEdits({AddJointEdit{rope}}).jointsCreated.at(0);
        if (!bothOnOneShape) {
            EXPECT_TRUE(world.applyEdits({DetachJointEdit{handle, post}}).jointsBroken.empty());
            EXPECT_TRUE(world.joints().at(handle).ends[1].isFree);
        }
        const FrameChanges changes = world.applyEdits({DetachJointEdit{handle, beam}});
        EXPECT_FALSE(world.joints().find(handle));
        ASSERT_EQ(changes.jointsBroken.size(), 1u);
        EXPECT_EQ(changes.jointsBroken[0].reason, JointBreak::Removed);
    }
}

TEST(Joint, AGrabHoldsAShapeByItsFirstEndAndNothingElse) {
    World world;
    world.load(beamAndPost());
    const ShapeHandle beam = world.joints().at(firstJoint(world)).ends[0].shape;
    const Joint grab = jointAt(world, JointKind::Ball, beam, {}, {{1.0, 1.05, 0.05}});
    Joint reversed = jointAt(world, JointKind::Ball, {}, beam, {{1.0, 1.05, 0.05}}), rope = grab, both = grab;
    rope.kind = JointKind::Rope;
    both.ends[1] = both.ends[0];
    const size_t before = world.joints().size();
    for (Joint each : {reversed, rope, both}) {
        each.hand = 1;
        EXPECT_TRUE(world.applyEdits({AddJointEdit{each}}).jointsCreated.empty());
        world.applyEdits({ReleaseEdit{}});
        EXPECT_EQ(world.joints().size(), before);
    }
    Joint valid = grab;
    valid.hand = 1;
    EXPECT_EQ(world.applyEdits({AddJointEdit{valid}}).jointsCreated.size(), 1u);
    world.applyEdits({ReleaseEdit{}});
    EXPECT_EQ(world.joints().size(), before);
    Joint loose = grab;  // a ball joint cannot hang free
    loose.ends[1].isFree = true;
    EXPECT_TRUE(world.applyEdits({AddJointEdit{loose}}).jointsCreated.empty());
}

/// Two shapes of one free body, and another body.
TEST(Joint, OnlyARopeHasBothEndsOnOneBody) {
    Level level = beamAndPost();
    LevelShape second = levelShape("second", solidGrid({4, 4, 4}, 1));
    second.local.position = {0.0, 0.1, 0.0};
    level.bodies[0].shapes.push_back(second);
    level.joints.push_back({{.name = "itself", .kind = JointKind::Fixed}, {"shape", "shape"}});
    level.joints.push_back({{.name = "one body", .kind = JointKind::Hinge}, {"shape", "second"}});
    World world;
    world.load(level);
    EXPECT_EQ(world.joints().size(), 1u) << "the hinge between beam and post";
    const std::vector<ShapeHandle> shapes = world.bodies().at(world.bodies().handleAt(0)).shapes;
    const Pose frame{{0.05, 1.05, 0.05}};
    for (int kind = 0; kind <= int(JointKind::Wheel); ++kind)
        for (const ShapeHandle other : shapes) {
            const AddJointEdit add{jointAt(world, JointKind(kind), shapes[0], other, frame)};
            const bool isRope = JointKind(kind) == JointKind::Rope;
            EXPECT_EQ(world.applyEdits({add}).jointsCreated.size(), isRope ? 1u : 0u) << kind;
        }
}

TEST(Joint, UndoRestoresBrokenAndMovedJoints) {
    World world;
    world.load(beamAndPost());
    WorldSettings settings;
    settings.undoMarks = 4;
    world.applyEdits({SettingsEdit{settings}});
    world.applyEdits({HistoryEdit{}});
    const uint64_t before = resolvedHash(world);
    for (const double x : {3.0, 2.05}) {
        world.applyEdits({sphereCarve({x, 1.05, 0.05}, 0.06)});
        EXPECT_NE(resolvedHash(world), before);
        const FrameChanges changes = world.applyEdits({HistoryEdit{HistoryAction::Undo}});
        EXPECT_EQ(resolvedHash(world), before);
        EXPECT_FALSE(changes.jointsCreated.empty() && changes.jointsChanged.empty());
        const JointHandle joint = firstJoint(world);
        ASSERT_TRUE(world.joints().find(joint));
        EXPECT_EQ(world.data().jointIndex.of(world.joints().at(joint).ends[0].shape).size(), 1u);
        world.applyEdits({HistoryEdit{}});
    }
}

TEST(JointIndex, ListsWhatWindsAndWhatTurns) {
    SlotMap<JointHandle, Joint> joints;
    JointIndex index;
    const JointHandle still = joints.insert({.kind = JointKind::Rope}), rope = joints.insert({.kind = JointKind::Rope}),
                      wheel = joints.insert({.kind = JointKind::Wheel, .steer = 0.1, .steerTarget = 0.2});
    for (const JointHandle each : {still, rope, wheel}) index.add(each, joints.at(each));
    EXPECT_TRUE(index.winding().empty());
    ASSERT_EQ(index.turning().size(), 1u);
    EXPECT_EQ(index.turning()[0], wheel);
    joints.at(rope).motor.mode = MotorMode::Speed, joints.at(wheel).steer = 0.2;
    for (const JointHandle each : {rope, wheel}) index.updateDrive(each, joints.at(each));
    ASSERT_EQ(index.winding().size(), 1u);
    EXPECT_EQ(index.winding()[0], rope);
    EXPECT_TRUE(index.turning().empty());
    index.remove(rope, joints.at(rope));
    EXPECT_TRUE(index.winding().empty());
}

}  // namespace
}  // namespace rubble
