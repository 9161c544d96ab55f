#include "runtime/world/stages/edit_step.h"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/world/edits/edit_error.h"
#include "runtime/world/stages/body_edits.h"
#include "runtime/world/stages/bounds_stage.h"
#include "runtime/world/stages/carve_edits.h"
#include "runtime/world/stages/character_edits.h"
#include "runtime/world/stages/constrain_edits.h"
#include "runtime/world/stages/create_edits.h"
#include "runtime/world/stages/debris_stage.h"
#include "runtime/world/stages/drive_edits.h"
#include "runtime/world/stages/grab_edits.h"
#include "runtime/world/stages/impulse_stage.h"
#include "runtime/world/stages/joint_stage.h"
#include "runtime/world/stages/light_group_stage.h"
#include "runtime/world/stages/light_stage.h"
#include "runtime/world/stages/material_edits.h"
#include "runtime/world/stages/note_edits.h"
#include "runtime/world/stages/paint_edits.h"
#include "runtime/world/stages/palette_edits.h"
#include "runtime/world/stages/region_edits.h"
#include "runtime/world/stages/rope_stage.h"
#include "runtime/world/stages/settings_edits.h"
#include "runtime/world/stages/shape_edits.h"
#include "runtime/world/stages/split_stage.h"
#include "runtime/world/stages/stress_stage.h"
#include "runtime/world/stages/trigger_stage.h"
#include "runtime/world/stages/voxel_edits.h"
#include "runtime/world/state/load_level.h"

namespace rubble {
namespace {

/// Overloads of a visitor.
template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;  // clang 14 does not deduce aggregates

}  // namespace

void EditStep::run(const Edits& edits) {
    m_context.changes.unsettled = std::exchange(m_context.world.unsettled, {});
    takeRestoredBricks();
    if (m_context.world.stress) openCracks(m_context);
    for (const Edit& edit : edits) applyEdit(edit);
    settlePlacedShapes(m_context);
    includeStatics(m_context.world, m_context.changes.shapesCreated);
    updateWinches(m_context);
    updateSteering(m_context);
    m_fire.update();
    splitShapes(m_context);
    releaseUnheldJoints(m_context);
    updateVelocities(m_context);
    applyImpulses(m_context);
    enforceBounds(m_context);
    enforceDebrisBudgets(m_context);
    updateLightGroups(m_context);
    if (m_context.world.stress) runStressAnalysis(m_context);
    markBroken();
    listChangedBricks();
    if (m_context.world.triggers.size()) updateTriggers(m_context);
    dropNotes(m_context);
}

void EditStep::runAlone(const Edits& edits) {
    takeRestoredBricks();
    for (const Edit& edit : edits) applyEdit(edit);
    settlePlacedShapes(m_context);
    includeStatics(m_context.world, m_context.changes.shapesCreated);
    releaseFragments(m_context);
    dropEmptyShapes(m_context);
    releaseUnheldJoints(m_context);
    updateVelocities(m_context);
    applyImpulses(m_context);
    forgetLostVoxels(m_context);
    listChangedBricks();
    if (m_context.world.triggers.size()) updateTriggers(m_context);
    countAsOfLevel();
    dropNotes(m_context);
    m_context.changes.dust.clear();  // it rises with time
    m_context.changes.blasts.clear();
}

/// Later tests for what came off look at whole shapes again, because no test has followed these edits.
void EditStep::countAsOfLevel() {
    for (const BodyHandle handle : m_context.changes.bodiesCreated)
        if (Body* body = m_context.world.bodies.find(handle); body && body->createdStep == m_context.changes.step) {
            body->createdStep = body->restingSince = 0;
            m_context.world.updateDebris(handle);
        }
    for (const auto& [slot, each] : m_context.editStates)
        if (Shape* shape = m_context.world.shapes.find(each.shape)) shape->knownConnected = false;
}

void EditStep::applyEdit(const Edit& edit) {
    m_context.edit = &edit;
    if (const std::string error = editError(edit); !error.empty()) {
        if (std::holds_alternative<AddLightEdit>(edit)) m_context.changes.lightsAdded.emplace_back();
        if (edit.made) return m_context.refuse(error);
        return logWarning(std::string(editName(edit)) + ": " + error + "; nothing was changed");
    }
    if (edit.made && !isReserved(m_context.world, edit.made))
        return m_context.refuse("an undo, or a game that was loaded, has something else under its handle");
    std::visit(Overloaded{[&](const HeatEdit& each) { m_fire.apply(each); },
                          [&](const ExtinguishEdit& each) { m_fire.apply(each); },
                          [&](const RemoveFiresEdit& each) { m_fire.apply(each); },
                          [&](const ImpactLoadEdit& each) { m_impactLoads.apply(each); },
                          [](const HistoryEdit&) {},  // World::applyEdits() has done it
                          [&](const auto& each) { apply(m_context, each); }},
               edit);
    if (edit.made && isReserved(m_context.world, edit.made)) m_context.refuse("it makes nothing");
}

/// Takes the bricks and materials that undo or redo has changed over from the journal: they are listed in the end, each
/// once, as the step leaves them, or not at all if their shape gets another grid.
void EditStep::takeRestoredBricks() {
    const std::vector<ShapeHandle> refilled = std::exchange(m_context.changes.carved, {});
    for (const ShapeHandle shape : refilled) m_context.editState(shape).otherMaterials = true;  // or it has bricks
    for (const BrickChange& each : std::exchange(m_context.changes.bricks, {})) {
        ShapeEditState& state = m_context.editState(each.shape);
        const bool isRefilled = std::find(refilled.begin(), refilled.end(), each.shape) != refilled.end();
        (isRefilled ? state.filled : state.painted).insert(each.brick);
    }
}

void EditStep::markBroken() {
    for (const auto& [slot, each] : m_context.editStates)
        if (m_context.world.shapes.find(each.shape) && each.isBroken()) m_context.markBroken(each.shape);
}

/// Adds to the journal what the edit states hold: bricks and carved shapes.
void EditStep::listChangedBricks() {
    size_t count = 0;
    for (auto& [slot, each] : m_context.editStates) {
        const Shape* shape = m_context.world.shapes.find(each.shape);
        if (!shape) continue;
        each.carved.insert(each.filled);
        if (!each.carved.empty() || each.otherMaterials) m_context.changes.carved.push_back(each.shape);
        each.carved.insert(each.painted);
        each.carved.forEachNode([&](glm::ivec3, BrickMask bricks) { count += size_t(std::popcount(bricks)); });
    }
    m_context.changes.bricks.reserve(count);
    for (const auto& [slot, each] : m_context.editStates) {
        const Shape* shape = m_context.world.shapes.find(each.shape);
        if (!shape) continue;
        each.carved.forEach([&, handle = each.shape](glm::ivec3 brick) {
            m_context.changes.bricks.push_back({handle, brick, shape->grid.shareBrick(brick)});
        });
    }
}

}  // namespace rubble
