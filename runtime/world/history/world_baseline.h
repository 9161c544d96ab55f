#pragma once
#include <span>

#include "runtime/world/history/world_delta.h"
#include "runtime/world/state/world_state.h"

namespace rubble {

/// The last known state of a World, which deltas are made against: undo and recordings have one. Making it costs a copy
/// of the World's objects, not of their voxels; updating it costs what changed.
class WorldBaseline {
public:
    /// Begins with the World as it is.
    explicit WorldBaseline(const WorldData& world);

    /// A delta without objects, with the numbers that belong to no object.
    WorldDelta emptyDelta() const;
    /// Brings the baseline up to date after a step; returns the objects that its journal names as they were before.
    WorldDelta update(const WorldData& world, const FrameChanges& changes);
    /// Brings bodies up to date that World::setPoses() moved; adds them to `before` as they were, unless it has them.
    void move(const WorldData& world, std::span<const BodyPose> poses, SlotValues<BodyHandle, Body>& before);
    /// The same for characters that World::setCharacters() moved.
    void move(const WorldData& world, std::span<const CharacterMove> moves,
              SlotValues<CharacterHandle, Character>& before);
    /// The same for ropes that World::setRopes() moved.
    void move(const WorldData& world, std::span<const RopeMotion> ropes, SlotValues<JointHandle, Joint>& before);
    /// The baseline itself.
    const WorldState& last() const { return m_last; }

private:
    WorldState m_last;
    ObjectKinds<FreeSlots> m_freeSlots;
};

}  // namespace rubble
