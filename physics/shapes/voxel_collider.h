#pragma once
#include <array>
#include <glm/mat3x3.hpp>
#include <memory>
#include <vector>

#include "physics/shapes/hull_points.h"
#include "physics/shapes/surface_features.h"
#include "runtime/core/lazy.h"
#include "runtime/core/pose.h"
#include "runtime/voxel/cell_box.h"
#include "runtime/world/world.h"

namespace rubble {

/// How a palette's entries rub and bounce.
struct ContactMaterials {
    std::array<float, 256> friction{}, restitution{};
    std::array<bool, 256> solid{};  ///< false: unphysical, seen but not touched
    ContactMaterials(const Palette& palette, const MaterialTable& materials);
};

/// What narrowphase wants to know of a small part.
struct PartSurface {
    explicit PartSurface(const VoxelGrid& grid, const CellBox& box)
        : rows(grid, box), features(findFeatures(rows)), hull(rows) {}
    SolidRows rows;
    FeatureList features;
    HullPoints hull;
};

/// Who isConstrained whom: each one's layer must be in the other's mask. Bits.
struct CollisionFilter {
    uint8_t layer = 1, mask = 255;
    bool meets(CollisionFilter other) const { return (layer & other.mask) && (other.layer & mask); }
};

/// One shape as physics sees it: its bricks, shared with World, and the features of those that something came near.
/// A cut changes bricks and nothing else. Written by the main thread; narrowphase threads read it together.
class VoxelPart {
public:
    static constexpr int kMaxWholeSize = 32;
    /// frame: grid corner -> the collider's frame.
    VoxelPart(const Shape& shape, const Pose& frame, const MaterialTable& materials);

    const VoxelGrid& grid() const { return m_grid; }
    const Pose& frame() const { return m_frame; }
    void setFrame(const Pose& frame) { m_frame = frame; }
    double voxelSize() const { return m_voxelSize; }
    /// Cells that hold all solid ones; tight for small grids, by bricks for large ones.
    const CellBox& bounds() const { return m_bounds; }
    const ContactMaterials& contactMaterials() const { return *m_contactMaterials; }
    CollisionFilter filter() const { return m_filter; }
    void setFilter(CollisionFilter filter) { m_filter = filter; }
    /// Of all of it if its bounds are at most kMaxWholeSize cells on a side, else null. Like the others, found when
    /// first asked for.
    const PartSurface* whole() const;
    const HullPoints& hull() const;
    /// Of one brick.
    const FeatureList& features(glm::ivec3 brick) const;
    const SolidRows& rows(glm::ivec3 brick) const;

    /// The shape's voxels have changed in these bricks; its size has not. Costs those bricks and the directory.
    void update(const Shape& shape, const std::vector<glm::ivec3>& bricks, const MaterialTable& materials);

private:
    struct NodeSurface {
        mutable std::array<Lazy<FeatureList>, 64> features;
        mutable std::array<Lazy<SolidRows>, 64> rows;
    };
    const NodeSurface& node(glm::ivec3 brick) const;
    /// All of it, or what has changed in these bricks.
    void takeGrid(const VoxelGrid& grid, const std::vector<glm::ivec3>* bricks);
    void findBounds();
    size_t nodeNumber(glm::ivec3 node) const {
        const glm::ivec3 n = m_grid.sizeInNodes();
        return (size_t(node.z) * size_t(n.y) + size_t(node.y)) * size_t(n.x) + size_t(node.x);
    }

    VoxelGrid m_grid;
    Pose m_frame;
    double m_voxelSize;
    CollisionFilter m_filter;
    CellBox m_bounds;
    bool m_hasUnphysical = false;  ///< the shape has voxels that are not in m_grid
    std::shared_ptr<const ContactMaterials> m_contactMaterials;
    std::unique_ptr<Lazy<NodeSurface>[]> m_nodes;  ///< of large parts
    mutable Lazy<PartSurface> m_whole;
    mutable Lazy<HullPoints> m_hull;
};

/// The bricks of a shape that the journal names.
void changedBricks(const FrameChanges& changes, ShapeHandle shape, std::vector<glm::ivec3>& out);

/// All shapes of a body, or one of a static body.
struct VoxelCollider {
    std::vector<std::unique_ptr<VoxelPart>> parts;

    bool empty() const;
    /// Box of the collider's frame that holds all parts.
    void bounds(glm::dvec3& low, glm::dvec3& high) const;
    /// The farthest that any of it is from the frame's origin, metres.
    double radius() const;
};

}  // namespace rubble
