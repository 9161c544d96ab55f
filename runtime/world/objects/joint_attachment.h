#pragma once
#include <string>

#include "runtime/world/objects/world_objects.h"

namespace rubble {

/// Fills in what a joint leaves open before it is inserted: for each end on a shape the voxel that holds it, the
/// nearest one to the end's frame within JointEnd::radius unless JointEnd::cell names a voxel; for a rope its length
/// and its points, on a straight line. Rotations are normalised. Returns what is wrong; empty: nothing.
std::string attachJoint(const WorldObjects& objects, Joint& joint);

/// Says what is wrong with the bodies of a joint whose ends are on these shapes (null: the world); empty: nothing. Only
/// a rope may have both ends on one body.
std::string jointBodiesError(JointKind kind, const Shape* first, const Shape* second);

/// Moves the frame of an end from the world into the shape that the end is on, as that is placed now. An end without a
/// live shape stays.
void placeEnd(const WorldObjects& objects, JointEnd& end);

/// A joint between two shapes, or a shape and the world (an empty handle), as they are placed now. `frame` is in the
/// world, and its x axis is the joint's.
Joint jointAt(const WorldObjects& objects, JointKind kind, ShapeHandle first, ShapeHandle second, const Pose& frame);

}  // namespace rubble
