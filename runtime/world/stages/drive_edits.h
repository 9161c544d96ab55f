#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Drives the wheels of a body: motor, brake and steering, each within its WheelSettings.
void apply(EditContext& context, const DriveEdit& edit);
/// Turns the wheels that are not where they were steered to, by their steerRate.
void updateSteering(EditContext& context);

}  // namespace rubble
