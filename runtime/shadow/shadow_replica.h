#pragma once
#include <array>
#include <atomic>
#include <memory>
#include <unordered_map>
#include <vector>

#include "runtime/shadow/rasterize.h"
#include "runtime/shadow/shadow_cell_transform.h"
#include "runtime/shadow/shadow_step.h"
#include "runtime/shadow/shadow_volume.h"
#include "runtime/shadow/shape_raster.h"

namespace rubble {

/// The shadow worker's own copy of all shapes, and the volume made from them. A brick of the volume that anything
/// touches is rebuilt from all shapes that overlap it, so the volume always equals one built from nothing. Owned by
/// one thread.
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
    /// One brick of the volume, and who is in it.
    struct BrickState {
        std::vector<uint32_t> resting, moving;  ///< slots of shapes
        ShadowBrickRef published;
        ShadowBrickRef rest;         ///< of the resting shapes alone, kept while others move through
        bool isRestCurrent = false;  ///< false: `rest` is not of the shapes as they are
        bool isTransient = false;    ///< how it was published
        bool touched = false;
    };
    struct BrickHash {
        size_t operator()(glm::ivec3 brick) const;
    };
    using BrickMap = std::unordered_map<glm::ivec3, BrickState, BrickHash>;
    using BrickEntry = BrickMap::value_type;  ///< stays where it is until it is erased
    struct Shape {
        ShapeHandle handle;
        VoxelGrid grid;
        VoxelGrid opaque;  ///< the grid without its translucent voxels; unused if it has none
        bool hasTranslucent = false;
        OpaqueEntries entries{};
        double voxelSize = 0.1;
        Pose pose;
        ShadowCellTransform cellTransform;
        CellBox bounds;       ///< in shadow cells
        RasterSource source;  ///< of a small shape that has moved
        ShapeRaster raster;   ///< of a small shape that moves
        bool placed = false;  ///< false if its pose is unusable
        bool moving = false;
        bool isQueued = false;             ///< to be placed by the next update
        std::vector<BrickEntry*> covered;  ///< the bricks whose lists it is in, in the order of isBefore
        /// What casts shadows: all voxels, or the opaque ones where some are translucent.
        const VoxelGrid& casterGrid() const { return hasTranslucent ? opaque : grid; }
    };
    Shape* find(ShapeHandle handle);
    void create(ShadowStep::NewShape&& from);
    void destroy(ShapeHandle handle);
    void setBrick(Shape& shape, const BrickChange& change);
    void setPalette(Shape& shape, const Palette& palette);
    void setPose(Shape& shape, const Pose& pose, bool asleep);
    void queuePlacement(Shape& shape);
    void place(Shape& shape);
    BrickEntry* enter(const Shape& shape, glm::ivec3 brick);
    void leave(const Shape& shape, BrickEntry& entry);
    void leaveAll(Shape& shape);
    void touch(const Shape& shape, BrickEntry& entry);
    void touchVoxelBrick(Shape& shape, glm::ivec3 voxelBrick);
    void rasterizeMoving(Shape& shape);
    ShadowBrickRef buildResting(const BrickState& place, glm::ivec3 brick) const;
    ShadowWords cellsOf(const BrickState& place, glm::ivec3 brick) const;
    ShadowBrickRef currentContent(BrickState& place, glm::ivec3 brick) const;
    void rebuildBrick(BrickEntry& entry, ShadowPatches& out);

    std::vector<std::unique_ptr<Shape>> m_shapes;  ///< by slot
    BrickMap m_brickStates;
    std::vector<ShapeHandle> m_waiting;      ///< shapes to be placed: once an update, however many steps it shows
    std::vector<BrickEntry*> m_touched;      ///< bricks to be rebuilt
    std::vector<glm::ivec3> m_bricks;        ///< scratch of place()
    std::vector<BrickEntry*> m_nextCovered;  ///< scratch of place()
    ShapeRaster m_nextRaster;                ///< scratch of place()
};

}  // namespace rubble
