#pragma once
#include <array>
#include <atomic>
#include <memory>
#include <unordered_map>
#include <vector>

#include "runtime/shadow/rasterize.h"
#include "runtime/shadow/shadow_lattice.h"
#include "runtime/shadow/shadow_step.h"
#include "runtime/shadow/shadow_volume.h"

namespace rubble {

/// The shadow worker's own copy of all shapes, and the volume made from them. A brick of the volume that anything touches is
/// made anew from all shapes that overlap it, so the volume always equals one built from nothing. Owned by one thread.
class ShadowReplica {
public:
    /// Voxels whose palette entry is less opaque let light through: they are left out of the volume.
    static constexpr uint8_t kMinOpacity = 128;

    /// Stops early, leaving the replica fit only for destruction, when `stop` becomes true.
    void apply(ShadowStep&& step, const std::atomic<bool>& stop);
    /// Makes the touched bricks and lists those that differ from what the last call left. False if stopped.
    bool update(ShadowPatches& out, const std::atomic<bool>& stop);

private:
    /// Which palette entries cast a shadow.
    using OpaqueEntries = std::array<bool, 256>;
    struct Shape {
        ShapeHandle handle;
        VoxelGrid grid;
        VoxelGrid opaque;  ///< the grid without its translucent voxels; unused if it has none
        bool hasTranslucent = false;
        OpaqueEntries entries{};
        double voxelSize = 0.1;
        Pose pose;
        ShadowLattice lattice;
        CellBox bounds;       ///< in shadow cells
        ShapeRaster raster;   ///< of a moving shape; made when it is first needed
        bool placed = false;  ///< false if its pose is unusable
        bool moving = false;
        std::vector<glm::ivec3> covered;  ///< the bricks whose lists it is in
        const VoxelGrid& casting() const { return hasTranslucent ? opaque : grid; }
    };
    /// One brick of the volume, and who is in it.
    struct Place {
        std::vector<uint32_t> resting, moving;  ///< slots of shapes
        std::unique_ptr<CellRows> rest;         ///< the resting shapes' cells, kept while others move through
        ShadowBrickRef published;
        bool touched = false;
    };
    struct PlaceHash {
        size_t operator()(glm::ivec3 brick) const;
    };
    Shape* find(ShapeHandle handle);
    void create(ShadowStep::NewShape&& from);
    void destroy(ShapeHandle handle);
    void setBrick(Shape& shape, const BrickChange& change);
    void setPalette(Shape& shape, const Palette& palette);
    void setPose(Shape& shape, const Pose& pose, bool asleep);
    void insert(Shape& shape);
    void remove(Shape& shape);
    void cover(Shape& shape, glm::ivec3 brick);
    std::vector<glm::ivec3> bricksOf(const Shape& shape) const;
    void touch(glm::ivec3 brick, Place& place);
    void touchVoxels(Shape& shape, glm::ivec3 voxelBrick);
    void fill(Place& place, glm::ivec3 brick, CellRows& rows) const;
    void fillFrom(const std::vector<uint32_t>& slots, glm::ivec3 brick, CellRows& rows) const;

    std::vector<std::unique_ptr<Shape>> m_shapes;  ///< by slot
    std::unordered_map<glm::ivec3, Place, PlaceHash> m_places;
    std::vector<glm::ivec3> m_touched;
};

}  // namespace rubble
