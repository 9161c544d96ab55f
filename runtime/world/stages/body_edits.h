#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Changes pose, motion or sleep of a body.
void apply(EditContext& context, const SetBodyEdit& edit);
/// Erases a body.
void apply(EditContext& context, const DestroyBodyEdit& edit);

}  // namespace rubble
