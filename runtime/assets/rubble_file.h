#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/assets/assets.h"

namespace rubble {

/// A baked level in memory: a chunk file (chunk_file.h) whose content hash is hashLevel(). Chunks: PALT, the palettes;
/// LEVL, everything but voxels; GRID, bricks of one shape, several for large shapes.
std::vector<uint8_t> levelToRubble(const Level& level);
/// Reads a baked level. `name`: of the file, for messages. Any bytes give a valid level or an error.
Result<Level> levelFromRubble(std::span<const uint8_t> bytes, const std::string& name);

}  // namespace rubble
