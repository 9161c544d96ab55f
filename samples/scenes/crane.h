#pragma once
#include "samples/scenes/placement.h"

namespace rubble::scenes {

/// A tower crane of 13 m whose mast's low corner stands at a cell: bodies "mast", "jib" and "wrecking ball". A hinge
/// with a motor turns the jib by slewSpeed (radians a second), which points toward +z at first, and a rope carries the
/// ball.
void addCrane(Level& level, ivec3 cell, double slewSpeed);

}  // namespace rubble::scenes
