#include <gtest/gtest.h>

#include <glm/mat3x3.hpp>

#include "runtime/destruction/carve.h"
#include "runtime/world/edits/resolve_brush.h"
#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

using Vector = glm::dvec3;

/// A rigid body in world axes, for sums of momenta (scene P17 of the accuracy tests).
struct Rigid {
    double mass;
    Vector center, velocity, angularVelocity;
    glm::dmat3 inertia;
    Vector linear() const { return mass * velocity; }
    Vector angular() const { return glm::cross(center, linear()) + inertia * angularVelocity; }
    double scale() const { return mass * (glm::length(velocity) + glm::length(angularVelocity) * glm::length(center)); }
};

Rigid rigidOf(const Body& body, const MassProperties& mass) {
    const std::array<double, 6>& t = mass.inertia;
    const glm::dmat3 rotation = glm::mat3_cast(body.pose.rotation);
    const glm::dmat3 inertia(t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2]);
    return {mass.mass, body.pose.transformPoint(mass.center), body.velocity, body.angularVelocity,
            rotation * inertia * glm::transpose(rotation)};
}

/// A level with one tumbling tower.
struct Scene {
    Level level;
    explicit Scene(uint64_t seed) {
        Random random(seed);
        const float w = random.unit(), x = random.unit(), y = random.unit(), z = random.unit();
        const Pose pose{{100.0 * x, -30.0 * y, 7.0}, glm::normalize(glm::dquat(w + 0.1, x - 0.5, y - 0.5, z - 0.5))};
        level = test::oneShapeLevel(towerGrid({40, 61, 33}, 2), false, pose);
        level.bodies[0].velocity = {3.0f * x, -2.0f, 5.0f * z};
        level.bodies[0].angularVelocity = {4.0f * z, 7.0f * w, -3.0f * y};
    }
};

TEST(Momentum, SplitsConserveMomentum) {
    size_t bodies = 0;
    for (uint64_t seed = 1; seed <= 25; ++seed) {
        World world;
        world.load(Scene(seed).level);
        world.applyEdits({});
        Random random(seed);
        const ShapeHandle shape = test::firstShape(world);
        const BodyHandle bodyHandle = world.shapes().at(shape).body;
        const float x = random.unit(), y = random.unit(), z = random.unit();
        const Pose pose = shapeToWorld(world, shape);
        // A slightly oblique slab across the whole tower.
        const glm::dquat aslant = glm::normalize(glm::dquat(1.0, 0.3 * x, 0.3 * y, 0.3 * z));
        const CarveEdit cut{.kind = BrushKind::Box,
                            .position = pose.transformPoint({2.0, 1.5 + 3.0 * y, 1.6}),
                            .halfSize = {9.0, 0.2, 9.0},
                            .rotation = pose.rotation * aslant};

        // The body after the carve and before the split: the carved grid as one rigid body that moves as before.
        const Body before = world.bodies().at(bodyHandle);
        const Rigid whole = rigidOf(before, bodyMass(world, bodyHandle));
        VoxelGrid grid = world.shapes().at(shape).grid;
        const Palette palette = *world.shapes().at(shape).palette;
        CarveResult carved;
        carve(grid, resolveBrush(cut, pose, world.shapes().at(shape).voxelSize), palette, world.materials(), carved);
        Rigid expected = rigidOf(
            before, massProperties(gridMoments(grid, palette, world.materials()), world.shapes().at(shape).voxelSize));
        expected.velocity = whole.velocity + glm::cross(whole.angularVelocity, expected.center - whole.center);

        const FrameChanges changes = world.applyEdits({cut});
        Vector linear(0.0), angular(0.0);
        double mass = 0.0;
        world.bodies().forEach([&](BodyHandle handle, const Body& body) {
            const Rigid piece = rigidOf(body, bodyMass(world, handle));
            mass += piece.mass, linear += piece.linear(), angular += piece.angular();
            EXPECT_EQ(body.angularVelocity, before.angularVelocity);
        });
        bodies += world.bodies().size();
        const double arm = glm::length(expected.center) + 5.0;
        EXPECT_NEAR(mass, expected.mass, 1e-9 * expected.mass);
        EXPECT_LT(glm::length(linear - expected.linear()), 1e-6 * expected.scale()) << "seed " << seed;
        EXPECT_LT(glm::length(angular - expected.angular()), 1e-6 * expected.scale() * arm) << "seed " << seed;
    }
    EXPECT_GT(bodies, 35u) << "the cuts must split something";
}

TEST(Momentum, PiecesOfStaticBodiesStartAtRest) {
    World world;
    Level level = Scene(3).level;
    level.bodies[0].isStatic = true;
    level.bodies[0].velocity = level.bodies[0].angularVelocity = {};
    world.load(level);
    Edits edits;
    for (int i = 0; i < 12; ++i)
        edits.push_back(test::sphereCarve(
            shapeToWorld(world, test::firstShape(world)).transformPoint(Vector(i % 4, i * 0.5, i % 3)), 0.8));
    const FrameChanges changes = world.applyEdits(edits);
    EXPECT_FALSE(changes.bodiesCreated.empty());
    for (const BodyHandle handle : changes.bodiesCreated) EXPECT_EQ(world.bodies().at(handle).velocity, Vector(0.0));
}

TEST(Momentum, MassMomentsStayExactThroughAHundredCuts) {
    World world;
    world.load(Scene(5).level);
    MassMoments imported = world.shapes().at(test::firstShape(world)).moments;
    Random random(8);
    for (int step = 0; step < 100; ++step) {
        const float x = random.unit(), y = random.unit(), z = random.unit();
        const Pose pose = shapeToWorld(world, test::firstShape(world));
        world.applyEdits({test::sphereCarve(pose.transformPoint(Vector(4.0 * x, 6.0 * y, 3.3 * z)), 0.5)});
        ASSERT_TRUE(voxelAccounting(world).balances());
    }
    EXPECT_GT(world.shapes().size(), 5u);
    int64_t weight = 0;
    world.shapes().forEach([&](ShapeHandle, const Shape& shape) {
        EXPECT_EQ(shape.moments, gridMoments(shape.grid, *shape.palette, world.materials()));
        weight += shape.moments.weight;
    });
    EXPECT_LT(weight, imported.weight);
}

}  // namespace
}  // namespace rubble
