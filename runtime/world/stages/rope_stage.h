#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Cuts every rope that a volume overlaps, in the middle of where it first does.
void cutRopes(EditContext& context, const CarveEdit& volume);
/// Parts a rope at `place`: the index of a point and the share of the segment to the next one. The first part keeps the
/// handle, or the second if nothing is left of the first. False: nothing is left at all, and nothing was done.
bool cutRope(EditContext& context, JointHandle rope, double place, JointBreak reason);
/// Changes the length of ropes that have a motor, by a step.
void updateWinches(EditContext& context);

}  // namespace rubble
