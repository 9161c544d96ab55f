#pragma once
#include "runtime/core/pose.h"
#include "runtime/core/world_box.h"
#include "runtime/world/objects/world_objects.h"

namespace rubble {

// Poses of what hangs on bodies, all in world space and metres. The handles must be live.

/// The frame of a shape's grid: maps the grid's corner to the world.
Pose shapeToWorld(const WorldObjects& objects, ShapeHandle shape);
/// A light's frame. A light without a live shape is placed in the world itself.
Pose lightToWorld(const WorldObjects& objects, const Light& light);
/// The frame of a joint's end. An end without a live shape is placed in the world itself.
Pose jointToWorld(const WorldObjects& objects, const JointEnd& end);
/// The world box around a shape's whole grid, empty cells included.
WorldBox gridBounds(const WorldObjects& objects, ShapeHandle shape);

}  // namespace rubble
