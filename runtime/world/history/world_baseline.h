#pragma once
#include <span>

#include "runtime/world/history/world_delta.h"
#include "runtime/world/state/world_state.h"

namespace rubble {

/// A World as it was when last looked at: what undo and recording compare with. It costs one copy of the World's
/// objects (not of their voxels) when it is made; after that, what changes.
class WorldBaseline {
public:
    explicit WorldBaseline(const WorldData& world);

    /// Of no object, with the numbers that belong to none.
    WorldDelta emptyDelta() const;
    /// The objects that a step's journal names, as they were before it. The mirror is then up to date.
    WorldDelta update(const WorldData& world, const FrameChanges& changes);
    /// Adds bodies that World::setPoses() has moved, as they were, where `before` does not have them.
    void move(const WorldData& world, std::span<const BodyPose> poses, SlotValues<BodyHandle, Body>& before);
    /// The same for characters that World::setCharacters() has moved.
    void move(const WorldData& world, std::span<const CharacterMove> moves,
              SlotValues<CharacterHandle, Character>& before);
    /// The same for ropes, which World::setRopes() has moved.
    void move(const WorldData& world, std::span<const RopeMotion> ropes, SlotValues<JointHandle, Joint>& before);
    const WorldState& last() const { return m_last; }

private:
    WorldState m_last;
    ObjectKinds<FreeSlots> m_freeSlots;
};

}  // namespace rubble
