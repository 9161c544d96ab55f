#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace rubble {

/// Which of a sector's 4x4x4 bricks are occupied: bit x + 4 y + 16 z.
using SectorBricks = uint64_t;
/// The sets of a sector and of the 26 around it: sector (x, y, z), -1 to 1 each, at (x + 1) + 3 (y + 1) + 9 (z + 1).
using SectorSurroundings = std::array<SectorBricks, 27>;
/// How far rays may skip from a brick, in bricks along x, y and z: 4 bits for each octant of directions (bit a of its
/// number: down axis a), the first octant lowest.
using BrickSkips = std::array<uint32_t, 3>;

/// How far rays may skip over the empty bricks of the sector in the middle: for each brick and octant the sides of an
/// empty box that has the brick in its corner, lies ahead and ends within this sector and the next one along each axis:
/// 1, 2, 3, 4, 6 or 8; 0 if the brick is occupied. Of all such boxes it is one with the largest harmonic mean of its
/// sides, as rays leave flat boxes soon. A brick that changes thus changes nothing beyond the sectors around, and there
/// only the octants that look at it. Brings these octants (a bit each) of `skips` up to date.
void updatePageSkips(const SectorSurroundings& occupied, uint8_t octants, std::array<BrickSkips, 64>& skips);

}  // namespace rubble
