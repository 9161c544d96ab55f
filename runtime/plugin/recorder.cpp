#include "runtime/plugin/recorder.h"

namespace rubble {

void Recorder::recordEdits(const Edits& hostEdits, const FrameChanges& changes, const World& world,
                           bool physicsRebuilt) {
    m_step = {.step = changes.step, .physicsRebuilt = physicsRebuilt, .edits = hostEdits};
    WorldDelta before = m_baseline.update(world, changes);
    if (m_content == DeltaContent::EditsOnly) dropMotion(before.bodies, world.data());
    m_step.delta = stepDeltaToBytes(before, changes, world, m_palettes);
}

void Recorder::recordMotion(std::span<const BodyPose> poses, std::span<const CharacterMove> characters,
                            const World& world) {
    if (m_content == DeltaContent::EditsOnly) {
        if (!m_step.delta.empty()) m_step.voxelHash = voxelHash(world);
        return m_take(m_step);
    }
    SlotValues<BodyHandle, Body> oldBodies;  // move() returns the values that it replaces; only undo needs them
    m_baseline.move(world, poses, oldBodies);
    SlotValues<CharacterHandle, Character> oldCharacters;
    m_baseline.move(world, characters, oldCharacters);
    m_step.poses.assign(poses.begin(), poses.end());
    m_step.characters.assign(characters.begin(), characters.end());
    m_step.hash = world.hash();
    m_step.resolvedHash = resolvedHash(world);
    m_step.voxelHash = voxelHash(world);
    m_take(m_step);
}

}  // namespace rubble
