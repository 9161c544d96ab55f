#include <algorithm>
#include <cmath>

#include "runtime/core/log.h"
#include "runtime/core/number_range.h"
#include "runtime/world/stages/edit_step.h"

namespace rubble {
namespace {

constexpr uint32_t kWetSeconds = 20;  ///< that what was under water stays wet

constexpr double kMaxCoordinate = 1e9;  // metres

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

void EditStep::apply(const SetCollisionEdit& edit) {
    Shape* shape = m_world.m_shapes.find(edit.shape);
    if (!shape) return logWarning("SetCollisionEdit: the handle of its shape is stale; nothing was changed");
    shape->collisionLayer = edit.layer;
    shape->collisionMask = edit.mask;
    m_changes.filters.push_back(edit.shape);
    wake(shape->body);
}

void EditStep::apply(const AddWaterEdit& edit) {
    if (!isSane(edit.water))
        return logWarning(
            "AddWaterEdit: expected an outline of three points or more, a depth above zero and finite numbers; no "
            "water was made");
    m_changes.waters.push_back(m_world.m_waters.insert(edit.water));
}

void EditStep::apply(const RemoveWaterEdit& edit) {
    if (!m_world.m_waters.erase(edit.water))
        return logWarning("RemoveWaterEdit: the handle of its water is stale; nothing was removed");
    m_changes.waters.push_back(edit.water);
}

/// What is under water goes out and gets wet.
void EditStep::extinguishUnderWater() {
    for (HeatField& field : m_world.m_fire.fields)
        for (HotBrick& hot : field.bricks) {
            if (!m_world.m_shapes.find(field.shape)) continue;
            const glm::dvec3 at = brickInWorld(field.shape, hot.brick);
            m_world.m_waters.forEach([&](WaterHandle, const Water& water) {
                if (water.contains(at)) extinguishBrick(field.shape, hot, kWetSeconds * kHeatUpdatesPerSecond);
            });
        }
}

void EditStep::apply(const AddTriggerEdit& edit) {
    if (!isSane(edit.trigger))
        return logWarning("AddTriggerEdit: expected a size above zero and finite numbers; no trigger was made");
    Trigger trigger = edit.trigger;
    trigger.inside.clear();
    const TriggerHandle handle = m_world.m_triggers.insert(std::move(trigger));
    m_world.m_triggerBounds.update(handle.slot(), edit.trigger.bounds());
    m_changes.triggers.push_back(handle);
}

void EditStep::apply(const RemoveTriggerEdit& edit) {
    if (!m_world.m_triggers.erase(edit.trigger))
        return logWarning("RemoveTriggerEdit: the handle of its trigger is stale; nothing was removed");
    m_world.m_triggerBounds.remove(edit.trigger.slot());
    m_changes.triggers.push_back(edit.trigger);
}

}  // namespace rubble
