#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "runtime/assets/vox_file.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// The one palette of a MagicaVoxel file for the shapes of a level, and for each shape its entries in it.
struct VoxExportPalette {
    Palette entries;
    std::vector<std::array<uint8_t, 256>> slots;  ///< for each shape, in the order of `shapes`
    std::map<int32_t, VoxAttributes> materials;   ///< of entries that a MATL chunk describes
    std::vector<std::string> lost;                ///< what the file cannot hold, for people
};
/// Merges the palettes: entries keep their numbers where they can.
VoxExportPalette voxExportPalette(const std::vector<const LevelShape*>& shapes, const MaterialTable& materials);

}  // namespace rubble
