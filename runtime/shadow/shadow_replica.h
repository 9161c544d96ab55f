#pragma once
#include <array>
#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

#include "runtime/core/index_allocator.h"
#include "runtime/shadow/rasterize.h"
#include "runtime/shadow/shadow_cell_transform.h"
#include "runtime/shadow/shadow_step.h"
#include "runtime/shadow/shadow_volume.h"
#include "runtime/shadow/shape_raster.h"

namespace rubble {

/// The shadow worker's copy of all shapes, and the shadow volume of them. When a shape in a brick of the volume
/// changes, the brick is built again from all shapes that overlap it, so that the volume always equals a full rebuild.
/// Owned by one thread.
class ShadowReplica {
public:
    /// Asked between two pieces of work: a shape, a brick.
    using MustStop = std::function<bool()>;
    /// Voxels of palette entries below this opacity cast no shadow.
    static constexpr uint8_t kMinOpacity = 128;

    /// Applies a step to the copy. Returns early when `mustStop` says so; then the replica can only be destroyed.
    void apply(ShadowStep&& step, const MustStop& mustStop);
    /// Rebuilds the touched bricks and lists those that differ from what the last call published. False if stopped.
    bool update(ShadowPatches& out, const MustStop& mustStop);

private:
    static constexpr uint32_t kNone = ~0u;
    /// A shape in a brick, and the next one of the list.
    struct Member {
        uint32_t slot, next;
    };
    /// Which palette entries cast a shadow.
    using OpaqueEntries = std::array<bool, 256>;
    /// One brick of the volume, and the shapes in it.
    struct BrickState {
        uint32_t resting = kNone, moving = kNone;  ///< lists of shapes: the first of each in m_members
        ShadowBrickRef published;
        ShadowBrickRef rest;         ///< of the resting shapes alone, kept while other shapes move through
        bool isRestCurrent = false;  ///< `rest` is up to date
        bool isTransient = false;    ///< `published` was made with moving shapes: see makeShadowBrick()
        bool touched = false;
    };
    struct BrickHash {
        size_t operator()(glm::ivec3 brick) const;
    };
    using BrickMap = std::unordered_map<glm::ivec3, BrickState, BrickHash>;
    using BrickEntry = BrickMap::value_type;  ///< its address is stable until it is erased
    struct Shape {
        ShapeHandle handle;
        VoxelGrid grid;
        VoxelGrid opaque;  ///< the grid without its translucent voxels, if it has any
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
        double tiles = -1.0;  ///< surfaceTiles() of a shape of large voxels; negative: not known
        bool isLargeLogged = false;
        bool isQueued = false;             ///< the next update() places it
        bool keepsCells = false;           ///< then the bricks that it stays in have the same cells, if not touched
        std::vector<BrickEntry*> covered;  ///< the bricks whose lists it is in, in the order of isBefore
        /// The voxels that cast a shadow: all of them, or the opaque ones.
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
    static uint32_t& listOf(const Shape& shape, BrickEntry& entry) {
        return shape.moving ? entry.second.moving : entry.second.resting;
    }
    void leaveAll(Shape& shape);
    void touch(const Shape& shape, BrickEntry& entry);
    void touchVoxelBrick(Shape& shape, glm::ivec3 voxelBrick);
    void touchSurface(Shape& shape, glm::ivec3 voxelBrick);
    void rasterizeMoving(Shape& shape);
    void keepNextRaster(Shape& shape);
    void dropRaster(Shape& shape);
    void listSurface(Shape& shape);
    ShadowBrickRef buildResting(const BrickState& state, glm::ivec3 brick) const;
    ShadowWords cellsOf(const BrickState& state, glm::ivec3 brick) const;
    ShadowBrickRef currentContent(BrickState& state, glm::ivec3 brick) const;
    void rebuildBrick(BrickEntry& entry, ShadowPatches& out);

    static constexpr size_t kSpareBricks = 4096;  ///< 2.4 MB: what moves replaces hundreds in a step
    static constexpr size_t kSpareRasters = 256;  ///< 1 MB: in a collapse dozens of shapes rest or break in a step

    std::vector<std::unique_ptr<Shape>> m_shapes;  ///< by slot
    std::shared_ptr<BlockPool> m_pool;             ///< of the bricks it makes; null until there is a shape
    BrickMap m_brickStates;
    std::vector<Member> m_members;
    IndexAllocator m_memberSlots;
    std::vector<BrickMap::node_type> m_spares;  ///< of bricks that are empty again, for those to come
    std::vector<ShapeHandle> m_waiting;         ///< shapes to place: once per update, however many steps it includes
    std::vector<BrickEntry*> m_touched;         ///< bricks to be rebuilt
    std::vector<glm::ivec3> m_bricks;           ///< scratch of place()
    std::vector<BrickEntry*> m_nextCovered;     ///< scratch of place()
    ShapeRaster m_nextRaster;                   ///< scratch of place()
    std::vector<ShapeRaster> m_spareRasters;    ///< of shapes that move no more: memory for those to come
    bool m_isFarLogged = false;
};

}  // namespace rubble
