#include "tests/benchmark/destruction_scenes.h"

#include <algorithm>

#include "runtime/core/random.h"

namespace rubble::bench {
namespace {

bool inBuilding(glm::ivec3 c, int size) {
    const int y = c.y % 32;
    if (y < 3) return true;
    const bool isOuter = c.x < 3 || c.z < 3 || c.x >= size - 3 || c.z >= size - 3;
    if (isOuter) return !(y > 10 && y < 22 && (c.x + c.z) % 16 < 8);
    const bool isDoor = y < 20 && (c.x % 64 > 28 || c.z % 64 > 28) && (c.x % 64 < 37 && c.z % 64 < 37);
    return (c.x % 64 < 2 || c.z % 64 < 2) && !isDoor;
}

bool inHoled(glm::ivec3 c) {
    const glm::ivec3 cell = c >> 4;
    const uint32_t h = hashCell(cell.x, cell.y, cell.z, 5);
    if (h % 10 < 3) return true;
    const glm::ivec3 offset = (c & 15) - glm::ivec3(7 + int(h >> 8 & 1), 7 + int(h >> 9 & 1), 7 + int(h >> 10 & 1));
    const int radius = 4 + int(h >> 12) % 4;
    return offset.x * offset.x + offset.y * offset.y + offset.z * offset.z > radius * radius;
}

bool inCracked(glm::ivec3 c) {
    const glm::ivec3 shifted = c + glm::ivec3(20 * (c.y / 40 & 1), 0, 13 * (c.y / 40));
    if (c.y % 40 != 39 && shifted.x % 40 != 39 && shifted.z % 40 != 39) return true;
    return hashCell(c.x >> 2, c.y >> 2, c.z >> 2, 9) % 100 < 15;
}

bool inHalves(glm::ivec3 c, int size) {
    return c.x < size / 2 - 8 || c.x >= size / 2 + 8 || (c.y / 4 == size / 8 && c.z / 4 == size / 8);
}

/// Whether a cell lies inside a Voronoi cell of jittered points: not in the gap where its two nearest points are about
/// equally far.
bool inVoronoi(glm::ivec3 c) {
    constexpr int kCell = 20;
    int64_t nearest = INT64_MAX, second = INT64_MAX;
    const glm::ivec3 home = c / kCell;
    for (int i = 0; i < 27; ++i) {
        const glm::ivec3 cell = home + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1;
        const uint32_t h = hashCell(cell.x, cell.y, cell.z, 11);
        const glm::ivec3 offset =
            cell * kCell + glm::ivec3(int(h % kCell), int(h >> 8) % kCell, int(h >> 16) % kCell) - c;
        const int64_t square =
            int64_t(offset.x) * offset.x + int64_t(offset.y) * offset.y + int64_t(offset.z) * offset.z;
        second = std::min(second, std::max(nearest, square));
        nearest = std::min(nearest, square);
    }
    return second - nearest > 60;
}

bool isSolid(Solid solid, glm::ivec3 c, int size) {
    switch (solid) {
        case Solid::Building:
            return inBuilding(c, size);
        case Solid::Holed:
            return inHoled(c);
        case Solid::Cracked:
            return inCracked(c);
        case Solid::Block:
            return true;
        case Solid::Halves:
            return inHalves(c, size);
        case Solid::Voronoi:
            return inVoronoi(c);
        case Solid::Noise20:
            return hashCell(c.x, c.y, c.z, 7) % 100 < 20;
        case Solid::Noise32:
            return hashCell(c.x, c.y, c.z, 7) % 100 < 32;
    }
    return false;
}

}  // namespace

VoxelGrid makeSolid(Solid solid, int size) {
    VoxelGrid grid(glm::ivec3{size});
    const int bricks = size / kBrickSize;
    for (int b = 0; b < bricks * bricks * bricks; ++b) {
        const glm::ivec3 brick(b % bricks, b / bricks % bricks, b / bricks / bricks);
        BrickIndices indices;
        for (int i = 0; i < kBrickVoxels; ++i) {
            const glm::ivec3 c = brick * kBrickSize + voxelInBrick(i);
            // Every other storey has one colour: some bricks are uniform, some are not, as in real models.
            const uint32_t entry = c.y / 32 & 1 ? 1 : 1 + hashCell(c.x, c.y, c.z) % 3;
            indices[size_t(i)] = isSolid(solid, c, size) ? uint8_t(entry) : uint8_t(0);
        }
        grid.setBrick(brick, makeBrick(indices));
    }
    return grid;
}

VoxelGrid coldCopy(const VoxelGrid& grid) {
    VoxelGrid out(grid.size());
    BrickIndices indices;
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        expandBrick(brick.get(), indices);
        out.setBrick(position, makeBrick(indices));
    });
    return out;
}

}  // namespace rubble::bench
