#pragma once
#include <string>

#include "samples/scenes/canvas.h"

namespace rubble::scenes {

/// A saloon car, 42 x 15 x 18 cells, its front toward +x: hollow, with seats, an engine, panes and lights. Its wheels
/// are part of the shape and do not turn.
LevelShape makeCar(std::string name, const struct SurfaceStyle& paint);
/// The same car to drive (see DriveEdit), its front toward +x: a body named `name` and four wheels on wheel joints. All
/// wheels are driven and braked, the front ones steered. `throttle`: the motors' share of full torque at the start.
/// Returns the index of the car's body in level.bodies.
size_t addDrivenCar(Level& level, const std::string& name, const SurfaceStyle& paint, ivec3 cell,
                    double throttle = 0.0);
/// A delivery van, 50 x 22 x 20 cells, its front toward +x, with an empty cargo space behind the seats.
LevelShape makeVan(std::string name, const SurfaceStyle& paint);

}  // namespace rubble::scenes
