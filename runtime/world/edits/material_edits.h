#pragma once
#include <cstdint>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/voxel/material.h"
#include "runtime/voxel/palette.h"

namespace rubble {

/// Replaces entries of a shape's palette: its voxels look, weigh, break and burn as the new ones say from this step on.
/// Entries of a light group that is out do not shine. Refused, and logged, if one names a material or a light group
/// that is not there.
struct SetPaletteEdit {
    ShapeHandle shape;
    bool all = false;   ///< also of all shapes whose palette has the same entries as that of the shape
    uint8_t first = 1;  ///< the entry that the first row replaces, 1 to 255
    std::vector<PaletteEntry> entries;
};

/// Replaces rows of the world's table of materials, or adds rows behind its last one. What is of a material weighs,
/// breaks and burns as its row says from this step on. Rows are never removed: palettes hold their numbers. Refused,
/// and logged, if it leaves rows out between the last one and the first new one.
struct SetMaterialsEdit {
    uint8_t first = 1;  ///< the row that the first of `materials` replaces, 1 to 255
    std::vector<Material> materials;
};

}  // namespace rubble
