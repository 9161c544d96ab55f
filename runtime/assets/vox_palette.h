#pragma once
#include <array>
#include <cstdint>

#include "runtime/assets/vox_file.h"
#include "runtime/voxel/palette.h"

namespace rubble {

/// How the stored colours become entries of a palette: entry = slot[stored index]. With IMAP it is the slot that
/// MagicaVoxel shows the colour in, so that rows of the palette keep their meaning.
std::array<uint8_t, 256> voxPaletteSlots(const VoxFile& file);

/// Colour, roughness, metal, opacity and emission of every entry, from RGBA and MATL. `used`: by entry; the others get
/// no material, so that paint can take them.
Palette voxPalette(const VoxFile& file, const std::array<bool, 256>& used, bool teardownPalette);

/// The breakable material that an entry most likely shows: glass, metal and glowing things by their properties, the
/// rest by colour (green foliage, brown wood, brick red, grey concrete, white plaster, bright plastic).
uint8_t guessMaterial(const PaletteEntry& entry);

}  // namespace rubble
