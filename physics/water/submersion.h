#pragma once
#include <glm/vec3.hpp>
#include <span>

#include "physics/bodies/dynamic_body.h"
#include "runtime/world/objects/water.h"

namespace rubble {

/// The part of some voxels that is in water.
struct Submersion {
    double volume = 0.0;     ///< m3 in the water
    double waterline = 0.0;  ///< m2 of the surface that the voxels cut
    glm::dvec3 moment{0.0};  ///< volume times its centroid, from the collider's origin, world axes
};

/// Several waters.
using Waters = std::span<const Water* const>;

/// Adds the part of a voxel part that is in a water: above its bottom, below its surface and within its outline, and
/// not in a water of `before`. origin: of the collider, world. See submersion.cpp for the method.
void addSubmersion(const ColliderPart& part, const CellTransform& cells, glm::dvec3 origin, const Water& water,
                   Submersion& sum, Waters before = {});

/// The part of a unit cube that lies below a plane.
struct CubeBelowPlane {
    double volume = 0.0;     ///< 0 to 1
    glm::dvec3 moment{0.0};  ///< volume times its centroid, from the cube's low corner
};
/// Of the points x of the unit cube with n . x <= d; n must not be zero. Exact to 1e-6.
CubeBelowPlane cubeBelowPlane(glm::dvec3 n, double d);

}  // namespace rubble
