// Bodies that wait for a place in the budget of wakes: that they do is part of the world's state.
#include <gtest/gtest.h>

#include "tests/runtime/plugin/headless_loop.h"
#include "tests/runtime/world/worlds.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

using namespace test;

constexpr int kCubes = 300;

/// Cubes on a ground that do not touch each other, and wake 20 a step.
class Waiting : public testing::Test {
protected:
    Waiting() : m_loop(settings()), m_other(settings()) {
        Level level;
        level.bodies.push_back({.name = "ground", .pose = {{-1.0, -0.2, -1.0}}});
        level.bodies[0].shapes.push_back(levelShape("ground", solidGrid({170, 2, 100}, 1)));
        for (int i = 0; i < kCubes; ++i) {
            LevelBody cube{.name = "cube", .pose = {{0.5 * (i % 30), 0.0, 0.5 * (i / 30)}}, .isStatic = false};
            cube.shapes.push_back(levelShape("cube", solidGrid({3, 3, 3}, 1)));
            level.bodies.push_back(std::move(cube));
        }
        m_loop.load(level);
        m_loop.step();
    }

    static FrameLoopSettings settings() {
        FrameLoopSettings settings = headlessSettings();
        settings.physics.wakesPerStep = 20;
        return settings;
    }

    /// Takes the ground away.
    void removeGround() {
        const World& world = m_loop.world();
        const ShapeHandle ground = world.bodies().at(world.bodies().handleAt(0)).shapes[0];
        m_loop.edits().push(Edits{CarveEdit{
            .kind = BrushKind::Box, .position = {7.5, -0.1, 4.0}, .halfSize = {9.0, 0.2, 6.0}, .shape = ground}});
        m_loop.step();
        ASSERT_GT(waiting(m_loop), kCubes / 2);
    }

    static int waiting(const FrameLoop& loop) {
        int count = 0;
        loop.world().bodies().forEach([&](BodyHandle, const Body& body) { count += body.waitsToWake; });
        return count;
    }

    /// The cubes that have not fallen.
    static int hanging(const FrameLoop& loop) {
        int count = 0;
        loop.world().bodies().forEach(
            [&](BodyHandle, const Body& body) { count += body.name == "cube" && body.pose.position.y > -0.5; });
        return count;
    }

    FrameLoop m_loop, m_other;
};

TEST_F(Waiting, TheWorldKnowsWhoDoes) {
    removeGround();
    for (int i = 0; i < 60; ++i) {
        EXPECT_EQ(waiting(m_loop), m_loop.physics()->stats().waiting);
        m_loop.world().bodies().forEach(
            [&](BodyHandle, const Body& body) { EXPECT_TRUE(body.asleep || !body.waitsToWake); });
        m_loop.step();
    }
    EXPECT_EQ(waiting(m_loop), 0);
    EXPECT_EQ(hanging(m_loop), 0);
}

TEST_F(Waiting, ASaveChangesNothing) {
    removeGround();
    const uint64_t before = m_loop.world().hash();
    const int waited = waiting(m_loop);
    const std::vector<uint8_t> bytes = gameToBytes(m_loop.save());
    EXPECT_EQ(m_loop.world().hash(), before);
    Result<SavedGame> saved = gameFromBytes(bytes, "save", m_other.world().id());
    ASSERT_TRUE(saved) << saved.error();
    m_other.load(std::move(*saved));
    EXPECT_EQ(m_other.world().hash(), before);
    EXPECT_EQ(waiting(m_other), waited);
    for (int i = 0; i < 100; ++i) {
        m_loop.step(), m_other.step();
        ASSERT_EQ(m_loop.world().hash(), m_other.world().hash()) << i;
        if (i == 0) {
            EXPECT_GT(waiting(m_loop), waited - 20) << "they wake in turns, as without a save";
        }
    }
    EXPECT_EQ(hanging(m_loop), 0);
}

TEST_F(Waiting, RecordingsReplay) {
    const TempFolder folder;
    ASSERT_TRUE(m_loop.startRecording(folder / "first.rubblelog"));
    removeGround();
    for (int i = 0; i < 3; ++i) m_loop.step();
    ASSERT_TRUE(m_loop.startRecording(folder / "second.rubblelog")) << "it begins while they wait";
    ASSERT_GT(waiting(m_loop), 0);
    for (int i = 0; i < 40; ++i) m_loop.step();
    ASSERT_TRUE(m_loop.stopRecording());
    for (const char* name : {"first.rubblelog", "second.rubblelog"}) expectReplay(m_other, folder / name);
}

TEST_F(Waiting, FollowersKnowWhoDoes) {
    m_other.load(m_loop.save());
    m_loop.keepDeltas(DeltaContent::All);
    removeGround();
    Result<Deltas> deltas = deltasFromBytes(m_loop.deltas()->file(), "deltas", m_other.world().id());
    ASSERT_TRUE(deltas) << deltas.error();
    const Result<Done> followed = m_other.follow(*deltas, [] {});
    ASSERT_TRUE(followed) << followed.error();
    EXPECT_EQ(waiting(m_other), waiting(m_loop));
    EXPECT_EQ(m_other.world().hash(), m_loop.world().hash());
}

/// What waits after an undo is what waited at the mark, whatever has woken since.
TEST_F(Waiting, AnUndoGoesBackToWhoDid) {
    WorldSettings settings = m_loop.world().settings();
    settings.undoMarks = 2;
    m_loop.edits().push(Edits{SettingsEdit{settings}});
    m_loop.step();
    removeGround();
    const int waited = waiting(m_loop);
    m_loop.edits().push(Edits{HistoryEdit{HistoryAction::Mark}});
    for (int i = 0; i < 60; ++i) m_loop.step();
    ASSERT_EQ(waiting(m_loop), 0);
    m_loop.edits().push(Edits{HistoryEdit{HistoryAction::Undo}});
    m_loop.step();
    EXPECT_GE(waiting(m_loop), waited - 20);
    EXPECT_LT(waiting(m_loop), waited);
    for (int i = 0; i < 60; ++i) m_loop.step();
    EXPECT_EQ(hanging(m_loop), 0);
}

/// A host that puts one to sleep means it.
TEST_F(Waiting, WhatIsPutToSleepWaitsNoLonger) {
    removeGround();
    BodyHandle last;
    m_loop.world().bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (body.waitsToWake) last = handle;
    });
    SetBodyEdit sleep{.body = last};
    sleep.setsSleep = sleep.asleep = true;
    m_loop.edits().push(Edits{sleep});
    m_loop.step();
    EXPECT_FALSE(m_loop.world().bodies().at(last).waitsToWake);
    for (int i = 0; i < 60; ++i) m_loop.step();
    EXPECT_TRUE(m_loop.world().bodies().at(last).asleep);
    EXPECT_EQ(hanging(m_loop), 1);
}

}  // namespace
}  // namespace rubble
