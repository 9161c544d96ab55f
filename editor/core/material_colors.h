#pragma once
#include "editor/core/editor.h"

namespace editor {

/// Gives the entries of a shape that has just been made the colours of their materials, so that wood and brick are told
/// apart, and glass is clear. Carries out what is queued.
void colorByMaterial(Editor& editor, rubble_shape shape);

}  // namespace editor
