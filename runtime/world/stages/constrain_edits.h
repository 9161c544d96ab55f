#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Hands a constraint over to physics, and wakes its bodies.
void apply(EditContext& context, const ConstrainEdit& edit);

}  // namespace rubble
