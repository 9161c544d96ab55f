#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Replaces or adds rows of the table of materials; all shapes that are of them follow.
void apply(EditContext& context, const SetMaterialsEdit& edit);

}  // namespace rubble
