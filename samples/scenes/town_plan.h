#pragma once
#include <glm/vec3.hpp>

/// Positions in the town, in cells; the demolition script aims at them. x points to the right, z toward the camera, and
/// y = 0 is the height of the lawns.
namespace rubble::scenes::plan {

inline constexpr glm::ivec3 kHouse{180, 0, 296};  ///< low corner of its walls, 112 x 96
inline constexpr glm::ivec3 kShop{352, 0, 262};   ///< low corner of its walls, 120 x 100
inline constexpr glm::ivec3 kTower{490, 0, 206};  ///< low corner of its legs' square, 48 x 48
inline constexpr glm::ivec3 kWall{138, 0, 438};   ///< concrete wall along x
inline constexpr int kWallLength = 112, kWallHeight = 12;
inline constexpr glm::ivec3 kCornerStreetLight{304, 0, 456};
inline constexpr glm::ivec3 kRedCar{196, -2, 474};

inline constexpr int kStreetLow = 470, kStreetHigh = 552;  ///< z of the street along x
inline constexpr int kSideLow = 28, kSideHigh = 110;       ///< x of the street along z
inline constexpr int kSideEnd = 150;                       ///< z of that street's end
inline constexpr int kPavement = 24;

}  // namespace rubble::scenes::plan
