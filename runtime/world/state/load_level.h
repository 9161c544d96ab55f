#pragma once
#include <span>

#include "runtime/world/level/level.h"
#include "runtime/world/state/world_data.h"

namespace rubble {

/// Replaces everything by the level; handles from before go stale. Hidden shapes are left out. Static shapes without
/// anchors are anchored by their lowest layer of voxels (anchorByDefault()). Joints that find no voxel to hold on to
/// are left out and logged.
void loadLevel(WorldData& world, const Level& level);

/// A shape of a world for that body, not on it yet. Without anchors: see anchorByDefault().
Shape makeShape(const LevelShape& from, const Body& body, const MaterialTable& materials);
/// A shape without anchors on a static body is anchored by its lowest layer of voxels, as it stands in the world: the
/// first one with a voxel from that side of its grid which faces the ground most, as a box over the whole grid; of an
/// empty grid that side's first layer.
void anchorByDefault(Shape& shape, const Body& body);
/// To be called with shapes that edits have created, when those of the step are done: widens WorldState::made, unless
/// the level has bounds.
void includeMade(WorldData& world, ShapeHandle shape);
/// To be called when the edits of a step are done, with FrameChanges::shapesCreated, which has all static shapes that
/// came to be, became static, moved or got another grid: widens WorldState::footprint around those that are static, and
/// `made` as includeMade() does.
void includeStatics(WorldData& world, std::span<const ShapeHandle> shapes);
/// The palette of shapes that name none: entry i is of material i, entries behind the last material of the last. Glass,
/// if it is the first material, changes places with "generic": entry 1 is what hosts take without a thought.
PaletteRef materialPalette(const MaterialTable& materials);

}  // namespace rubble
