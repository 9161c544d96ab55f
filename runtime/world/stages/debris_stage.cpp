#include <algorithm>

#include "runtime/world/stages/edit_step.h"

namespace rubble {

/// Settles what has slept long enough, then makes room for what this step has made.
void EditStep::enforceDebrisBudgets() {
    const DebrisSettings& settings = m_world.m_settings.debris;
    for (auto& [slot, each] : m_editStates)
        if (const Shape* shape = m_world.m_shapes.find(each.shape); shape && !each.carved.empty()) wake(shape->body);
    const DebrisQueue& debris = m_world.m_debris;
    const uint64_t step = m_changes.step;
    while (step >= settings.settleSteps) {
        const std::optional<BodyHandle> body = debris.asleepSince(step - settings.settleSteps);
        if (!body) break;
        m_world.m_bodies.at(*body).settled = true;
        m_world.updateDebris(*body);
        m_changes.settled.push_back(*body);
    }
    const size_t before = m_changes.bodiesDestroyed.size();
    while (debris.awakeCount() > settings.awakeBodies) despawn(debris.firstAwake());
    while (debris.count() > settings.bodies || debris.voxels() > settings.voxels) despawn(debris.first());
    if (m_changes.bodiesDestroyed.size() > before) dropTransient();
}

/// Physics will wake it too: by an impulse, or because its shape is another one now.
void EditStep::wake(BodyHandle handle) {
    Body& body = m_world.m_bodies.at(handle);
    body.asleep = false;
    body.restingSince = 0;
    if (std::exchange(body.settled, false)) m_changes.unsettled.push_back(handle);
    m_world.updateDebris(handle);
}

void EditStep::despawn(BodyHandle handle) {
    const Body& body = m_world.m_bodies.at(handle);
    const ShapeHandle shapeHandle = body.shapes.front();
    const Shape& shape = m_world.m_shapes.at(shapeHandle);
    std::array<uint64_t, 256> removed{};
    shape.grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
        forEachVoxel(brick->occupancy, [&](int i) { ++removed[brick->at(i)]; });
    });
    const glm::dvec3 half = glm::dvec3(shape.grid.size()) * (0.5 * shape.voxelSize);
    recordRemoved(shapeHandle, removed,
                  {m_world.shapeToWorld(shapeHandle).transformPoint(half), glm::length(half), body.velocity});
    destroyShape(shapeHandle);
}

/// Pieces that were born and became dust in one step: nobody else needs to have heard of them.
void EditStep::dropTransient() {
    const auto removeCommon = [](auto& created, auto& destroyed, const auto& living) {
        const auto lives = [&](auto handle) {
            return living.find(handle) != nullptr;
        };  // undo may make it anew under its handle
        auto born = created;
        std::erase_if(born, lives);
        std::sort(born.begin(), born.end());
        const auto wasBorn = [&](auto handle) { return std::binary_search(born.begin(), born.end(), handle); };
        auto gone = destroyed;
        std::erase_if(gone, lives);
        std::erase_if(destroyed, wasBorn);
        std::sort(gone.begin(), gone.end());
        std::erase_if(created, [&](auto handle) { return std::binary_search(gone.begin(), gone.end(), handle); });
    };
    removeCommon(m_changes.bodiesCreated, m_changes.bodiesDestroyed, m_world.m_bodies);
    removeCommon(m_changes.shapesCreated, m_changes.shapesDestroyed, m_world.m_shapes);
    std::erase_if(m_changes.impulses, [&](const ImpulseApplied& each) { return !m_world.m_bodies.find(each.body); });
    for (std::vector<BodyHandle>* list : {&m_changes.settled, &m_changes.unsettled})
        std::erase_if(*list, [&](BodyHandle body) { return !m_world.m_bodies.find(body); });
    std::erase_if(m_changes.unanchored, [&](ShapeHandle shape) { return !m_world.m_shapes.find(shape); });
    for (ShapeSplit& split : m_changes.splits) {
        size_t kept = 0;
        for (size_t i = 0; i < split.children.size(); ++i) {
            if (!m_world.m_shapes.find(split.children[i])) continue;
            split.children[kept] = split.children[i];
            split.parentOffset[kept] = split.parentOffset[i];
            split.motions[kept++] = split.motions[i];
        }
        split.children.resize(kept);
        split.parentOffset.resize(kept);
        split.motions.resize(kept);
    }
    std::erase_if(m_changes.splits, [](const ShapeSplit& split) { return split.children.empty(); });
}

}  // namespace rubble
