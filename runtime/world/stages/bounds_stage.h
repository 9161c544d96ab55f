#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Turns free bodies that have left the bounds to dust, in slot order, if BoundsSettings say so.
void enforceBounds(EditContext& context);

}  // namespace rubble
