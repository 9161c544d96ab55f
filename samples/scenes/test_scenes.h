#pragma once
#include "runtime/world/level/level.h"

/// Small scenes with known answers, for tests and benchmarks. Static things stand on y = 0; a flat floor lies below.
namespace rubble {

/// One cube of `size` cells, loose, `height` metres above a floor of 8 x 8 m.
Level makeSingleCube(int size, double height);
/// A closed room whose walls are one cell thick, `inner` cells inside; nothing else. Its inside's low corner is at
/// (0.1, 0.1, 0.1) m.
Level makeClosedRoom(int inner);
/// A brick wall along x, 4 x 2.4 x 0.3 m, on the floor; its low corner at (2, 0, 3.9) m.
Level makeWall();
/// A tower of `storeys` slabs on four posts each, 2.4 x 2.4 m, on the floor.
Level makeTestTower(int storeys);
/// `count` loose cubes of `size` cells in a pile above the floor, in a fixed order from the seed.
Level makeCubeRain(int count, int size, uint64_t seed);

}  // namespace rubble
