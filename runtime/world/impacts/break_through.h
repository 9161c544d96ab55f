#pragma once
#include <span>

#include "runtime/world/impacts/impact_damage.h"

namespace rubble {

/// Gives bodies that break through something the rest of their momentum back. A pane of a static body, or a wall that a
/// hole goes right through, takes no more impulse than its breaking needs. What is too large for the hole hits its rim
/// in the next step. `damage`: what impactDamage() made of the impacts; impulses are appended to it. A body of which
/// the damage may break something off gets its velocities back before that, so that all its pieces go on.
void addBreakThroughImpulses(const WorldData& world, std::span<const Impact> impacts, Edits& damage);

}  // namespace rubble
