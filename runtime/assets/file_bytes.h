#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/core/result.h"

namespace rubble {

/// A whole file in memory; an error if it cannot be read or is larger than `limit`.
Result<std::vector<uint8_t>> readFileBytes(const std::string& path, uint64_t limit);
/// Writes a neighbour, then renames it: readers see the old file or the whole new one.
Result<Done> writeFileAtomically(const std::string& path, std::span<const uint8_t> bytes);

}  // namespace rubble
