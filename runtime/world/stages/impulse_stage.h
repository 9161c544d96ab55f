#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Defers an impulse until the pieces of this step exist.
void apply(EditContext& context, const ImpulseEdit& edit);

/// Gives bodies that lost voxels the velocity of their new centre of mass, v + w x r, so that each part moves as it did
/// within the whole: a split conserves momentum.
void updateVelocities(EditContext& context);
/// Applies the impulses of this step's edits and explosions, in their order.
void applyImpulses(EditContext& context);

}  // namespace rubble
