#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "runtime/world/history/world_baseline.h"
#include "tests/runtime/world/worlds.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

constexpr int kPillars = 12;  ///< on each side of the square

/// A slab of 0.4 m with pillars of 2x6x2 cells, 4 cells apart; column x is two cells lower if `uneven`.
VoxelGrid pillars(bool uneven = false) {
    return gridOf({4 * kPillars, 10, 4 * kPillars}, [=](glm::ivec3 c) {
        const bool isPillar = c.x % 4 < 2 && c.z % 4 < 2 && (!uneven || c.x < 4 || c.y < 8);
        return uint8_t(c.y < 4 || isPillar);
    });
}

/// Carves one layer of cells out of the pillars of columns [from, to), whose upper parts come off.
CarveEdit cutColumns(int from, int to) {
    CarveEdit edit{.kind = BrushKind::Box};
    edit.position = {0.1 * (from + to) * 2.0, 0.45, 2.4};
    edit.halfSize = {0.1 * (to - from) * 2.0, 0.05, 2.4};
    return edit;
}

WorldSettings withBudgets(uint32_t awake, uint32_t bodies, uint64_t voxels) {
    WorldSettings settings;
    settings.debris.awakeBodies = awake;
    settings.debris.bodies = bodies;
    settings.debris.voxels = voxels;
    settings.debris.settleSteps = 10;
    return settings;
}

struct DebrisWorld : World {
    explicit DebrisWorld(const WorldSettings& settings, bool uneven = false) {
        setSettings(settings);
        load(test::oneShapeLevel(pillars(uneven), true));
    }
    void sleep(const std::vector<BodyHandle>& which, bool asleep = true) {
        for (const BodyHandle handle : which) {
            BodyPose pose{handle, bodies().at(handle).pose};
            pose.asleep = asleep;
            setPoses({&pose, 1});
        }
    }
};

uint64_t dustOf(const FrameChanges& changes) {
    uint64_t sum = 0;
    for (const DustCloud& cloud : changes.dust) sum += cloud.count;
    return sum;
}
uint64_t removedOf(const FrameChanges& changes) {
    uint64_t sum = 0;
    for (const RemovedVoxels& each : changes.removed) sum += each.count;
    return sum;
}

void expectNoStaleHandles(const World& world, const FrameChanges& changes) {
    for (const BodyHandle body : changes.bodiesCreated) EXPECT_TRUE(world.bodies().find(body));
    for (const ShapeHandle shape : changes.shapesCreated) EXPECT_TRUE(world.shapes().find(shape));
    for (const ShapeSplit& split : changes.splits) {
        EXPECT_EQ(split.children.size(), split.parentOffset.size());
        EXPECT_EQ(split.children.size(), split.motions.size());
        for (const ShapeHandle shape : split.children) EXPECT_TRUE(world.shapes().find(shape));
    }
}

TEST(Debris, PiecesOverTheBodyBudgetBecomeDustAtOnce) {
    DebrisWorld world(withBudgets(1000, 100, 1000000));
    const FrameChanges changes = world.applyEdits({cutColumns(0, kPillars)});
    EXPECT_EQ(world.data().debris.count(), 100u);
    EXPECT_EQ(changes.bodiesCreated.size(), 100u);
    EXPECT_TRUE(changes.bodiesDestroyed.empty()) << "nobody has heard of them";
    expectNoStaleHandles(world, changes);
    EXPECT_EQ(dustOf(changes), removedOf(changes));
    EXPECT_EQ(removedOf(changes), 144u * 4 + 44u * 20);
    EXPECT_TRUE(voxelAccounting(world).balances());
    EXPECT_EQ(voxelAccounting(world).inPieces, 100u * 20);
}

TEST(Debris, BudgetOfVoxels) {
    DebrisWorld world(withBudgets(1000, 1000, 1999));
    world.applyEdits({cutColumns(0, kPillars)});
    EXPECT_EQ(world.data().debris.voxels(), 99u * 20);
    EXPECT_TRUE(voxelAccounting(world).balances());
}

TEST(Debris, SmallSettledAndOldPiecesAreRemovedFirst) {
    DebrisWorld world(withBudgets(1000, 1000, 1000000), true);
    const std::vector<BodyHandle> large = world.applyEdits({cutColumns(0, 1)}).bodiesCreated;    // 20 voxels each
    const std::vector<BodyHandle> small = world.applyEdits({cutColumns(1, 2)}).bodiesCreated;    // 12 voxels each
    const std::vector<BodyHandle> younger = world.applyEdits({cutColumns(2, 3)}).bodiesCreated;  // 12 voxels each
    ASSERT_EQ(large.size() + small.size() + younger.size(), 36u);
    world.sleep({large[3], small[5]});
    for (int i = 0; i < 12; ++i) world.applyEdits({});
    EXPECT_TRUE(world.bodies().at(large[3]).settled && world.bodies().at(small[5]).settled);
    world.sleep({younger[0]});

    const auto shrinkTo = [&](uint32_t bodies) {
        world.setSettings(withBudgets(1000, bodies, 1000000));
        return world.applyEdits({}).bodiesDestroyed;
    };
    EXPECT_EQ(shrinkTo(35), std::vector{small[5]}) << "settled and small";
    EXPECT_EQ(shrinkTo(34), std::vector{large[3]}) << "settled";
    EXPECT_EQ(shrinkTo(33), std::vector{younger[0]}) << "asleep";
    EXPECT_EQ(shrinkTo(32), std::vector{small[0]}) << "small, and the oldest such";
    EXPECT_TRUE(voxelAccounting(world).balances());
}

TEST(Debris, AwakePiecesHaveTheirOwnBudget) {
    DebrisWorld world(withBudgets(50, 1000, 1000000));
    world.applyEdits({cutColumns(0, 4)});
    EXPECT_EQ(world.data().debris.awakeCount(), 48u);
    world.applyEdits({cutColumns(4, 6)});
    EXPECT_EQ(world.data().debris.awakeCount(), 50u);
    EXPECT_EQ(world.data().debris.count(), 50u) << "none sleeps yet: 22 are dust";
    std::vector<BodyHandle> all;
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (!body.isStatic) all.push_back(handle);
    });
    world.sleep(all);
    EXPECT_EQ(world.data().debris.awakeCount(), 0u);
    world.applyEdits({cutColumns(8, 12)});
    EXPECT_EQ(world.data().debris.awakeCount(), 48u);
    EXPECT_EQ(world.data().debris.count(), 98u);
    // Pieces that an explosion wakes count as awake too.
    const FrameChanges blast = world.applyEdits({ExplodeEdit{.position = {1.2, 1.4, 2.4}, .size = 0.5}});
    EXPECT_LE(world.data().debris.awakeCount(), 50u);
    for (const ImpulseApplied& impulse : blast.impulses) EXPECT_TRUE(world.bodies().find(impulse.body));
    expectNoStaleHandles(world, blast);
    EXPECT_TRUE(voxelAccounting(world).balances());
}

TEST(Debris, SettlesAfterItsTimeAndReportsIt) {
    DebrisWorld world(withBudgets(1000, 1000, 1000000));
    const std::vector<BodyHandle> pieces = world.applyEdits({cutColumns(0, 1)}).bodiesCreated;
    world.sleep({pieces[0], pieces[7]});
    const uint64_t asleepAt = world.step();
    FrameChanges changes;
    while ((changes = world.applyEdits({})).settled.empty()) ASSERT_LT(world.step(), 100u);
    EXPECT_EQ(world.step() - asleepAt, 10u);
    EXPECT_EQ(changes.settled, (std::vector{pieces[0], pieces[7]}));
    EXPECT_FALSE(changes.empty());
    EXPECT_TRUE(world.applyEdits({}).empty());
    world.sleep({pieces[7]}, false);  // physics wakes it
    EXPECT_FALSE(world.bodies().at(pieces[7]).settled);
    EXPECT_EQ(world.applyEdits({}).unsettled, std::vector{pieces[7]});
    EXPECT_EQ(world.applyEdits({ImpulseEdit{pieces[0], {}, {0, 1, 0}}}).unsettled, std::vector{pieces[0]});
    EXPECT_FALSE(world.bodies().at(pieces[0]).asleep);
}

TEST(Debris, LargePiecesAndLevelBodiesAreNotDebris) {
    WorldSettings settings = withBudgets(0, 0, 0);
    settings.debris.largestPiece = 19;
    DebrisWorld world(settings);
    const FrameChanges changes = world.applyEdits({cutColumns(0, kPillars)});
    EXPECT_EQ(changes.bodiesCreated.size(), 144u);
    EXPECT_EQ(world.data().debris.count(), 0u);
}

TEST(Debris, VoxelAccountingBalancesEveryStep) {
    DebrisWorld world(withBudgets(40, 60, 900));
    Random random(5);
    uint64_t removed = 0;
    for (int i = 0; i < 60; ++i) {
        const float x = random.unit(), z = random.unit();
        const FrameChanges changes = world.applyEdits({test::sphereCarve({4.8 * x, 0.5, 4.8 * z}, 0.3)});
        removed += removedOf(changes);
        EXPECT_EQ(dustOf(changes), removedOf(changes));
        EXPECT_LE(world.data().debris.awakeCount(), 40u);
        EXPECT_LE(world.data().debris.count(), 60u);
        EXPECT_LE(world.data().debris.voxels(), 900u);
        EXPECT_EQ(voxelAccounting(world).removed, removed);
        EXPECT_TRUE(voxelAccounting(world).balances());
        EXPECT_EQ(voxelAccounting(world).inPieces, world.data().debris.voxels());
        expectNoStaleHandles(world, changes);
        if (i % 7 == 0 && !changes.bodiesCreated.empty()) world.sleep({changes.bodiesCreated[0]});
    }
    EXPECT_GT(removed, 1000u);
}

TEST(Debris, BrokenIsReportedOnce) {
    DebrisWorld world(withBudgets(1000, 1000, 1000000));
    BodyHandle ground;
    world.bodies().forEach([&](BodyHandle handle, const Body&) { ground = handle; });
    EXPECT_EQ(world.applyEdits({cutColumns(0, 1)}).broken, std::vector{ground});
    EXPECT_TRUE(world.applyEdits({cutColumns(1, 2)}).broken.empty());
}

TEST(Debris, AShapeThatComesOffWholeTakesAlongThatItIsBroken) {
    Level level = test::oneShapeLevel(solidGrid({8, 8, 8}), true);
    level.bodies[0].shapes.push_back(level.bodies[0].shapes[0]);
    level.bodies[0].shapes[1].local.position = {0.0, 0.8, 0.0};
    World world;
    world.load(level);
    world.applyEdits({});
    const ShapeHandle upper = world.shapes().handleAt(1);
    const Edit hole = test::sphereCarve(shapeToWorld(world, upper).position, 0.15);
    const BodyHandle whole = world.shapes().at(upper).body;
    EXPECT_EQ(world.applyEdits({hole}).broken, std::vector{whole});
    world.applyEdits({SetShapeEdit{.shape = upper, .anchorChange = AnchorChange::Boxes}});
    const BodyHandle own = world.shapes().at(upper).body;
    ASSERT_NE(own, whole);
    EXPECT_TRUE(world.bodies().at(own).broken);
}

TEST(Debris, SplitsReportInitialMotions) {
    DebrisWorld world(withBudgets(1000, 1000, 1000000));
    const FrameChanges changes = world.applyEdits({cutColumns(0, 1)});
    ASSERT_EQ(changes.splits.size(), 1u);
    for (size_t i = 0; i < changes.splits[0].children.size(); ++i) {
        const PieceMotion& motion = changes.splits[0].motions[i];
        const BodyHandle body = world.shapes().at(changes.splits[0].children[i]).body;
        const MassProperties mass = bodyMass(world, body);
        EXPECT_NEAR(motion.mass, mass.mass, 1e-9);
        EXPECT_LT(glm::length(motion.center - world.bodies().at(body).pose.transformPoint(mass.center)), 1e-12);
    }
}

/// Expects the list of debris that a load would make.
void expectDebrisAsLoaded(const World& world) {
    World loaded;
    loaded.setState(world.state());
    const DebrisQueue &is = world.data().debris, &wanted = loaded.data().debris;
    EXPECT_EQ(is.count(), wanted.count());
    EXPECT_EQ(is.voxels(), wanted.voxels());
    EXPECT_EQ(is.awakeCount(), wanted.awakeCount());
    world.bodies().forEach([&](BodyHandle body, const Body&) { EXPECT_EQ(is.contains(body), wanted.contains(body)); });
    if (wanted.count()) {
        EXPECT_EQ(is.first(), wanted.first());
    }
}

TEST(Debris, TheListIsTheOneThatALoadMakes) {
    Level level = test::oneShapeLevel(solidGrid({4, 4, 4}), false, {{0.0, 30.0, 0.0}});
    level.bodies.push_back(test::oneShapeLevel(pillars(), true).bodies[0]);
    World world;
    world.load(level);
    WorldSettings settings = withBudgets(1000, 1000, 1000000);
    settings.undoMarks = 9;
    settings.debris.largestPiece = 100000;
    world.applyEdits({SettingsEdit{settings}, test::sphereCarve({0.2, 30.2, 0.2}, 1.0)});
    ASSERT_EQ(world.bodies().size(), 1u) << "slot 0 is free";
    const std::vector<ShapeHandle> pieces = world.applyEdits({cutColumns(0, 2)}).shapesCreated;
    ASSERT_TRUE(world.data().debris.contains(world.bodies().handleAt(0)));
    expectDebrisAsLoaded(world);
    const auto resize = [&](int i, int height) {
        return ResizeShapeEdit{pieces[size_t(i)], {{0, 0, 0}, {8, height, 8}}};
    };
    world.applyEdits({HistoryEdit{}, resize(0, 8), resize(1, 9), TrimShapeEdit{pieces[2]}, SplitShapeEdit{pieces[3]}});
    EXPECT_EQ(world.data().debris.voxels(), 24u * 20 - 12);
    expectDebrisAsLoaded(world);
    // The slab loses its anchors and is debris itself.
    world.applyEdits({HistoryEdit{}, cutColumns(2, 4),
                      CarveEdit{.kind = BrushKind::Box, .position = {2.4, 0.0, 2.4}, .halfSize = {9.0, 0.15, 9.0}}});
    ASSERT_EQ(world.data().debris.count(), world.bodies().size());
    expectDebrisAsLoaded(world);
    for (const HistoryAction action :
         {HistoryAction::Undo, HistoryAction::Redo, HistoryAction::Undo, HistoryAction::Undo, HistoryAction::Redo}) {
        world.applyEdits({HistoryEdit{action}});
        expectDebrisAsLoaded(world);
    }
}

TEST(Debris, APieceOfSeveralShapesCountsAsOne) {
    DebrisWorld world(withBudgets(1000, 1000, 1000000));
    const ShapeHandle piece = world.applyEdits({cutColumns(0, 1)}).shapesCreated[0];
    const BodyHandle body = world.shapes().at(piece).body;
    const size_t pieces = world.data().debris.count();
    const CellBox middle{{0, 7, 0}, {2, 8, 2}};
    world.applyEdits({WriteVoxelsEdit{piece, middle, std::vector<uint8_t>(4, 0)}, SplitShapeEdit{piece}});
    ASSERT_EQ(world.bodies().at(body).shapes.size(), 2u);
    EXPECT_TRUE(world.data().debris.contains(body));
    EXPECT_EQ(world.data().debris.count(), pieces);
    expectDebrisAsLoaded(world);
}

TEST(Debris, APieceThatIsResizedAndDespawnsInOneStepIsGoneForAll) {
    for (const bool trims : {true, false}) {
        DebrisWorld world(withBudgets(1000, 1000, 1000000));
        world.applyEdits({});
        const FrameChanges cut = world.applyEdits({cutColumns(0, 1)});
        const ShapeHandle piece = cut.shapesCreated[0];
        const BodyHandle body = world.shapes().at(piece).body;
        WorldBaseline baseline(world);
        Edit edit = ResizeShapeEdit{piece, {{0, 0, 0}, {40, 40, 40}}};
        if (trims) {
            baseline.update(world, world.applyEdits({edit}));
            edit = TrimShapeEdit{piece};
        }
        const FrameChanges changes = world.applyEdits({SettingsEdit{withBudgets(1000, 0, 0)}, edit, cutColumns(1, 2)});
        ASSERT_FALSE(world.shapes().find(piece));
        EXPECT_EQ(std::count(changes.shapesDestroyed.begin(), changes.shapesDestroyed.end(), piece), 1);
        EXPECT_EQ(std::count(changes.bodiesDestroyed.begin(), changes.bodiesDestroyed.end(), body), 1);
        EXPECT_EQ(changes.shapesDestroyed.size(), 12u) << "of the twelve that were there before";
        EXPECT_TRUE(changes.shapesCreated.empty());
        baseline.update(world, changes);
        EXPECT_EQ(resolvedHash(world), resolvedHash(baseline.last()));
        EXPECT_TRUE(voxelAccounting(world).balances());
    }
}

TEST(Debris, UndoBringsBackTheBudgetAndAStateOverItKeepsTheLedger) {
    DebrisWorld world(withBudgets(1000, 1000, 1000000));
    const auto settings = [&](uint32_t bodies) {
        WorldSettings out = withBudgets(1000, bodies, 1000000);
        out.undoMarks = 9;
        return out;
    };
    world.applyEdits({SettingsEdit{settings(1000)}});
    const uint64_t before = resolvedHash(world);
    world.applyEdits({HistoryEdit{}, cutColumns(0, 2)});
    const size_t pieces = world.data().debris.count();
    ASSERT_GT(pieces, 5u);
    const CarveEdit all{.kind = BrushKind::Box, .position = {0.0, 1.0, 0.0}, .halfSize = {9.0, 0.6, 9.0}};
    world.applyEdits({HistoryEdit{}, all});
    ASSERT_EQ(world.data().debris.count(), 0u);
    world.applyEdits({SettingsEdit{settings(5)}});
    WorldBaseline baseline(world);
    const auto step = [&](HistoryAction action, const Edits& others = {}) {
        Edits edits = {HistoryEdit{action}};
        edits.insert(edits.end(), others.begin(), others.end());
        const FrameChanges changes = world.applyEdits(edits);
        expectNoStaleHandles(world, changes);
        baseline.update(world, changes);
        EXPECT_EQ(resolvedHash(world), resolvedHash(baseline.last()));
        EXPECT_TRUE(voxelAccounting(world).balances());
        expectDebrisAsLoaded(world);
    };
    step(HistoryAction::Undo);
    EXPECT_EQ(world.data().debris.count(), pieces) << "under the budget of then";
    step(HistoryAction::Redo);
    step(HistoryAction::Undo);
    step(HistoryAction::Undo);
    EXPECT_EQ(resolvedHash(world), before);
    step(HistoryAction::Redo, {SettingsEdit{settings(5)}});
    EXPECT_EQ(world.data().debris.count(), 5u);
}

}  // namespace
}  // namespace rubble
