#include "runtime/world/impacts/break_through.h"

#include <gtest/gtest.h>

#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

/// A block, of steel unless said otherwise, hits a fixed sheet of a material from +z.
struct Throw {
    explicit Throw(const char* sheet, int thickness = 1, int side = 4, const char* thrown = "heavy metal") {
        auto palette = std::make_shared<Palette>();
        (*palette)[1].material = defaultMaterials().find(thrown);
        (*palette)[2].material = defaultMaterials().find(sheet);
        Level level;
        const auto add = [&](VoxelGrid grid, glm::dvec3 corner, bool isStatic) {
            LevelBody body{.name = "body", .pose = {corner}, .isStatic = isStatic};
            body.shapes.push_back({.name = "shape", .grid = std::move(grid), .palette = palette});
            level.bodies.push_back(std::move(body));
        };
        add(solidGrid(glm::ivec3(side), 1), {0.8, 0.8, 0.1}, false);
        add(solidGrid({20, 20, thickness}, 2), {0, 0, -0.1 * (thickness - 1)}, true);
        world.load(level);
        world.bodies().forEach([&](BodyHandle handle, const Body& body) { (body.isStatic ? wall : block) = handle; });
    }
    Edits damage(Impact impact) const {
        Edits edits = impactDamage(world, {&impact, 1});
        addBreakThroughImpulses(world, {&impact, 1}, edits);
        return edits;
    }
    World world;
    BodyHandle block, wall;
};

TEST(BreakThrough, APaneTakesOnlyItsBreakingImpulse) {
    const Throw thrown("glass");
    // Physics lists the two bodies in any order; the normal is the direction in which it pushed the first.
    for (const bool blockFirst : {true, false}) {
        Impact impact{thrown.block, thrown.wall, {1, 1, 0.1}, {0, 0, 1}, 5000.0, 10.0};
        if (!blockFirst) impact = {thrown.wall, thrown.block, {1, 1, 0.1}, {0, 0, -1}, 5000.0, 10.0};
        const Edits edits = thrown.damage(impact);
        ASSERT_EQ(edits.size(), 2u);
        const auto& given = std::get<ImpulseEdit>(edits.back());
        EXPECT_EQ(given.body, thrown.block);
        EXPECT_LT(given.impulse.z, -4900.0) << "nearly all of it, and on through the pane";
        EXPECT_GT(given.impulse.z, -5000.0);
    }
}

TEST(BreakThrough, AThinWallTakesPartOfTheMomentumAThickOneAll) {
    const auto given = [](const Throw& thrown, double impulse, double speed = 1000.0) {
        const Edits edits = thrown.damage({thrown.block, thrown.wall, {1, 1, 0.1}, {0, 0, 1}, impulse, speed});
        EXPECT_TRUE(std::holds_alternative<BreakEdit>(edits.front()));
        double sum = 0.0;
        for (const Edit& edit : edits)
            if (const auto* impulseEdit = std::get_if<ImpulseEdit>(&edit)) sum -= impulseEdit->impulse.z;
        return sum;
    };
    EXPECT_EQ(given(Throw("brick", 3), 5000.0), 0.0) << "the hole is as large as the impulse can make it";
    const double through = given(Throw("brick", 3), 100'000.0);
    EXPECT_GT(through, 50'000.0);
    EXPECT_LT(through, 95'000.0);
    EXPECT_EQ(given(Throw("brick", 12), 100'000.0), 0.0) << "it comes out nowhere";
    EXPECT_EQ(given(Throw("brick", 3, 16), 100'000.0), through) << "what is too large for the hole hits the rim next";
    EXPECT_GT(given(Throw("glass", 1, 16), 100'000.0), 99'000.0);
    EXPECT_EQ(given(Throw("glass", 12), 100'000.0), 0.0);
    const double mass = 0.4 * 0.4 * 0.4 * 7850.0;
    EXPECT_NEAR(given(Throw("brick", 3), 100'000.0, 5.0), mass * 5.0, 1e-3)
        << "what is pressed through goes on as fast as it came";
}

/// Else what is left of the body under its handle, a crumb perhaps, got the momentum of all.
TEST(BreakThrough, WhatBreaksOffGoesOnAsFast) {
    Throw thrown("glass", 1, 16, "wood");
    const double mass = bodyMass(thrown.world, thrown.block).mass;
    const Edits damage = thrown.damage({thrown.block, thrown.wall, {0.9, 0.9, 0.1}, {0, 0, 1}, 10.0 * mass, 10.0});
    const FrameChanges changes = thrown.world.applyEdits({}, damage);
    EXPECT_TRUE(changes.impulses.empty());
    int pieces = 0;
    thrown.world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        const Body* parent = thrown.world.bodies().find(thrown.block);
        if (body.isStatic || body.angularVelocity != parent->angularVelocity) return;  // the pane's pieces rest
        ++pieces;
        const glm::dvec3 apart = body.pose.transformPoint(bodyMass(thrown.world, handle).center) -
                                 parent->pose.transformPoint(bodyMass(thrown.world, thrown.block).center);
        EXPECT_NEAR(glm::distance(body.velocity, parent->velocity + glm::cross(parent->angularVelocity, apart)), 0.0,
                    1e-6);
    });
    EXPECT_GT(pieces, 3);
    EXPECT_NEAR(thrown.world.bodies().at(thrown.block).velocity.z, -10.0, 1.0);
}

}  // namespace
}  // namespace rubble
