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
/// Kinds 0..7 are corners; bit i is set if it is on the high side of axis i. Kinds 8..19 are edges of one voxel's
/// length: 8 + 4 axis + sides, where the two bits of `sides` are the sides along the next two axes in cyclic order.
inline constexpr int kFeatureKinds = 20;

struct FeatureKind {
    glm::vec3 offset;   ///< of the corner, or of the edge's middle, from the voxel's low corner, in cells
    glm::vec3 outward;  ///< +-1 along each axis on which the feature sticks out, 0 along an edge
    int edgeAxis;       ///< -1: a corner
};
/// All kinds by number.
const std::array<FeatureKind, kFeatureKinds>& featureKinds();

/// The features of a region of at most 120 cells on a side, in half cells from its low corner. They lie in clusters of
/// 4 x 4 x 4 cells, and side by side in packs of four for SIMD. They are bytes because fetching them from memory is
/// what the contacts of a landing piece cost.
struct FeatureList {
    struct Pack {
        std::array<uint8_t, 4> x, y, z;  ///< half cells
        std::array<uint8_t, 4> kind;     ///< kNoFeature: an unused lane
    };
    struct ClusterPack {
        std::array<std::array<uint8_t, 4>, 3> low;   ///< bounds of the features by axis, half cells
        std::array<std::array<uint8_t, 4>, 3> high;  ///< below `low` in unused lanes
        std::array<uint32_t, 4> from, to;            ///< in `packs`
    };
    static constexpr uint8_t kNoFeature = 255;
    /// The cell that feature i of a pack belongs to, from the region's low corner.
    static glm::ivec3 cellOf(const Pack& pack, size_t i);
    std::vector<Pack> packs;
    std::vector<ClusterPack> clusters;
    size_t count = 0;  ///< of features
};

/// The features of the solid cells of the rows' box. A corner is convex if the seven cells that share it with its own
/// are empty, an edge if the three are.
FeatureList findFeatures(const SolidRows& rows);

}  // namespace rubble
