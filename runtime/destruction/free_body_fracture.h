#pragma once
#include <vector>

#include "runtime/destruction/stress_analysis.h"

namespace rubble {

/// A plane through a body at which it breaks: between the layers plane - 1 and plane of its cells along an axis.
struct FracturePlane {
    int axis = 0, plane = 0;
    double utilization = 0.0;  ///< stress over strength
    FailureMode cause = FailureMode::Tension;
    double width = 0.0;  ///< cells: square root of the area of the bounding rectangle of its faces
};

/// Where an impact breaks a body that is not anchored. Returns the plane of the highest utilization and others parallel
/// to it, sorted by plane, so that no part between them breaks again; empty if the body withstands the impact. `seed`
/// moves the other planes. The cost is three sums over the voxels. The algorithm is at the top of
/// free_body_fracture.cpp.
std::vector<FracturePlane> findFracturePlanes(const StressedShape& body, const ImpactForce& impact, uint32_t seed);

/// The sections of a plane, one for each brick, in the order of cellBefore().
std::vector<Section> sectionsInPlane(const VoxelGrid& grid, const StrengthTable& entries, int axis, int plane);

}  // namespace rubble
