#pragma once
#include "samples/sandbox/shell/input.h"
#include "samples/support/display.h"

namespace sandbox {

/// Reads what the player does at a display; false: its window was closed. Nobody does anything in memory.
bool readDevices(rubble::Display& display, Input& input);

}  // namespace sandbox
