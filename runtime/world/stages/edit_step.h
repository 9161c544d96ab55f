#pragma once
#include "runtime/world/stages/edit_context.h"
#include "runtime/world/stages/fire_stage.h"
#include "runtime/world/stages/impact_load_stage.h"

namespace rubble {

/// One step of edits on a world, stage by stage: the stages, and the order of their work, are in run(). Lives for one
/// step.
class EditStep {
public:
    /// For one step on a world, with the journal to complete.
    EditStep(WorldData& world, FrameChanges& changes)
        : m_context(world, changes), m_fire(m_context), m_impactLoads(m_context) {}

    /// Applies the edits, then does everything that follows from them and from time, and completes the journal.
    void run(const Edits& edits);
    /// Applies the edits and nothing that follows from time, weight or a missing hold: what they make counts as brought
    /// by the level, what they take was never there.
    void runAlone(const Edits& edits);

private:
    void applyEdit(const Edit& edit);
    void takeRestoredBricks();
    void countAsOfLevel();
    void listChangedBricks();
    void markBroken();

    EditContext m_context;
    FireStage m_fire;
    ImpactLoadStage m_impactLoads;
};

}  // namespace rubble
