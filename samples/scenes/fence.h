#pragma once
#include <string>

#include "samples/scenes/placement.h"

/// Walls, fences and gates. All stand kFenceFoot cells deep in the ground.
namespace rubble::scenes {

inline constexpr int kFenceFoot = 3;

/// A concrete wall along x with reinforcement inside, a coping and pilasters; thickness 3 cells.
LevelShape makeConcreteWall(std::string name, int length, int height);
/// A barred steel gate along x between two posts.
LevelShape makeGate(std::string name, int width, int height);
/// A picket fence along x or z.
LevelShape makePicketFence(std::string name, int length, int height, bool alongZ);

}  // namespace rubble::scenes
