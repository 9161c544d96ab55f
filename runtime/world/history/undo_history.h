#pragma once
#include <deque>
#include <map>
#include <span>
#include <vector>

#include "runtime/world/history/grid_patch.h"
#include "runtime/world/history/world_baseline.h"

namespace rubble {

/// Exact undo and redo. Marks divide time. For each interval between marks it keeps the objects that changed there, as
/// they were at its beginning, so undo costs what changed. Undo restores the World of the last mark, what physics moved
/// included: resolvedHash() is what it was. Redo restores the moment of the undo, unless something else changed since;
/// motion alone does not count.
class UndoHistory {
public:
    /// Begins with the World as it is, without a mark; costs a copy of its objects.
    explicit UndoHistory(const WorldData& world);

    /// Sets a mark, to which the next undo returns. Of more than `limit` marks the oldest is dropped.
    void mark(size_t limit);
    /// Restores the World of the last mark and adds to the journal; false if there is nothing to undo.
    bool undo(WorldData& world, FrameChanges& changes);
    /// Restores the World as it was before the last undo; false if there is nothing to redo.
    bool redo(WorldData& world, FrameChanges& changes);

    /// Whether resolvedHash() is another one than at the last mark, undo or redo. Costs the objects that changed since.
    bool differs(const WorldData& world) const;

    /// Takes over what a step changed. Unless the step was an undo or redo and nothing else, redo is no longer
    /// possible.
    void recordStep(const WorldData& world, const FrameChanges& changes, bool isOnlyHistory);
    /// Takes over that World::setRopes() moved these.
    void recordMoves(const WorldData& world, std::span<const RopeMotion> ropes);
    /// Takes over that World::setPoses() moved these.
    void recordMoves(const WorldData& world, std::span<const BodyPose> poses);
    /// Takes over that World::setCharacters() moved these.
    void recordMoves(const WorldData& world, std::span<const CharacterMove> moves);

private:
    /// Objects of an interval as they were at its beginning. The grids of shapes that are still there at its end, in
    /// their size, are patches to the grids of that moment: the World is at it whenever an entry is used.
    struct Entry {
        WorldDelta objects;
        std::map<uint32_t, GridPatch> grids;  ///< by the shape's slot; its own grid is empty
    };
    bool hasChanged() const;
    Entry pack(WorldDelta objects) const;
    WorldDelta unpack(Entry entry) const;
    WorldDelta swapEntry(WorldData& world, WorldDelta entry, FrameChanges& changes);

    WorldBaseline m_baseline;
    std::deque<Entry> m_marks;           ///< for each mark: what changed until the next one, as it was at the mark
    WorldDelta m_current;                ///< the same since the last mark, undo or redo
    bool m_isMarked = false;             ///< whether that began with a mark, an undo or a redo
    bool m_onlyMotionSinceUndo = false;  ///< since an undo or redo
    std::vector<Entry> m_redo;           ///< what each undo replaced; the last is redone first
};

}  // namespace rubble
