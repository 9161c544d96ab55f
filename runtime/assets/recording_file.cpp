#include "runtime/assets/recording_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <new>

#include "runtime/assets/binary_archive.h"
#include "runtime/assets/chunk_file.h"
#include "runtime/assets/file_bytes.h"
#include "runtime/assets/state_fields.h"

namespace rubble {

template <>
inline constexpr auto kFields<BodyPose> = std::tuple{
    Field{"body", &BodyPose::body},         Field{"pose", &BodyPose::pose},
    Field{"velocity", &BodyPose::velocity}, Field{"angular_velocity", &BodyPose::angularVelocity},
    Field{"asleep", &BodyPose::asleep},
};
template <>
inline constexpr auto kFields<CharacterMove> = std::tuple{
    Field{"character", &CharacterMove::character}, Field{"position", &CharacterMove::position},
    Field{"velocity", &CharacterMove::velocity},   Field{"grounded", &CharacterMove::grounded},
    Field{"crouched", &CharacterMove::crouched},   Field{"swimming", &CharacterMove::swimming},
    Field{"ground", &CharacterMove::ground},
};
template <>
inline constexpr auto kFields<RecordedStep> = std::tuple{
    Field{"step", &RecordedStep::step},
    Field{"physics_rebuilt", &RecordedStep::physicsRebuilt},
    Field{"edits", &RecordedStep::edits},
    Field{"delta", &RecordedStep::delta},
    Field{"poses", &RecordedStep::poses},
    Field{"characters", &RecordedStep::characters},
    Field{"hash", &RecordedStep::hash},
    Field{"resolved_hash", &RecordedStep::resolvedHash},
    Field{"voxel_hash", &RecordedStep::voxelHash},
};

Result<RecordingWriter> RecordingWriter::open(const std::string& path, const SavedGame& start) {
    RecordingWriter writer;
    writer.m_path = path;
    writer.m_file.reset(std::fopen((path + ".part").c_str(), "wb"));
    if (!writer.m_file) return Error{path + ".part: cannot write: " + std::strerror(errno)};
    ChunkWriter chunks;
    chunks.add({'G', 'A', 'M', 'E'}, gameToBytes(start));
    writer.m_chunks = chunks.count();
    writer.write(chunks.file(0));
    return writer;
}

void RecordingWriter::write(const std::vector<uint8_t>& bytes) {
    m_hasFailed = m_hasFailed || std::fwrite(bytes.data(), 1, bytes.size(), m_file.get()) != bytes.size();
}

void RecordingWriter::add(const RecordedStep& step) {
    ChunkWriter chunk;
    chunk.add({'S', 'T', 'E', 'P'}, recordedStepToBytes(step));
    write(chunk.bytes());
    ++m_chunks;
    m_lastHash = step.hash;
}

Result<Done> RecordingWriter::close() {
    const FileHeader header = makeFileHeader(m_chunks, m_lastHash);
    std::FILE* file = m_file.get();
    m_hasFailed =
        m_hasFailed || std::fseek(file, 0, SEEK_SET) != 0 || std::fwrite(&header, sizeof header, 1, file) != 1;
    m_hasFailed = m_hasFailed || std::fflush(file) != 0 || fsync(fileno(file)) != 0;
    m_hasFailed = m_hasFailed || std::rename((m_path + ".part").c_str(), m_path.c_str()) != 0;
    const int reason = errno;
    m_file.reset();
    if (!m_hasFailed) return Done{};
    std::remove((m_path + ".part").c_str());
    return Error{m_path + ": cannot write: " + std::strerror(reason)};
}

std::vector<uint8_t> recordedStepToBytes(const RecordedStep& step) {
    std::vector<uint8_t> bytes;
    PaletteList unused;
    BinaryOutputArchive(bytes, unused).put(step);
    return bytes;
}

Result<RecordedStep> recordedStepFromBytes(std::span<const uint8_t> bytes, const std::string& name, uint8_t world) {
    ByteReader reader(bytes, "recorded step");
    RecordedStep step;
    BinaryInputArchive(reader, {}, world).get(step);
    reader.expectEnd("step");
    if (reader.failed()) return Error{name + ": " + reader.error()};
    return step;
}

Result<Recording> recordingFromBytes(std::span<const uint8_t> bytes, const std::string& name, uint8_t world) {
    ByteReader in(bytes, "recording");
    const FileHeader header = readFileHeader(in);
    Recording recording;
    bool haveStart = false;
    for (uint32_t i = 0; i < header.chunks && !in.failed(); ++i) {
        ChunkHeader chunk;
        const size_t start = in.offset();
        const std::vector<uint8_t> raw = readChunk(in, chunk);
        if (in.failed()) break;
        const std::string kind(chunk.kind.data(), 4),
            part = fmt::format("{}: byte {}, chunk {} ({}) unpacked", name, start, i, kind);
        if (kind == "GAME") {
            Result<SavedGame> game = gameFromBytes(raw, part, world);
            if (!game) return Error{game.error()};
            recording.start = std::move(*game);
            haveStart = true;
        } else if (kind == "STEP") {
            Result<RecordedStep> step = recordedStepFromBytes(raw, part, world);
            if (!step) return Error{step.error()};
            const uint64_t expected = recording.start.world.step + recording.steps.size() + 1;
            if (!haveStart || step->step != expected)
                return Error{fmt::format("{}: expected step {}, found {}", part, expected, step->step)};
            recording.steps.push_back(std::move(*step));
        }
    }
    in.expectEnd("file");
    if (!haveStart) in.fail("a GAME chunk", "none");
    if (in.failed()) return Error{name + ": " + in.error()};
    return recording;
}

Result<Recording> readRecording(const std::string& path, uint8_t world) try {
    const Result<std::vector<uint8_t>> bytes = readFileBytes(path, kMaxFileBytes);
    if (!bytes) return Error{bytes.error()};
    return recordingFromBytes(*bytes, path, world);
} catch (const std::bad_alloc&) {
    return Error{path + ": not enough memory for what it describes"};
}

}  // namespace rubble
