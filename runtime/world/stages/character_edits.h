#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Adds a character if its numbers are valid.
void apply(EditContext& context, const AddCharacterEdit& edit);
/// Erases a character.
void apply(EditContext& context, const RemoveCharacterEdit& edit);
/// Sets what a character wants from now on.
void apply(EditContext& context, const MoveCharacterEdit& edit);
/// Puts a character somewhere else; it stands on nothing until physics finds its ground.
void apply(EditContext& context, const TeleportCharacterEdit& edit);

}  // namespace rubble
