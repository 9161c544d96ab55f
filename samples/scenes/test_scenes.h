#pragma once
#include "runtime/world/level/level.h"

/// Small levels with known results, for tests and benchmarks. Static bodies stand at y = 0 on a flat floor.
namespace rubble {

/// One dynamic cube of `size` cells, `height` metres above a floor of 8 x 8 m.
Level makeSingleCube(int size, double height);
/// A closed room with walls one cell thick and `inner` cells of space inside, and nothing else. The low corner of the
/// space is at (0.1, 0.1, 0.1) m.
Level makeClosedRoom(int inner);
/// A brick wall along x, 4 x 2.4 x 0.3 m, on the floor; its low corner at (2, 0, 3.9) m.
Level makeWall();
/// A tower of `storeys` slabs on four posts each, 2.4 x 2.4 m, on the floor.
Level makeTestTower(int storeys);
/// `count` dynamic cubes of `size` cells in a grid above the floor; the seed gives them spins.
Level makeCubeRain(int count, int size, uint64_t seed);

}  // namespace rubble
