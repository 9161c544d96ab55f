#pragma once
#include "runtime/core/pose.h"
#include "runtime/destruction/brush.h"
#include "runtime/world/edits/edit.h"

namespace rubble {

/// A world-space carve as an integer brush in the cells of a shape with this placement (grid corner -> world).
Brush resolveBrush(const CarveEdit& edit, const Pose& shapeToWorld, double voxelSize);

/// A sphere in the world that holds everything the edit can touch. A NaN in the edit gives a radius of -1.
struct BoundingSphere {
    glm::dvec3 center;
    double radius;
};
BoundingSphere boundingSphere(const CarveEdit& edit);

}  // namespace rubble
