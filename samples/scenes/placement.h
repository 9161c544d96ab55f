#pragma once
#include <numbers>
#include <string>

#include "samples/scenes/canvas.h"

namespace rubble::scenes {

inline constexpr double kVoxel = 0.1;                           ///< metres
inline constexpr double kSqrtHalf = 0.5 * std::numbers::sqrt2;  ///< cosine and sine of 45 degrees, for quarter turns

/// Quarter turns about y, and a slight one for objects that were not placed exactly.
enum class Turn { None, Quarter, Half, ThreeQuarters, Askew };

/// Adds a static body with one shape; the shape's low corner lies at a cell of the level.
void addStatic(Level& level, LevelShape shape, ivec3 cell);
/// Adds a dynamic body with one shape; after the turn, the low corner of its bounds lies at the cell.
void addDynamic(Level& level, LevelShape shape, ivec3 cell, Turn turn = Turn::None);
/// Adds a dynamic body with one shape on an upright hinge of the shape `holder`, and returns that hinge. corner, cell:
/// of the level, where the low corners of the holder and of the leaf lie; pivot: in cells of the leaf.
Joint& addHinged(Level& level, const std::string& holder, ivec3 corner, LevelShape leaf, ivec3 cell,
                 const glm::dvec3& pivot);

/// Adds a light group that goes out when the share `threshold` of its voxels is gone. Returns its index plus one, the
/// number that palette entries store.
uint32_t addLightGroup(Level& level, std::string name, float threshold = 0.4f);
/// Adds a light to a shape, at a cell of its grid. Cones point down. `reach` and `radius` are in metres.
void addLight(Level& level, const std::string& shape, uint32_t group, LightKind kind, glm::dvec3 cell, glm::vec3 color,
              float reach, float radius);

inline constexpr glm::vec3 kWarmLight{1.0f, 0.72f, 0.43f};  ///< 2700 K, linear
/// The pose of a camera at `from` that looks at `to`, with y up.
Pose lookAt(glm::dvec3 from, glm::dvec3 to);

}  // namespace rubble::scenes
