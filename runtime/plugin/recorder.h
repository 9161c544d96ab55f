#pragma once
#include "runtime/assets/recording_file.h"
#include "runtime/world/history/world_baseline.h"

namespace rubble {

/// Writes the steps of a FrameLoop to a recording. Costs what each step changed, one copy of the World's objects, and a
/// hash of the World a step.
class Recorder {
public:
    /// The World must be the one that `writer` was opened with.
    Recorder(RecordingWriter writer, const World& world) : m_writer(std::move(writer)), m_baseline(world) {}

    /// After applyEdits(). physicsRebuilt: physics is made anew in this step.
    void edited(const Edits& hostEdits, const FrameChanges& changes, const World& world, bool physicsRebuilt);
    /// After setPoses() and setCharacters(): the step is done.
    void moved(std::span<const BodyPose> poses, std::span<const CharacterMove> characters, const World& world);
    Result<Done> close() { return m_writer.close(); }

private:
    RecordingWriter m_writer;
    WorldBaseline m_baseline;
    PaletteList m_palettes;
    RecordedStep m_step;
};

}  // namespace rubble
