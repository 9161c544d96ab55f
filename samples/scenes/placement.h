#pragma once
#include <string>

#include "samples/scenes/canvas.h"

namespace rubble::scenes {

inline constexpr double kVoxel = 0.1;  ///< metres

/// Quarter turns about y, and a slight one for things that people put down by hand.
enum class Turn { None, Quarter, Half, ThreeQuarters, Askew };
glm::dquat turnRotation(Turn turn);

/// A static body with one shape whose corner lies at a cell of the town.
void addStatic(Level& level, LevelShape shape, ivec3 cell);
/// A dynamic body with one shape; its turned bounds' low corner lies at the cell.
void addDynamic(Level& level, LevelShape shape, ivec3 cell, Turn turn = Turn::None);

/// A new light group that goes out when the share `threshold` of its voxels is gone; returns its index plus one, as
/// palette entries want it.
uint32_t addLightGroup(Level& level, std::string name, float threshold = 0.4f);
/// A light on a shape, at a cell of its grid. Cones look down.
void addLight(Level& level, const std::string& shape, uint32_t group, LightKind kind, glm::dvec3 cell, glm::vec3 color,
              float reach, float radius);

inline constexpr glm::vec3 kWarmLight{1.0f, 0.72f, 0.43f};  ///< 2700 K, linear
/// `from` at a point, looking at another, y up.
Pose lookAt(glm::dvec3 from, glm::dvec3 to);

}  // namespace rubble::scenes
