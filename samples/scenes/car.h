#pragma once
#include "samples/scenes/canvas.h"

namespace rubble::scenes {

/// A saloon car, 42 x 15 x 18 cells, its front toward +x, hollow, with seats, an engine, panes and lamps.
LevelShape makeCar(std::string name, const struct Recipe& paint);
/// A delivery van, 50 x 22 x 20 cells, its front toward +x, with crates' worth of room behind.
LevelShape makeVan(std::string name, const Recipe& paint);

}  // namespace rubble::scenes
