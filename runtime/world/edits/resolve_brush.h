#pragma once
#include "runtime/core/pose.h"
#include "runtime/destruction/brush.h"
#include "runtime/world/edits/edit.h"

namespace rubble {

/// A world-space carve as an integer brush in the cells of a shape. `shapeToWorld` maps the grid's corner to the world;
/// `voxelSize` in metres.
Brush resolveBrush(const CarveEdit& edit, const Pose& shapeToWorld, double voxelSize);

struct BoundingSphere {
    glm::dvec3 center;  ///< world
    double radius;      ///< metres
};
/// A sphere around everything that the edit can reach. A NaN in the edit gives a radius of -1.
BoundingSphere boundingSphere(const CarveEdit& edit);

}  // namespace rubble
