#pragma once
#include "samples/scenes/building.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {

struct HouseStyle {
    int width = 112, depth = 96;  ///< of the walls, cells; the front (+z) has the door
    const SurfaceStyle* wall = &kBrick;
    const SurfaceStyle* roof = &kRoofTile;
    const SurfaceStyle* door = &kGreenWood;
    bool courses = true;  ///< bricks; else plastered outside
    bool rooms = true;    ///< inner walls, stairs, lamps and a porch; a plain shell with floors otherwise
};

/// Cells between the shape's low corner and the walls: eaves left, right and behind.
inline constexpr int kHouseMargin = 8;
/// Cells that the shape reaches in front of the walls, for the porch.
inline constexpr int kHouseFront = 24;

/// Where things are inside the detailed house, in cells of its shape.
struct HouseRooms {
    static constexpr int kGroundFloor = 5, kUpperFloor = 32;  ///< y of the first free cell above the boards
    static constexpr CellBox kLiving{{11, 5, 57}, {62, 28, 101}};
    static constexpr CellBox kKitchen{{11, 5, 11}, {62, 28, 54}};
    static constexpr CellBox kBedroom{{11, 32, 57}, {62, 55, 101}};
    static constexpr CellBox kBathroom{{11, 32, 11}, {62, 55, 54}};
    static constexpr CellBox kHall{{65, 5, 53}, {117, 28, 101}};
    static constexpr CellBox kStudy{{65, 32, 53}, {117, 55, 101}};
};

/// A static two-storey house named `name`; `cell` is where the low corner of its walls meets the ground.
void addHouse(Level& level, const std::string& name, ivec3 cell, const HouseStyle& style);

/// Loose furniture for the detailed house that stands at the same cell.
void addHouseFurniture(Level& level, ivec3 cell);

}  // namespace rubble::scenes
