#pragma once
#include "runtime/core/random.h"
#include "tests/support/grids.h"

namespace rubble {

/// A block of houses to cast rays through: walls one voxel thick, windows, floors, streets between the houses.
inline VoxelGrid makeHouses() {
    const glm::ivec3 size(256, 128, 256);
    return gridOf(size, [](glm::ivec3 c) {
        const int height = 30 + int(hashCell(c.x / 64, 0, c.z / 64) % 90), hx = c.x % 64, hz = c.z % 64;
        const bool isHouse = hx >= 8 && hx < 56 && hz >= 8 && hz < 56 && c.y < height;
        const bool isWall = hx == 8 || hx == 55 || hz == 8 || hz == 55,
                   isWindow = c.y % 24 > 8 && c.y % 24 < 18 && (hx + hz) % 12 < 6;
        return uint8_t(c.y < 2 || (isHouse && ((isWall && !isWindow) || c.y % 24 == 0)));
    });
}

}  // namespace rubble
