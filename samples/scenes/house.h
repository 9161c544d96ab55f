#pragma once
#include <string>

#include "samples/scenes/building.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {

struct HouseStyle {
    int width = 112, depth = 96;  ///< of the walls, in cells; the door is in the front (+z)
    const SurfaceStyle* wall = &kBrick;
    const SurfaceStyle* roof = &kRoofTile;
    const SurfaceStyle* door = &kGreenWood;
    bool courses = true;  ///< bricks in courses; else plastered outside
    bool rooms = true;    ///< inner walls, stairs, lights and a porch; else a shell with floors
};

/// Cells between the shape's low corner and the walls: eaves left, right and behind.
inline constexpr int kHouseMargin = 8;
/// Cells of the shape in front of the walls, for the porch.
inline constexpr int kHouseFront = 24;

/// Where the rooms of the detailed house are, in cells of its shape.
struct HouseRooms {
    static constexpr int kGroundFloor = 5, kUpperFloor = 32;  ///< y of the first free cell above the boards
    static constexpr CellBox kLiving{{11, 5, 57}, {62, 28, 101}};
    static constexpr CellBox kBedroom{{11, 32, 57}, {62, 55, 101}};
    static constexpr CellBox kHall{{65, 5, 53}, {117, 28, 101}};
};

/// A static two-storey house; `cell` is where the low corner of its walls meets the ground.
void addHouse(Level& level, const std::string& name, ivec3 cell, const HouseStyle& style);

/// Furniture, each piece a dynamic body, for a detailed house at the same cell.
void addHouseFurniture(Level& level, ivec3 cell);

}  // namespace rubble::scenes
