#include "tests/runtime/world/random_game.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "runtime/assets/save_file.h"
#include "runtime/assets/step_delta.h"
#include "runtime/core/log.h"
#include "runtime/world/history/undo_history.h"
#include "runtime/world/history/world_baseline.h"
#include "runtime/world/objects/joint_attachment.h"
#include "tests/runtime/world/journal_check.h"

namespace rubble {
namespace {

using namespace test;

int gameCount() {
    return std::getenv("RUBBLE_LONG") ? 2000 : 24;
}

/// Random edits are refused by the hundred: their warnings are not shown.
class RandomGame : public testing::Test {
protected:
    void SetUp() override {
        setLogSink([](void*, LogLevel, std::string_view) {}, nullptr);
    }
    void TearDown() override { setLogSink(nullptr, nullptr); }
};

void expectSound(const World& world) {
    EXPECT_TRUE(voxelAccounting(world).balances());
    world.shapes().forEach([&](ShapeHandle handle, const Shape& shape) {
        EXPECT_EQ(shape.moments, gridMoments(shape.grid, *shape.palette, world.materials()));
        EXPECT_GT(shape.grid.voxelCount(), 0u);
        const std::vector<ShapeHandle>& mates = world.bodies().at(shape.body).shapes;
        EXPECT_EQ(std::count(mates.begin(), mates.end(), handle), 1);
    });
    world.joints().forEach([&](JointHandle, const Joint& joint) {
        EXPECT_EQ(jointEndsError(joint), "");
        EXPECT_EQ(jointBodiesError(joint.kind, world.shapes().find(joint.ends[0].shape),
                                   world.shapes().find(joint.ends[1].shape)),
                  "");
        for (const JointEnd& end : joint.ends) {
            if (!end.shape) continue;
            ASSERT_TRUE(world.shapes().find(end.shape));
            EXPECT_TRUE(world.shapes().at(end.shape).grid.at(end.cell)) << "it holds on to a voxel";
        }
    });
    for (const HeatField& field : world.data().fire.fields) EXPECT_TRUE(world.shapes().find(field.shape));
}

/// Expects the indexes that a load would make.
void expectIndexesAsLoaded(const World& world) {
    World loaded(world.id());
    loaded.setState(world.state());
    const WorldData &is = world.data(), &wanted = loaded.data();
    EXPECT_EQ(is.debris.count(), wanted.debris.count());
    EXPECT_EQ(is.debris.voxels(), wanted.debris.voxels());
    EXPECT_EQ(is.debris.awakeCount(), wanted.debris.awakeCount());
    if (wanted.debris.count() && is.debris.count()) {
        EXPECT_EQ(is.debris.first(), wanted.debris.first());
    }
    EXPECT_EQ(is.flickeringGroups, wanted.flickeringGroups);
    world.shapes().forEach([&](ShapeHandle handle, const Shape&) {
        const auto a = is.jointIndex.of(handle), b = wanted.jointIndex.of(handle);
        EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
    });
    EXPECT_EQ(is.jointIndex.ropes().size(), wanted.jointIndex.ropes().size());
    EXPECT_EQ(is.jointIndex.grabs().size(), wanted.jointIndex.grabs().size());
}

/// Moves every free body a little, in place of physics, and lets some sleep.
std::vector<BodyPose> moveBodies(World& world, Random& random) {
    std::vector<BodyPose> poses;
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (body.isStatic || random.below(3) == 0) return;
        BodyPose pose{handle, body.pose, body.velocity, body.angularVelocity, random.below(2) == 0};
        pose.pose.position.y -= 0.01;
        poses.push_back(pose);
    });
    world.setPoses(poses);
    return poses;
}

/// What journals tell: a baseline, as undo and recordings have one, and a follower of deltas.
class Followers {
public:
    explicit Followers(const World& world) : m_baseline(world), m_follower(world.id()) {
        m_follower.setState(world.state());
    }
    void step(const World& world, const FrameChanges& changes) {
        expectTrueJournal(changes, world);
        const std::vector<uint8_t> bytes =
            stepDeltaToBytes(m_baseline.update(world, changes), changes, world, m_palettes);
        const Result<FrameChanges> applied = applyStepDelta(bytes, "t", m_follower, m_known);
        ASSERT_TRUE(applied) << applied.error();
        EXPECT_EQ(resolvedHash(m_baseline.last()), resolvedHash(world)) << "the journal misses something";
        EXPECT_EQ(voxelHash(m_follower), voxelHash(world)) << "the delta misses something";
    }
    void move(const World& world, const std::vector<BodyPose>& poses) {
        SlotValues<BodyHandle, Body> old;
        m_baseline.move(world, poses, old);
        m_follower.setPoses(poses);
        EXPECT_EQ(resolvedHash(m_follower), resolvedHash(world)) << "the follower parted";
    }

private:
    WorldBaseline m_baseline;
    World m_follower;
    PaletteList m_palettes;
    std::vector<PaletteRef> m_known;
};

TEST_F(RandomGame, JournalsDeltasAndIndexesTellAll) {
    for (int game = 0; game < gameCount() && !HasFailure(); ++game) {
        RandomEdits edits{uint64_t(game)};
        World world;
        world.load(gameLevel(uint64_t(game)));
        WorldSettings settings;
        settings.undoMarks = 6;
        world.applyEdits({SettingsEdit{settings}});
        Followers followers(world);
        for (int step = 0; step < 60 && !HasFailure(); ++step) {
            SCOPED_TRACE("game " + std::to_string(game) + ", step " + std::to_string(step));
            followers.step(world, world.applyEdits(edits.next(world, true)));
            followers.move(world, moveBodies(world, edits.random()));
            expectSound(world);
            expectIndexesAsLoaded(world);
        }
    }
}

/// The history alone, without the stages of a step: fires and lights go on in the step of an undo.
TEST_F(RandomGame, UndoAndRedoRestoreTheHash) {
    constexpr int kMarks = 5;
    for (int game = 0; game < gameCount() && !HasFailure(); ++game) {
        SCOPED_TRACE("game " + std::to_string(game));
        RandomEdits edits{uint64_t(game)};
        World world;
        world.load(gameLevel(uint64_t(game)));
        world.applyEdits({});
        UndoHistory history(world.data());
        std::vector<std::pair<uint64_t, uint64_t>> atMark;
        const auto hashes = [](const WorldData& data) { return std::pair(resolvedHash(data), data.fire.hash()); };
        for (int step = 0; step < 6 * kMarks; ++step) {
            Edits next = edits.next(world, false);
            if (step % 6 == 0) {
                atMark.push_back(hashes(world));
                history.mark(kMarks);
                next.push_back(CarveEdit{.position = {0.5, 1.0 + 0.01 * step, 0.5}, .radii = {0.3, 0.3, 0.3}});
                next.push_back(AddLightEdit{});  // so that no mark is like the one before
            }
            history.recordStep(world.data(), world.applyEdits(next), false);
            history.recordMoves(world.data(), moveBodies(world, edits.random()));
        }
        WorldData data = world.data();
        const auto expectMark = [&](int mark, const FrameChanges& changes) {
            history.recordStep(data, changes, true);
            EXPECT_EQ(hashes(data), atMark[size_t(mark)]) << mark;
            World same(data.id);
            same.setState(data);
            expectSound(same);
            EXPECT_EQ(same.data().debris.count(), data.debris.count());
        };
        for (int mark = kMarks - 1; mark >= 0; --mark) {
            FrameChanges changes;
            ASSERT_TRUE(history.undo(data, changes));
            expectMark(mark, changes);
        }
        for (int mark = 1; mark < kMarks; ++mark) {
            FrameChanges changes;
            ASSERT_TRUE(history.redo(data, changes));
            expectMark(mark, changes);
        }
    }
}

TEST_F(RandomGame, ASavedGameGoesOnLikeTheRunningOne) {
    for (int game = 0; game < gameCount() && !HasFailure(); ++game) {
        RandomEdits edits{uint64_t(game)};
        World world;
        world.load(gameLevel(uint64_t(game)));
        for (int round = 0; round < 3 && !HasFailure(); ++round) {
            for (int step = 0; step < 15; ++step) {
                world.applyEdits(edits.next(world, false));
                moveBodies(world, edits.random());
            }
            SCOPED_TRACE("game " + std::to_string(game) + ", round " + std::to_string(round));
            Result<SavedGame> saved = gameFromBytes(gameToBytes({world.state(), {}}), "t", world.id());
            ASSERT_TRUE(saved) << saved.error();
            world.resetCaches();
            World loaded(world.id());
            loaded.setState(std::move(saved->world));
            for (int step = 0; step < 15; ++step) {
                ASSERT_EQ(loaded.hash(), world.hash()) << step;
                const Edits next = edits.next(world, false);
                world.applyEdits(next);
                loaded.applyEdits(next);
                loaded.setPoses(moveBodies(world, edits.random()));
            }
        }
    }
}

}  // namespace
}  // namespace rubble
