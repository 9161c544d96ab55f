#pragma once
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/assets/chunk_file.h"
#include "runtime/assets/file_bytes.h"
#include "runtime/assets/save_file.h"
#include "runtime/assets/step_delta.h"
#include "runtime/world/edits/edit.h"

namespace rubble {

/// What the host's own physics did between two steps.
struct HostMotion {
    std::vector<BodyPose> poses;  ///< of bodies that it moved, in the order in which it said so
    Edits damage;                 ///< by impacts
};

/// One step of a recording: the edits of the host, and what they came to.
struct RecordedStep {
    uint64_t step = 0;
    bool physicsRebuilt = false;  ///< physics was rebuilt from the World before this step
    Edits edits;  ///< of the host; those of impacts follow from physics, and their effect is in the delta
    std::vector<uint8_t> delta;   ///< what the edits changed, see stepDeltaToBytes()
    std::vector<BodyPose> poses;  ///< of bodies that physics moved; after the step
    std::vector<CharacterMove> characters;
    uint64_t hash = 0;          ///< World::hash() after the step
    uint64_t resolvedHash = 0;  ///< World::resolvedHash(): what delta, poses and characters alone must come to
    uint64_t voxelHash = 0;     ///< World::voxelHash(): what the delta alone must come to
    std::optional<HostMotion> hostMotion;  ///< before the step; none: the world has physics of its own
};

/// Writes a recording: a chunk file with a saved game (GAME), a chunk for each step (STEP) and one for what the host's
/// physics did after the last (HOST). Until close() the file's name ends in ".part"; where the host writes files
/// (file_hooks.h) it is kept in memory and written as a whole. Without close() no file is left.
class RecordingWriter {
public:
    RecordingWriter(RecordingWriter&&) = default;
    RecordingWriter& operator=(RecordingWriter&&) = delete;
    ~RecordingWriter();
    /// Opens the file and writes the saved game. An error if that cannot be written, if the file could not get its
    /// name, or if another recording is being written to it.
    static Result<RecordingWriter> open(const std::string& path, const SavedGame& start);
    /// Appends a step. What cannot be written is logged, ends the recording, and is reported by close(). A file that is
    /// as long as one may get gets no more.
    void add(const RecordedStep& step);
    /// Appends what the host's physics did after the last step; call it before close().
    void add(const HostMotion& after);
    /// Completes the file and gives it its name. An error if some of it could not be written; then the file has the
    /// steps before, or is removed where that cannot be either.
    Result<Done> close();

private:
    RecordingWriter() = default;
    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    Result<Done> openPart();
    void write(std::span<const uint8_t> bytes);
    void write(const ChunkWriter& chunks);
    Result<Done> handOver(const FileHeader& header);

    std::string m_path, m_part;
    FileClaim m_claim;
    std::unique_ptr<std::FILE, Closer> m_file;  ///< null: m_whole
    std::vector<uint8_t> m_whole;               ///< for the host
    uint32_t m_chunks = 0;
    uint64_t m_bytes = 0, m_memory = 0;  ///< of the file so far; that reading it takes
    uint64_t m_lastHash = 0;
    int m_failure = 0;        ///< errno of the first; 0: none. Further steps are left out
    bool m_isBroken = false;  ///< its file ends within a step
    bool m_isFull = false;    ///< further steps are left out
};

/// A recording in memory.
struct Recording {
    SavedGame start;
    std::vector<RecordedStep> steps;
    std::optional<HostMotion> after;  ///< the last step
};

/// The content of a STEP chunk. A network host can send it to a client that joins late. `memory`: gets what reading it
/// takes (MemoryBudget).
std::vector<uint8_t> recordedStepToBytes(const RecordedStep& step, uint64_t* memory = nullptr);
/// Reads it. `world`: number of the World whose handles the handles become.
Result<RecordedStep> recordedStepFromBytes(std::span<const uint8_t> bytes, const std::string& name, uint8_t world);

/// The same from a reader of its bytes, with its budget of memory.
Result<RecordedStep> recordedStepFrom(ByteReader& in, const std::string& name, uint8_t world);

/// Reads a whole recording. Steps must follow each other without a gap. `name`: of the file, for messages.
Result<Recording> recordingFromBytes(std::span<const uint8_t> bytes, const std::string& name, uint8_t world);
/// Reads a recording from a file; see recordingFromBytes().
Result<Recording> readRecording(const std::string& path, uint8_t world);

}  // namespace rubble
