#pragma once
#include "runtime/destruction/load_analysis.h"

namespace rubble {

/// Plane of a body's cells, from the low side: between the layers plane - 1 and plane along an axis.
struct BodyPlane {
    int axis = 0, plane = 0;
    double share = 0.0;  ///< stress over strength
    LoadFailure cause = LoadFailure::Tension;
    double width = 0.0;  ///< cells: the root of the rectangle around its faces
};

/// What a blow does to a body that nothing holds: each part follows as fast as the whole does, and the plane between two parts
/// passes on what that takes. `planes` sorted by place along one axis: the most loaded, and others, by `seed`, so that what
/// is left between them bears the blow: a beam's bending goes with the square of its length. Empty if it bears it whole.
/// Costs three sums a voxel.
std::vector<BodyPlane> breakingPlanes(const LoadedShape& body, const LoadBlow& blow, uint32_t seed);

/// The sections of a plane, brick by brick, in the order of cellBefore().
std::vector<Section> sectionsOf(const VoxelGrid& grid, const LoadEntries& entries, int axis, int plane);

}  // namespace rubble
