#include <algorithm>
#include <bit>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/world/stages/edit_step.h"
#include "runtime/world/history/undo_history.h"

namespace rubble {

FrameChanges World::applyEdits(const Edits& edits) {
    FrameChanges changes;
    changes.step = ++m_step;
    changes.levelReplaced = std::exchange(m_levelReplaced, false);
    if (m_settings.undoMarks == 0)
        m_undo.clear();
    else if (m_undo.empty())
        m_undo.emplace_back(*this);
    const bool isUndoOrRedo = runHistory(edits, changes);
    if (isUndoOrRedo) restartStress();
    const bool isBusy = hasDebrisWork() || m_flickeringGroups || m_fire.isActive() ||
                        (m_stress && m_stress->isBusy()) || !m_movedBodies.empty() || !m_pendingSplits.empty() ||
                        hasActiveWinch();
    if (!edits.empty() || isBusy) EditStep(*this, changes).run(edits);
    for (UndoHistory& undo : m_undo) undo.recordStep(*this, changes, isUndoOrRedo);
    return changes;
}

/// Marks, undo and redo, before all other edits of the step. True if the World went back or forth in time.
bool World::runHistory(const Edits& edits, FrameChanges& changes) {
    bool isUndoOrRedo = false;
    for (const Edit& edit : edits) {
        const auto* history = std::get_if<HistoryEdit>(&edit);
        if (!history) continue;
        if (m_undo.empty())
            logWarning("HistoryEdit: nothing is remembered; set WorldSettings::undoMarks");
        else if (isUndoOrRedo)
            logWarning("HistoryEdit: one undo or redo a step; this one is left out");
        else if (history->action == HistoryAction::Mark)
            m_undo[0].mark(m_settings.undoMarks);
        else
            isUndoOrRedo = history->action == HistoryAction::Undo ? m_undo[0].undo(*this, changes)
                                                                  : m_undo[0].redo(*this, changes);
        if (isUndoOrRedo && m_settings.split.partsPerStep) resetSearches(changes);
    }
    return isUndoOrRedo;
}

/// What shapes look like now has nothing to do with what waiting searches have seen; a piece may hang that was waited
/// for.
void World::resetSearches(const FrameChanges& changes) {
    for (PendingSplit& pending : m_pendingSplits) pending.search.reset();
    for (const auto* list : {&changes.carved, &changes.shapesCreated})
        for (const ShapeHandle handle : *list)
            if (Shape* shape = m_shapes.find(handle)) shape->knownConnected = false;
}

void World::resetCaches() {
    restartStress();
    for (const PendingSplit& pending : m_pendingSplits)
        if (Shape* shape = m_shapes.find(pending.shape)) shape->knownConnected = false;
    m_pendingSplits.clear();
}

EditStep::EditStep(World& world, FrameChanges& changes)
    : m_world(world), m_changes(changes), m_removedByGroup(world.m_groups.slotCount()) {}

void EditStep::run(const Edits& edits) {
    m_changes.unsettled = std::exchange(m_world.m_revived, {});
    if (m_world.m_stress) openCracks();
    for (const Edit& edit : edits) std::visit([&](const auto& each) { apply(each); }, edit);
    updateWinches();
    updateFires();
    splitShapes();
    releaseUnheldJoints();
    updateVelocities();
    for (const DeferredImpulse& each : m_deferredImpulses)
        std::visit([&](const auto& edit) { applyImpulse(edit); }, each);
    enforceDebrisBudgets();
    redistributeHeat();
    updateLightGroups();
    if (m_world.m_stress) runStressAnalysis();
    listChangedBricks();
    if (m_world.m_triggers.size()) updateTriggers();
}

void EditStep::apply(const SettingsEdit& edit) {
    m_world.setSettings(edit.settings);
}

EditStep::ShapeEditState& EditStep::editState(ShapeHandle shape) {
    ShapeEditState& out = m_editStates[shape.slot()];
    out.shape = shape;
    return out;
}

void EditStep::listChangedBricks() {
    std::erase_if(m_changes.palettes, [&](ShapeHandle shape) { return !m_world.m_shapes.find(shape); });
    size_t count = m_changes.bricks.size();
    for (auto& [slot, each] : m_editStates) {
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
    for (const auto& [slot, each] : m_editStates) {
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
