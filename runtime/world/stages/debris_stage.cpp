#include "runtime/world/stages/debris_stage.h"

#include <vector>

#include "runtime/world/objects/transforms.h"
#include "runtime/world/stages/entry_counts.h"
#include "runtime/world/stages/shape_lifecycle.h"

namespace rubble {
namespace {

void despawn(EditContext& context, BodyHandle handle) {
    const Body& body = context.world.bodies.at(handle);
    const ShapeHandle shapeHandle = body.shapes.front();
    const Shape& shape = context.world.shapes.at(shapeHandle);
    const glm::dvec3 half = glm::dvec3(shape.grid.size()) * (0.5 * shape.voxelSize);
    context.recordRemoved(
        shapeHandle, countEntries(shape.grid),
        {shapeToWorld(context.world, shapeHandle).transformPoint(half), glm::length(half), body.velocity});
    destroyShape(context, shapeHandle);
}

}  // namespace

void enforceDebrisBudgets(EditContext& context) {
    const DebrisSettings& settings = context.world.settings.debris;
    for (auto& [slot, each] : context.editStates)
        if (const Shape* shape = context.world.shapes.find(each.shape); shape && !each.carved.empty())
            context.wakeBody(shape->body);
    const DebrisQueue& debris = context.world.debris;
    const uint64_t step = context.changes.step;
    while (step >= settings.settleSteps) {
        const std::optional<BodyHandle> body = debris.asleepSince(step - settings.settleSteps);
        if (!body) break;
        context.world.bodies.at(*body).settled = true;
        context.world.updateDebris(*body);
        context.changes.settled.push_back(*body);
    }
    while (debris.awakeCount() > settings.awakeBodies) despawn(context, debris.firstAwake());
    while (debris.count() > settings.bodies || debris.voxels() > settings.voxels) despawn(context, debris.first());
}

}  // namespace rubble
