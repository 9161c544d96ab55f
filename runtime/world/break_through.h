#pragma once
#include <span>

#include "runtime/world/edit.h"

namespace rubble {

class World;
struct Impact;

/// What hits a pane of a static body and breaks it is stopped only by as much as the pane can bear: gives it the rest back.
/// `damage`: what World::damageFrom() made of the impacts; the impulses go to its end.
void addBreakThrough(const World& world, std::span<const Impact> impacts, Edits& damage);

}  // namespace rubble
