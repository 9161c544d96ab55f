#include "runtime/frame/snapshots.h"

#include <gtest/gtest.h>

#include "runtime/shadow/shadow_worker.h"
#include "tests/support/allocation_count.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

LevelBody makeBody(const char* name, glm::dvec3 position, glm::ivec3 size, bool isStatic) {
    LevelBody body;
    body.pose.position = position;
    body.isStatic = isStatic;
    auto palette = std::make_shared<Palette>();
    (*palette)[1].material = defaultMaterials().find("wood");
    LevelShape shape;
    shape.name = name;
    shape.grid = solidGrid(size);
    shape.palette = palette;
    body.shapes.push_back(std::move(shape));
    return body;
}

/// A wall, a falling crate with a light on it, and another crate.
World makeWorld() {
    Level level;
    level.bodies.push_back(makeBody("wall", {0, 0, 0}, {20, 40, 2}, true));
    level.bodies.push_back(makeBody("crate", {0, 9, 0}, {8, 8, 8}, false));
    level.bodies.push_back(makeBody("other", {4, 9, 0}, {8, 8, 8}, false));
    LevelLight light;
    light.light.name = "light";
    light.shapeName = "crate";
    level.lights.push_back(light);
    World world;
    world.load(level);
    return world;
}

BodyPose moveTo(const World& world, uint32_t slot, double y) {
    BodyPose out;
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (handle.slot() != slot) return;
        out = {handle, body.pose, {}, {}, false};
        out.pose.position.y = y;
    });
    return out;
}

/// One step of a loop without physics.
struct Loop {
    World world = makeWorld();
    Snapshots snapshots;
    FrameChanges changes;

    void step(const Edits& edits = {}, std::vector<BodyPose> moved = {}) {
        changes = world.applyEdits(edits);
        world.setPoses(moved);
        snapshots.publishWithoutShadow(changes, moved, world);
    }
};

TEST(Snapshots, TheFirstHoldsTheWholeLevel) {
    Loop loop;
    loop.step();
    const auto first = loop.snapshots.take();
    ASSERT_TRUE(first);
    EXPECT_TRUE(first->replacesAll && first->shadowReplacesAll && first->environmentChanged && first->lightsChanged);
    EXPECT_EQ(first->version, 1u);
    EXPECT_EQ(first->created.size(), 3u);
    EXPECT_EQ(first->poses.size(), 3u) << "world poses of what was created";
    EXPECT_EQ(first->lights.size(), 1u);
    ASSERT_EQ(first->materials.size(), loop.world.materials().materials.size());
    EXPECT_EQ(first->materials[1], loop.world.materials()[1].name);
    EXPECT_EQ(first->created[0].bricks.size(), 3u * 5 * 1);
    EXPECT_FALSE(loop.snapshots.take());
}

TEST(Snapshots, AMovedBodyHasBothPosesAndComesToRestOnce) {
    Loop loop;
    loop.step();
    loop.snapshots.take();
    loop.step({}, {moveTo(loop.world, 2, 8.5)});
    const auto moved = loop.snapshots.take();
    ASSERT_TRUE(moved);
    ASSERT_EQ(moved->poses.size(), 1u);
    EXPECT_EQ(moved->poses[0].previous.position.y, 9.0);
    EXPECT_EQ(moved->poses[0].current.position.y, 8.5);
    EXPECT_FALSE(moved->lightsChanged) << "its light did not move";
    loop.step();
    const auto rested = loop.snapshots.take();
    ASSERT_TRUE(rested);
    ASSERT_EQ(rested->poses.size(), 1u);
    EXPECT_EQ(rested->poses[0].previous.position.y, 8.5);
    EXPECT_EQ(rested->poses[0].current.position.y, 8.5);
    loop.step();
    EXPECT_FALSE(loop.snapshots.take());
}

TEST(Snapshots, ABodyThatAnEditPutsFarAwayHasNoPoseBetween) {
    Loop loop;
    loop.step();
    loop.snapshots.take();
    BodyPose crate = moveTo(loop.world, 1, 9.0);
    const auto put = [&](double x, glm::dvec3 velocity) {
        crate.pose.position.x = x, crate.velocity = velocity;
        SetBodyEdit edit{.body = crate.body};
        edit.setsPose = edit.setsVelocity = true, edit.pose = crate.pose, edit.velocity = velocity;
        loop.step({edit}, {crate});
        const auto snapshot = loop.snapshots.take();
        return snapshot && snapshot->poses.size() == 1 ? snapshot->poses[0] : SnapshotPose{};
    };
    SnapshotPose pose = put(3.0, {});
    EXPECT_EQ(pose.current.position.x, 3.0);
    EXPECT_EQ(pose.previous, pose.current) << "it jumped";
    pose = put(3.3, {});
    EXPECT_EQ(pose.previous.position.x, 3.0) << "a host moves it step by step";
    pose = put(4.3, {60, 0, 0});
    EXPECT_EQ(pose.previous.position.x, 3.3) << "it is that fast";
    crate.pose.rotation = glm::angleAxis(1.0, glm::dvec3(0, 1, 0));
    pose = put(4.3, {});
    EXPECT_EQ(pose.previous, pose.current) << "it jumped to another rotation";
}

TEST(Snapshots, LightsFollowTheirBody) {
    Loop loop;
    loop.step();
    loop.snapshots.take();
    loop.step({}, {moveTo(loop.world, 1, 8.0)});
    const auto moved = loop.snapshots.take();
    ASSERT_TRUE(moved && moved->lightsChanged);
    EXPECT_EQ(moved->lights.at(0).position.y, 8.0);
}

TEST(Snapshots, LightsComeAndGoWithTheStepOfTheirEdit) {
    Loop loop;
    loop.step();
    loop.snapshots.take();
    loop.step({AddLightEdit{{.local = {{0.0, 5.0, 0.0}}}}, AddLightEdit{{.enabled = false}}});
    const auto come = loop.snapshots.take();
    ASSERT_TRUE(come && come->lightsChanged);
    ASSERT_EQ(come->lights.size(), 2u);
    const LightHandle added = loop.changes.lightsAdded.at(0);
    EXPECT_EQ(come->lights[1].light, added);
    EXPECT_EQ(come->lights[1].position.y, 5.0);
    loop.step({RemoveLightEdit{added}});
    const auto gone = loop.snapshots.take();
    ASSERT_TRUE(gone && gone->lightsChanged);
    ASSERT_EQ(gone->lights.size(), 1u);
    EXPECT_NE(gone->lights[0].light, added);
}

TEST(Snapshots, APieceStartsWhereItsParentWas) {
    Loop loop;
    loop.step();
    loop.snapshots.take();
    CarveEdit cut;  // through the middle of the wall
    cut.kind = BrushKind::Box;
    cut.position = {1.0, 2.0, 0.1};
    cut.halfSize = {2.0, 0.2, 1.0};
    loop.step({cut});
    const auto split = loop.snapshots.take();
    ASSERT_TRUE(split);
    ASSERT_EQ(loop.changes.splits.size(), 1u);
    ASSERT_EQ(split->created.size(), 1u);
    ASSERT_EQ(split->poses.size(), 1u);
    EXPECT_NEAR(split->poses[0].previous.position.y, split->poses[0].current.position.y, 1e-6);
    EXPECT_FLOAT_EQ(split->poses[0].current.position.y, 0.1 * loop.changes.splits[0].parentOffset[0].y);
    EXPECT_GT(split->poses[0].current.position.y, 1.0);
    EXPECT_FALSE(split->bricks.empty());
}

TEST(Snapshots, AStepWaitsForItsShadow) {
    World world = makeWorld();
    Snapshots snapshots;
    const auto publish = [&](std::vector<BodyPose> moved, std::vector<ShadowPatches> patches) {
        const FrameChanges changes = world.applyEdits({});
        world.setPoses(moved);
        snapshots.publish(changes, moved, world, std::move(patches));
    };
    const auto reached = [](uint64_t version) {
        std::vector<ShadowPatches> patches(1);
        patches[0].version = version;
        patches[0].patches.push_back({{int(version), 0, 0}, std::make_shared<const ShadowBrick>()});
        return patches;
    };
    publish({}, {});
    EXPECT_FALSE(snapshots.take()) << "its shadow volume is not published yet";
    publish({moveTo(world, 1, 8.0)}, reached(1));
    auto first = snapshots.take();
    ASSERT_TRUE(first);
    EXPECT_EQ(first->version, 1u);
    EXPECT_EQ(first->newestStep, 2u);
    EXPECT_EQ(first->poses.at(1).current.position.y, 9.0) << "drawn at the pose that the shadow volume shows";
    EXPECT_EQ(first->shadow.size(), 1u);
    publish({moveTo(world, 1, 7.0)}, {});
    EXPECT_FALSE(snapshots.take());
    publish({moveTo(world, 1, 6.0)}, reached(3));
    const auto later = snapshots.take();
    ASSERT_TRUE(later);
    EXPECT_EQ(later->version, 3u);
    EXPECT_EQ(later->poses.at(0).previous.position.y, 8.0);
    EXPECT_EQ(later->poses.at(0).current.position.y, 7.0);
    publish({}, reached(4));
    const auto rest = snapshots.take();
    ASSERT_TRUE(rest);
    EXPECT_EQ(rest->version, 5u) << "coming to rest does not change the shadow volume";
    EXPECT_EQ(rest->poses.at(0).previous.position.y, 6.0);
    EXPECT_FALSE(snapshots.isWaiting());
    publish({moveTo(world, 1, 5.0)}, {});
    ASSERT_TRUE(snapshots.isWaiting());
    snapshots.release(reached(6));
    const auto paused = snapshots.take();
    ASSERT_TRUE(paused) << "no step must come for it";
    EXPECT_EQ(paused->version, 6u);
    EXPECT_EQ(paused->newestStep, 6u);
    EXPECT_FALSE(snapshots.isWaiting());
}

TEST(Snapshots, WithTheWorkerAllArrivesAndTheVersionsAgree) {
    Loop loop;
    ShadowWorker worker(ShadowWorker::Mode::Thread);
    Snapshots snapshots;
    uint64_t version = 0;
    double shown = 0.0;
    const auto publish = [&](const std::vector<BodyPose>& moved, bool waits) {
        const FrameChanges changes = loop.world.applyEdits({});
        loop.world.setPoses(moved);
        worker.submit(changes, moved, loop.world);
        if (waits) worker.waitFor(changes.step);
        snapshots.publish(changes, moved, loop.world, worker.takePatches());
        while (auto snapshot = snapshots.take()) {
            EXPECT_GE(snapshot->version, version);
            version = snapshot->version;
            for (const SnapshotPose& pose : snapshot->poses)
                if (pose.shape.slot() == 1) shown = pose.current.position.y;
            EXPECT_EQ(shown, version <= 100 ? 9.0 - 0.01 * double(version) : 8.0);
        }
    };
    for (int i = 1; i <= 100; ++i) publish({moveTo(loop.world, 1, 9.0 - 0.01 * i)}, i % 7 == 0);
    publish({}, true);
    EXPECT_EQ(version, 101u);
}

TEST(Snapshots, QueueStaysBoundedWithoutAReader) {
    Loop loop;
    for (int i = 0; i < 1000; ++i) loop.step({}, {moveTo(loop.world, 1, 9.0 - 0.001 * i)});
    const auto all = loop.snapshots.take();
    ASSERT_TRUE(all);
    EXPECT_EQ(all->version, 1000u);
    EXPECT_EQ(all->created.size(), 3u);
    EXPECT_EQ(all->poses.size(), 3u);
}

/// Work is counted as allocations; each pose or brick that is merged again would need one.
TEST(Snapshots, AStepCostsTheSameHoweverManyBeforeItWereNotDrawn) {
    Level level;
    for (int i = 0; i < 400; ++i) level.bodies.push_back(makeBody("crate", {i % 20, 9, int(i / 20)}, {8, 8, 8}, false));
    World world;
    world.load(level);
    Snapshots snapshots;
    ShadowWorker worker(ShadowWorker::Mode::Inline);
    const auto allocationsOfSteps = [&](int count, bool allMove) {
        size_t sum = 0;
        for (int i = 0; i < count; ++i) {
            const FrameChanges changes = world.applyEdits({});
            std::vector<BodyPose> moved;
            world.bodies().forEach([&](BodyHandle handle, const Body& body) {
                if (!allMove && handle.slot() != 1) return;
                moved.push_back({handle, body.pose, {}, {}, false});
                moved.back().pose.position.y += 0.01;
            });
            world.setPoses(moved);
            worker.submit(changes, moved, world);
            std::vector<ShadowPatches> patches = worker.takePatches();
            const size_t before = allocationCount();
            snapshots.publish(changes, moved, world, std::move(patches));
            sum += allocationCount() - before;
        }
        return sum;
    };
    allocationsOfSteps(1, false);
    ASSERT_TRUE(snapshots.take());
    const size_t few = allocationsOfSteps(64, false);
    allocationsOfSteps(400, true);
    EXPECT_LE(allocationsOfSteps(64, false), 2 * few);  // both 0 where a sanitizer has its own operator new
    const auto all = snapshots.take();
    ASSERT_TRUE(all);
    EXPECT_EQ(all->poses.size(), 400u);
}

TEST(Snapshots, AStepInWhichNothingHappensAllocatesNothing) {
    Loop loop;
    ShadowWorker worker(ShadowWorker::Mode::Inline);
    const auto step = [&] {
        const FrameChanges changes = loop.world.applyEdits({});
        worker.submit(changes, {}, loop.world);
        loop.snapshots.publish(changes, {}, loop.world, worker.takePatches());
    };
    step();
    loop.snapshots.take();
    const size_t before = allocationCount();
    for (int i = 0; i < 10; ++i) step();
    EXPECT_EQ(allocationCount(), before);
    EXPECT_FALSE(loop.snapshots.take());
}

}  // namespace
}  // namespace rubble
