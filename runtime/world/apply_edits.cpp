#include <algorithm>
#include <utility>

#include "runtime/world/edit_step.h"

namespace rubble {

FrameChanges World::applyEdits(const Edits& edits) {
    FrameChanges changes;
    changes.step = ++m_step;
    changes.levelReplaced = std::exchange(m_levelReplaced, false);
    if (!edits.empty() || debrisWaits()) EditStep(*this, changes).run(edits);
    return changes;
}

EditStep::EditStep(World& world, FrameChanges& changes) : m_world(world), m_changes(changes), m_groupRemoved(world.m_groups.slotCount()) {}

void EditStep::run(const Edits& edits) {
    m_changes.revived = std::exchange(m_world.m_revived, {});
    for (const Edit& edit : edits) std::visit([&](const auto& each) { apply(each); }, edit);
    for (auto& [slot, each] : m_touched)
        if (!each.carved.empty()) splitShape(each);
    settleMotions();
    for (const Push& each : m_pushes) std::visit([&](const auto& edit) { push(edit); }, each);
    limitDebris();
    updateLightGroups();
    listChangedBricks();
}

EditStep::Touched& EditStep::touched(ShapeHandle shape) {
    Touched& out = m_touched[shape.slot()];
    out.shape = shape;
    return out;
}

void EditStep::listChangedBricks() {
    std::erase_if(m_changes.palettes, [&](ShapeHandle shape) { return !m_world.m_shapes.find(shape); });
    for (auto& [slot, each] : m_touched) {
        const Shape* shape = m_world.m_shapes.find(each.shape);
        if (!shape) continue;
        if (!each.carved.empty()) {
            m_changes.carved.push_back(each.shape);
            markBroken(shape->body);
        }
        std::vector<glm::ivec3>& bricks = each.carved;
        bricks.insert(bricks.end(), each.painted.begin(), each.painted.end());
        std::sort(bricks.begin(), bricks.end(), cellBefore);
        bricks.erase(std::unique(bricks.begin(), bricks.end()), bricks.end());
        for (const glm::ivec3 brick : bricks) m_changes.bricks.push_back({each.shape, brick, shape->grid.shareBrick(brick)});
    }
}

void EditStep::markBroken(BodyHandle handle) {
    Body& body = m_world.m_bodies.at(handle);
    if (!std::exchange(body.broken, true)) m_changes.broken.push_back(handle);
}

}  // namespace rubble
