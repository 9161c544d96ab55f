#include "runtime/assets/delta_file.h"

#include <cstring>

#include "runtime/assets/byte_reader.h"
#include "runtime/assets/memory_budget.h"

namespace rubble {

void DeltaWriter::clear() {
    m_chunks = {};
    std::vector<uint8_t> start(sizeof m_start);
    std::memcpy(start.data(), &m_start, sizeof m_start);
    m_chunks.add({'S', 'T', 'R', 'T'}, start);
}

void DeltaWriter::add(RecordedStep step) {
    step.edits.clear();
    step.hostMotion.reset();
    uint64_t memory = 0;
    const std::vector<uint8_t> bytes = recordedStepToBytes(step, &memory);
    m_chunks.add({'S', 'T', 'E', 'P'}, bytes, memory);
    m_lastHash = step.hash;
}

std::vector<uint8_t> DeltaWriter::file() const {
    return ChunkWriter(m_chunks).file(m_lastHash);
}

Result<Deltas> deltasFromBytes(std::span<const uint8_t> bytes, const std::string& name, uint8_t world) {
    ByteReader in(bytes, "deltas");
    Deltas out;
    bool hasStart = false;
    std::string error;
    readChunkFile(in, [&](const ChunkHeader& chunk, const std::vector<uint8_t>& raw, uint32_t) {
        const std::string kind(chunk.kind.data(), 4);
        if (kind == "STRT") {
            if (raw.size() != sizeof out.start) return in.fail("8 bytes of STRT", std::to_string(raw.size()));
            std::memcpy(&out.start, raw.data(), sizeof out.start);
            hasStart = true;
        } else if (kind == "STEP" && error.empty()) {
            ByteReader reader(raw, "recorded step", in);
            if (!in.takeMemory(listMemory(1, sizeof(RecordedStep)))) return;
            Result<RecordedStep> step = recordedStepFrom(reader, name, world);
            if (step)
                out.steps.push_back(std::move(*step));
            else
                error = step.error();
        }
    });
    if (!hasStart) in.fail("a STRT chunk", "none");
    if (in.failed()) return Error{name + ": " + in.error()};
    if (!error.empty()) return Error{error};
    return out;
}

}  // namespace rubble
