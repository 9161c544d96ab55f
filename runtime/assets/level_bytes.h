#pragma once
#include <cstdint>
#include <vector>

#include "runtime/assets/byte_reader.h"
#include "runtime/assets/palette_list.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// The bytes of all fields of a level except its voxels. Its palettes are added to the list and written as their
/// numbers. `memory`: gets what reading them takes (MemoryBudget).
std::vector<uint8_t> levelToBytes(const Level& level, PaletteList& palettes, uint64_t* memory = nullptr);
/// Reads such bytes. The grids have their sizes and no voxels. Fails in the reader.
Level levelFromBytes(ByteReader& in, const std::vector<PaletteRef>& palettes);

/// The bytes of palettes: their number, then 256 entries each.
std::vector<uint8_t> palettesToBytes(const std::vector<PaletteRef>& palettes);
/// Reads such bytes. Fails in the reader.
std::vector<PaletteRef> palettesFromBytes(ByteReader& in);

/// Appends a brick: its position in bricks (3 x 16 bits), its kind (8 bits: full of one entry, one entry and an
/// occupancy mask, or 512 entries; plus 4 if painted), its entries, and 512 bytes of paint if painted. Equal bricks
/// give equal bytes.
void appendBrick(std::vector<uint8_t>& out, glm::ivec3 position, const Brick& brick);
/// Puts the next brick into a grid. Fails in the reader if it lies outside the grid, is empty, or is there already.
void readBrick(ByteReader& in, VoxelGrid& grid);

}  // namespace rubble
