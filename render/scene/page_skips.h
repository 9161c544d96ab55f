#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace rubble {

/// Which of a sector's 4x4x4 bricks are occupied: bit x + 4 y + 16 z.
using SectorBricks = uint64_t;
/// The sets of a sector and of the 26 around it: sector (x, y, z), -1 to 1 each, at (x + 1) + 3 (y + 1) + 9 (z + 1).
using SectorSurroundings = std::array<SectorBricks, 27>;

/// How far rays may skip over the empty bricks of the sector in the middle: for each brick, and for each octant of
/// directions (bit a of its number: down axis a; 4 bits each, the first octant lowest), the side in bricks of the
/// largest empty cube that has the brick in its corner, lies ahead and ends within this sector and the next one along
/// each axis: 1 to 8; 0 if the brick is occupied. A brick that changes thus changes nothing beyond the sectors around.
std::array<uint32_t, 64> pageSkips(const SectorSurroundings& occupied);

}  // namespace rubble
