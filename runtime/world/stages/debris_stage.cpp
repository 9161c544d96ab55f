#include "runtime/world/stages/debris_stage.h"

#include <algorithm>
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

/// Removes from both lists what was created and destroyed in the same step; what an undo brought back stays.
template <class Handle, class Map>
void removeTransient(std::vector<Handle>& created, std::vector<Handle>& destroyed, const Map& alive) {
    const auto isAlive = [&](Handle handle) { return alive.find(handle) != nullptr; };
    std::vector<Handle> deadCreated = created, deadDestroyed = destroyed;
    std::erase_if(deadCreated, isAlive);
    std::sort(deadCreated.begin(), deadCreated.end());
    std::erase_if(deadDestroyed, isAlive);
    std::sort(deadDestroyed.begin(), deadDestroyed.end());
    std::erase_if(destroyed,
                  [&](Handle handle) { return std::binary_search(deadCreated.begin(), deadCreated.end(), handle); });
    std::erase_if(
        created, [&](Handle handle) { return std::binary_search(deadDestroyed.begin(), deadDestroyed.end(), handle); });
}

/// Removes pieces that were made and despawned in this step from the journal.
void dropTransient(EditContext& context) {
    removeTransient(context.changes.bodiesCreated, context.changes.bodiesDestroyed, context.world.bodies);
    removeTransient(context.changes.shapesCreated, context.changes.shapesDestroyed, context.world.shapes);
    std::erase_if(context.changes.impulses,
                  [&](const ImpulseApplied& each) { return !context.world.bodies.find(each.body); });
    for (std::vector<BodyHandle>* list : {&context.changes.settled, &context.changes.unsettled})
        std::erase_if(*list, [&](BodyHandle body) { return !context.world.bodies.find(body); });
    std::erase_if(context.changes.unanchored, [&](ShapeHandle shape) { return !context.world.shapes.find(shape); });
    for (ShapeSplit& split : context.changes.splits) {
        size_t kept = 0;
        for (size_t i = 0; i < split.children.size(); ++i) {
            if (!context.world.shapes.find(split.children[i])) continue;
            split.children[kept] = split.children[i];
            split.parentOffset[kept] = split.parentOffset[i];
            split.motions[kept++] = split.motions[i];
        }
        split.children.resize(kept);
        split.parentOffset.resize(kept);
        split.motions.resize(kept);
    }
    std::erase_if(context.changes.splits, [](const ShapeSplit& split) { return split.children.empty(); });
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
    const size_t before = context.changes.bodiesDestroyed.size();
    while (debris.awakeCount() > settings.awakeBodies) despawn(context, debris.firstAwake());
    while (debris.count() > settings.bodies || debris.voxels() > settings.voxels) despawn(context, debris.first());
    if (context.changes.bodiesDestroyed.size() > before) dropTransient(context);
}

}  // namespace rubble
