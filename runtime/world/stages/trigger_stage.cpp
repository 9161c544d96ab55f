#include <algorithm>
#include <glm/mat3x3.hpp>
#include <set>

#include "runtime/world/stages/edit_step.h"
#include "runtime/world/queries/query.h"

namespace rubble {
namespace {

/// Of the grids of a body's shapes.
WorldBox gridBounds(const World& world, const Body& body) {
    WorldBox bounds{glm::dvec3(1e300), glm::dvec3(-1e300)};
    for (const ShapeHandle handle : body.shapes) {
        const Shape& shape = world.shapes().at(handle);
        const Pose pose = world.shapeToWorld(handle);
        const glm::dvec3 half = glm::dvec3(shape.grid.size()) * (0.5 * shape.voxelSize);
        bounds = bounds.merged(QueryShape{.kind = QueryShapeKind::Box,
                                          .position = pose.transformPoint(half),
                                          .halfSize = half,
                                          .rotation = pose.rotation}
                                   .bounds());
    }
    return bounds;
}

/// Whether a voxel of a body has its middle above a polygon, within its height.
bool containsVoxelCenter(const World& world, const Body& body, const Trigger& trigger) {
    const WorldBox bounds = trigger.bounds();
    for (const ShapeHandle handle : body.shapes) {
        const Shape& shape = world.shapes().at(handle);
        if (!(shape.collisionLayer & trigger.layers)) continue;
        const Pose pose = world.shapeToWorld(handle);
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

bool isInside(const World& world, BodyHandle handle, const Trigger& trigger) {
    const Body* body = world.bodies().find(handle);
    if (!body || body->isStatic) return false;
    if (trigger.kind == TriggerKind::Polygon) return containsVoxelCenter(world, *body, trigger);
    const QueryShape region{.kind = trigger.kind == TriggerKind::Sphere ? QueryShapeKind::Sphere : QueryShapeKind::Box,
                            .position = trigger.pose.position,
                            .radius = trigger.radius,
                            .halfSize = trigger.halfSize,
                            .rotation = trigger.pose.rotation};
    return overlapsBody(world, handle, region, {.layers = trigger.layers});
}

template <class Handle>
bool bySlot(Handle a, Handle b) {
    return a.slot() < b.slot();
}

}  // namespace

void EditStep::initTriggers(World& world) {
    if (!world.m_triggers.size()) return;
    world.m_triggers.forEach([&](TriggerHandle handle, const Trigger& trigger) {
        world.m_triggerBounds.update(handle.slot(), trigger.bounds());
    });
    world.m_bodies.forEach([&](BodyHandle handle, const Body& body) {
        if (!body.isStatic) world.m_movedBodies.push_back(handle);
    });
}

/// Bodies that physics has moved or this step has editState, by slot.
std::vector<BodyHandle> EditStep::movedBodies() {
    std::vector<BodyHandle> bodies = std::exchange(m_world.m_movedBodies, {});
    for (const auto* list : {&m_changes.bodiesCreated, &m_changes.bodiesDestroyed, &m_changes.teleported})
        bodies.insert(bodies.end(), list->begin(), list->end());
    for (const auto* list : {&m_changes.carved, &m_changes.shapesCreated, &m_changes.filters})
        for (const ShapeHandle handle : *list)
            if (const Shape* shape = m_world.m_shapes.find(handle)) bodies.push_back(shape->body);
    std::sort(bodies.begin(), bodies.end(), [](BodyHandle a, BodyHandle b) { return a < b; });
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    return bodies;
}

/// Who has come into which trigger, and who has left: bodies that moved against triggers near them and triggers that
/// they were in, and everything near a trigger that is new.
void EditStep::updateTriggers() {
    const std::vector<BodyHandle> moved = movedBodies();
    std::set<std::pair<TriggerHandle, BodyHandle>> pairs;  // all of one world: ordered by slot but for generations
    for (const BodyHandle handle : moved) {
        const Body* body = m_world.m_bodies.find(handle);
        if (!body || body->isStatic) continue;
        const WorldBox bounds = gridBounds(m_world, *body);
        m_world.m_triggerBounds.find([&](const WorldBox& box) { return box.overlaps(bounds); },
                                     [&](uint32_t slot) { pairs.emplace(m_world.m_triggers.handleAt(slot), handle); });
    }
    m_world.m_triggers.forEach([&](TriggerHandle handle, const Trigger& trigger) {
        for (const BodyHandle body : trigger.inside)
            if (std::binary_search(moved.begin(), moved.end(), body)) pairs.emplace(handle, body);
    });
    for (const TriggerHandle handle : m_changes.triggers)
        if (const Trigger* trigger = m_world.m_triggers.find(handle))
            for (const BodyHandle body : bodiesInBox(m_world, trigger->bounds(), {.includeStatic = false}))
                pairs.emplace(handle, body);
    for (const auto& [handle, body] : pairs) {
        Trigger& trigger = m_world.m_triggers.at(handle);
        const bool is = isInside(m_world, body, trigger);
        const auto at = std::find(trigger.inside.begin(), trigger.inside.end(), body);
        if (is == (at != trigger.inside.end())) continue;
        if (is)
            trigger.inside.insert(
                std::upper_bound(trigger.inside.begin(), trigger.inside.end(), body, bySlot<BodyHandle>), body);
        else
            trigger.inside.erase(at);
        m_changes.triggerEvents.push_back({handle, body, is});
        if (std::find(m_changes.triggers.begin(), m_changes.triggers.end(), handle) == m_changes.triggers.end())
            m_changes.triggers.push_back(handle);
    }
    std::stable_sort(m_changes.triggerEvents.begin(), m_changes.triggerEvents.end(),
                     [](const TriggerEvent& a, const TriggerEvent& b) {
                         return a.trigger.slot() != b.trigger.slot() ? a.trigger.slot() < b.trigger.slot()
                                                                     : a.body.slot() < b.body.slot();
                     });
}

}  // namespace rubble
