#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/core/result.h"

namespace rubble {

/// Reads a whole file. An error if it is no regular file, cannot be read, or is larger than `limit` bytes.
Result<std::vector<uint8_t>> readFileBytes(const std::string& path, uint64_t limit);
/// Writes a temporary file beside `path`, flushes it to the disk and renames it: readers see the old file or the whole
/// new one, even after a power failure.
Result<Done> writeFileAtomically(const std::string& path, std::span<const uint8_t> bytes);

}  // namespace rubble
