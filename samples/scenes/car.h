#pragma once
#include "samples/scenes/canvas.h"

namespace rubble::scenes {

/// A saloon car, 42 x 15 x 18 cells, its front toward +x, hollow, with seats, an engine, panes and lamps; its wheels
/// stand still.
LevelShape makeCar(std::string name, const struct SurfaceStyle& paint);
/// The same car to drive (see DriveEdit), its front toward +x: a body named `name` and four wheels on axles of their
/// own, driven and braked all, the front ones steered. Returns the place of its body in level.bodies. `throttle`: how
/// it sets out.
size_t addDrivenCar(Level& level, const std::string& name, const SurfaceStyle& paint, ivec3 cell,
                    double throttle = 0.0);
/// A delivery van, 50 x 22 x 20 cells, its front toward +x, with crates' worth of room behind.
LevelShape makeVan(std::string name, const SurfaceStyle& paint);

}  // namespace rubble::scenes
