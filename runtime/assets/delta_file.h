#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/assets/chunk_file.h"
#include "runtime/assets/recording_file.h"

namespace rubble {

/// Steps of one world as bytes for another one that was equal before the first of them.
struct Deltas {
    uint64_t start = 0;               ///< the step after which they began to be kept
    std::vector<RecordedStep> steps;  ///< without edits
};

/// Packs deltas, each as its step ends: a chunk file with a STRT chunk and a STEP chunk for each step.
class DeltaWriter {
public:
    /// start: see Deltas.
    explicit DeltaWriter(uint64_t start) : m_start(start) { clear(); }
    /// Appends a step; its edits are left out.
    void add(RecordedStep step);
    /// The file with what was added since the last clear().
    std::vector<uint8_t> file() const;
    /// Leaves out what was added until now.
    void clear();

private:
    uint64_t m_start;
    uint64_t m_lastHash = 0;
    ChunkWriter m_chunks;
};

/// Reads what DeltaWriter::file() made. Handles become those of the World with the number `world`. `name`: for
/// messages.
Result<Deltas> deltasFromBytes(std::span<const uint8_t> bytes, const std::string& name, uint8_t world);

}  // namespace rubble
