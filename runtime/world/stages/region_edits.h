#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Gives a shape another collision layer and mask, and wakes its body.
void apply(EditContext& context, const SetCollisionFilterEdit& edit);
/// Sets what a shape is touched as, and wakes its body.
void apply(EditContext& context, const SetCollisionShapeEdit& edit);
/// Adds a body of water if its numbers are valid.
void apply(EditContext& context, const AddWaterEdit& edit);
/// Erases a body of water.
void apply(EditContext& context, const RemoveWaterEdit& edit);
/// Adds a trigger if its numbers are valid; bodies inside are found in the same step.
void apply(EditContext& context, const AddTriggerEdit& edit);
/// Erases a trigger, without events for the bodies inside.
void apply(EditContext& context, const RemoveTriggerEdit& edit);

}  // namespace rubble
