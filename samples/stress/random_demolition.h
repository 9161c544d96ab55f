#pragma once
#include "runtime/core/random.h"
#include "runtime/world/edits/edit.h"
#include "runtime/world/world.h"

namespace rubble {

/// The town with hoppers in the sky: lots of small pieces, asleep until they are poured.
Level makeStressLevel(uint64_t seed);
/// Budgets under which demolition can go on for ever, and everything that can break on.
WorldSettings stressSettings();

/// What one player too many does to a world: carves, blasts, strikes, shoves, sprays, burns, wets and pours, where
/// something is.
Edits randomEdits(const World& world, Random& random);

}  // namespace rubble
