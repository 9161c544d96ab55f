#include "runtime/shadow/shadow_worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <thread>

#include "runtime/core/log.h"
#include "tests/runtime/shadow/received_volume.h"
#include "tests/support/allocation_count.h"

namespace rubble {
namespace {

std::atomic<int> g_lines = 0;  ///< of the log

int editCount() {
    return std::getenv("RUBBLE_LONG") ? 10'000 : 500;
}

/// A world of 128^3 voxels with 50 bodies that move about in it, and random edits of it.
class Demolition {
public:
    explicit Demolition(uint64_t seed) : m_random(seed) {
        std::vector<LevelBody> bodies;
        const auto building = [](glm::ivec3 c) {
            return uint8_t(c.y < 6 ? 1 : c.y % 30 < 2 || c.x % 40 < 2 ? 1 : c.z % 50 < 1 ? 2 : 0);
        };
        bodies.push_back(makeBody(gridOf({128, 128, 128}, building), {}, true));
        bodies.push_back(makeBody(gridOf({20, 60, 3}, [](glm::ivec3) { return uint8_t(1); }),
                                  {{3, 1, 9}, glm::angleAxis(0.6, glm::dvec3(0, 1, 0))}, true));
        for (int i = 0; i < 50; ++i) {
            const int size = m_random.between(2, 14);
            const uint8_t entry = uint8_t(1 + m_random.below(8) / 7);
            const Pose pose{drawPoint(m_random, 0.0, 12.0), drawRotation(m_random)};
            bodies.push_back(makeBody(gridOf(glm::ivec3(size), [&](glm::ivec3) { return entry; }), pose, false));
        }
        m_world = worldOf(std::move(bodies));
    }

    /// One step: an edit, then new poses for the bodies that are awake.
    void step() {
        Edits edits;
        CarveEdit carve;
        carve.position = drawPoint(m_random, 0.0, 12.8);
        const double radius = 0.1 + double(m_random.unit());
        carve.radii = {radius, radius, radius};
        PaintEdit paint;
        paint.position = carve.position;
        if (m_random.below(5)) edits.push_back(carve);
        if (!m_random.below(5)) edits.push_back(paint);
        m_changes = m_world.applyEdits(edits);
        move();
    }
    const World& world() const { return m_world; }
    const FrameChanges& changes() const { return m_changes; }
    std::span<const BodyPose> moved() const { return m_moved; }

private:
    void move() {
        m_moved.clear();
        std::vector<BodyHandle> awake;
        m_world.bodies().forEach([&](BodyHandle handle, const Body& body) {
            if (!body.isStatic && awake.size() < 50) awake.push_back(handle);
        });
        for (const BodyHandle handle : awake) {
            const Body& body = m_world.bodies().at(handle);
            if (body.asleep && m_random.below(20)) continue;
            const bool sleeps = !m_random.below(30);
            const glm::dvec3 turn = drawPoint(m_random, -0.1, 0.1), shift = drawPoint(m_random, -0.2, 0.2);
            Pose pose = body.pose;
            if (!sleeps) {
                pose.position += shift;
                pose.rotation = glm::normalize(glm::dquat(1.0, turn.x, turn.y, turn.z) * pose.rotation);
            }
            m_moved.push_back({handle, pose, {}, {}, sleeps});
        }
        m_world.setPoses(m_moved);
    }
    Random m_random;
    World m_world;
    FrameChanges m_changes;
    std::vector<BodyPose> m_moved;
};

void expectRebuildAtEveryPublish(ShadowWorker::Mode mode, int edits) {
    Demolition demolition(11);
    ShadowWorker worker(mode);
    Random random(12);
    Volume volume;
    std::map<uint64_t, Volume> expected;  // by steps that are not published yet
    uint64_t version = 0;
    int publications = 0;
    for (int i = 0; i < edits; ++i) {
        demolition.step();
        const uint64_t step = demolition.changes().step;
        worker.submit(demolition.changes(), demolition.moved(), demolition.world());
        expected[step] = rebuild(demolition.world());
        if (i + 1 == edits || !random.below(3)) worker.waitFor(step);
        for (const ShadowPatches& publication : worker.takePatches()) {
            ASSERT_GT(publication.version, version) << "versions increase";
            version = publication.version;
            volume.apply(publication);
            ASSERT_TRUE(volume == expected.at(version)) << "at version " << version;
            ASSERT_EQ(volume.wrongBoxes(), 0u) << "at version " << version;
            expected.erase(expected.begin(), expected.upper_bound(version));
            ++publications;
        }
        ASSERT_TRUE(mode == ShadowWorker::Mode::Thread || version == step);
    }
    EXPECT_EQ(version, demolition.changes().step);
    EXPECT_GT(publications, edits / 4);
    EXPECT_GT(demolition.world().shapes().size(), 52u) << "nothing broke off";
}

TEST(ShadowWorker, EqualsARebuildAtEveryPublishInline) {
    expectRebuildAtEveryPublish(ShadowWorker::Mode::Inline, editCount() / 4);
}
TEST(ShadowWorker, EqualsARebuildAtEveryPublishOnItsThread) {
    expectRebuildAtEveryPublish(ShadowWorker::Mode::Thread, editCount());
}

/// Counts a worker's pieces of work, so that a test can act at a point of it.
class Progress {
public:
    void add() {
        ++m_pieces;
        m_pieces.notify_one();
    }
    uint32_t pieces() const { return m_pieces; }
    /// Waits until so many pieces were begun.
    void waitFor(uint32_t pieces) {
        for (uint32_t now = m_pieces; now < pieces; now = m_pieces) m_pieces.wait(now);
    }

private:
    std::atomic<uint32_t> m_pieces = 0;
};

TEST(ShadowWorker, StopsAndChangesLevelsAtAnyPoint) {
    Random random(5);
    for (int round = 0; round < 12; ++round) {
        Progress progress;
        ShadowWorker worker(ShadowWorker::Mode::Thread, [&] { progress.add(); });
        Volume volume;
        uint64_t step = 0;
        uint32_t begin = 0;
        for (int level = 0; level < 2; ++level) {
            Demolition demolition(uint64_t(round) * 2 + uint64_t(level));  // its steps begin at 1 again
            begin = progress.pieces();
            for (uint32_t i = 2 + random.below(4); i; --i) {
                demolition.step();
                worker.submit(demolition.changes(), demolition.moved(), demolition.world());
                if (random.below(2)) continue;
                for (const ShadowPatches& publication : worker.takePatches()) volume.apply(publication);
            }
            step = demolition.changes().step;
            if (random.below(2)) continue;
            worker.waitFor(step);
            for (const ShadowPatches& publication : worker.takePatches()) volume.apply(publication);
            ASSERT_TRUE(volume == rebuild(demolition.world()));
        }
        progress.waitFor(begin + random.below(600));  // the second level alone has more
    }
}

TEST(ShadowWorker, AStepInWhichNothingHappensIsFree) {
    for (const auto mode : {ShadowWorker::Mode::Inline, ShadowWorker::Mode::Thread}) {
        World world;
        ShadowWorker worker(mode);
        for (int i = 0; i < 10; ++i) {
            const FrameChanges changes = world.applyEdits({});
            worker.submit(changes, {}, world);
            EXPECT_EQ(worker.publishedVersion(), changes.step) << "nothing to wait for";
            EXPECT_TRUE(worker.takePatches().empty());
        }
    }
}

TEST(ShadowWorker, StepsInWhichNothingHappensDoNotAge) {
    World world = worldOf({makeBody(solidGrid({8, 8, 8}), {}, true)});
    std::atomic<bool> isHeld = false;
    ShadowWorker worker(ShadowWorker::Mode::Thread, [&] { isHeld.wait(true); });
    const auto submit = [&](const Edits& edits) {
        const FrameChanges changes = world.applyEdits(edits);
        worker.submit(changes, {}, world);
        return changes.step;
    };
    worker.waitFor(submit({}));
    for (int i = 0; i < 50; ++i) submit({});
    CarveEdit carve;
    carve.radii = {0.3, 0.3, 0.3};
    isHeld = true;
    const uint64_t step = submit({carve});
    EXPECT_EQ(worker.lag(), 1u);
    EXPECT_EQ(worker.publishedVersion(), step - 1);
    submit({});
    EXPECT_EQ(worker.lag(), 2u);
    isHeld = false;
    isHeld.notify_all();
    worker.waitFor(step + 1);
    EXPECT_EQ(worker.publishedVersion(), step + 1);
}

TEST(ShadowWorker, SleepingBodiesCostNothing) {
    const VoxelGrid cube = gridOf(glm::ivec3(8), [](glm::ivec3) { return uint8_t(1); });
    World world = worldOf({makeBody(cube, {{1, 1, 1}, glm::angleAxis(0.4, glm::dvec3(0, 1, 0))}, false),
                           makeBody(cube, {{5, 1, 1}}, false)});
    ShadowWorker worker(ShadowWorker::Mode::Inline);
    worker.submit(world.applyEdits({}), {}, world);
    EXPECT_FALSE(worker.takePatches().at(0).patches.empty());
    std::vector<BodyPose> asleep;
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        asleep.push_back({handle, body.pose, {}, {}, true});
    });
    worker.submit(world.applyEdits({}), asleep, world);
    const std::vector<ShadowPatches> patches = worker.takePatches();
    ASSERT_EQ(patches.size(), 1u) << "a version for each step that may have changed something";
    EXPECT_TRUE(patches[0].patches.empty());
}

TEST(ShadowWorker, AnErrorInItEndsNoProcessAndAnotherLevelStartsItAgain) {
    World world = worldOf({makeBody(solidGrid({800, 8, 800}), {}, true)});
    for (const auto mode : {ShadowWorker::Mode::Inline, ShadowWorker::Mode::Thread}) {
        ShadowWorker worker(mode);
        setLogSink([](void* lines, LogLevel, std::string_view) { ++*static_cast<std::atomic<int>*>(lines); }, &g_lines);
        limitAllocations(20'000);  // less than the list of its bricks needs
        const int before = g_lines;
        FrameChanges changes = world.applyEdits({});
        changes.levelReplaced = true;
        worker.submit(changes, {}, world);
        worker.waitFor(changes.step);
        limitAllocations(~size_t(0));
        setLogSink(nullptr, nullptr);
        if (g_lines == before) GTEST_SKIP() << "allocations cannot be limited here";
        Volume volume;
        for (const ShadowPatches& publication : worker.takePatches()) volume.apply(publication);
        EXPECT_TRUE(volume.empty());
        changes = world.applyEdits({});
        changes.levelReplaced = true;
        worker.submit(changes, {}, world);
        worker.waitFor(changes.step);
        for (const ShadowPatches& publication : worker.takePatches()) volume.apply(publication);
        EXPECT_TRUE(volume == rebuild(world));
    }
}

TEST(ShadowWorker, LargeVoxelsCostTheirSurface) {
    World world = worldOf({makeBody(solidGrid({8, 8, 8}), {{1.0, 2.0, 3.0}}, true, 20.0f)});
    ShadowWorker worker(ShadowWorker::Mode::Inline);
    worker.submit(world.applyEdits({}), {}, world);
    size_t bricks = 0;
    Volume volume;
    for (const ShadowPatches& publication : worker.takePatches()) {
        bricks += publication.patches.size();
        volume.apply(publication);
    }
    EXPECT_LE(bricks, size_t(6 * 102 * 102)) << "of 1.6 m, on the faces of a cube of 160 m; there are a million inside";
    const glm::dvec3 middle(81.0, 82.0, 83.0);
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 from = middle, toward(0.0);
            from[axis] += side * 80.5;
            toward[axis] = -side;
            from[(axis + 1) % 3] += 33.3;
            EXPECT_TRUE(volume.occluded(from, toward, 1.0));
            EXPECT_FALSE(volume.occluded(from, -toward, 1.0));
        }
    CarveEdit carve;  // the corner voxel goes: what is behind it is a surface now
    carve.position = {11.0, 12.0, 13.0};
    carve.radii = {9.0, 9.0, 9.0};
    worker.submit(world.applyEdits({carve}), {}, world);
    for (const ShadowPatches& publication : worker.takePatches()) volume.apply(publication);
    EXPECT_FALSE(volume.occluded({0.0, 12.0, 13.0}, {1.0, 0.0, 0.0}, 20.0));
    EXPECT_TRUE(volume.occluded({0.0, 12.0, 13.0}, {1.0, 0.0, 0.0}, 22.0));
}

TEST(ShadowWorker, AShapeBeyondItsBudgetIsLeftOut) {
    World world = worldOf({makeBody(solidGrid({64, 8, 64}), {}, true, 1000.0f)});
    ShadowWorker worker(ShadowWorker::Mode::Inline);
    worker.submit(world.applyEdits({}), {}, world);
    for (const ShadowPatches& publication : worker.takePatches()) EXPECT_TRUE(publication.patches.empty());
}

TEST(ShadowWorker, AShapeBeyondItsBudgetIsLoggedOnce) {
    World world = worldOf({makeBody(solidGrid({64, 8, 64}), {}, false, 1000.0f)});
    ShadowWorker worker(ShadowWorker::Mode::Inline);
    BodyHandle body;
    world.bodies().forEach([&](BodyHandle handle, const Body&) { body = handle; });
    const int before = g_lines;
    setLogSink([](void* lines, LogLevel, std::string_view) { ++*static_cast<std::atomic<int>*>(lines); }, &g_lines);
    for (int step = 0; step < 10; ++step) {
        const FrameChanges changes = world.applyEdits({});
        const std::vector<BodyPose> moved = {{body, {{100.0 * step, 0.0, 0.0}}, {}, {}, false}};
        world.setPoses(moved);
        worker.submit(changes, moved, world);
    }
    setLogSink(nullptr, nullptr);
    EXPECT_EQ(g_lines - before, 1);
}

TEST(ShadowWorker, AShapeTooFarFromTheOriginIsLoggedOnce) {
    for (const double metres : {0.99e8, 1.01e8, -1.01e8}) {
        World world = worldOf({makeBody(solidGrid({4, 4, 4}), {{0, 0, metres}}, true),
                               makeBody(solidGrid({4, 4, 4}), {{2, 0, metres}}, true)});
        ShadowWorker worker(ShadowWorker::Mode::Inline);
        const int before = g_lines;
        setLogSink([](void* lines, LogLevel, std::string_view) { ++*static_cast<std::atomic<int>*>(lines); }, &g_lines);
        worker.submit(world.applyEdits({}), {}, world);
        setLogSink(nullptr, nullptr);
        const bool casts = std::abs(metres) < 1e8;
        EXPECT_EQ(g_lines - before, casts ? 0 : 1) << metres;
        for (const ShadowPatches& publication : worker.takePatches())
            EXPECT_NE(publication.patches.empty(), casts) << metres;
    }
}

TEST(ShadowWorker, WithoutMemoryTheVolumeStaysAsItIsUntilAllIsReplaced) {
    World world = worldOf({makeBody(solidGrid({64, 64, 64}), {}, true)});
    if (!allocationCount()) GTEST_SKIP() << "this sanitizer counts no allocations";
    ShadowWorker worker(ShadowWorker::Mode::Thread);
    Volume volume;
    const auto submit = [&](const Edits& edits) {
        const FrameChanges changes = world.applyEdits(edits);
        worker.submit(changes, {}, world);
        worker.waitFor(changes.step);
        for (const ShadowPatches& publication : worker.takePatches()) volume.apply(publication);
    };
    submit({});
    const Volume before = volume;
    const int lines = g_lines;
    setLogSink([](void* count, LogLevel, std::string_view) { ++*static_cast<std::atomic<int>*>(count); }, &g_lines);
    CarveEdit carve;
    carve.position = {1.0, 6.4, 1.0};
    carve.radii = {0.8, 0.8, 0.8};
    {
        const AllocationFailure failure(0, AllocationFailure::Threads::Others);
        submit({carve});
        EXPECT_TRUE(failure.hasHappened());
    }
    carve.position.x = 3.0;
    submit({carve});
    setLogSink(nullptr, nullptr);
    EXPECT_EQ(g_lines - lines, 1) << "the log says it once";
    EXPECT_TRUE(volume == before);
    world = worldOf({makeBody(solidGrid({16, 16, 16}), {}, true)});
    submit({});
    EXPECT_TRUE(volume == rebuild(world));
}

TEST(ShadowWorker, AnEditOfLargeVoxelsBuildsTheBricksBesideIt) {
    World world = worldOf({makeBody(solidGrid({32, 8, 32}), {{1.0, 2.0, 3.0}}, true, 2.0f)});
    size_t work = 0;
    ShadowWorker worker(ShadowWorker::Mode::Inline, [&] { ++work; });
    Volume volume;
    const auto submit = [&](const Edits& edits) {
        work = 0;
        worker.submit(world.applyEdits(edits), {}, world);
        for (const ShadowPatches& publication : worker.takePatches()) volume.apply(publication);
        return work;
    };
    const size_t all = submit({});
    EXPECT_GT(all, 4000u) << "bricks and shapes";
    CarveEdit carve;
    carve.position = {2.0, 17.0, 4.0};
    carve.radii = {1.5, 1.5, 1.5};
    EXPECT_LT(submit({carve}), all / 8) << "8x8x8 voxels of 32x8x32 are beside the change";
    EXPECT_TRUE(volume == rebuild(world));
    carve.position += glm::dvec3(2.0, 0.0, 0.0);  // beside the hole, so that open faces vanish and come
    CarveEdit other = carve;
    other.position = {50.0, 17.0, 30.0};
    EXPECT_LT(submit({carve, other}), all / 4);
    EXPECT_TRUE(volume == rebuild(world));
}

TEST(ShadowWorker, ALargeShapeCastsNoShadowWhileItMovesAndCostsNothingThen) {
    World world = worldOf({makeBody(solidGrid({3, 3, 3}), {}, false, 30.0f),
                           makeBody(solidGrid({2, 2, 2}), {{500.0, 0.0, 0.0}}, false, 8.0f)});
    size_t work = 0;
    ShadowWorker worker(ShadowWorker::Mode::Inline, [&] { ++work; });
    std::vector<BodyHandle> bodies;
    world.bodies().forEach([&](BodyHandle handle, const Body&) { bodies.push_back(handle); });
    Volume volume;
    const auto move = [&](double y, bool asleep) {
        const std::vector<BodyPose> moved = {{bodies[0], {{0.0, y, 0.0}}, {}, {}, asleep},
                                             {bodies[1], {{500.0, y, 0.0}}, {}, {}, asleep}};
        world.setPoses(moved);
        worker.submit(world.applyEdits({}), moved, world);
        for (const ShadowPatches& publication : worker.takePatches()) volume.apply(publication);
    };
    const auto isDark = [&](double x) { return volume.occluded({x, 110.0, 5.0}, {0.0, -1.0, 0.0}, 150.0); };
    for (const double y : {10.0, 9.0, 8.0}) {
        work = 0;
        move(y, false);
        EXPECT_LT(work, 2000u) << "bricks and shapes";
        EXPECT_FALSE(isDark(45.0)) << "a cube of 90 m";
        EXPECT_TRUE(isDark(505.0)) << "one of 16 m";
    }
    move(8.0, true);
    EXPECT_TRUE(isDark(45.0));
    EXPECT_TRUE(volume == rebuild(world));
}

/// Bricks that are replaced, and entries of those that are empty again, are used for the next.
TEST(ShadowWorker, WhatMovesTakesNoMemoryForWhatItChanges) {
    constexpr int kBodies = 30, kSteps = 40;
    std::vector<LevelBody> bodies;
    for (int i = 0; i < kBodies; ++i) bodies.push_back(makeBody(solidGrid({6, 6, 6}), {{2.0 * i, 0, 0}}, false));
    World world = worldOf(std::move(bodies));
    ShadowWorker worker(ShadowWorker::Mode::Inline);
    Volume volume;
    std::vector<BodyPose> moved;
    world.bodies().forEach([&](BodyHandle handle, const Body& body) { moved.push_back({handle, body.pose}); });
    const auto allocationsOf = [&](int steps) {
        size_t sum = 0;
        for (int step = 0; step < steps; ++step) {
            for (BodyPose& each : moved) each.pose.position.z += 0.11;
            world.setPoses(moved);
            const FrameChanges changes = world.applyEdits({});
            const size_t before = allocationCount();
            worker.submit(changes, moved, world);
            sum += allocationCount() - before;
            for (const ShadowPatches& publication : worker.takePatches()) {
                EXPECT_GE(publication.patches.size(), size_t(kBodies));
                volume.apply(publication);
            }
        }
        return sum;
    };
    allocationsOf(kSteps);
    EXPECT_LE(allocationsOf(kSteps), size_t(10 * kSteps));
    EXPECT_TRUE(volume == rebuild(world));
}

}  // namespace
}  // namespace rubble
