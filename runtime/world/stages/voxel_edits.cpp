#include "runtime/world/stages/voxel_edits.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/voxel/write_box.h"
#include "runtime/world/stages/entry_counts.h"
#include "runtime/world/stages/light_group_stage.h"
#include "runtime/world/stages/shape_lifecycle.h"
#include "runtime/world/stages/split_stage.h"

namespace rubble {
namespace {

/// What a write changes.
struct WrittenCells {
    EntryCounts lost{};       ///< voxels that were there, by entry
    EntryCounts made{};       ///< voxels that are there now, by entry
    MassMoments before, now;  ///< of those
    CellBox emptied;          ///< around the cells that had a voxel and have none
    BrickSet carved, filled;  ///< bricks with such cells; with cells that got or changed a voxel
};

WrittenCells writeCells(VoxelGrid& grid, const WriteVoxelsEdit& edit, const Densities& densities) {
    WrittenCells out;
    const glm::ivec3 low = brickOfCell(edit.box.low), high = brickOfCell(edit.box.high - 1);
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) {
                const glm::ivec3 brick(x, y, z), corner = brick * kBrickSize;
                BrickWrite write = writtenBrick(grid, brick, edit.box, edit.entries, edit.mask);
                if (!write.any()) continue;
                const BrickBits lost = write.lost(), made = write.made();
                if (write.before) out.before += brickMoments(*write.before, lost, brick, densities);
                if (write.after) {
                    out.now += brickMoments(*write.after, made, brick, densities);
                    addEntries(*write.after, made, out.made);
                }
                if (write.before) addEntries(*write.before, lost, out.lost);
                if (made != BrickBits{}) out.filled.insert(brick);
                if (made != write.changed) {
                    out.carved.insert(brick);
                    out.emptied = joined(
                        out.emptied, {glm::max(edit.box.low, corner), glm::min(edit.box.high, corner + kBrickSize)});
                }
                grid.setBrick(brick, std::move(write.after));
            }
    return out;
}

}  // namespace

void apply(EditContext& context, const WriteVoxelsEdit& edit) {
    releaseFragments(context);  // they came out of the cells as they were
    Shape* shape = context.world.shapes.find(edit.shape);
    if (!shape)
        return context.warnStale(edit.shape, "write_voxels: the handle of its shape is stale; nothing was written");
    if (glm::any(glm::lessThan(edit.box.low, glm::ivec3(0))) ||
        glm::any(glm::greaterThan(edit.box.high, shape->grid.size())))
        return logWarning(
            "write_voxels: expected a box within the shape's grid, found one that is not; nothing was "
            "written. Call resize_shape() first");
    if (!context.isNew(shape->body)) context.recordMotion(shape->body);
    const WrittenCells cells = writeCells(shape->grid, edit, Densities(*shape->palette, context.world.materials));
    shape->moments -= cells.before;
    shape->moments += cells.now;
    context.recordErased(edit.shape, cells.lost);
    countMade(context, *shape->palette, cells.made);
    context.world.imported += cells.now.voxels;
    ShapeEditState& state = context.editState(edit.shape);
    state.carved.insert(cells.carved);
    state.filled.insert(cells.filled);
    state.lost = joined(state.lost, cells.emptied);
    if (!cells.now.voxels) return;
    state.lostVoxels = true;  // what was made may touch nothing: all of the shape is tested
    shape->knownConnected = false;
    if (!context.isNew(shape->body)) context.wakeBody(shape->body);
}

void apply(EditContext& context, const DestroyShapeEdit& edit) {
    if (!context.world.shapes.find(edit.shape))
        return context.warnStale(edit.shape, "destroy_shape: the handle of its shape is stale; nothing was destroyed");
    releaseFragments(context);
    context.recordMotion(context.world.shapes.at(edit.shape).body);
    eraseShape(context, edit.shape);
}

}  // namespace rubble
