#include "runtime/world/stages/reframe_shape.h"

#include <glm/common.hpp>
#include <string>

#include "runtime/core/log.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/stages/entry_counts.h"
#include "runtime/world/stages/heat_moves.h"
#include "runtime/world/stages/joint_stage.h"
#include "runtime/world/stages/light_group_stage.h"
#include "runtime/world/stages/shape_lifecycle.h"

namespace rubble {

bool reframeShape(EditContext& context, ShapeHandle handle, const CellBox& box) {
    Shape& shape = context.world.shapes.at(handle);
    const auto fits = [](int low, int high) {
        return low >= -kMaxGridSize && high <= 2 * kMaxGridSize && low < high && high - low <= kMaxGridSize;
    };
    if (!fits(box.low.x, box.high.x) || !fits(box.low.y, box.high.y) || !fits(box.low.z, box.high.z)) {
        logWarning("a shape's grid: expected 1 to " + std::to_string(kMaxGridSize) +
                   " cells on each side, not far from where it is now, found a box of another size; nothing was done");
        return false;
    }
    if (box == CellBox{glm::ivec3(0), shape.grid.size()}) return true;
    context.recordMotion(shape.body);
    EntryCounts removed = countEntries(shape.grid);
    shape.grid = cropped(shape.grid, box);
    const EntryCounts kept = countEntries(shape.grid);
    bool isLess = false;
    for (size_t i = 0; i < 256; ++i) removed[i] -= kept[i], isLess = isLess || removed[i];
    shape.local = shape.local * Pose{glm::dvec3(box.low) * double(shape.voxelSize)};
    shape.anchors = translatedBoxes(shape.anchors, box.low, shape.grid.size());
    shape.moments = gridMoments(shape.grid, *shape.palette, context.world.materials);
    shape.knownConnected = shape.knownConnected && !isLess;
    context.world.lights.forEach([&](LightHandle light, Light& attached) {
        if (attached.shape != handle) return;
        attached.local.position -= glm::dvec3(box.low) * double(shape.voxelSize);
        context.changes.lights.push_back(light);
    });
    reframeJoints(context, handle, box.low);
    moveSupplies(context, handle, handle, -box.low);
    if (isLess)
        context.recordRemoved(handle, removed, {shapeToWorld(context.world, handle).transformPoint({}), 0.0, {}});
    for (PendingSplit& pending : context.world.pendingSplits)  // their cuts are in the old cells
        if (pending.shape == handle) pending.cut.clear(), pending.search.reset(), shape.knownConnected = false;
    dropHeat(context, handle);
    if (shape.grid.empty()) {
        context.editStates.erase(handle.slot());
        destroyShape(context, handle);
        return false;
    }
    ShapeEditState& each = context.editState(handle);
    const bool isBroken = isLess || each.isBroken(), lostVoxels = isBroken || each.lostVoxels;
    if (lostVoxels) shape.knownConnected = false;
    each = {.shape = handle, .lostVoxels = lostVoxels, .brokeBefore = isBroken};
    context.world.updateShapeBounds(handle);
    context.world.updateDebris(shape.body);
    context.changes.shapesDestroyed.push_back(handle);
    context.changes.shapesCreated.push_back(handle);
    return true;
}

}  // namespace rubble
