#pragma once
#include "runtime/destruction/components.h"
#include "runtime/world/level/level.h"

namespace rubble {

/// A light with the extent of `voxels`, a component of `only`: the grid with just the voxels of that entry. In the
/// shape's frame. It is a capsule if they are a rod, an area if they are a plate, else a sphere: their principal
/// moments of inertia are those of a box whose sides decide. Local x is along the longest side, z along the thinnest.
/// The intensity is that of the glowing faces seen from far away, averaged over all directions (Cauchy: a quarter of
/// the surface).
Light fitLight(const LevelShape& shape, const VoxelGrid& only, const Component& voxels, const PaletteEntry& entry);

/// Makes a light group with one light of each connected component of glowing voxels of one palette entry that belongs
/// to no group. The component gets a palette entry of its own while there are free ones, else it shares one. Makes at
/// most level.autoLightGroups groups.
void fitLights(Level& level);

}  // namespace rubble
