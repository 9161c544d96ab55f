#pragma once
#include "samples/scenes/placement.h"

namespace rubble::scenes {

/// A street lamp 5.2 m high at a cell of the ground, its arm toward +z or, if `alongX`, toward -x. The head glows in a
/// group named as the lamp, with a cone of warm light under it. Returns the middle of its head in town cells.
ivec3 addStreetLight(Level& level, const std::string& name, ivec3 cell, bool alongX);

}  // namespace rubble::scenes
