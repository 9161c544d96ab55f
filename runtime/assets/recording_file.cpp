#include "runtime/assets/recording_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <new>
#include <utility>

#include "runtime/assets/binary_archive.h"
#include "runtime/assets/chunk_file.h"
#include "runtime/assets/file_hooks.h"
#include "runtime/assets/state_fields.h"
#include "runtime/core/log.h"
#include "runtime/core/range_check.h"
#include "runtime/core/ranges.h"
#include "runtime/world/objects/object_errors.h"

namespace rubble {

template <>
inline constexpr auto kFields<BodyPose> = std::tuple{
    Field{"body", &BodyPose::body},         Field{"pose", &BodyPose::pose},
    Field{"velocity", &BodyPose::velocity}, Field{"angular_velocity", &BodyPose::angularVelocity},
    Field{"asleep", &BodyPose::asleep},     Field{"waits_to_wake", &BodyPose::waitsToWake},
};
template <>
inline constexpr auto kFields<CharacterMove> = std::tuple{
    Field{"character", &CharacterMove::character}, Field{"position", &CharacterMove::position},
    Field{"velocity", &CharacterMove::velocity},   Field{"ground_velocity", &CharacterMove::groundVelocity},
    Field{"grounded", &CharacterMove::grounded},   Field{"crouched", &CharacterMove::crouched},
    Field{"swimming", &CharacterMove::swimming},   Field{"ground", &CharacterMove::ground},
};
template <>
inline constexpr auto kFields<HostMotion> = std::tuple{
    Field{"poses", &HostMotion::poses},
    Field{"damage", &HostMotion::damage},
};
/// Without hostMotion, which is behind the others if there is one.
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

namespace {

/// Opens a file to write it from its beginning; null, with errno, if that cannot be. EWOULDBLOCK: somebody who opened
/// it so has it open still.
std::FILE* openAlone(const std::string& path) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0) return nullptr;
    std::FILE* file =
        flock(descriptor, LOCK_EX | LOCK_NB) == 0 && ftruncate(descriptor, 0) == 0 ? fdopen(descriptor, "wb") : nullptr;
    if (file) return file;
    const int reason = errno;
    ::close(descriptor);
    errno = reason;
    return nullptr;
}

}  // namespace

RecordingWriter::~RecordingWriter() {
    if (m_file) std::remove(m_part.c_str());
}

Result<RecordingWriter> RecordingWriter::open(const std::string& path, const SavedGame& start) {
    RecordingWriter writer;
    writer.m_path = path;
    Result<FileClaim> claim = FileClaim::make(path);
    if (!claim) return Error{claim.error()};
    writer.m_claim = std::move(*claim);
    if (!fileHooks().write)
        if (const Result<Done> opened = writer.openPart(); !opened) return Error{opened.error()};
    ChunkWriter chunks;
    uint64_t memory = 0;
    const std::vector<uint8_t> game = gameToBytes(start, &memory);
    chunks.add({'G', 'A', 'M', 'E'}, game, memory);
    const FileHeader header = makeFileHeader(0, 0);  // close() writes the right one
    const auto* bytes = reinterpret_cast<const uint8_t*>(&header);
    writer.write({bytes, sizeof header});
    writer.write(chunks);
    if (!writer.m_failure) return writer;
    return fileError(path, "cannot write", writer.m_failure);
}

/// The file that has its name after close().
Result<Done> RecordingWriter::openPart() {
    const std::string path = m_path;
    const Result<std::string> target = fileToWrite(path);
    if (!target) return Error{target.error()};
    m_path = *target;
    m_part = m_path + ".part";
    const Result<std::string> part = fileToWrite(m_part);
    if (!part) return Error{part.error()};
    m_file.reset(openAlone(*part));
    if (!m_file && errno == EWOULDBLOCK)
        return Error{path + ": expected a file of its own, found one that a recording is being written to"};
    if (!m_file) {
        const int reason = errno;
        if (reason == ENOMEM) std::remove(part->c_str());
        requireMemory(reason);
        return fileError(*part, "cannot write", reason);
    }
    std::setvbuf(m_file.get(), nullptr, _IONBF, 0);  // a step is one write, so that it is in the file or it is not
    return Done{};
}

void RecordingWriter::write(std::span<const uint8_t> bytes) {
    if (m_failure) return;
    errno = 0;
    if (!m_file)
        m_whole.insert(m_whole.end(), bytes.begin(), bytes.end());
    else if (std::fwrite(bytes.data(), 1, bytes.size(), m_file.get()) != bytes.size()) {
        m_failure = errno ? errno : EIO;
        if (ftruncate(fileno(m_file.get()), off_t(m_bytes)) != 0) m_isBroken = true;
        return;
    }
    m_bytes += bytes.size();
}

void RecordingWriter::write(const ChunkWriter& chunks) {
    write(chunks.bytes());
    if (m_failure) return;
    m_chunks += chunks.count();
    m_memory += chunks.memory();
}

void RecordingWriter::add(const RecordedStep& step) {
    uint64_t memory = 0;
    const std::vector<uint8_t> bytes = recordedStepToBytes(step, &memory);
    ChunkWriter chunk;
    chunk.add({'S', 'T', 'E', 'P'}, bytes, memory);
    if (m_isFull || m_failure) return;
    if (m_bytes + chunk.bytes().size() > kMaxFileBytes / 2) {  // the rest is room for padding
        m_isFull = true;
        logWarning(
            fmt::format("{}: the recording is as long as a file may get; it ends before step {}", m_path, step.step));
        return;
    }
    write(chunk);
    if (!m_failure)
        m_lastHash = step.hash;
    else
        logError(fmt::format("{}; the recording ends before step {}", fileError(m_path, "cannot write", m_failure).text,
                             step.step));
}

void RecordingWriter::add(const HostMotion& after) {
    std::vector<uint8_t> bytes;
    PaletteList unused;
    BinaryOutputArchive archive(bytes, unused);
    archive.put(after);
    ChunkWriter chunk;
    chunk.add({'H', 'O', 'S', 'T'}, bytes, archive.memory());
    if (m_isFull || m_failure || m_bytes + chunk.bytes().size() > kMaxFileBytes / 2) return;
    write(chunk);
}

Result<Done> RecordingWriter::close() {
    const int failure = std::exchange(m_failure, 0);  // what was written before it is kept
    ChunkWriter padding;
    padding.pad(m_bytes, m_memory);
    write(padding);
    const FileHeader header = makeFileHeader(m_chunks, m_lastHash);
    std::FILE* file = m_file.get();
    if (!file) return handOver(header);
    errno = 0;
    const bool isWritten = !m_failure && !m_isBroken && std::fseek(file, 0, SEEK_SET) == 0 &&
                           std::fwrite(&header, sizeof header, 1, file) == 1 && fsync(fileno(file)) == 0 &&
                           std::rename(m_part.c_str(), m_path.c_str()) == 0;
    const int reason = failure ? failure : m_failure ? m_failure : errno;
    m_file.reset();
    m_claim.release();
    if (isWritten && !failure) return Done{};
    if (!isWritten) std::remove(m_part.c_str());
    const std::string text = fileError(m_path, "cannot write", reason).text;
    return Error{isWritten ? text + "; the recording ends before the first step that could not be written" : text};
}

Result<Done> RecordingWriter::handOver(const FileHeader& header) {
    std::memcpy(m_whole.data(), &header, sizeof header);
    m_claim.release();
    return writeFileAtomically(m_path, m_whole, kMaxFileBytes);
}

std::vector<uint8_t> recordedStepToBytes(const RecordedStep& step, uint64_t* memory) {
    std::vector<uint8_t> bytes;
    PaletteList unused;
    BinaryOutputArchive archive(bytes, unused);
    archive.put(step);
    if (step.hostMotion) archive.put(*step.hostMotion);
    if (memory) *memory = archive.memory() + listMemory(1, sizeof(RecordedStep));
    return bytes;
}

Result<RecordedStep> recordedStepFromBytes(std::span<const uint8_t> bytes, const std::string& name, uint8_t world) {
    ByteReader reader(bytes, "recorded step");
    return recordedStepFrom(reader, name, world);
}

/// About the motion of bodies; empty: nothing.
static std::string motionError(const std::vector<BodyPose>& poses) {
    RangeCheck check;
    for (const BodyPose& pose : poses)
        check.include(
            objectError(Body{.pose = pose.pose, .velocity = pose.velocity, .angularVelocity = pose.angularVelocity}));
    return check.error();
}

/// About the motion of bodies and characters in a step; empty: nothing.
static std::string motionError(const RecordedStep& step) {
    RangeCheck check;
    check.include(motionError(step.poses));
    if (step.hostMotion) check.include(motionError(step.hostMotion->poses));
    for (const CharacterMove& move : step.characters)
        check.vector("position", move.position, ranges::kPlace)
            .include(characterVelocityError("velocity", move.velocity))
            .include(characterVelocityError("ground_velocity", move.groundVelocity));
    return check.error();
}

Result<RecordedStep> recordedStepFrom(ByteReader& reader, const std::string& name, uint8_t world) {
    RecordedStep step;
    BinaryInputArchive archive(reader, {}, world);
    archive.get(step);
    if (reader.remaining() > 0) archive.get(step.hostMotion.emplace());
    reader.expectEnd("step");
    if (!reader.failed())
        if (const std::string error = motionError(step); !error.empty()) reader.fail("motion within its ranges", error);
    if (reader.failed()) return Error{name + ": " + reader.error()};
    return step;
}

static Result<HostMotion> hostMotionFrom(ByteReader& reader, const std::string& name, uint8_t world) {
    HostMotion motion;
    BinaryInputArchive archive(reader, {}, world);
    archive.get(motion);
    reader.expectEnd("motion");
    if (!reader.failed())
        if (const std::string error = motionError(motion.poses); !error.empty())
            reader.fail("motion within its ranges", error);
    if (reader.failed()) return Error{name + ": " + reader.error()};
    return motion;
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
            ByteReader reader(raw, "save", in);
            Result<SavedGame> game = gameFrom(reader, part, world);
            if (!game) return Error{game.error()};
            recording.start = std::move(*game);
            haveStart = true;
        } else if (kind == "STEP") {
            ByteReader reader(raw, "recorded step", in);
            if (!in.takeMemory(listMemory(1, sizeof(RecordedStep)))) break;
            Result<RecordedStep> step = recordedStepFrom(reader, part, world);
            if (!step) return Error{step.error()};
            const uint64_t expected = recording.start.world.step + recording.steps.size() + 1;
            if (!haveStart || step->step != expected)
                return Error{fmt::format("{}: expected step {}, found {}", part, expected, step->step)};
            recording.steps.push_back(std::move(*step));
        } else if (kind == "HOST") {
            ByteReader reader(raw, "recorded motion", in);
            Result<HostMotion> after = hostMotionFrom(reader, part, world);
            if (!after) return Error{after.error()};
            recording.after = std::move(*after);
        }
    }
    in.expectEnd("file");
    if (!haveStart) in.fail("a GAME chunk", "none");
    if (in.failed()) return Error{name + ": " + in.error()};
    return recording;
}

Result<Recording> readRecording(const std::string& path, uint8_t world) {
    const Result<std::vector<uint8_t>> bytes = readFileBytes(path, kMaxFileBytes);
    if (!bytes) return Error{bytes.error()};
    try {
        return recordingFromBytes(*bytes, path, world);
    } catch (const std::bad_alloc&) {
        return Error{path + ": not enough memory for what it describes"};
    }
}

}  // namespace rubble
