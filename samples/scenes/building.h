#pragma once
#include <functional>
#include <string>

#include "samples/scenes/placement.h"
#include "samples/scenes/surface_styles.h"

/// Parts of houses and shops: walls, windows, doors, floors, roofs. All lengths are in cells of 0.1 m.
namespace rubble::scenes {

inline constexpr int kStorey = 27;  ///< cells from floor to floor
inline constexpr int kDoorHeight = 21, kDoorWidth = 9;
inline constexpr int kFooting = 3;  ///< depth of a building's foot in the ground

/// The coordinates of a wall: u along it as seen from outside, y up, k inward from its outer face.
struct WallFrame {
    ivec3 origin;
    ivec3 along;
    ivec3 inward;
    int length;
    /// The canvas cell of a point of the wall.
    ivec3 cell(int u, int y, int k) const { return origin + along * u + inward * k + ivec3(0, y, 0); }
};

/// The four outer walls of a box of cells: front (+z), right (+x), back (-z), left (-x). Corners belong to front and
/// back.
struct WallFrames {
    WallFrame front, right, back, left;
};
/// The outer walls of the box low..high; high is exclusive, and y is not used.
WallFrames wallFrames(ivec3 low, ivec3 high);

/// What an outer wall is made of: two cells of stone and one of plaster.
struct WallSwatches {
    Swatch stone, joint, plaster, dirty, wire, pipe;
    bool courses = true;  ///< bricks in courses with joints
};
/// Draws a wall from y = low up to y = high (exclusive), with wires and a pipe behind the plaster.
void drawWall(Canvas& canvas, const WallFrame& wall, int low, int high, const WallSwatches& s);

struct WindowSwatches {
    Swatch frame, glass, sill, curtain, soot;
};
/// An opening of width x height whose lower left corner is at (u, y), with a frame, a cross, panes, a sill and a
/// lintel.
void drawWindow(Canvas& canvas, const WallFrame& wall, int u, int y, int width, int height, const WindowSwatches& s,
                bool curtains);
/// A door kDoorWidth wide in a frame, which does not open; its lower left corner is at (u, y).
void drawDoor(Canvas& canvas, const WallFrame& wall, int u, int y, Swatch leaf, Swatch frame, Swatch knob);
/// The opening of such a door, with its frame.
void drawDoorFrame(Canvas& canvas, const WallFrame& wall, int u, int y, Swatch frame);
/// The leaf of such a door in a wall along x, for addHinged(): 3 cells deep with its knobs.
LevelShape makeDoorLeaf(std::string name, const SurfaceStyle& style);

struct FloorSwatches {
    Swatch board, seam, joist, ceiling;
};
/// Boards on joists over the box low..high, in the layers y - 3 to y: boards at y, and at y - 3 a plaster ceiling if
/// `ceiling`.
void drawFloor(Canvas& canvas, ivec3 low, ivec3 high, int y, const FloorSwatches& s, bool ceiling);

/// Studs every six cells between two skins of plaster, three cells thick. It runs along the longer side of the box.
void drawInnerWall(Canvas& canvas, ivec3 low, ivec3 high, Swatch skin, Swatch otherSkin, Swatch stud, Swatch wire);

struct RoofSwatches {
    Swatch tile, tileDark, rafter, ridge, barge;
};
/// Height of a gable roof over its eaves at depth z, for a roof from lowZ to highZ (exclusive).
int gableHeight(int z, int lowZ, int highZ);
/// A gable roof over the box low..high (eaves included) from height y, its ridge along x: rows of tiles on rafters,
/// each row two cells higher than the one before it.
void drawGableRoof(Canvas& canvas, ivec3 low, ivec3 high, int y, const RoofSwatches& s);

}  // namespace rubble::scenes
