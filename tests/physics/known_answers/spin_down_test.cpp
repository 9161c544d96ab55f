#include <gtest/gtest.h>

#include "tests/physics/scenes/impact_scenes.h"

namespace rubble {
namespace {

/// What spins flat on the floor loses mu m g r of its angular momentum in a second, with the mean distance r of the
/// area on which it stands from its middle.
TEST(SpinDown, AreasResistSpinByTheirMeanRadius) {
    for (const auto& [name, grid] : known::spinDownGrids())
        for (const double spin : {1.0, 3.0, 8.0}) {
            const known::SpinDown down = known::spinDown(accuratePhysics(), grid, spin);
            EXPECT_NEAR(down.lost / down.expected, 1.0, 0.04) << name << " at " << spin << " rad/s";
        }
}

}  // namespace
}  // namespace rubble
