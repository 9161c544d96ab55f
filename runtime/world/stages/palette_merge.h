#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "runtime/voxel/paint_colors.h"
#include "runtime/voxel/palette.h"
#include "runtime/world/stages/entry_counts.h"

namespace rubble {

/// Adds the entries of `from` that `used` counts to a palette, over equal and free entries: the entry of `into` for
/// each of `from`. Nothing if there are not enough free ones; `into` may be changed then.
std::optional<std::array<uint8_t, 256>> mergePalette(Palette& into, const Palette& from, const EntryCounts& used);

/// Adds paint colours: the slot, counted from 1, of `into` for each of `from`. A colour for which no slot is left
/// becomes the nearest by squared distance in sRGB.
std::array<uint8_t, 16> mergePaintColors(PaintColors& into, const PaintColors& from);

}  // namespace rubble
