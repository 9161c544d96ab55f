#pragma once
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/assets/save_file.h"
#include "runtime/assets/step_delta.h"

namespace rubble {

/// One step of a recording: what the host asked for, and what became of it.
struct RecordedStep {
    uint64_t step = 0;
    bool physicsRebuilt = false;  ///< physics was made anew from the World before this step
    Edits edits;                  ///< the host's alone; what impacts did is in the delta, and follows from physics
    std::vector<uint8_t> delta;   ///< see stepDeltaToBytes()
    std::vector<BodyPose> poses;  ///< that physics handed over
    std::vector<CharacterMove> characters;
    uint64_t hash = 0;          ///< of the World after the step
    uint64_t resolvedHash = 0;  ///< what the delta and the poses must come to
    uint64_t voxelHash = 0;     ///< what the delta alone must come to
};

/// Writes a recording: a save, then the steps, each a chunk. The file gets its name when it is closed; until then it
/// has a neighbour's name, ending in .part.
class RecordingWriter {
public:
    static Result<RecordingWriter> open(const std::string& path, const SavedGame& start);
    /// Failures are kept for close().
    void add(const RecordedStep& step);
    Result<Done> close();

private:
    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    void write(const std::vector<uint8_t>& bytes);

    std::string m_path;
    std::unique_ptr<std::FILE, Closer> m_file;
    uint32_t m_chunks = 0;
    uint64_t m_lastHash = 0;
    bool m_hasFailed = false;
};

/// A recording in memory.
struct Recording {
    SavedGame start;
    std::vector<RecordedStep> steps;
};

/// A step as the payload of a chunk: what goes over a wire to one who joins late.
std::vector<uint8_t> recordedStepToBytes(const RecordedStep& step);
Result<RecordedStep> recordedStepFromBytes(std::span<const uint8_t> bytes, const std::string& name, uint8_t world);

Result<Recording> recordingFromBytes(std::span<const uint8_t> bytes, const std::string& name, uint8_t world);
Result<Recording> readRecording(const std::string& path, uint8_t world);

}  // namespace rubble
