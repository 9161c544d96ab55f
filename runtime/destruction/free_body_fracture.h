#pragma once
#include "runtime/destruction/stress_analysis.h"

namespace rubble {

/// Plane of a body's cells, from the low side: between the layers plane - 1 and plane along an axis.
struct FracturePlane {
    int axis = 0, plane = 0;
    double utilization = 0.0;  ///< stress over strength
    FailureMode cause = FailureMode::Tension;
    double width = 0.0;  ///< cells: the root of the rectangle around its faces
};

/// What a impact does to a body that nothing holds: each part follows as fast as the whole does, and the plane between
/// two parts passes on what that takes. `planes` sorted by place along one axis: the largest loaded, and others, by
/// `seed`, so that what is left between them bears the impact: a beam's bending goes with the square of its length.
/// Empty if it bears it whole. Costs three sums a voxel.
std::vector<FracturePlane> findFracturePlanes(const StressedShape& body, const ImpactForce& impact, uint32_t seed);

/// The sections of a plane, brick by brick, in the order of cellBefore().
std::vector<Section> sectionsInPlane(const VoxelGrid& grid, const StrengthTable& entries, int axis, int plane);

}  // namespace rubble
