#pragma once
#include "runtime/destruction/components.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// A light of the size and place of a component of `only`, the shape's voxels of that entry, in their shape's frame: a
/// capsule if they are a rod, an area if they are a plate, else a sphere. Its local z is along the thinnest axis, x
/// along the longest. Its intensity is that of the voxels' faces seen from afar, averaged over all directions.
Light fitLight(const LevelShape& shape, const VoxelGrid& only, const Component& voxels, const PaletteEntry& entry);

/// Makes a light group of each connected set of glowing voxels of one palette entry that belongs to none, with one
/// light. The set gets an entry of its own while its palette has free ones, else shares it. Stops at
/// level.autoLightGroups.
void fitLights(Level& level);

}  // namespace rubble
