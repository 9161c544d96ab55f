#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "runtime/voxel/paint_colors.h"
#include "runtime/voxel/palette.h"
#include "runtime/voxel/used_entries.h"

namespace rubble {

/// Adds to `into` the entries of `from` that its voxels use: each takes an equal entry, else a free one, which has no
/// material and no voxel of `into`. Returns the entry of `into` by entry of `from`; nothing if too few are free, and
/// then `into` may have changed.
std::optional<std::array<uint8_t, 256>> mergePalette(Palette& into, UsedEntries usedInto, const Palette& from,
                                                     const UsedEntries& usedFrom);

/// Adds the paint colours of `from` to `into`. Returns the number of each in `into`, both counted from 1. A colour for
/// which none is left becomes the nearest in sRGB.
std::array<uint8_t, 16> mergePaintColors(PaintColors& into, const PaintColors& from);

}  // namespace rubble
