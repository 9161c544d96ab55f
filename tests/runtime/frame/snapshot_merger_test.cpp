#include "runtime/frame/snapshot_merger.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <tuple>

#include "runtime/core/random.h"
#include "tests/runtime/shadow/received_volume.h"
#include "tests/support/allocation_count.h"

namespace rubble {
namespace {

/// What a receiver knows after applying snapshots: the meaning of a snapshot, without any renderer.
struct Receiver {
    struct Shape {
        PaletteRef palette;
        std::map<std::tuple<int, int, int>, BrickRef> bricks;
        Pose previous, current;
        bool operator==(const Shape&) const = default;
    };
    std::map<ShapeHandle, Shape> shapes;
    std::map<std::tuple<int, int, int>, ShadowBrickRef> shadow;
    size_t lights = 0;
    float exposure = 0.0f;
    uint64_t version = 0, newestStep = 0;
    bool operator==(const Receiver&) const = default;

    void apply(const FrameSnapshot& s) {
        if (s.replacesAll) shapes.clear();
        if (s.shadowReplacesAll) shadow.clear();
        for (const ShapeHandle shape : s.destroyed)
            ASSERT_EQ(shapes.erase(shape), 1u) << "destroys what was never created";
        for (const SnapshotShape& created : s.created) {
            ASSERT_TRUE(shapes.emplace(created.shape, Shape{created.palette, {}, {}, {}}).second);
            for (const BrickChange& brick : created.bricks) set(brick);
        }
        for (const BrickChange& brick : s.bricks) set(brick);
        for (const SnapshotPalette& palette : s.palettes) shapes.at(palette.shape).palette = palette.palette;
        for (const SnapshotPose& pose : s.poses) {
            shapes.at(pose.shape).previous = pose.previous;
            shapes.at(pose.shape).current = pose.current;
        }
        for (const ShadowPatch& patch : s.shadow) {
            const auto key = std::tuple(patch.brick.x, patch.brick.y, patch.brick.z);
            if (patch.content)
                shadow[key] = patch.content;
            else
                shadow.erase(key);
        }
        if (s.lightsChanged) lights = s.lights.size();
        if (s.environmentChanged) exposure = s.environment.exposure;
        version = s.version;
        newestStep = s.newestStep;
    }
    void set(const BrickChange& change) {
        const auto key = std::tuple(change.brick.x, change.brick.y, change.brick.z);
        if (change.content)
            shapes.at(change.shape).bricks[key] = change.content;
        else
            shapes.at(change.shape).bricks.erase(key);
    }
};

/// Makes random snapshots that a world could have made: shapes are created and destroyed, and only existing ones
/// change.
class Story {
public:
    explicit Story(uint64_t seed) : m_random(seed) {}
    FrameSnapshot next() {
        FrameSnapshot s;
        s.version = s.newestStep = ++m_step;
        if (!m_random.below(12)) {
            s.replacesAll = s.shadowReplacesAll = s.lightsChanged = s.environmentChanged = true;
            m_living.clear();
        }
        while (!m_living.empty() && m_random.below(3) == 0) {
            const size_t i = m_random.below(uint32_t(m_living.size()));
            s.destroyed.push_back(m_living[i]);
            m_living.erase(m_living.begin() + ptrdiff_t(i));
        }
        const std::vector<ShapeHandle> old = m_living;
        while (m_random.below(2)) create(s);
        std::map<std::pair<ShapeHandle, int>, bool> touched;
        for (const ShapeHandle shape : old) {
            const int brick = m_random.between(0, 2);
            if (m_random.below(2))
                s.bricks.push_back(
                    {shape, {brick, 0, 0}, m_random.below(3) ? std::make_shared<const Brick>() : nullptr});
            if (!m_random.below(3)) s.palettes.push_back({shape, std::make_shared<const Palette>()});
            if (m_random.below(2)) s.poses.push_back({shape, drawPose(), drawPose()});
        }
        if (s.shadowReplacesAll) m_hasShadow = {};
        for (int i = 0; i < 3; ++i) {
            if (!m_random.below(2)) continue;
            const bool isThere = m_random.below(3);
            s.shadow.push_back(
                {{i, 0, -1}, isThere ? std::make_shared<const ShadowBrick>() : nullptr, !m_hasShadow[size_t(i)]});
            m_hasShadow[size_t(i)] = isThere;
        }
        if (!m_random.below(4)) s.lightsChanged = true, s.lights.resize(m_random.below(5));
        if (!m_random.below(4)) s.environmentChanged = true, s.environment.exposure = m_random.unit();
        return s;
    }

private:
    void create(FrameSnapshot& s) {
        const ShapeHandle shape =
            ShapeHandle::make(1, m_step & 0xffffff, uint32_t(m_living.size()) + m_random.below(100) * 1000);
        if (std::find(m_living.begin(), m_living.end(), shape) != m_living.end()) return;
        m_living.push_back(shape);
        s.created.push_back({shape, {24, 8, 8}, 0.1f, std::make_shared<const Palette>(), {}});
        for (int i = 0; i < 3; ++i)
            if (m_random.below(2))
                s.created.back().bricks.push_back({shape, {i, 0, 0}, std::make_shared<const Brick>()});
        const Pose pose = drawPose();
        s.poses.push_back({shape, pose, pose});
    }
    Pose drawPose() {
        const double x = m_random.unit();
        return {{x, 0.0, 0.0}};
    }
    Random m_random;
    uint64_t m_step = 0;
    std::vector<ShapeHandle> m_living;
    std::array<bool, 3> m_hasShadow{};
};

/// Copies of snapshots: each is applied on its own and merged.
FrameSnapshot copyOf(const FrameSnapshot& s) {
    return s;
}

TEST(SnapshotMerger, EqualsApplyingEachInTurn) {
    for (uint64_t seed = 0; seed < 300; ++seed) {
        Story story(seed);
        Random random(seed, 1);
        Receiver inTurn, merged;
        for (int round = 0; round < 8; ++round) {
            FrameSnapshot all = story.next();
            inTurn.apply(all);
            for (uint32_t more = random.below(6); more; --more) {
                FrameSnapshot later = story.next();
                inTurn.apply(later);
                merge(all, copyOf(later));
            }
            merged.apply(all);
            ASSERT_FALSE(HasFatalFailure()) << "seed " << seed;
            ASSERT_TRUE(inTurn == merged) << "seed " << seed << " round " << round;
        }
    }
}

TEST(SnapshotMerger, IsAssociative) {
    for (uint64_t seed = 0; seed < 100; ++seed) {
        Story story(seed);
        Receiver left, right;
        const FrameSnapshot first = story.next();
        left.apply(first);
        right.apply(first);
        const FrameSnapshot a = story.next(), b = story.next(), c = story.next();
        FrameSnapshot ab = copyOf(a), bc = copyOf(b), abc = copyOf(a);
        merge(ab, copyOf(b));
        merge(ab, copyOf(c));
        merge(bc, copyOf(c));
        merge(abc, copyOf(bc));
        left.apply(ab);
        right.apply(abc);
        ASSERT_TRUE(left == right) << "seed " << seed;
    }
}

TEST(SnapshotMerger, CreatedAndDestroyedInBetweenLeavesNothing) {
    const ShapeHandle shape = ShapeHandle::make(1, 1, 0);
    FrameSnapshot first, second;
    first.created.push_back({shape, {8, 8, 8}, 0.1f, nullptr, {{shape, {0, 0, 0}, std::make_shared<const Brick>()}}});
    first.poses.push_back({shape, {}, {}});
    second.destroyed.push_back(shape);
    merge(first, std::move(second));
    EXPECT_TRUE(first.created.empty() && first.destroyed.empty() && first.poses.empty());
}

TEST(SnapshotMerger, ACreatedShapeTakesLaterBricksAndTheNewestPose) {
    const ShapeHandle shape = ShapeHandle::make(1, 1, 0);
    const BrickRef brick = std::make_shared<const Brick>();
    FrameSnapshot first, second;
    first.created.push_back({shape, {8, 8, 8}, 0.1f, nullptr, {{shape, {0, 0, 0}, brick}}});
    first.poses.push_back({shape, {}, {}});
    second.bricks = {{shape, {0, 0, 0}, nullptr}, {shape, {1, 0, 0}, brick}};
    second.poses.push_back({shape, {{1, 0, 0}}, {{2, 0, 0}}});
    merge(first, std::move(second));
    EXPECT_TRUE(first.bricks.empty());
    ASSERT_EQ(first.created[0].bricks.size(), 1u);
    EXPECT_EQ(first.created[0].bricks[0].brick, glm::ivec3(1, 0, 0));
    ASSERT_EQ(first.poses.size(), 1u);
    EXPECT_EQ(first.poses[0].previous.position.x, 1.0);
    EXPECT_EQ(first.poses[0].current.position.x, 2.0);
}

/// What a body leaves behind while nobody draws.
TEST(SnapshotMerger, ShadowThatCameAndWentLeavesNothing) {
    const auto content = std::make_shared<const ShadowBrick>();
    FrameSnapshot all;
    all.shadow = {{{-1, 0, 0}, content, false}, {{0, 0, 0}, content, true}};
    for (int x = 0; x < 100; ++x) {
        FrameSnapshot step;
        step.shadow = {{{x, 0, 0}, nullptr}, {{x + 1, 0, 0}, content, true}};
        if (x == 50) step.shadow.push_back({{-1, 0, 0}, nullptr});
        merge(all, std::move(step));
        EXPECT_EQ(all.shadow.size(), 2u) << "the brick that the receiver had, and the one that is there now";
    }
    EXPECT_EQ(all.shadow[0].brick, glm::ivec3(-1, 0, 0));
    EXPECT_FALSE(all.shadow[0].content);
    EXPECT_EQ(all.shadow[1].brick, glm::ivec3(100, 0, 0));
}

/// Work is counted as allocations: an index of what was added before would need one for each entry of it.
TEST(SnapshotMerger, ToAddASnapshotCostsWhatItHoldsHoweverMuchWasAddedBefore) {
    const auto content = std::make_shared<const ShadowBrick>();
    const auto brick = std::make_shared<const Brick>();
    const ShapeHandle shape = ShapeHandle::make(1, 1, 0), other = ShapeHandle::make(1, 1, 1);
    FrameSnapshot level;
    level.created.push_back({shape, {8 * 5000, 8, 8}, 0.1f, nullptr, {}});
    for (int x = 0; x < 5000; ++x) {
        level.created[0].bricks.push_back({shape, {x, 0, 0}, brick});
        level.bricks.push_back({other, {x, 0, 0}, brick});
        level.shadow.push_back({{x, 0, 0}, content, true});
    }
    SnapshotMerger merger;
    merger.add(std::move(level));
    const auto addStep = [&](int x) {
        FrameSnapshot step;
        step.bricks = {{shape, {x, 0, 0}, brick}, {other, {x, 0, 0}, nullptr}};
        step.poses = {{shape, {}, {}}};
        step.shadow = {{{x, 0, 0}, nullptr}, {{x, 1, 0}, content, true}};
        merger.add(std::move(step));
    };
    addStep(0);  // makes the indexes, once
    const size_t before = allocationCount();
    for (int x = 1; x <= 100; ++x) addStep(x);
    EXPECT_LT(allocationCount() - before, 100u * 20);
    const auto all = merger.take();
    ASSERT_TRUE(all);
    EXPECT_EQ(all->created[0].bricks.size(), 5000u);
    EXPECT_EQ(all->bricks.size(), 5000u);
    EXPECT_EQ(all->shadow.size(), 5000u) << "those of the level that are left and those that came";
    EXPECT_TRUE(merger.empty());
    EXPECT_FALSE(merger.take());
}

/// A body without gravity that passes through many bricks of the volume.
TEST(SnapshotMerger, ShadowPatchesOfMovingBodiesMergeToWhatIsThere) {
    World world = worldOf({makeBody(solidGrid({4, 4, 4}), {}, false)});
    ShadowWorker worker(ShadowWorker::Mode::Inline);
    FrameSnapshot all;
    BodyHandle body;
    world.bodies().forEach([&](BodyHandle handle, const Body&) { body = handle; });
    for (int step = 0; step < 60; ++step) {
        const FrameChanges changes = world.applyEdits({});
        const std::vector<BodyPose> moved = {{body, {{0.5 * step, 0.1, 0.1}}, {}, {}, false}};
        world.setPoses(moved);
        worker.submit(changes, moved, world);
        for (ShadowPatches& publication : worker.takePatches()) {
            FrameSnapshot later;
            later.shadow = std::move(publication.patches);
            merge(all, std::move(later));
        }
        EXPECT_LE(all.shadow.size(), 8u) << "as many bricks as the body can be in, in step " << step;
    }
    EXPECT_FALSE(all.shadow.empty());
}

}  // namespace
}  // namespace rubble
