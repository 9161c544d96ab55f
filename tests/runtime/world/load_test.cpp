#include <gtest/gtest.h>

#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

/// A beam of concrete from a wall at x < 4.
Level cantilever(int length, int depth, float voxelSize = 0.1f) {
    VoxelGrid grid({4 + length, depth, depth});
    {
        GridWriter writer(grid);
        for (int z = 0; z < depth; ++z)
            for (int y = 0; y < depth; ++y)
                for (int x = 0; x < 4 + length; ++x) writer.set({x, y, z}, 1);
    }
    Level level;
    Palette palette{};
    palette[1].material = level.materials.find("concrete");
    LevelShape shape{.name = "beam", .voxelSize = voxelSize, .grid = std::move(grid), .palette = std::make_shared<const Palette>(palette)};
    shape.anchors = {{{0, 0, 0}, {4, depth, depth}}};
    LevelBody body{.name = "wall", .isStatic = true};
    body.shapes.push_back(std::move(shape));
    level.bodies.push_back(std::move(body));
    return level;
}

/// Stress over strength at the wall under its own weight, by beam theory.
double shareAtWall(int length, int depth, double voxelSize, double strengthScale) {
    return 2400.0 * 9.81 * 3.0 * length * length * voxelSize / depth / (2.6e6 * strengthScale);
}

WorldSettings loadOn(double strengthScale) {
    WorldSettings settings;
    settings.load.on = true;
    settings.load.strengthScale = strengthScale;
    return settings;
}

TEST(Load, CantileverSnapsAtTheWall) {
    for (const float voxelSize : {0.05f, 0.1f, 0.25f}) {
        const double scale = shareAtWall(80, 8, voxelSize, 1.0);
        for (const double overload : {0.95, 1.05}) {
            World world;
            world.setSettings(loadOn(scale / overload));
            world.load(cantilever(80, 8, voxelSize));
            std::vector<CrackOpened> cracks;
            size_t pieces = 0;
            for (int step = 0; step < 60; ++step) {
                const FrameChanges changes = world.applyEdits({});
                cracks.insert(cracks.end(), changes.cracks.begin(), changes.cracks.end());
                pieces += changes.shapesCreated.size();
            }
            EXPECT_EQ(pieces, overload > 1.0 ? 1u : 0u) << voxelSize;
            EXPECT_EQ(cracks.empty(), overload < 1.0);
            if (!cracks.empty()) {
                EXPECT_NEAR(cracks[0].position.x, 4 * voxelSize, 1e-6);
                EXPECT_EQ(cracks[0].cause, LoadFailure::Tension);
            }
            EXPECT_TRUE(world.ledger().balances());
        }
    }
}

}  // namespace
}  // namespace rubble
