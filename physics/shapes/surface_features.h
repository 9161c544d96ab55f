#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "physics/shapes/solid_rows.h"

namespace rubble {

/// Where two bodies of voxels can touch first: the convex corners and edges of their voxels. Faces need no points of
/// their own: two faces meet where the corners or edges of one lie on the other.
///
/// Kinds 0..7 are corners; bit i: at the high side of axis i. Kinds 8..19 are edges of one voxel's length: 8 + 4 axis +
/// sides, the two bits being the sides along the next two axes in cyclic order.
inline constexpr int kFeatureKinds = 20;

struct FeatureKind {
    glm::vec3 offset;   ///< in the voxel, its low corner being 0: the corner, or the edge's middle
    glm::vec3 outward;  ///< +-1 along each axis that the feature sticks out on, 0 along an edge
    int edgeAxis;       ///< -1: a corner
};
const std::array<FeatureKind, kFeatureKinds>& featureKinds();

/// Features of a region of at most 120 cells a side, from its low corner, in clusters of 4 x 4 x 4 cells. What is gone
/// through lies side by side, pack at a time and packed: landing pieces are bound by how much of it must be fetched.
struct FeatureList {
    struct Pack {
        std::array<uint8_t, 4> x, y, z;  ///< where they are, in half cells
        std::array<uint8_t, 4> kind;     ///< kNoFeature: filled up
    };
    struct ClusterPack {
        std::array<std::array<uint8_t, 4>, 3> low,
            high;                          ///< bounds of the features, in half cells, by axis; of none low > high
        std::array<uint32_t, 4> from, to;  ///< in `packs`
    };
    static constexpr uint8_t kNoFeature = 255;
    /// The cell that a feature of a pack belongs to.
    static glm::ivec3 cellOf(const Pack& pack, size_t i);
    std::vector<Pack> packs;
    std::vector<ClusterPack> clusters;
    size_t count = 0;
};

/// The features of the voxels of the rows' box. A corner is convex if all seven cells around it but its own are empty,
/// an edge if all three are.
FeatureList findFeatures(const SolidRows& rows);

}  // namespace rubble
