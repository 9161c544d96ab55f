#include "runtime/world/stages/debris_stage.h"

#include "runtime/world/stages/shape_lifecycle.h"

namespace rubble {

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
