#pragma once
#include <array>
#include <cstdint>

#include "runtime/assets/vox_file.h"
#include "runtime/voxel/palette.h"

namespace rubble {

/// The palette index of each stored colour index. With an IMAP chunk it is the slot in which MagicaVoxel shows the
/// colour, so that rows of the palette keep their meaning.
std::array<uint8_t, 256> voxPaletteSlots(const VoxFile& file);

/// The palette of a file: colours from RGBA, roughness, metal, opacity and emission from MATL, materials from the
/// Teardown rows or guessed. Entries that no voxel uses (`used`, by palette index) get no material, so that paint can
/// take them.
Palette voxPalette(const VoxFile& file, const std::array<bool, 256>& used, bool teardownPalette);

/// The breakable material that an entry most likely shows: glass, metal and light sources by their optical properties,
/// others by colour (green: foliage, brown: wood, red: brick, grey: concrete, white: plaster, vivid: plastic).
uint8_t guessMaterial(const PaletteEntry& entry);

}  // namespace rubble
