#include "runtime/world/stages/voxel_edits.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <vector>

#include "runtime/core/log.h"
#include "runtime/voxel/read_box.h"
#include "runtime/world/stages/entry_counts.h"
#include "runtime/world/stages/shape_lifecycle.h"
#include "runtime/world/stages/split_stage.h"

namespace rubble {
namespace {

/// What a write changes.
struct WrittenCells {
    EntryCounts lost{};       ///< voxels that were there, by entry
    uint64_t made = 0;        ///< voxels that are there now
    MassMoments before, now;  ///< of those
    CellBox emptied;          ///< around cells that had a voxel and have none
    BrickSet carved, filled;  ///< bricks with such cells; with cells that got or changed a voxel
};

/// Cells whose entry stays keep their paint.
WrittenCells writeCells(VoxelGrid& grid, const WriteVoxelsEdit& edit, const Densities& densities) {
    WrittenCells out;
    std::vector<uint8_t> present(edit.entries.size());
    readBox(grid, edit.box, CellByte::Index, present);
    GridWriter writer(grid);
    size_t next = 0;
    for (int z = edit.box.low.z; z < edit.box.high.z; ++z)
        for (int y = edit.box.low.y; y < edit.box.high.y; ++y)
            for (int x = edit.box.low.x; x < edit.box.high.x; ++x) {
                const glm::ivec3 cell(x, y, z);
                const uint8_t was = present[next], is = edit.entries[next];
                ++next;
                if (was == is) continue;
                writer.set(cell, is);
                (is ? out.filled : out.carved).insert(brickOfCell(cell));
                if (was) ++out.lost[was], out.before.add(cell, densities.byEntry[was]);
                if (is) ++out.made, out.now.add(cell, densities.byEntry[is]);
                if (!is) out.emptied = joined(out.emptied, {cell, cell + 1});
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
    context.world.imported += cells.made;
    ShapeEditState& state = context.editState(edit.shape);
    state.carved.insert(cells.carved);
    state.filled.insert(cells.filled);
    state.lost = joined(state.lost, cells.emptied);
    if (!cells.made) return;
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
