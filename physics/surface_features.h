#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// Where two bodies of voxels can touch first: the convex corners and edges of their voxels. Faces need no points of
/// their own: two faces meet where the corners or edges of one lie on the other.
///
/// Kinds 0..7 are corners; bit i: at the high side of axis i. Kinds 8..19 are edges of one voxel's length: 8 + 4 axis +
/// sides, the two bits being the sides along the next two axes in cyclic order.
inline constexpr int kFeatureKinds = 20;

struct FeatureKind {
    glm::vec3 place;    ///< in the voxel, its low corner being 0: the corner, or the edge's middle
    glm::vec3 outward;  ///< +-1 along each axis that the feature sticks out on, 0 along an edge
    int edgeAxis;       ///< -1: a corner
};
const std::array<FeatureKind, kFeatureKinds>& featureKinds();

/// Features of one brick, side by side in arrays that are gone through four at a time.
struct FeatureList {
    std::vector<float> x, y, z;   ///< where they are, in cells from the brick's low corner; filled up to fours with NaN
    std::vector<uint16_t> voxel;  ///< in the brick, as voxelIndex()
    std::vector<uint8_t> kind;
    std::array<uint32_t, kBrickSize + 1> layers{};  ///< where those of the voxels of each z begin, and their number
    size_t size() const { return kind.size(); }
};

/// The features of the voxels of one brick, in the order of voxels. A corner is convex if all seven cells around it but its
/// own are empty, an edge if all three are. What lies outside the grid is empty.
FeatureList findFeatures(const VoxelGrid& grid, glm::ivec3 brick);

/// Which cells of a brick, and of two more around it, are solid.
struct BrickSurroundings {
    static constexpr int kAround = 2, kSize = kBrickSize + 2 * kAround;
    std::array<uint16_t, size_t(kSize) * kSize> rows{};  ///< bit x + 2 of row (y + 2) + 12 (z + 2)

    /// Whether a cell of a box is solid; both ends are part of it and count from the brick's low corner, -2 to 9.
    bool any(glm::ivec3 low, glm::ivec3 high) const {
        uint32_t found = 0;
        for (int z = low.z + kAround; z <= high.z + kAround; ++z)
            for (int y = low.y + kAround; y <= high.y + kAround; ++y) found |= rows[size_t(y + kSize * z)];
        return found & ((2u << (high.x + kAround)) - (1u << (low.x + kAround)));
    }
};
BrickSurroundings surroundBrick(const VoxelGrid& grid, glm::ivec3 brick);

}  // namespace rubble
