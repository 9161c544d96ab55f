#pragma once
#include <functional>
#include <span>
#include <utility>

#include "runtime/assets/delta_file.h"
#include "runtime/world/history/world_baseline.h"

namespace rubble {

/// Describes the steps of a FrameLoop: for a recording, and for a world that follows this one. Costs time for what each
/// step changed and for a hash of the World, and memory for one copy of the World's objects.
class Recorder {
public:
    /// `take` gets each step as it ends. The first is the next one of the World. content: with DeltaContent::EditsOnly
    /// a step has no motion, and of its hashes that of the voxels alone, if they changed.
    Recorder(const World& world, DeltaContent content, std::function<void(const RecordedStep&)> take)
        : m_baseline(world), m_content(content), m_take(std::move(take)) {}

    /// Begins a step; call it after World::applyEdits(). physicsRebuilt: this step rebuilds physics from the World.
    void recordEdits(const Edits& hostEdits, const FrameChanges& changes, const World& world, bool physicsRebuilt);
    /// Adds what the host's physics did before the step; call it after recordEdits().
    void recordHostMotion(const HostMotion& motion) { m_step.hostMotion = motion; }
    /// Ends the step and hands it over; call it after setPoses() and setCharacters().
    void recordMotion(std::span<const BodyPose> poses, std::span<const CharacterMove> characters, const World& world);

private:
    WorldBaseline m_baseline;
    DeltaContent m_content;
    PaletteList m_palettes;
    RecordedStep m_step;
    std::function<void(const RecordedStep&)> m_take;
};

}  // namespace rubble
