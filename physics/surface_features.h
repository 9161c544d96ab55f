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
    size_t size() const { return kind.size(); }
};

/// The features of the voxels of one brick, in the order of voxels. A corner is convex if all seven cells around it but its
/// own are empty, an edge if all three are. What lies outside the grid is empty.
FeatureList findFeatures(const VoxelGrid& grid, glm::ivec3 brick);

/// Cells of a brick that are solid or have a solid one among their 26 neighbours.
BrickBits dilateBrick(const VoxelGrid& grid, glm::ivec3 brick);

}  // namespace rubble
