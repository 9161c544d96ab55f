#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Makes, moves or replaces what a hand holds.
void apply(EditContext& context, const GrabEdit& edit);
/// Removes what a hand holds and pushes it.
void apply(EditContext& context, const ReleaseEdit& edit);

}  // namespace rubble
