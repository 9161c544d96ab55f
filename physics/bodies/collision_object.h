#pragma once
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <utility>
#include <vector>

#include "physics/shapes/cell_transform.h"
#include "physics/shapes/voxel_collider.h"

struct btDbvtNode;

namespace rubble {

class DynamicBody;

inline constexpr uint32_t kStaticObject = 0x80000000u;  ///< bit in the number of a static object
inline constexpr uint32_t kNoBody = ~0u;                ///< what World does not hold: the ground around a level

/// What can be touched, at its pose: all voxels of a dynamic body, or one shape of a static body. What is asked of
/// every pair comes first, in two lines of the cache.
struct alignas(64) CollisionObject {
    Pose pose;                       ///< collider's frame -> world
    double radius = 0.0;             ///< of the collider about its frame's origin, metres
    glm::dvec3 displacement{0.0};    ///< in the step, metres
    double turn = 0.0;               ///< metres by which its spin moves a point in the step, at most
    double minHalfExtent = 0.0;      ///< half the smallest side of a dynamic body's bounds, metres
    DynamicBody* dynamic = nullptr;  ///< null: static
    uint32_t number = 0;             ///< unique: a body's slot, or a static shape's slot with kStaticObject
    uint32_t version = 0;            ///< changes when it is added again or its voxels change
    CollisionFilter filter;          ///< of all parts together, as of the last setPose()
    bool isNew = true;               ///< no warm start: its mass or shape has changed since the last step
    bool isCrowded = false;          ///< it is deep in many others, or was: see Crowds
    uint32_t crowdPairs = 0;         ///< with those
    glm::dvec3 low{0.0}, high{0.0};  ///< world bounds, with what it sweeps in the step
    uint32_t body = 0;               ///< slot, or kNoBody
    double smallestVoxel = 0.0;      ///< the side of the smallest voxels of its parts, metres, as of the last setPose()
    VoxelCollider collider;

    /// Sets the pose, and computes the filter and the cell transforms from it. Leaves the bounds to Broadphase::move().
    void setPose(const Pose& newPose);
    /// The cell transforms of the collider's parts, relative to the position of `pose`.
    std::span<const CellTransform> cellTransforms() const { return m_cellTransforms; }

private:
    friend class Broadphase;
    std::vector<CellTransform> m_cellTransforms;
    btDbvtNode* m_leaf = nullptr;
    bool m_moves = false;
    uint32_t m_place = 0;  ///< among those whose pairs are searched
};

/// An upper bound of how far points of two objects move against each other in the step, metres.
inline double maxRelativeDisplacement(const CollisionObject& a, const CollisionObject& b) {
    return glm::length(a.displacement - b.displacement) + a.turn + b.turn;
}

/// Two objects, the one with the lower number first. Pairs are sorted by these numbers wherever their order matters.
using ObjectPair = std::pair<CollisionObject*, CollisionObject*>;

}  // namespace rubble
