#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/assets/chunk_file.h"
#include "runtime/assets/recording_file.h"
#include "runtime/assets/step_events.h"

namespace rubble {

/// What deltas say of a step.
enum class DeltaContent : uint8_t {
    All,       ///< all that it changed
    EditsOnly  ///< what edits changed: not how bodies and characters moved
};

/// What deltas were taken from: which steps of which start.
struct DeltaSpan {
    uint64_t start = 0;  ///< the step after which they began to be kept
    uint64_t from = 0;   ///< the step before the first of them
    uint64_t to = 0;     ///< the last of them
    DeltaContent content = DeltaContent::All;
};

/// Steps of one world as bytes for another one that was equal before the first of them.
struct Deltas {
    DeltaSpan span;
    /// In order, without edits; an empty HostMotion says that the host moved the bodies before the step.
    /// DeltaContent::EditsOnly: only those that changed something.
    std::vector<RecordedStep> steps;
    std::vector<StepEvents> events;  ///< in order: of steps that had some, if they were kept
};

/// Packs deltas, each as its step ends: a chunk file with a SPAN chunk, a STEP chunk for each step of Deltas,
/// and an EVNT chunk for each of its events.
class DeltaWriter {
public:
    /// start: see DeltaSpan.
    /// withEvents: whether addEvents() adds any.
    DeltaWriter(uint64_t start, DeltaContent content, bool withEvents)
        : m_span{start, start, start, content}, m_withEvents(withEvents) {}
    /// Appends a step; its edits are left out.
    void add(RecordedStep step);
    /// Appends what the last step that was added tells of, if that is kept and anything happened.
    void addEvents(const FrameChanges& changes);
    /// What each step is to say.
    DeltaContent content() const { return m_span.content; }
    /// The file with what was added since the last clear(). Costs a copy of it.
    std::vector<uint8_t> file() const;
    /// Leaves out what was added until now.
    void clear();

private:
    DeltaSpan m_span;
    bool m_withEvents;
    uint64_t m_lastHash = 0;
    ChunkWriter m_chunks;  ///< of the steps
};

/// Reads what DeltaWriter::file() made. Handles become those of the World with the number `world`. `name`: for
/// messages.
Result<Deltas> deltasFromBytes(std::span<const uint8_t> bytes, const std::string& name, uint8_t world);

}  // namespace rubble
