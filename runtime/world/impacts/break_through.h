#pragma once
#include <span>

#include "runtime/world/edits/edit.h"

namespace rubble {

class World;
struct Impact;

/// What breaks a pane of a static body, or a hole right through a wall, is stopped by no more than that takes: gives it
/// the rest of its momentum back. What is too large for the hole hits its rim next. `damage`: what World::damageFrom()
/// made of the impacts; the impulses go to its end.
void addBreakThroughImpulses(const World& world, std::span<const Impact> impacts, Edits& damage);

}  // namespace rubble
