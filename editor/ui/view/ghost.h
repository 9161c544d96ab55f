#pragma once
#include "editor/ui/view/picking.h"
#include "editor/ui/view/wires.h"

namespace editor {

/// Shows which cells a stroke would cover, before it is drawn.
void drawGhost(Wires& wires, const rubble::World& world, const Brush& brush, const Stroke& stroke);

}  // namespace editor
