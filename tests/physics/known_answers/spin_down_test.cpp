#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/scenes/known_scenes.h"

namespace rubble {
namespace {

/// The mean distance of the cells of a grid's lowest layer from its middle, cells.
double meanRadius(const VoxelGrid& grid) {
    double sum = 0.0;
    int count = 0;
    const glm::dvec2 middle = glm::dvec2(grid.size().x, grid.size().z) * 0.5;
    for (int x = 0; x < grid.size().x; ++x)
        for (int z = 0; z < grid.size().z; ++z) {
            if (!grid.at({x, 0, z})) continue;
            for (int i = 0; i < 16; ++i)  // the parts of a cell
                sum += glm::length(glm::dvec2(x + (i % 4 + 0.5) / 4.0, z + (i / 4 + 0.5) / 4.0) - middle) / 16.0;
            ++count;
        }
    return sum / count;
}

/// What spins flat on the floor loses mu m g r of its angular momentum in a second, with the mean distance r of the
/// area on which it stands from its middle.
TEST(SpinDown, AreasResistSpinByTheirMeanRadius) {
    const auto disc = [](glm::ivec3 c) {
        const int x = 2 * c.x - 19, z = 2 * c.z - 19;
        return uint8_t(x * x + z * z <= 400 ? 7 : 0);
    };
    const auto ring = [&](glm::ivec3 c) {
        const int x = 2 * c.x - 19, z = 2 * c.z - 19;
        return uint8_t(x * x + z * z > 196 ? disc(c) : 0);
    };
    const auto table = [](glm::ivec3 c) {
        const bool isFoot = (c.x < 3 || c.x > 16) && (c.z < 3 || c.z > 16);
        return uint8_t(c.y > 0 || isFoot ? 7 : 0);
    };
    const std::vector<std::pair<const char*, VoxelGrid>> grids{
        {"disc", gridOf({20, 2, 20}, disc)},   {"ring", gridOf({20, 2, 20}, ring)},
        {"square", solidGrid({10, 2, 10}, 7)}, {"bar", solidGrid({24, 2, 4}, 7)},
        {"table", gridOf({20, 2, 20}, table)},
    };
    for (const auto& [name, grid] : grids)
        for (const double spin : {1.0, 3.0, 8.0}) {
            PhysicsScene scene(known::sleepless(accuratePhysics()));
            known::setMaterial(scene, 7, 0.4f, 0.0f);
            scene.addFloor(7);
            const glm::dvec3 half = glm::dvec3(grid.size()) * 0.05;
            scene.add(grid, {-half.x, 0.0, -half.z}, false).angularVelocity = {0.0f, float(spin), 0.0f};
            scene.load();
            const MassProperties mass = bodyMass(scene.world, scene.handle(1));
            const double loss = 0.4 * 9.81 * mass.mass * 0.1 * meanRadius(grid) / mass.inertia[1];  // rad/s in a second
            const double time = 0.6 * spin / loss;
            const int steps = std::max(1, int(time * 60.0));
            scene.step(steps);
            const double lost = spin - double(scene.body(1).angularVelocity.y);
            EXPECT_NEAR(lost / (loss * steps / 60.0), 1.0, 0.04) << name << " at " << spin << " rad/s";
        }
}

}  // namespace
}  // namespace rubble
