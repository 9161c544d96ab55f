#pragma once
#include <rubble/rubble.h>

namespace rubble_godot {

/// What Godot does for Rubble: its log, and the functions of the GL that its window has.
rubble_host hostServices();

}  // namespace rubble_godot
