#pragma once
#include "runtime/core/random.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// A block of houses to cast rays through: walls one voxel thick, windows, floors, streets between the houses.
inline VoxelGrid makeHouses() {
    const glm::ivec3 size(256, 128, 256);
    VoxelGrid grid(size);
    GridWriter writer(grid);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const int height = 30 + int(hashCell(x / 64, 0, z / 64) % 90), hx = x % 64, hz = z % 64;
                const bool isHouse = hx >= 8 && hx < 56 && hz >= 8 && hz < 56 && y < height;
                const bool isWall = hx == 8 || hx == 55 || hz == 8 || hz == 55,
                           isWindow = y % 24 > 8 && y % 24 < 18 && (hx + hz) % 12 < 6;
                if (y < 2 || (isHouse && ((isWall && !isWindow) || y % 24 == 0))) writer.set({x, y, z}, 1);
            }
    writer.flush();
    return grid;
}

}  // namespace rubble
