#include <gtest/gtest.h>

#include "runtime/world/edits/edit.h"
#include "tests/physics/physics_scene.h"
#include "tests/support/allocation_count.h"

namespace rubble {
namespace {

constexpr ReportFilter kAll{.begun = true, .slid = true, .hit = true, .water = true};

/// A floor of concrete and a crate of wood that falls on it, or lies on it.
struct CrateScene : PhysicsScene {
    explicit CrateScene(double height) {
        addFloor(6);
        add(solidGrid({5, 5, 5}, 5), {0.0, height, 0.0}, false);
    }
    /// How many contacts of a kind the next steps report.
    int count(bool ReportedContact::*kind, int steps) {
        int out = 0;
        for (int i = 0; i < steps; ++i) {
            step();
            for (const ReportedContact& contact : physics.contacts()) out += contact.*kind;
        }
        return out;
    }
    uint8_t materialOf(const ContactSide& side) {
        const ShapeHandle handle = world.shapes().handleAt(side.shapeSlot);
        const Shape& shape = world.shapes().at(handle);
        return (*shape.palette)[shape.grid.at(side.cell)].material;
    }
};

TEST(Reports, NothingIsCollectedThatNobodyAskedFor) {
    CrateScene scene(0.5), asked(0.5);
    asked.physics.report(kAll);
    scene.load(), asked.load();
    for (int i = 0; i < 60; ++i) {
        scene.step(), asked.step();
        EXPECT_TRUE(scene.physics.contacts().empty());
    }
    EXPECT_EQ(scene.world.hash(), asked.world.hash()) << "who listens changes nothing";
    asked.physics.report({});
    asked.step();
    EXPECT_TRUE(asked.physics.contacts().empty());
}

TEST(Reports, AFallingCrateHitsAndBeginsToTouch) {
    CrateScene scene(1.0);
    scene.physics.report(kAll);
    scene.load();
    int begun = 0, hits = 0;
    for (int i = 0; i < 120; ++i) {
        scene.step();
        for (const ReportedContact& contact : scene.physics.contacts()) {
            begun += contact.begun, hits += contact.hit;
            if (!contact.begun || begun > 1) continue;  // it may bounce
            EXPECT_NEAR(contact.hitSpeed, std::sqrt(2.0 * 9.81 * 1.0), 0.2);
            EXPECT_GT(contact.impulse, bodyMass(scene.world, scene.handle(1)).mass * 4.0);
            EXPECT_NEAR(contact.position.y, 0.0, 0.02) << "where it touches";
            EXPECT_NEAR(contact.position.x, 0.25, 0.05);
            EXPECT_NEAR(contact.normal.y, 1.0, 1e-6) << "towards the crate";
            EXPECT_NEAR(contact.size, 0.5 * std::sqrt(2.0), 0.05) << "the diagonal of its face";
            EXPECT_EQ(contact.sides[0].body, scene.handle(1));
            EXPECT_EQ(contact.sides[1].body, scene.handle(0));
            EXPECT_EQ(scene.materialOf(contact.sides[0]), 5);
            EXPECT_EQ(scene.materialOf(contact.sides[1]), 6);
        }
    }
    EXPECT_GE(begun, 1);
    EXPECT_LE(begun, 3) << "one bounce or two";
    EXPECT_GE(hits, 1);
    EXPECT_LE(hits, 3);
}

TEST(Reports, WhatLiesBeginsNothingWhenItWakes) {
    CrateScene scene(0.0);
    scene.physics.report(kAll);
    scene.load();
    EXPECT_EQ(scene.count(&ReportedContact::begun, 120), 0);
    ASSERT_TRUE(scene.body(1).asleep);
    const BodyHandle crate = scene.handle(1);
    scene.stepWith({ImpulseEdit{crate, scene.center(1), glm::dvec3(0.0)}});
    EXPECT_EQ(scene.count(&ReportedContact::begun, 60), 0) << "it lay there all the time";
    const double mass = bodyMass(scene.world, crate).mass;
    scene.stepWith({ImpulseEdit{crate, scene.center(1), glm::dvec3(0.0, 3.0 * mass, 0.0)}});
    EXPECT_GE(scene.count(&ReportedContact::begun, 120), 1) << "it was in the air";
    scene.world.state();
    scene.physics.load(scene.world);  // as the step after a save does
    EXPECT_EQ(scene.count(&ReportedContact::begun, 60), 0);
}

TEST(Reports, APushedCrateSlidesUntilItStops) {
    CrateScene scene(0.0);
    scene.physics.report({.slid = true, .minSlipSpeed = 0.2});
    scene.load();
    const double mass = bodyMass(scene.world, scene.handle(1)).mass;
    scene.stepWith({ImpulseEdit{scene.handle(1), scene.center(1), glm::dvec3(2.0 * mass, 0.0, 0.0)}});
    ASSERT_EQ(scene.physics.contacts().size(), 1u);
    EXPECT_NEAR(scene.physics.contacts()[0].slipSpeed, 2.0, 0.3);
    EXPECT_FALSE(scene.physics.contacts()[0].begun) << "nobody asked";
    EXPECT_GT(scene.count(&ReportedContact::slid, 10), 5);
    scene.step(120);
    EXPECT_EQ(scene.count(&ReportedContact::slid, 30), 0) << "it has stopped";
}

TEST(Reports, SofterContactsThanAskedForAreLeftOut) {
    CrateScene scene(1.0);
    scene.physics.report({.begun = true, .slid = true, .hit = true, .minImpulse = 1e6});
    scene.load();
    EXPECT_EQ(scene.count(&ReportedContact::begun, 60), 0);
    scene.physics.report(kAll);
    EXPECT_EQ(scene.count(&ReportedContact::begun, 60), 0) << "it touched before";
}

TEST(Reports, ACrateGetsIntoWaterOnce) {
    PhysicsScene scene;
    scene.level.waters.push_back(
        {.name = "lake", .outline = {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}}, .depth = 40.0});
    scene.add(solidGrid({5, 5, 5}, 5), {0.0, 1.0, 0.0}, false);
    scene.add(solidGrid({5, 5, 5}, 5), {9.0, -0.4, 0.0}, false);
    scene.physics.report({.water = true});
    scene.load();
    std::vector<WaterEntry> entries;
    for (int i = 0; i < 300; ++i) {
        scene.step();
        entries.insert(entries.end(), scene.physics.waterEntries().begin(), scene.physics.waterEntries().end());
    }
    ASSERT_GE(entries.size(), 1u);
    EXPECT_EQ(entries[0].body, scene.handle(0)) << "the other one was in it";
    EXPECT_NEAR(entries[0].speed, std::sqrt(2.0 * 9.81 * 1.0), 0.4);
    EXPECT_NEAR(entries[0].position.y, 0.0, 1e-9);
    EXPECT_NEAR(entries[0].mass, bodyMass(scene.world, scene.handle(0)).mass, 1e-9);
    EXPECT_LE(entries.size(), 3u) << "it may leap out once or twice";
}

/// Reports keep their memory: what is asked for in every step costs no allocation in most.
TEST(Reports, RestingContactsTakeNoMemory) {
    CrateScene scene(0.0), asked(0.0);
    asked.physics.report(kAll);
    const auto allocations = [](CrateScene& of) {
        of.load();
        of.step(10);
        const size_t before = allocationCount();
        of.step(10);
        return allocationCount() - before;
    };
    EXPECT_EQ(allocations(asked), allocations(scene));
}

}  // namespace
}  // namespace rubble
