#pragma once
#include "runtime/world/history/frame_changes.h"
#include "runtime/world/objects/world_objects.h"

namespace rubble {

/// Reduces a journal to what it means for one who knows the world before the step and the world after it: bodies and
/// shapes that were made and are gone again are not in it, and each other one is at most once in the lists of the
/// created and of the destroyed.
void keepNetChanges(FrameChanges& changes, const WorldObjects& after);

}  // namespace rubble
