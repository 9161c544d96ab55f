#pragma once
#include <deque>
#include <span>
#include <vector>

#include "runtime/world/history/world_baseline.h"

namespace rubble {

/// Exact undo and redo. Marks divide time; each keeps what was editState after it as it was at the mark, so undo costs
/// what changed. It takes back everything since the mark, what physics moved too: the World has the resolvedHash() that
/// it had there. Redo brings back the moment of the undo, unless something changed since.
class UndoHistory {
public:
    explicit UndoHistory(const WorldData& world);

    /// Begins what the next undo takes back; of more than `limit` marks the oldest is forgotten.
    void mark(size_t limit);
    /// Changes the World and adds to its journal; false if there is nothing to undo.
    bool undo(WorldData& world, FrameChanges& changes);
    bool redo(WorldData& world, FrameChanges& changes);

    /// A step has made these changes. If it went back or forth itself, they do not end the redo.
    void recordStep(const WorldData& world, const FrameChanges& changes, bool wasUndoOrRedo);
    /// World::setPoses() has moved these.
    void recordMoves(const WorldData& world, std::span<const RopeMotion> ropes);
    void recordMoves(const WorldData& world, std::span<const BodyPose> poses);
    void recordMoves(const WorldData& world, std::span<const CharacterMove> moves);

private:
    WorldDelta swapEntry(WorldData& world, WorldDelta entry, FrameChanges& changes);

    WorldBaseline m_baseline;
    std::deque<WorldDelta> m_marks;      ///< what was editState between each mark and the next, as it was at the mark
    WorldDelta m_current;                ///< the same since the last of them, or, drifting, since the last undo or redo
    bool m_onlyMotionSinceUndo = false;  ///< nothing but motion since an undo or redo
    std::vector<WorldDelta> m_redo;      ///< what was undone, as it was at the undo; the last comes back first
};

}  // namespace rubble
