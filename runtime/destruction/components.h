#pragma once
#include <cstdint>
#include <vector>

#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// A 6-connected component of the voxels of one brick, and where it reaches the brick's faces.
struct BrickPart {
    BrickBits voxels{};
    std::array<uint64_t, 6> faces{};  ///< -x +x -y +y -z +z: one bit a cell; facing faces have the same bit order
};

/// The direction of each of BrickPart::faces; face i ^ 1 of the neighbour there touches face i.
inline constexpr std::array<glm::ivec3, 6> kFaceSteps = {{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};

/// Appends the components inside a brick, the one with the lowest voxel first. Flood fill on whole words of occupancy.
void findBrickParts(const BrickBits& occupancy, std::vector<BrickPart>& out);

/// A component's share of one brick.
struct BrickShare {
    glm::ivec3 brick;
    BrickBits voxels;
};

/// A 6-connected set of voxels of one grid.
struct Component {
    std::vector<BrickShare> shares;
    uint64_t voxels = 0;
    glm::ivec3 lowest{0};  ///< the cell that comes first by z, then y, then x
};

/// Whether cell a comes before cell b, by z, then y, then x.
inline bool cellBefore(glm::ivec3 a, glm::ivec3 b) {
    return a.z != b.z ? a.z < b.z : a.y != b.y ? a.y < b.y : a.x < b.x;
}
/// The lowest cell of a share, in the grid's cells.
glm::ivec3 lowestCell(const BrickShare& share);
/// Which of two components keeps the name of what they came from: the larger, else the one with the lowest cell.
bool outranks(const Component& a, const Component& b);

/// All components of a grid, ordered by their lowest cell. Components inside bricks, then a union-find over the faces
/// between bricks (Tarjan 1975, path halving).
std::vector<Component> findComponents(const VoxelGrid& grid);

}  // namespace rubble
