#pragma once
#include "runtime/world/edits/edit.h"
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Takes over settings, and journals them if they are others.
void apply(EditContext& context, const SettingsEdit& edit);
/// Takes over where the world ends, and journals it if it is elsewhere.
void apply(EditContext& context, const SetBoundsEdit& edit);

}  // namespace rubble
