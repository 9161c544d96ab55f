#include "runtime/world/stages/region_edits.h"

#include <utility>

#include "runtime/core/log.h"

namespace rubble {
void apply(EditContext& context, const SetCollisionFilterEdit& edit) {
    Shape* shape = context.world.shapes.find(edit.shape);
    if (!shape) return context.warnStale("set_collision_filter: the handle of its shape is stale; nothing was changed");
    shape->collisionLayer = edit.layer;
    shape->collisionMask = edit.mask;
    context.changes.filters.push_back(edit.shape);
    if (!context.isNew(shape->body)) context.wakeBody(shape->body);  // a body that is made asleep stays so
}

void apply(EditContext& context, const SetCollisionShapeEdit& edit) {
    Shape* shape = context.world.shapes.find(edit.shape);
    if (!shape) return context.warnStale("set_collision_shape: the handle of its shape is stale; nothing was changed");
    shape->collisionShape = edit.kind;
    context.changes.filters.push_back(edit.shape);
    if (!context.isNew(shape->body)) context.wakeBody(shape->body);  // a body that is made asleep stays so
}

void apply(EditContext& context, const AddWaterEdit& edit) {
    context.changes.waters.push_back(context.make(context.world.waters, edit.water));
}

void apply(EditContext& context, const RemoveWaterEdit& edit) {
    if (!context.world.waters.erase(edit.water))
        return context.warnStale("remove_water: the handle of its water is stale; nothing was removed");
    context.changes.waters.push_back(edit.water);
}

void apply(EditContext& context, const AddTriggerEdit& edit) {
    Trigger trigger = edit.trigger;
    trigger.inside.clear();
    const TriggerHandle handle = context.make(context.world.triggers, std::move(trigger));
    context.world.triggerBounds.update(handle.slot(), edit.trigger.bounds());
    context.changes.triggers.push_back(handle);
}

void apply(EditContext& context, const RemoveTriggerEdit& edit) {
    const Trigger* const trigger = context.world.triggers.find(edit.trigger);
    if (!trigger) return context.warnStale("remove_trigger: the handle of its trigger is stale; nothing was removed");
    for (const BodyHandle body : trigger->inside) context.changes.triggerEvents.push_back({edit.trigger, body, false});
    context.world.triggers.erase(edit.trigger);
    context.world.triggerBounds.remove(edit.trigger.slot());
    context.changes.triggers.push_back(edit.trigger);
}

}  // namespace rubble
