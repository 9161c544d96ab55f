#pragma once
#include "runtime/core/random.h"
#include "runtime/world/edits/edit.h"
#include "runtime/world/world.h"

namespace rubble {

/// The town with hoppers in the sky, groups of small pieces that sleep until they are poured; and the machines beside
/// it.
Level makeStressLevel(uint64_t seed);
/// Stress analysis on, and debris budgets that keep an endless demolition bounded.
WorldSettings stressSettings();

/// Random edits at a random shape: carves, explosions, impacts, impulses, paint, heat, water, a hopper that pours; or a
/// command to a machine.
Edits randomEdits(const World& world, Random& random);

}  // namespace rubble
