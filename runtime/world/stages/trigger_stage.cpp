#include "runtime/world/stages/trigger_stage.h"

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <set>
#include <utility>

#include "runtime/world/objects/transforms.h"
#include "runtime/world/queries/query.h"

namespace rubble {
namespace {

/// The box around the grids of all shapes of a body.
WorldBox bodyGridBounds(const WorldData& world, const Body& body) {
    WorldBox bounds{glm::dvec3(1e300), glm::dvec3(-1e300)};
    for (const ShapeHandle handle : body.shapes) bounds = bounds.merged(gridBounds(world, handle));
    return bounds;
}

/// Whether the centre of a voxel of a body lies above the trigger's polygon, within its height.
bool containsVoxelCenter(const WorldData& world, const Body& body, const Trigger& trigger) {
    const WorldBox bounds = trigger.bounds();
    for (const ShapeHandle handle : body.shapes) {
        const Shape& shape = world.shapes.at(handle);
        if (!(shape.collisionLayer & trigger.layerMask)) continue;
        const Pose pose = shapeToWorld(world, handle);
        const glm::dmat3 axes = glm::mat3_cast(pose.rotation) * double(shape.voxelSize);
        const glm::dvec3 halfExtent = (glm::abs(axes[0]) + glm::abs(axes[1]) + glm::abs(axes[2])) * (0.5 * kBrickSize);
        bool found = false;
        shape.grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            const glm::dvec3 middle = pose.position + axes * (glm::dvec3(position * kBrickSize) + 0.5 * kBrickSize);
            if (found || !WorldBox{middle - halfExtent, middle + halfExtent}.overlaps(bounds)) return;
            forEachVoxel(brick->occupancy, [&](int i) {
                if (found) return;
                const glm::dvec3 at = pose.position +
                                      axes * (glm::dvec3(position * kBrickSize + voxelInBrick(i)) + 0.5) -
                                      trigger.pose.position;
                found = at.y >= 0.0 && at.y <= trigger.height && contains(trigger.outline, at.x, at.z);
            });
        });
        if (found) return true;
    }
    return false;
}

bool isInside(const WorldData& world, BodyHandle handle, const Trigger& trigger) {
    const Body* body = world.bodies.find(handle);
    if (!body || body->isStatic) return false;
    if (trigger.kind == TriggerKind::Polygon) return containsVoxelCenter(world, *body, trigger);
    const QueryShape region{.kind = trigger.kind == TriggerKind::Sphere ? QueryShapeKind::Sphere : QueryShapeKind::Box,
                            .position = trigger.pose.position,
                            .radius = trigger.radius,
                            .halfSize = trigger.halfSize,
                            .rotation = trigger.pose.rotation};
    return overlapsBody(world, handle, region, {.layerMask = trigger.layerMask});
}

template <class Handle>
bool bySlot(Handle a, Handle b) {
    return a.slot() < b.slot();
}

/// Bodies that physics has moved since the last step or this step has changed, in slot order.
std::vector<BodyHandle> takeMovedBodies(EditContext& context) {
    std::vector<BodyHandle> bodies = std::exchange(context.world.movedBodies, {});
    for (const auto* list : {&context.changes.bodiesCreated, &context.changes.bodiesDestroyed,
                             &context.changes.teleported, &context.changes.lostShapes})
        bodies.insert(bodies.end(), list->begin(), list->end());
    for (const auto* list : {&context.changes.carved, &context.changes.shapesCreated, &context.changes.filters})
        for (const ShapeHandle handle : *list)
            if (const Shape* shape = context.world.shapes.find(handle)) bodies.push_back(shape->body);
    for (const ShapeSplit& split : context.changes.splits)
        if (const Shape* shape = context.world.shapes.find(split.parent)) bodies.push_back(shape->body);
    std::sort(bodies.begin(), bodies.end(), [](BodyHandle a, BodyHandle b) { return a < b; });
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    return bodies;
}

/// Pairs of a trigger and a body for which being inside may have changed.
std::set<std::pair<TriggerHandle, BodyHandle>> findPairs(EditContext& context) {
    const std::vector<BodyHandle> moved = takeMovedBodies(context);
    std::set<std::pair<TriggerHandle, BodyHandle>> pairs;  // of one world, so ordered by slot
    for (const BodyHandle handle : moved) {
        const Body* body = context.world.bodies.find(handle);
        if (!body || body->isStatic) continue;
        const WorldBox bounds = bodyGridBounds(context.world, *body);
        context.world.triggerBounds.find(
            [&](const WorldBox& box) { return box.overlaps(bounds); },
            [&](uint32_t slot) { pairs.emplace(context.world.triggers.handleAt(slot), handle); });
    }
    context.world.triggers.forEach([&](TriggerHandle handle, const Trigger& trigger) {
        for (const BodyHandle body : trigger.inside)
            if (std::binary_search(moved.begin(), moved.end(), body)) pairs.emplace(handle, body);
    });
    for (const TriggerHandle handle : context.changes.triggers)
        if (const Trigger* trigger = context.world.triggers.find(handle))
            for (const BodyHandle body : bodiesInBox(context.world, trigger->bounds(), {.rejectStatic = true}))
                pairs.emplace(handle, body);
    return pairs;
}

}  // namespace

void updateTriggers(EditContext& context) {
    for (const auto& [handle, body] : findPairs(context)) {
        Trigger& trigger = context.world.triggers.at(handle);
        const bool is = isInside(context.world, body, trigger);
        const auto at = std::find(trigger.inside.begin(), trigger.inside.end(), body);
        if (is == (at != trigger.inside.end())) continue;
        if (is)
            trigger.inside.insert(
                std::upper_bound(trigger.inside.begin(), trigger.inside.end(), body, bySlot<BodyHandle>), body);
        else
            trigger.inside.erase(at);
        context.changes.triggerEvents.push_back({handle, body, is});
        if (std::find(context.changes.triggers.begin(), context.changes.triggers.end(), handle) ==
            context.changes.triggers.end())
            context.changes.triggers.push_back(handle);
    }
    std::stable_sort(context.changes.triggerEvents.begin(), context.changes.triggerEvents.end(),
                     [](const TriggerEvent& a, const TriggerEvent& b) {
                         return a.trigger.slot() != b.trigger.slot() ? a.trigger.slot() < b.trigger.slot()
                                                                     : a.body.slot() < b.body.slot();
                     });
}

}  // namespace rubble
