#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Carves every shape in reach, or the one that the edit names, and cuts ropes.
void apply(EditContext& context, const CarveEdit& edit);
/// How many voxels that would remove from the world as it is. A stale shape has none.
uint64_t countCarved(const WorldData& world, const CarveEdit& edit);
/// Breaks fragments and dust out of every shape in reach, or the one that the edit names, and cuts ropes.
void apply(EditContext& context, const BreakEdit& edit);
/// Breaks, paints soot around the hole, and defers the push until the pieces exist.
void apply(EditContext& context, const ExplodeEdit& edit);

}  // namespace rubble
