#pragma once
#include <array>
#include <cstdint>

#include "runtime/assets/vox_file.h"
#include "runtime/voxel/palette.h"

namespace rubble {

/// MagicaVoxel's emission has no unit. A fully emissive colour of power 0 gets this factor on its linear colour: such a
/// light is brighter than a sunlit wall of the default environment.
inline constexpr float kVoxEmissionScale = 5.0f;
/// The attribute of a MATL chunk by which our own files name the material of an entry.
inline constexpr const char* kVoxMaterialKey = "_rubble_material";

/// The palette index of each stored colour index. With an IMAP chunk it is the slot in which MagicaVoxel shows the
/// colour, so that rows of the palette keep their meaning.
std::array<uint8_t, 256> voxPaletteSlots(const VoxFile& file);

/// The palette of a file: colours from RGBA, roughness, metal, opacity and emission from MATL, materials by name, from
/// the Teardown rows or guessed. Entries that no voxel uses (`used`, by palette index) get no material, so that paint
/// can take them.
Palette voxPalette(const VoxFile& file, const std::array<bool, 256>& used, bool teardownPalette);

/// The breakable material that an entry most likely shows: glass, metal and light sources by their optical properties,
/// others by colour (green: foliage, brown: wood, red: brick, grey: concrete, white: plaster, vivid: plastic).
uint8_t guessMaterial(const PaletteEntry& entry);

}  // namespace rubble
