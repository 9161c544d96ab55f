#include "samples/sandbox/player.h"

#include <gtest/gtest.h>

namespace rubble {
namespace {

TEST(Player, CarriesATorch) {
    World world;
    world.load({});
    world.applyEdits({});
    Player player;
    player.place({{0.0, 1.0, 0.0}});
    const auto step = [&] { return world.applyEdits(player.carryTorch(world)); };
    EXPECT_TRUE(step().empty());
    player.toggleTorch();
    const FrameChanges made = step();
    ASSERT_EQ(made.lightsAdded.size(), 1u);
    EXPECT_TRUE(step().empty()) << "held still it costs nothing";
    player.place({{5.0, 1.0, 0.0}});
    EXPECT_EQ(step().lights, made.lightsAdded) << "one torch, moved";
    EXPECT_NEAR(world.lights().at(made.lightsAdded[0]).local.position.x, 5.0, 0.5);
    player.toggleTorch();
    step();
    EXPECT_EQ(world.lights().size(), 0u);
    EXPECT_TRUE(step().empty());
}

}  // namespace
}  // namespace rubble
