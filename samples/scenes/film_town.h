#pragma once
#include <cstdint>

#include "runtime/world/level/level.h"

namespace rubble {

/// The town of makeTown() with an office tower behind the house, for the film of the sandbox.
Level makeFilmTown(uint64_t seed);

}  // namespace rubble
