#include <gtest/gtest.h>

#include <cmath>

#include "runtime/world/impacts/impact_damage.h"
#include "tests/runtime/world/stress_structures.h"
#include "tests/runtime/world/worlds.h"
#include "tests/support/allocation_count.h"

namespace rubble {
namespace {

using namespace test;

constexpr double kContact = StressSettings{}.contactTime;

/// A square column with an anchored foot; its corner is at cell (8, 0, 8).
Structure column(int side, int height) {
    Structure out({16 + side, height + 1, 16 + side});
    out.anchor({{8, 0, 8}, {8 + side, 1, 8 + side}});
    out.fill({{8, 1, 8}, {8 + side, 1 + height, 8 + side}});
    return out;
}

/// What an impact does in a world at rest.
Outcome applyBlow(World& world, const Level& level, glm::dvec3 position, glm::dvec3 impulse,
                  double strengthScale = 1.0) {
    Outcome before = stand(world, level, strengthScale, 30);
    EXPECT_FALSE(before.isBroken());
    Outcome out;
    step(world, out, {ImpactLoadEdit{firstShape(world), position, impulse}});
    for (int i = 0; i < 60; ++i) step(world, out);
    EXPECT_TRUE(voxelAccounting(world).balances());
    EXPECT_FALSE(world.data().stress->isBusy());
    return out;
}

TEST(ImpactLoad, AColumnBreaksAtItsFootAsBeamTheorySays) {
    for (const int side : {4, 8}) {
        const double d = side * 0.1, h = 6.0, lever = h - 0.05;
        // F lever c / I - weight / area = strength
        const double force = (kConcreteTension + kConcreteWeight * h) * d * d * d / 6.0 / lever;
        for (const double share : {0.9, 1.1}) {
            World world;
            const glm::dvec3 top{0.8 + d / 2, 0.1 + h - 0.05, 0.8 + d / 2};
            const Outcome out = applyBlow(world, column(side, 60).level(), top, {share * force * kContact, 0.0, 0.0});
            EXPECT_EQ(out.isBroken(), share > 1.0) << side;
            EXPECT_EQ(out.pieces, share > 1.0 ? 1u : 0u) << "it falls in one piece";
            for (const CrackOpened& crack : out.cracks) EXPECT_NEAR(crack.position.y, 0.1, 0.11);
        }
    }
}

TEST(ImpactLoad, AClampedFloorBreaksAtItsSupportsOrInTheMiddle) {
    const int span = 80, depth = 4, width = 8;
    Structure floor({span + 16, 16, 24});
    floor.anchor({{4, 4, 8}, {8, 4 + depth, 8 + width}});
    floor.anchor({{8 + span, 4, 8}, {12 + span, 4 + depth, 8 + width}});
    floor.fill({{8, 4, 8}, {8 + span, 4 + depth, 8 + width}});
    const double l = span * 0.1, d = depth * 0.1, b = width * 0.1, modulus = b * d * d / 6.0;
    // At the supports: F l / 8 + w l^2 / 12 = strength x modulus.
    const double force = (kConcreteTension * modulus - kConcreteWeight * b * d * l * l / 12.0) * 8.0 / l;
    ASSERT_GT(force, 0.0);
    for (const double share : {0.9, 1.1}) {
        World world;
        const Outcome out = applyBlow(world, floor.level(), {4.8, 0.75, 1.2}, {0.0, -share * force * kContact, 0.0});
        EXPECT_EQ(out.isBroken(), share > 1.0);
        if (out.isBroken()) {
            EXPECT_NEAR(std::fabs(out.cracks[0].position.x - 4.8), 4.0, 0.11);
        }
    }
}

TEST(ImpactLoad, StrengthScaleAppliesToWeightNotToImpacts) {
    const double lever = 5.95, force = kConcreteTension * 0.8 * 0.8 * 0.8 / 6.0 / lever;
    for (const double share : {0.9, 1.1}) {
        World world;
        Level level = column(8, 60).level();
        level.environment.gravity = {0.0f, 0.0f, 0.0f};
        const Outcome out = applyBlow(world, level, {1.2, 6.05, 1.2}, {share * force * kContact, 0.0, 0.0}, 0.03);
        EXPECT_EQ(out.isBroken(), share > 1.0);
    }
}

TEST(ImpactLoad, AFreeBeamBreaksInTheMiddleByInertia) {
    Structure beam({96, 8, 8});
    beam.fill({{0, 0, 0}, {96, 8, 8}});
    const double d = 0.8, l = 9.6, force = kConcreteTension * d * d * d / 6.0 * 8.0 / l;  // F l / 8
    for (const double share : {0.95, 1.05}) {
        World world;
        world.setSettings(stressOn(0.03));
        world.load(beam.level("concrete", false));
        Outcome out;
        step(world, out, {ImpactLoadEdit{firstShape(world), {4.85, 0.0, 0.4}, {0.0, share * force * kContact, 0.0}}});
        EXPECT_EQ(out.isBroken(), share > 1.0);
        EXPECT_EQ(out.pieces, share > 1.0 ? 1u : 0u);
        if (out.isBroken()) {
            EXPECT_NEAR(out.cracks[0].position.x, 4.8, 0.21);
        }
        EXPECT_TRUE(voxelAccounting(world).balances());
    }
}

TEST(ImpactLoad, ABeamUnderFourTimesItsLoadBreaksIntoThree) {
    Structure beam({96, 8, 8});
    beam.fill({{0, 0, 0}, {96, 8, 8}});
    const double d = 0.8, l = 9.6, force = kConcreteTension * d * d * d / 6.0 * 8.0 / l;
    World world;
    world.setSettings(stressOn(0.03));
    world.load(beam.level("concrete", false));
    Outcome out;
    step(world, out, {ImpactLoadEdit{firstShape(world), {4.85, 0.0, 0.4}, {0.0, 4.5 * force * kContact, 0.0}}});
    EXPECT_EQ(out.pieces, 2u);
    EXPECT_TRUE(voxelAccounting(world).balances());
}

/// A slender column and a ball that hits it.
struct Collision {
    explicit Collision(bool stressIsOn) {
        Level level = column(4, 60).level();
        LevelBody ball{.name = "ball", .pose = {{-1.0, 5.0, 0.8}}, .isStatic = false};
        ball.shapes.push_back(levelShape("ball", solidGrid({8, 8, 8}, 1)));
        ball.shapes[0].palette = level.bodies[0].shapes[0].palette;
        level.bodies.push_back(std::move(ball));
        WorldSettings settings;
        settings.stress.on = stressIsOn;
        world.setSettings(settings);
        world.load(level);
        BodyHandle bodies[2];
        world.bodies().forEach([&](BodyHandle handle, const Body& body) { bodies[body.isStatic] = handle; });
        impact = {.body = bodies[0],
                  .other = bodies[1],
                  .position = {0.8, 5.4, 1.0},
                  .normal = {-1.0, 0.0, 0.0},
                  .impulse = 1500.0};
    }
    World world;
    Impact impact;
};

TEST(ImpactLoad, SoftImpactsCanBreakSlenderColumns) {
    Collision with(true);
    for (int i = 0; i < 30; ++i) with.world.applyEdits({});
    const Edits edits = impactDamage(with.world, {&with.impact, 1});
    ASSERT_EQ(edits.size(), 1u) << "it crushes nothing";
    const ImpactLoadEdit& strike = std::get<ImpactLoadEdit>(edits[0]);
    EXPECT_EQ(strike.shape, firstShape(with.world));
    EXPECT_EQ(strike.impulse, glm::dvec3(1500.0, 0.0, 0.0)) << "the column is pushed the other way";
    Outcome out;
    step(with.world, out, edits);
    for (int i = 0; i < 60; ++i) step(with.world, out);
    EXPECT_EQ(out.pieces, 1u);
    EXPECT_TRUE(voxelAccounting(with.world).balances());
}

TEST(ImpactLoad, CostsNothingWhenOff) {
    Collision without(false);
    without.world.applyEdits({});
    EXPECT_TRUE(impactDamage(without.world, {&without.impact, 1}).empty());
    EXPECT_FALSE(without.world.data().stress);
    // An edit by the host costs no more than one that finds nothing.
    const Edits nothing{CarveEdit{.position = {500.0, 0.0, 0.0}, .radii = {0.1, 0.1, 0.1}}};
    const Edits strike{ImpactLoadEdit{firstShape(without.world), {1.0, 5.0, 1.0}, {1e6, 0.0, 0.0}}};
    const size_t start = allocationCount();
    without.world.applyEdits(nothing);
    const size_t between = allocationCount();
    EXPECT_TRUE(without.world.applyEdits(strike).empty());
    EXPECT_LE(allocationCount() - between, between - start);
    for (int i = 0; i < 10; ++i) EXPECT_TRUE(without.world.applyEdits({}).empty());
}

TEST(ImpactLoad, BadNumbersAreRefused) {
    World world;
    stand(world, column(4, 20).level(), 1.0, 10);
    const ShapeHandle shape = firstShape(world);
    Outcome out;
    step(world, out,
         {ImpactLoadEdit{shape, {1.0, 1.0, 1.0}, {std::nan(""), 0.0, 0.0}},
          ImpactLoadEdit{shape, {1e300, 0.0, 0.0}, {1.0, 0.0, 0.0}}});
    step(world, out,
         {ImpactLoadEdit{{}, {1.0, 1.0, 1.0}, {1.0, 0.0, 0.0}},
          ImpactLoadEdit{shape, {500.0, 0.0, 0.0}, {1e9, 0.0, 0.0}}});
    for (int i = 0; i < 10; ++i) step(world, out);
    EXPECT_FALSE(out.isBroken());
    // An impact whose force overflows breaks nothing, and the next one works as usual.
    WorldSettings settings = world.settings();
    settings.stress.contactTime = 1e-300;
    world.setSettings(settings);
    for (int i = 0; i < 10; ++i) step(world, out, {ImpactLoadEdit{shape, {1.0, 1.0, 1.0}, {1e9, 0.0, 0.0}}});
    settings.stress.contactTime = kContact;
    world.setSettings(settings);
    for (int i = 0; i < 30; ++i) step(world, out);
    EXPECT_FALSE(out.isBroken());
    step(world, out, {ImpactLoadEdit{shape, {1.0, 1.9, 1.0}, {1e6, 0.0, 0.0}}});
    for (int i = 0; i < 60; ++i) step(world, out);
    EXPECT_TRUE(out.isBroken());
}

TEST(ImpactLoad, TheSameBlowsGiveTheSameHashes) {
    World first, second;
    for (World* world : {&first, &second}) stand(*world, column(8, 60).level(), 1.0, 10);
    for (int i = 0; i < 40; ++i) {
        Edits edits;
        if (i % 3 == 0)
            edits.push_back(
                ImpactLoadEdit{firstShape(first), {1.2, 1.0 + 0.1 * i, 1.2}, {3000.0 + 100.0 * i, 0.0, 50.0 * i}});
        first.applyEdits(edits);
        second.applyEdits(edits);
        ASSERT_EQ(first.hash(), second.hash()) << i;
    }
}

}  // namespace
}  // namespace rubble
