#pragma once
#include "runtime/voxel/mass_properties.h"
#include "runtime/world/objects/world_objects.h"

namespace rubble {

/// Mass (kg), centre (metres) and inertia (kg m2, about the centre) of all shapes of a live body, in the body's frame.
/// The shapes' tensors are moved to the common centre by the parallel axis theorem: I + m (r.r E - r rT).
MassProperties bodyMass(const WorldObjects& objects, BodyHandle body);
/// The same of some voxels of a shape, whose moments are in cells of its grid, in the grid's frame.
MassProperties massOf(const Shape& shape, const MassMoments& moments);

}  // namespace rubble
