#pragma once
#include <array>
#include <glm/mat3x3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "physics/shapes/box_surface.h"
#include "physics/shapes/cell_transform.h"
#include "physics/shapes/hull_points.h"
#include "physics/shapes/round_surface.h"
#include "physics/shapes/surface_features.h"
#include "runtime/core/lazy.h"
#include "runtime/core/pose.h"
#include "runtime/voxel/cell_box.h"
#include "runtime/world/world.h"

namespace rubble {

/// Friction and restitution of a palette's entries.
struct ContactMaterials {
    std::array<float, 256> friction{}, restitution{};
    std::array<bool, 256> solid{};  ///< false: unphysical, seen but not touched
    /// Looks up each entry's material in the table.
    ContactMaterials(const Palette& palette, const MaterialTable& materials);
};

/// The palette entry of all voxels of a grid; 0: there are several.
uint8_t commonEntry(const VoxelGrid& grid);

/// What narrowphase looks up in a part that is small enough to be kept in one piece.
struct PartSurface {
    /// bounds: of the solid cells.
    explicit PartSurface(const VoxelGrid& grid, const CellBox& bounds)
        : rows(grid, bounds),
          box(findBoxSurface(rows)),
          hull(box ? HullPoints(bounds) : HullPoints(rows)),
          widestGap(box ? 0 : rows.widestGap()),
          entry(commonEntry(grid)) {}
    /// What boxes that meet boxes do not need. [any thread]
    const FeatureList& features() const {
        const FeatureList* known = m_features.find();
        return known ? *known : m_features.keep(std::make_unique<FeatureList>(findFeatures(rows)));
    }
    SolidRows rows;
    std::optional<BoxSurface> box;
    HullPoints hull;
    int widestGap;  ///< see SolidRows, cells
    uint8_t entry;  ///< of the palette, of all its voxels; 0: they have several

private:
    mutable Lazy<FeatureList> m_features;
};

/// Two objects collide if a bit of each one's layer is in the other's mask.
struct CollisionFilter {
    uint8_t layer = 1, mask = 255;
    /// Whether the two collide; symmetric.
    bool meets(CollisionFilter other) const { return (layer & other.mask) && (other.layer & mask); }
};

/// One shape as physics sees it. It shares the bricks of World, and a cut replaces only those that it changed.
/// Features, rows and hulls are computed for the bricks that something came near, when they are first asked for. The
/// main thread writes it; narrowphase threads read it together.
class ColliderPart {
public:
    static constexpr int kMaxWholeSize = 32;  ///< cells on a side up to which a part has a PartSurface
    /// frame: from the grid's corner to the collider's frame.
    ColliderPart(const Shape& shape, const Pose& frame, const MaterialTable& materials);

    /// The cells that can be touched: the shape's without those of unphysical materials.
    const VoxelGrid& grid() const { return m_grid; }
    /// The pose of the grid's corner in the collider's frame, metres.
    const Pose& frame() const { return m_frame; }
    /// Takes the part's cells to the world, about the collider's origin, for a collider of this rotation.
    CellTransform cellsAt(const glm::dquat& rotation) const {
        return {glm::mat3_cast(rotation * m_frame.rotation) * m_voxelSize, rotation * m_frame.position};
    }
    /// Moves the part within the collider.
    void setFrame(const Pose& frame) { m_frame = frame; }
    /// The side of a voxel, metres.
    double voxelSize() const { return m_voxelSize; }
    /// A box of cells that holds all solid ones: tight for small grids, rounded to directory nodes for large ones.
    const CellBox& bounds() const { return m_bounds; }
    /// Friction and restitution by palette entry.
    const ContactMaterials& contactMaterials() const { return *m_contactMaterials; }
    /// Which other parts it collides with.
    CollisionFilter filter() const { return m_filter; }
    /// Takes effect when the collision object gets its next pose.
    void setFilter(CollisionFilter filter) { m_filter = filter; }
    /// The round surface that it is touched as; null: it is touched as voxels.
    const RoundSurface* round() const { return m_round ? &*m_round : nullptr; }
    /// The box that its solid cells fill; null: they fill none, or it is touched as something round, or it is longer
    /// than kMaxWholeSize. [any thread]
    const BoxSurface* box() const {
        const PartSurface* surface = m_round ? nullptr : whole();
        return surface && surface->box ? &*surface->box : nullptr;
    }
    /// What it is touched as from now on.
    void setCollisionShape(CollisionShape kind) {
        m_kind = kind;
        m_round = fitRoundSurface(m_grid, m_bounds, m_kind);
    }
    /// The surface of the whole part; null if its bounds are longer than kMaxWholeSize. [any thread]
    const PartSurface* whole() const;
    /// The palette entry of a solid cell. [any thread]
    uint8_t entryAt(glm::ivec3 cell) const {
        const PartSurface* surface = m_whole.find();
        return surface && surface->entry ? surface->entry : m_grid.at(cell);
    }
    /// The hull of the cells, or of the bounds of a large part. [any thread]
    const HullPoints& hull() const;
    /// The features of one brick's cells. [any thread]
    const FeatureList& features(glm::ivec3 brick) const;
    /// The rows of one brick. [any thread]
    const SolidRows& rows(glm::ivec3 brick) const;

    /// Takes over a change of the shape's voxels in these bricks; its size must be the same. The cost is that of these
    /// bricks and of copying the directory.
    void update(const Shape& shape, const std::vector<glm::ivec3>& bricks, const MaterialTable& materials);

private:
    struct NodeSurface {
        mutable std::array<Lazy<FeatureList>, 64> features;
        mutable std::array<Lazy<SolidRows>, 64> rows;
    };
    const NodeSurface& node(glm::ivec3 brick) const;
    /// bricks: those that changed; null: all.
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
    CollisionShape m_kind;
    std::optional<RoundSurface> m_round;
    CellBox m_bounds;
    bool m_hasUnphysical = false;  ///< the shape has voxels that are not in m_grid
    std::shared_ptr<const ContactMaterials> m_contactMaterials;
    std::unique_ptr<Lazy<NodeSurface>[]> m_nodes;  ///< by directory node
    mutable Lazy<PartSurface> m_whole;
    mutable Lazy<HullPoints> m_hull;
};

/// The bricks of a shape that changed in this step; replaces `out`.
void changedBricks(const FrameChanges& changes, ShapeHandle shape, std::vector<glm::ivec3>& out);

/// The shapes that move as one: all of a dynamic body, or one of a static body.
struct VoxelCollider {
    std::vector<std::unique_ptr<ColliderPart>> parts;

    /// Whether no part has a solid cell.
    bool empty() const;
    /// The box that holds all parts, in the collider's frame, metres.
    void bounds(glm::dvec3& low, glm::dvec3& high) const;
    /// The largest distance of a part's bounds from the frame's origin, metres.
    double radius() const;
    /// The side of the smallest voxels of its parts, metres.
    double smallestVoxel() const;
};

}  // namespace rubble
