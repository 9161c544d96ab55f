#pragma once
#include <span>

#include "runtime/assets/recording_file.h"
#include "runtime/world/history/world_baseline.h"

namespace rubble {

/// Writes the steps of a FrameLoop to a recording. Costs time for what each step changed and for a hash of the World,
/// and memory for one copy of the World's objects.
class Recorder {
public:
    /// The World must be in the state that `writer` was opened with.
    Recorder(RecordingWriter writer, const World& world) : m_writer(std::move(writer)), m_baseline(world) {}

    /// Begins a step; call it after World::applyEdits(). physicsRebuilt: this step rebuilds physics from the World.
    void recordEdits(const Edits& hostEdits, const FrameChanges& changes, const World& world, bool physicsRebuilt);
    /// Adds what the host's physics did before the step; call it after recordEdits().
    void recordHostMotion(const HostMotion& motion) { m_step.hostMotion = motion; }
    /// Ends the step and writes it; call it after setPoses() and setCharacters().
    void recordMotion(std::span<const BodyPose> poses, std::span<const CharacterMove> characters, const World& world);
    /// Completes the file; says what could not be written.
    Result<Done> close() { return m_writer.close(); }

private:
    RecordingWriter m_writer;
    WorldBaseline m_baseline;
    PaletteList m_palettes;
    RecordedStep m_step;
};

}  // namespace rubble
