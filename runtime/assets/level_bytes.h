#pragma once
#include <cstdint>
#include <vector>

#include "runtime/assets/byte_reader.h"
#include "runtime/assets/palette_list.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// All fields of a level but voxels, in bytes; its palettes are added to the list and stand as their numbers.
std::vector<uint8_t> levelToBytes(const Level& level, PaletteList& palettes);
/// Grids come back empty, with their sizes. Fails in the reader.
Level levelFromBytes(ByteReader& in, const std::vector<PaletteRef>& palettes);

std::vector<uint8_t> palettesToBytes(const std::vector<PaletteRef>& palettes);
std::vector<PaletteRef> palettesFromBytes(ByteReader& in);

/// A brick and its place. Equal bricks give equal bytes.
void appendBrick(std::vector<uint8_t>& out, glm::ivec3 position, const Brick& brick);
/// Puts the next brick into the grid; refuses what lies outside it, comes twice or is empty.
void readBrick(ByteReader& in, VoxelGrid& grid);

}  // namespace rubble
