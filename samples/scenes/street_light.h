#pragma once
#include <string>

#include "samples/scenes/placement.h"

namespace rubble::scenes {

/// Adds a street light, 5.2 m high, at a cell of the ground. Its arm points toward +z or, if `alongX`, toward -x. The
/// head glows; it belongs to a light group of the same name, with a warm cone light. Returns the middle of the head, in
/// cells of the level.
ivec3 addStreetLight(Level& level, const std::string& name, ivec3 cell, bool alongX);

}  // namespace rubble::scenes
