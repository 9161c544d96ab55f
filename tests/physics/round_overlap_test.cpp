// Spheres and cylinders that overlap where they start, also with one middle: they come apart, slowly, and each pair
// begins to touch once.
#include <gtest/gtest.h>

#include "tests/physics/physics_scene.h"

namespace rubble {
namespace {

constexpr int kAcross = 10, kLength = 30;  ///< voxels

/// A ball, or a cylinder along an axis.
VoxelGrid roundGrid(CollisionShape shape) {
    const int axis = int(shape) - int(CollisionShape::CylinderX);
    glm::ivec3 size(kAcross);
    if (axis >= 0) size[axis] = kLength;
    return gridOf(size, [&](glm::ivec3 cell) {
        glm::ivec3 from = 2 * cell + 1 - size;
        if (axis >= 0) from[axis] = 0;
        return uint8_t(from.x * from.x + from.y * from.y + from.z * from.z <= kAcross * kAcross ? 7 : 0);
    });
}

struct Apart {
    double fastest = 0.0, distance = 0.0;  ///< m/s; metres of the middles in the end
    int begun = 0;
    bool isFinite = true;
};

/// Two bodies without gravity, whose middles are `offset` apart at first, for three seconds.
Apart part(CollisionShape first, CollisionShape second, const glm::dvec3& offset) {
    PhysicsSettings settings;
    settings.sleepTime = 1e9;
    PhysicsScene scene(settings);
    scene.level.environment.gravity = {0, 0, 0};
    const CollisionShape shapes[] = {first, second};
    for (int i = 0; i < 2; ++i) {
        const VoxelGrid grid = roundGrid(shapes[i]);
        const glm::dvec3 middle = i ? offset : glm::dvec3(0.0);
        scene.add(grid, middle - glm::dvec3(grid.size()) * 0.05, false).shapes[0].collisionShape = shapes[i];
    }
    scene.load();
    scene.physics.report({.begun = true});
    Apart out;
    for (int step = 0; step < 180; ++step) {
        scene.step();
        for (int i = 0; i < 2; ++i) {
            const double speed = glm::length(glm::dvec3(scene.body(i).velocity));
            out.isFinite = out.isFinite && std::isfinite(speed);
            out.fastest = std::max(out.fastest, speed);
        }
        out.begun += int(scene.physics.contacts().size());
    }
    out.distance = glm::length(scene.center(1) - scene.center(0));
    return out;
}

TEST(RoundOverlap, ComesApartSlowlyAndIsToldOnce) {
    const CollisionShape kinds[] = {CollisionShape::Sphere, CollisionShape::CylinderX, CollisionShape::CylinderY,
                                    CollisionShape::CylinderZ};
    for (const CollisionShape first : kinds)
        for (const CollisionShape second : kinds)
            for (const glm::dvec3 offset : {glm::dvec3(0.0), {0.2, 0.0, 0.0}, {0.1, 0.5, 0.2}, {0.0, 0.0, 0.85}}) {
                const Apart apart = part(first, second, offset);
                const auto place = [&] {
                    return std::to_string(int(first)) + " " + std::to_string(int(second)) + " " +
                           std::to_string(glm::length(offset)) + ": " + std::to_string(apart.distance);
                };
                EXPECT_TRUE(apart.isFinite) << place();
                EXPECT_LT(apart.fastest, 4.0) << place();
                EXPECT_LE(apart.begun, 1) << place();
            }
}

/// On the axis of a cylinder the way out is to any side, not along it.
TEST(RoundOverlap, ASphereOnTheAxisOfACylinderComesOutAcrossIt) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto along = CollisionShape(int(CollisionShape::CylinderX) + axis);
        const Apart apart = part(along, CollisionShape::Sphere, glm::dvec3(0.0));
        EXPECT_GT(apart.distance, 0.95) << axis;
        EXPECT_LT(apart.distance, 1.5) << axis;
    }
}

}  // namespace
}  // namespace rubble
