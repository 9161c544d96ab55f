#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// See the edit.
void apply(EditContext& context, const SetNameEdit& edit);
/// See the edit.
void apply(EditContext& context, const SetTagEdit& edit);
/// See the edit.
void apply(EditContext& context, const RemoveTagEdit& edit);
/// See the edit.
void apply(EditContext& context, const SetUserValueEdit& edit);
/// See the edit.
void apply(EditContext& context, const SetScriptsEdit& edit);

/// Gives a shape that came off another one a copy of its note, with where it came from; also without a note if
/// WorldSettings::keepOrigins.
void inheritNote(EditContext& context, ShapeHandle from, ShapeHandle piece);
/// Drops the notes of what the step has destroyed. At no cost without notes.
void dropNotes(EditContext& context);

}  // namespace rubble
