#include <gtest/gtest.h>

#include <cmath>

#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

TEST(ImpactDamage, HardImpactsBreakAndWeightAtRestDoesNot) {
    World world;
    Level level = test::oneShapeLevel(test::solidGrid({20, 20, 20}, 2), false);  // 8 m3 of 1700 kg
    level.bodies.push_back(test::oneShapeLevel(test::solidGrid({40, 4, 40}), true, {{-1.0, -0.4, -1.0}}).bodies[0]);
    world.load(level);
    std::vector<BodyHandle> bodies;
    world.bodies().forEach([&](BodyHandle handle, const Body&) { bodies.push_back(handle); });
    const double mass = world.bodyMass(bodies[0]).mass;
    EXPECT_NEAR(mass, 8.0 * 1700.0, 1.0);
    Impact impact{.body = bodies[0], .other = bodies[1], .position = {1.0, 0.0, 1.0}};
    impact.impulse = mass * 9.81 / 60.0;
    EXPECT_GT(impact.impulse, world.settings().impactThreshold);
    EXPECT_TRUE(world.damageFrom({&impact, 1}).empty()) << "it only stands there";
    impact.impulse = mass * 5.0;
    const Edits edits = world.damageFrom({&impact, 1});
    ASSERT_EQ(edits.size(), 1u);
    const Ledger before = world.ledger();
    world.applyEdits(edits);
    EXPECT_LT(before.removed, world.ledger().removed);
}

TEST(ImpactDamage, TheHardestComeFirstAndTheirNumberIsLimited) {
    World world;
    std::vector<Impact> impacts(40);
    for (size_t i = 0; i < impacts.size(); ++i) {
        impacts[i].position = {double(i), 0.0, 0.0};
        impacts[i].impulse = 1500.0 + 100.0 * double(i);
    }
    impacts[3].impulse = std::nan("");
    const Edits edits = world.damageFrom(impacts);
    ASSERT_EQ(edits.size(), world.settings().impactsAStep);
    EXPECT_EQ(std::get<CarveEdit>(edits[0]).position.x, 39.0);
    EXPECT_TRUE(world.damageFrom(std::span(impacts).first(5)).empty());
}

}  // namespace
}  // namespace rubble
