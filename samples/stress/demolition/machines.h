#pragma once
#include "runtime/core/random.h"
#include "runtime/world/edits/edit.h"
#include "runtime/world/world.h"

namespace rubble {

/// Adds a yard with everything that moves by more than contacts: cars, a gallows with ropes, a winch, a chain and a
/// motor, a basin with things that float, and characters.
void addMachines(Level& level);

/// A random command to a car, a winch, a motor or a character.
Edits randomCommand(const World& world, Random& random);

}  // namespace rubble
