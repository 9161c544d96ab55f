#pragma once
#include "samples/scenes/placement.h"

namespace rubble::scenes {

/// A petrol station, 200 x 150 cells, which faces -z: a lit canopy on four columns, pumps that go off when they are
/// damaged (bodies with shapes of the tag "explosive"), and a shop behind. `cell` is the low corner of its yard.
void addPetrolStation(Level& level, ivec3 cell);

}  // namespace rubble::scenes
