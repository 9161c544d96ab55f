#include <algorithm>
#include <bit>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/world/edit_step.h"
#include "runtime/world/undo_history.h"

namespace rubble {

FrameChanges World::applyEdits(const Edits& edits) {
    FrameChanges changes;
    changes.step = ++m_step;
    changes.levelReplaced = std::exchange(m_levelReplaced, false);
    if (m_settings.undoMarks == 0)
        m_undo.clear();
    else if (m_undo.empty())
        m_undo.emplace_back(*this);
    const bool goesBack = runHistory(edits, changes);
    if (goesBack) listLoads();
    const bool isBusy = debrisWaits() || m_dyingGroups || m_fire.isActive() || (m_load && m_load->isBusy()) || !m_movedBodies.empty() ||
                        !m_pendingSplits.empty() || isWinding();
    if (!edits.empty() || isBusy) EditStep(*this, changes).run(edits);
    for (UndoHistory& undo : m_undo) undo.note(*this, changes, goesBack);
    return changes;
}

/// Marks, undo and redo, before all other edits of the step. True if the World went back or forth in time.
bool World::runHistory(const Edits& edits, FrameChanges& changes) {
    bool goesBack = false;
    for (const Edit& edit : edits) {
        const auto* history = std::get_if<HistoryEdit>(&edit);
        if (!history) continue;
        if (m_undo.empty())
            logWarning("HistoryEdit: nothing is remembered; set WorldSettings::undoMarks");
        else if (goesBack)
            logWarning("HistoryEdit: one undo or redo a step; this one is left out");
        else if (history->action == HistoryAction::Mark)
            m_undo[0].mark(m_settings.undoMarks);
        else
            goesBack = history->action == HistoryAction::Undo ? m_undo[0].undo(*this, changes) : m_undo[0].redo(*this, changes);
        if (goesBack && m_settings.split.partsAStep) forgetSearches(changes);
    }
    return goesBack;
}

/// What shapes look like now has nothing to do with what waiting searches have seen; a piece may hang that was waited for.
void World::forgetSearches(const FrameChanges& changes) {
    for (PendingSplit& pending : m_pendingSplits) pending.search.reset();
    for (const auto* list : {&changes.carved, &changes.shapesCreated})
        for (const ShapeHandle handle : *list)
            if (Shape* shape = m_shapes.find(handle)) shape->nothingLoose = false;
}

void World::resetCaches() {
    listLoads();
    for (const PendingSplit& pending : m_pendingSplits)
        if (Shape* shape = m_shapes.find(pending.shape)) shape->nothingLoose = false;
    m_pendingSplits.clear();
}

EditStep::EditStep(World& world, FrameChanges& changes) : m_world(world), m_changes(changes), m_groupRemoved(world.m_groups.slotCount()) {}

void EditStep::run(const Edits& edits) {
    m_changes.revived = std::exchange(m_world.m_revived, {});
    if (m_world.m_load) openCracks();
    for (const Edit& edit : edits) std::visit([&](const auto& each) { apply(each); }, edit);
    windRopes();
    burn();
    splitShapes();
    checkJoints();
    settleMotions();
    for (const Push& each : m_pushes) std::visit([&](const auto& edit) { push(edit); }, each);
    limitDebris();
    moveHeat();
    updateLightGroups();
    if (m_world.m_load) weighShapes();
    listChangedBricks();
    if (m_world.m_triggers.size()) updateTriggers();
}

void EditStep::apply(const SettingsEdit& edit) {
    m_world.setSettings(edit.settings);
}

EditStep::Touched& EditStep::touched(ShapeHandle shape) {
    Touched& out = m_touched[shape.slot()];
    out.shape = shape;
    return out;
}

void EditStep::listChangedBricks() {
    std::erase_if(m_changes.palettes, [&](ShapeHandle shape) { return !m_world.m_shapes.find(shape); });
    size_t count = m_changes.bricks.size();
    for (auto& [slot, each] : m_touched) {
        const Shape* shape = m_world.m_shapes.find(each.shape);
        if (!shape) continue;
        if (!each.carved.empty()) {
            m_changes.carved.push_back(each.shape);
            markBroken(shape->body);
        }
        each.carved.insert(each.painted);
        each.carved.forEachNode([&](glm::ivec3, BrickMask bricks) { count += size_t(std::popcount(bricks)); });
    }
    m_changes.bricks.reserve(count);
    for (const auto& [slot, each] : m_touched) {
        const Shape* shape = m_world.m_shapes.find(each.shape);
        if (!shape) continue;
        each.carved.forEach([&, handle = each.shape](glm::ivec3 brick) {
            m_changes.bricks.push_back({handle, brick, shape->grid.shareBrick(brick)});
        });
    }
}

void EditStep::markBroken(BodyHandle handle) {
    Body& body = m_world.m_bodies.at(handle);
    if (!std::exchange(body.broken, true)) m_changes.broken.push_back(handle);
}

}  // namespace rubble
