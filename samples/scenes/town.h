#pragma once
#include "runtime/world/level.h"

namespace rubble::scenes {

/// The town corner, late in the day: a furnished brick house on a corner lot, a shop, a water tower, streets. 64 x 64 m.
Level town();

/// The streets and the far side of them with an empty lot, for `model` to stand on: centred, on the pavement's level, its
/// bodies, lights and groups appended after the street's.
Level streetStage(const Level& model);

/// World bounds of a level's bodies in metres.
struct Bounds {
    glm::dvec3 low{0.0}, high{0.0};
};
Bounds levelBounds(const Level& level);

}  // namespace rubble::scenes
