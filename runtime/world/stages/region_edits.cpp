#include "runtime/world/stages/region_edits.h"

#include <algorithm>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/core/number_range.h"

namespace rubble {
namespace {

constexpr double kMaxCoordinate = 1e9;  ///< metres

bool isSane(const GroundPolygon& area) {
    return area.size() >= 3 && std::all_of(area.begin(), area.end(), [](const GroundPoint& p) {
               return isWithin({p.x, 0.0, p.z}, kMaxCoordinate);
           });
}

bool isSane(const Water& water) {
    return isSane(water.outline) && isWithin(water.surface, -kMaxCoordinate, kMaxCoordinate) &&
           isWithin(water.depth, 1e-6, 1e6) && isWithin(water.density, 0.0, 1e6) &&
           isWithin(water.linearDrag, 0.0, 1e6) && isWithin(water.angularDrag, 0.0, 1e6) &&
           isWithin(water.flow, kMaxCoordinate);
}

bool isSane(const Trigger& trigger) {
    const glm::dquat& q = trigger.pose.rotation;
    if (!isWithin(trigger.pose.position, kMaxCoordinate) ||
        !isWithin(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 0.999, 1.001))
        return false;
    if (trigger.kind == TriggerKind::Sphere) return isWithin(trigger.radius, 1e-6, 1e6);
    if (trigger.kind == TriggerKind::Polygon) return isSane(trigger.outline) && isWithin(trigger.height, 1e-6, 1e6);
    const glm::dvec3& h = trigger.halfSize;
    return isWithin(h.x, 1e-6, 1e6) && isWithin(h.y, 1e-6, 1e6) && isWithin(h.z, 1e-6, 1e6);
}

}  // namespace

void apply(EditContext& context, const SetCollisionFilterEdit& edit) {
    Shape* shape = context.world.shapes.find(edit.shape);
    if (!shape) return logWarning("set_collision_filter: the handle of its shape is stale; nothing was changed");
    shape->collisionLayer = edit.layer;
    shape->collisionMask = edit.mask;
    context.changes.filters.push_back(edit.shape);
    context.wakeBody(shape->body);
}

void apply(EditContext& context, const AddWaterEdit& edit) {
    if (!isSane(edit.water))
        return logWarning(
            "add_water: expected an outline of three points or more, a depth above zero and finite numbers; no "
            "water was made");
    context.changes.waters.push_back(context.world.waters.insert(edit.water));
}

void apply(EditContext& context, const RemoveWaterEdit& edit) {
    if (!context.world.waters.erase(edit.water))
        return logWarning("remove_water: the handle of its water is stale; nothing was removed");
    context.changes.waters.push_back(edit.water);
}

void apply(EditContext& context, const AddTriggerEdit& edit) {
    if (!isSane(edit.trigger))
        return logWarning("add_trigger: expected a size above zero and finite numbers; no trigger was made");
    Trigger trigger = edit.trigger;
    trigger.inside.clear();
    const TriggerHandle handle = context.world.triggers.insert(std::move(trigger));
    context.world.triggerBounds.update(handle.slot(), edit.trigger.bounds());
    context.changes.triggers.push_back(handle);
}

void apply(EditContext& context, const RemoveTriggerEdit& edit) {
    if (!context.world.triggers.erase(edit.trigger))
        return logWarning("remove_trigger: the handle of its trigger is stale; nothing was removed");
    context.world.triggerBounds.remove(edit.trigger.slot());
    context.changes.triggers.push_back(edit.trigger);
}

}  // namespace rubble
