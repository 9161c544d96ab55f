#pragma once
#include <functional>

#include "samples/scenes/placement.h"

/// Parts that houses and shops are put together from: walls, windows, doors, floors, roofs.
namespace rubble::scenes {

inline constexpr int kStorey = 27;  ///< cells from floor to floor
inline constexpr int kDoorHeight = 21;
inline constexpr int kFooting = 3;  ///< cells that a building reaches into the ground

/// A wall's own coordinates: u along it as seen from outside, y up, k inward from its outer face.
struct WallFrame {
    ivec3 origin;
    ivec3 along;
    ivec3 inward;
    int length;
    ivec3 cell(int u, int y, int k) const { return origin + along * u + inward * k + ivec3(0, y, 0); }
};

/// The four outer walls of a box of cells: front (+z), right (+x), back (-z), left (-x). Corners belong to front and
/// back.
struct WallFrames {
    WallFrame front, right, back, left;
};
WallFrames wallFrames(ivec3 low, ivec3 high);

/// What an outer wall is made of: two cells of stone and one of plaster.
struct WallSwatches {
    Swatch stone, joint, plaster, dirty, wire, pipe;
    bool courses = true;  ///< bricks in courses with joints
};
void drawWall(Canvas& canvas, const WallFrame& wall, int low, int high, const WallSwatches& s);

struct WindowSwatches {
    Swatch frame, glass, sill, curtain, soot;
};
/// An opening of width x height whose lower left corner is at (u, y), with a frame, a cross, panes, a sill and a
/// lintel.
void drawWindow(Canvas& canvas, const WallFrame& wall, int u, int y, int width, int height, const WindowSwatches& s,
                bool curtains);
void drawDoor(Canvas& canvas, const WallFrame& wall, int u, int y, Swatch leaf, Swatch frame, Swatch knob);

struct FloorSwatches {
    Swatch board, seam, joist, ceiling;
};
/// Boards on joists, with a plaster ceiling hung below if there is one: fills y-3 .. y of the box, boards on top at y.
void drawFloor(Canvas& canvas, ivec3 low, ivec3 high, int y, const FloorSwatches& s, bool ceiling);

/// Studs every six cells between two skins of plaster, three cells thick; along x if high.x - low.x is longer than
/// three.
void drawInnerWall(Canvas& canvas, ivec3 low, ivec3 high, Swatch skin, Swatch otherSkin, Swatch stud, Swatch wire);

struct RoofSwatches {
    Swatch tile, tileDark, rafter, ridge, barge;
};
/// A gable roof over the box low..high (eaves included), its ridge along x: rows of tiles that step up two every three
/// cells, on rafters. Returns the height of the roof above y at depth z.
int gableHeight(int z, int lowZ, int highZ);
void drawGableRoof(Canvas& canvas, ivec3 low, ivec3 high, int y, const RoofSwatches& s);

}  // namespace rubble::scenes
