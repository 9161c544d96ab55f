#pragma once
#include <span>

#include "runtime/world/level/level.h"
#include "runtime/world/state/world_data.h"

namespace rubble {

/// Replaces everything by the level; handles from before go stale. Hidden shapes are left out. Static shapes without
/// anchors are anchored by their lowest layer of voxels. Joints that find no voxel to hold on to are left out and
/// logged.
void loadLevel(WorldData& world, const Level& level);

/// A shape of a world, on no body yet. isStatic: it is anchored, by its lowest layer of voxels if it says nothing else.
Shape makeShape(const LevelShape& from, bool isStatic, const MaterialTable& materials);
/// The lowest layer of cells with a voxel, as a box over the whole grid; of an empty grid its lowest layer.
CellBox bottomLayer(const VoxelGrid& grid);
/// To be called when an edit has created a shape: widens WorldState::made, unless the level has bounds.
void includeMade(WorldData& world, ShapeHandle shape);
/// To be called when the edits of a step are done, with FrameChanges::shapesCreated, which has all static shapes that
/// came to be, became static, moved or got another grid: widens WorldState::footprint around those that are static.
void includeStatics(WorldData& world, std::span<const ShapeHandle> shapes);
/// The palette of shapes that name none: entry i is of material i, entries behind the last material of the last. Glass,
/// if it is the first material, changes places with "generic": entry 1 is what hosts take without a thought.
PaletteRef materialPalette(const MaterialTable& materials);

}  // namespace rubble
