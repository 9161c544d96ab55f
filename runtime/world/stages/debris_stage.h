#pragma once
#include "runtime/world/stages/edit_context.h"

namespace rubble {

/// Settles pieces that have slept for DebrisSettings::settleSteps, then despawns pieces until all budgets of
/// DebrisSettings hold, in the order of DebrisQueue. Despawned voxels become dust.
void enforceDebrisBudgets(EditContext& context);

}  // namespace rubble
