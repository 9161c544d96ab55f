#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "runtime/core/log.h"
#include "runtime/frame/shown_palettes.h"
#include "runtime/frame/snapshots.h"
#include "runtime/plugin/frame_loop.h"
#include "tests/runtime/shadow/received_volume.h"
#include "tests/runtime/world/random_game.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

int gameCount() {
    return std::getenv("RUBBLE_LONG") ? 400 : 3;
}

FrameLoopSettings headless() {
    FrameLoopSettings settings;
    settings.shadowVolume = settings.publish = false;
    return settings;
}

class RandomPlay : public testing::Test {
protected:
    void SetUp() override {
        setLogSink([](void*, LogLevel, std::string_view) {}, nullptr);
    }
    void TearDown() override { setLogSink(nullptr, nullptr); }
};

/// What the shadow worker and the renderer know of a world, from journals alone.
class Receivers {
public:
    void step(FrameLoop& loop) {
        const FrameChanges& changes = loop.changes();
        std::vector<BodyPose> moved(loop.physics()->poses().begin(), loop.physics()->poses().end());
        for (const BodyHandle handle : changes.teleported)
            if (const Body* body = loop.world().bodies().find(handle))
                moved.push_back({handle, body->pose, body->velocity, body->angularVelocity, body->asleep});
        m_snapshots.publishWithoutShadow(changes, moved, loop.world(), loop.physics()->impacts());
        if (auto snapshot = m_snapshots.take()) apply(*snapshot);
        const auto never = [] { return false; };
        ShadowPatches publication;
        publication.replacesAll = changes.levelReplaced;
        m_replica.apply(makeShadowStep(changes, moved, loop.world()), never);
        m_replica.update(publication, never);
        m_volume.apply(publication);
    }
    void expectEqual(const World& world) const {
        ShownPalettes shown;
        FrameChanges all;
        all.levelReplaced = true;
        shown.update(all, world);
        EXPECT_EQ(m_shapes.size(), world.shapes().size()) << "the renderer keeps a ghost, or misses a shape";
        world.shapes().forEach([&](ShapeHandle handle, const Shape& shape) {
            const auto found = m_shapes.find(handle);
            ASSERT_TRUE(found != m_shapes.end());
            const Drawn& drawn = found->second;
            EXPECT_EQ(drawn.grid.size(), shape.grid.size());
            EXPECT_EQ(drawn.grid.contentHash(), shape.grid.contentHash());
            EXPECT_EQ(*drawn.palette, *shown.of(shape));
            EXPECT_EQ(bool(drawn.paintColors), bool(shape.paintColors));
            if (drawn.paintColors && shape.paintColors) {
                EXPECT_EQ(*drawn.paintColors, *shape.paintColors);
            }
            EXPECT_EQ(drawn.pose, shapeToWorld(world, handle));
        });
        EXPECT_TRUE(m_volume == rebuild(world)) << "the shadow volume parted";
    }

private:
    struct Drawn {
        VoxelGrid grid;
        PaletteRef palette;
        PaintColorsRef paintColors;
        Pose pose;
    };
    void apply(const FrameSnapshot& snapshot) {
        if (snapshot.replacesAll) m_shapes.clear();
        for (const ShapeHandle handle : snapshot.destroyed) m_shapes.erase(handle);
        for (const SnapshotShape& shape : snapshot.created) {
            Drawn drawn{VoxelGrid(shape.size), shape.palette, shape.paintColors, {}};
            for (const BrickChange& brick : shape.bricks) drawn.grid.setBrick(brick.brick, brick.content);
            m_shapes[shape.shape] = std::move(drawn);
        }
        for (const BrickChange& brick : snapshot.bricks)
            m_shapes.at(brick.shape).grid.setBrick(brick.brick, brick.content);
        for (const SnapshotPalette& palette : snapshot.palettes) {
            m_shapes.at(palette.shape).palette = palette.palette;
            m_shapes.at(palette.shape).paintColors = palette.paintColors;
        }
        for (const SnapshotPose& pose : snapshot.poses) m_shapes.at(pose.shape).pose = pose.current;
    }

    Snapshots m_snapshots{ParticleSettings{}};
    ShadowReplica m_replica;
    Volume m_volume;
    std::map<ShapeHandle, Drawn> m_shapes;
};

/// Dynamic bodies that physics should have.
int dynamicBodies(const World& world) {
    int count = 0;
    world.bodies().forEach([&](BodyHandle, const Body& body) { count += !body.isStatic; });
    return count;
}

TEST_F(RandomPlay, AllWhoFollowTheJournalAgreeWithTheWorld) {
    for (int game = 0; game < gameCount() && !HasFailure(); ++game) {
        test::RandomEdits edits{uint64_t(game)};
        FrameLoop loop(headless());
        loop.load(test::gameLevel(uint64_t(game)));
        WorldSettings settings;
        settings.undoMarks = 6;
        loop.edits().push(SettingsEdit{settings});
        Receivers receivers;
        for (int step = 0; step < 80 && !HasFailure(); ++step) {
            SCOPED_TRACE("game " + std::to_string(game) + ", step " + std::to_string(step));
            loop.step();
            receivers.step(loop);
            if (step % 8 == 0) receivers.expectEqual(loop.world());
            EXPECT_EQ(loop.physics()->stats().bodies, dynamicBodies(loop.world()));
            EXPECT_TRUE(voxelAccounting(loop.world()).balances());
            loop.edits().push(edits.next(loop.world(), true));
        }
    }
}

TEST_F(RandomPlay, RecordingsReplayAndSavesGoOn) {
    const TempFolder folder;
    const std::string path = folder / "game.rubblelog";
    for (int game = 0; game < gameCount() && !HasFailure(); ++game) {
        SCOPED_TRACE("game " + std::to_string(game));
        test::RandomEdits edits{uint64_t(game)};
        FrameLoop loop(headless()), loaded(headless());
        loop.load(test::gameLevel(uint64_t(game)));
        WorldSettings settings;
        settings.undoMarks = 6;
        loop.edits().push(SettingsEdit{settings});
        const auto play = [&](int steps, bool history) {
            for (int step = 0; step < steps; ++step) {
                loop.edits().push(edits.next(loop.world(), history));
                loop.step();
            }
        };
        play(20, true);
        loop.edits().push(edits.next(loop.world(), true));
        ASSERT_TRUE(loop.startRecording(path));
        play(25, true);
        loop.edits().push(edits.next(loop.world(), false));
        Result<SavedGame> saved = gameFromBytes(gameToBytes(loop.save()), "t", loaded.world().id());
        ASSERT_TRUE(saved) << saved.error();
        loaded.load(std::move(*saved));
        loop.step(), loaded.step();
        for (int step = 0; step < 25; ++step) {
            ASSERT_EQ(loaded.world().hash(), loop.world().hash()) << "loaded, step " << step;
            const Edits next = edits.next(loop.world(), false);
            loop.edits().push(next), loaded.edits().push(next);
            loop.step(), loaded.step();
        }
        play(15, true);
        ASSERT_TRUE(loop.stopRecording());
        Result<Recording> recording = readRecording(path, loaded.world().id());
        ASSERT_TRUE(recording) << recording.error();
        World follower(loaded.world().id());
        follower.setState(recording->start.world);
        loaded.load(recording->start);
        std::vector<PaletteRef> palettes;
        for (const RecordedStep& step : recording->steps) {
            loaded.replay(step);
            ASSERT_EQ(loaded.world().hash(), step.hash) << "replayed, step " << step.step;
            const Result<FrameChanges> applied = applyStepDelta(step.delta, path, follower, palettes);
            ASSERT_TRUE(applied) << applied.error();
            ASSERT_EQ(voxelHash(follower), step.voxelHash) << "followed, step " << step.step;
            follower.setPoses(step.poses);
            follower.setCharacters(step.characters);
            ASSERT_EQ(resolvedHash(follower), step.resolvedHash) << "followed, step " << step.step;
        }
    }
}

}  // namespace
}  // namespace rubble
