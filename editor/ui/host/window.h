#pragma once
#include <string>

#include "editor/ui/host/stage.h"

namespace editor {

/// Opens the window with a level, an empty path: an empty one, and runs it until it is closed. An error says why there
/// is none; empty: all is well.
std::string runWindow(StageSettings settings, const std::string& level);
/// Whether there is a display to open it on.
bool hasDisplay();

}  // namespace editor
