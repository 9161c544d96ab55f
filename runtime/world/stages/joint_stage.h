#pragma once
#include <span>
#include <vector>

#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Makes a joint if its ends find voxels to hold on to.
void apply(EditContext& context, const AddJointEdit& edit);
/// Removes or breaks a joint; a rope that is cut or torn parts in two.
void apply(EditContext& context, const RemoveJointEdit& edit);
/// Sets motor, friction and steering of a joint.
void apply(EditContext& context, const SetJointMotorEdit& edit);
/// Frees a rope's end from a shape. Removes joints of other kinds, and a rope that nothing holds any more.
void apply(EditContext& context, const DetachJointEdit& edit);

/// Erases a joint and lists it in the journal.
void breakJoint(EditContext& context, JointHandle joint, JointBreak reason, glm::dvec3 position);
/// Moves an end into another frame of cells, whose cell 0 is at `cellOffset` of those that it is in now.
void moveJointEnd(EditContext& context, JointHandle joint, size_t end, ShapeHandle to, glm::ivec3 cellOffset);
/// Moves the ends whose voxels came off into the children of a split.
void moveJoints(EditContext& context, const ShapeSplit& split);
/// Moves the ends on a shape whose frame of cells now begins at cell `low` of the old one.
void reframeJoints(EditContext& context, ShapeHandle shape, glm::ivec3 low);
/// Releases all ends on a shape that is about to go: rope ends hang free, other joints break.
void releaseJointsOf(EditContext& context, ShapeHandle shape);
/// Releases the ends whose voxels this step removed.
void releaseUnheldJoints(EditContext& context);

/// A copy of a list of the joint index, to go through while joints change.
std::vector<JointHandle> copyOf(std::span<const JointHandle> joints);

}  // namespace rubble
