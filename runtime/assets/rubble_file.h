#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/assets/assets.h"

namespace rubble {

/// The baked format in memory. A header (magic "RUBBLE\r\n", version, number of chunks, hashLevel(), hash of the
/// header), then chunks, each with kind, codec, sizes and an XXH3 hash over its header and stored bytes: no flipped bit
/// passes. PALT: palettes; LEVL: everything but voxels; GRID: bricks of one shape, repeated when large. Unknown kinds
/// are skipped.
std::vector<uint8_t> levelToRubble(const Level& level);
Result<Level> levelFromRubble(std::span<const uint8_t> bytes, const std::string& name);

}  // namespace rubble
