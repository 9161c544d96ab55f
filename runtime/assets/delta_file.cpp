#include "runtime/assets/delta_file.h"

#include <cstring>

#include "runtime/assets/byte_reader.h"
#include "runtime/assets/memory_budget.h"

namespace rubble {

namespace {

/// More of them are in no file, so that a short one cannot ask for a long time.
constexpr uint64_t kMaxSteps = uint64_t(1) << 20;

std::vector<uint8_t> bytesOf(const DeltaSpan& span) {
    std::vector<uint8_t> out(25);
    std::memcpy(out.data(), &span.start, 8);
    std::memcpy(out.data() + 8, &span.from, 8);
    std::memcpy(out.data() + 16, &span.to, 8);
    out[24] = uint8_t(span.content);
    return out;
}

DeltaSpan readSpan(ByteReader& in, const std::vector<uint8_t>& raw) {
    DeltaSpan span;
    if (raw.size() != 25) {
        in.fail("25 bytes of SPAN", std::to_string(raw.size()));
        return span;
    }
    std::memcpy(&span.start, raw.data(), 8);
    std::memcpy(&span.from, raw.data() + 8, 8);
    std::memcpy(&span.to, raw.data() + 16, 8);
    span.content = DeltaContent(raw[24]);
    const bool isForward = span.start <= span.from && span.from <= span.to && span.to - span.from <= kMaxSteps;
    if (!isForward || span.content > DeltaContent::EditsOnly) in.fail("a span of steps", "another");
    return span;
}

/// Whether steps are in order within the span.
template <class Steps>
bool areInOrder(const Steps& steps, const DeltaSpan& span) {
    uint64_t last = span.from;
    for (const auto& step : steps) {
        if (step.step <= last || step.step > span.to) return false;
        last = step.step;
    }
    return true;
}

/// Whether the steps are in order within the span and, where each has a chunk, none is missing.
bool fitsSpan(const Deltas& deltas) {
    if (!areInOrder(deltas.steps, deltas.span) || !areInOrder(deltas.events, deltas.span)) return false;
    return deltas.span.content == DeltaContent::EditsOnly || deltas.steps.size() == deltas.span.to - deltas.span.from;
}

}  // namespace

void DeltaWriter::clear() {
    m_chunks = {};
    m_span.from = m_span.to;
}

void DeltaWriter::add(RecordedStep step) {
    m_span.to = step.step;
    if (m_span.content == DeltaContent::EditsOnly && step.delta.empty()) return;
    step.edits.clear();
    if (step.hostMotion) step.hostMotion.emplace();  // that there was some is all that is left of it
    uint64_t memory = 0;
    const std::vector<uint8_t> bytes = recordedStepToBytes(step, &memory);
    m_chunks.add({'S', 'T', 'E', 'P'}, bytes, memory);
    m_lastHash = step.hash;
}

void DeltaWriter::addEvents(const FrameChanges& changes) {
    if (!m_withEvents) return;
    const StepEvents events = eventsOf(changes);
    if (events.empty()) return;
    uint64_t memory = 0;
    const std::vector<uint8_t> bytes = stepEventsToBytes(events, &memory);
    m_chunks.add({'E', 'V', 'N', 'T'}, bytes, memory);
}

std::vector<uint8_t> DeltaWriter::file() const {
    ChunkWriter out = m_chunks;
    out.add({'S', 'P', 'A', 'N'}, bytesOf(m_span));
    return out.file(m_lastHash);
}

Result<Deltas> deltasFromBytes(std::span<const uint8_t> bytes, const std::string& name, uint8_t world) {
    ByteReader in(bytes, "deltas");
    Deltas out;
    bool hasSpan = false;
    std::string error;
    readChunkFile(in, [&](const ChunkHeader& chunk, const std::vector<uint8_t>& raw, uint32_t) {
        const std::string kind(chunk.kind.data(), 4);
        if (kind == "SPAN") {
            out.span = readSpan(in, raw);
            hasSpan = true;
        } else if (kind == "EVNT" && error.empty()) {
            ByteReader reader(raw, "events of a step", in);
            out.events.push_back(readStepEvents(reader, world));
            if (reader.failed()) error = name + ": " + reader.error();
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
    if (!hasSpan) in.fail("a SPAN chunk", "none");
    if (!in.failed() && error.empty() && !fitsSpan(out)) in.fail("the steps of the span, in order", "others");
    if (in.failed()) return Error{name + ": " + in.error()};
    if (!error.empty()) return Error{error};
    return out;
}

}  // namespace rubble
