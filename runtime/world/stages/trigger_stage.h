#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Finds which bodies entered and left triggers: bodies that moved or changed, against the triggers near them and those
/// they were in; and everything near a trigger that is new.
void updateTriggers(EditContext& context);

}  // namespace rubble
