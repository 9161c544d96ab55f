#include "samples/scenes/house.h"

#include <algorithm>

#include "runtime/core/random.h"

namespace rubble::scenes {
namespace {

constexpr int kFloor0 = kFooting + 1;  // boards of the ground floor
constexpr int kFloor1 = kFloor0 + kStorey;
constexpr int kFloor2 = kFloor1 + kStorey;  // the attic's
constexpr int kRoofBase = kFloor2 - 1;
constexpr int kEaves = 4;

struct HouseSwatches {
    HouseSwatches(Canvas& c, const HouseStyle& style)
        : concrete(c.addSurface(kConcrete)),
          white(c.addSurface(kWhiteWood)),
          timber(c.addSurface(kTimber)),
          door(c.addSurface(*style.door)),
          steel(c.addSurface(kDarkSteel)),
          plaster(c.addSurface(kPlaster)),
          green(c.addSurface(kWallpaperGreen)),
          rose(c.addSurface(kWallpaperRose)),
          tile(c.addSurface(kTileWhite)),
          rug(c.addSurface(kClothRed)),
          rugEdge(c.addSurface(kClothOchre)),
          rugBlue(c.addSurface(kClothTeal)),
          wire(c.addSurface(kWire)),
          pipe(c.addSurface(kCopperPipe)) {
        walls = {c.addSurface(*style.wall),
                 c.addSurface(style.courses ? kBrickJoint : *style.wall, 96),
                 plaster,
                 c.addSurface(*style.wall, 78),
                 wire,
                 pipe,
                 style.courses};
        windows = {white, c.addSurface(kGlass), concrete, c.addSurface(kClothCream), walls.dirty};
        floors = {c.addSurface(kFloorBoard), c.addSurface(kFloorSeam), timber, plaster};
        roof = {c.addSurface(*style.roof), c.addSurface(*style.roof, 84), timber, c.addSurface(*style.roof, 76), white};
    }
    Swatch concrete, white, timber, door, steel, plaster, green, rose, tile, rug, rugEdge, rugBlue, wire, pipe;
    WallSwatches walls;
    WindowSwatches windows;
    FloorSwatches floors;
    RoofSwatches roof;
};

struct HouseFrame {
    ivec3 low, high;  // of the walls
    WallFrames walls;
};

void drawGables(Canvas& canvas, const HouseFrame& frame, const HouseSwatches& s) {
    const int eaveLow = frame.low.z - kEaves, eaveHigh = frame.high.z + kEaves;
    for (const WallFrame* wall : {&frame.walls.left, &frame.walls.right})
        for (int u = 0; u < wall->length; ++u) {
            const int z = wall->cell(u, 0, 0).z;
            const int top = kRoofBase + gableHeight(z, eaveLow, eaveHigh);
            for (int y = kRoofBase; y < top; ++y)
                for (int k = 0; k < 2; ++k) {
                    const ivec3 cell = wall->cell(u, y, k);
                    const int shifted = u + (y % 2) * 2 + 400;
                    const bool joint = s.walls.courses && shifted % 4 == 0;
                    const uint32_t brick = hashCell(shifted / 4, y, 0, 42);
                    canvas.setEntry(cell, joint             ? PaletteBuilder::pickFor(s.walls.joint, brick)
                                          : s.walls.courses ? PaletteBuilder::pickFor(s.walls.stone, brick >> 8)
                                                            : PaletteBuilder::pick(s.walls.stone, cell));
                }
        }
    // An attic window in the gable that the camera sees.
    const WallFrame& left = frame.walls.left;
    drawWindow(canvas, left, left.length / 2 - 5, kFloor2 + 8, 10, 10, s.windows, false);
}

void drawShell(Canvas& canvas, const HouseFrame& frame, const HouseSwatches& s) {
    canvas.box({frame.low.x - 1, 0, frame.low.z - 1}, {frame.high.x + 1, kFooting - 1, frame.high.z + 1},
               s.concrete);  // below the lawn
    canvas.box({frame.low.x, kFooting - 1, frame.low.z}, {frame.high.x, kFloor0, frame.high.z}, s.concrete);
    for (const WallFrame* wall : {&frame.walls.left, &frame.walls.right, &frame.walls.back, &frame.walls.front})
        drawWall(canvas, *wall, kFloor0, kRoofBase + 2, s.walls);
    const ivec3 low(frame.low.x + 3, 0, frame.low.z + 3), high(frame.high.x - 3, 0, frame.high.z - 3);
    drawFloor(canvas, low, high, kFloor0, s.floors, false);
    drawFloor(canvas, low, high, kFloor1, s.floors, true);
    drawFloor(canvas, low, high, kFloor2, s.floors, true);
    drawGables(canvas, frame, s);
    drawGableRoof(canvas, {frame.low.x - 3, 0, frame.low.z - kEaves}, {frame.high.x + 3, 0, frame.high.z + kEaves},
                  kRoofBase, s.roof);
}

void drawWindows(Canvas& canvas, const HouseFrame& frame, const HouseSwatches& s, const HouseStyle& style) {
    const auto row = [&](const WallFrame& wall, std::initializer_list<int> places, int y) {
        for (int u : places) drawWindow(canvas, wall, u, y, 11, 13, s.windows, true);
    };
    const int w = style.width, d = style.depth;
    row(frame.walls.front, {w / 8, w / 8 + 18, w * 3 / 4 - 6}, kFloor1 + 8);
    row(frame.walls.front, {w / 8, w / 8 + 18}, kFloor0 + 8);
    for (int y : {kFloor0 + 8, kFloor1 + 8}) {
        row(frame.walls.left, {d / 5, d * 2 / 3 + 2}, y);
        row(frame.walls.right, {d / 5, d * 2 / 3}, y);
        row(frame.walls.back, {w / 6, w * 2 / 3}, y);
    }
}

void drawOpening(Canvas& canvas, ivec3 low, ivec3 high, Swatch frame) {
    canvas.clear(low, high);
    const bool alongX = high.x - low.x > high.z - low.z;
    canvas.box({low.x, high.y, low.z}, {high.x, high.y + 1, high.z}, frame);
    if (alongX) {
        canvas.box({low.x, low.y, low.z}, {low.x + 1, high.y, high.z}, frame);
        canvas.box({high.x - 1, low.y, low.z}, {high.x, high.y, high.z}, frame);
    } else {
        canvas.box({low.x, low.y, low.z}, {high.x, high.y, low.z + 1}, frame);
        canvas.box({low.x, low.y, high.z - 1}, {high.x, high.y, high.z}, frame);
    }
}

void drawRooms(Canvas& canvas, const HouseSwatches& s) {
    using Rooms = HouseRooms;
    for (int floor = 0; floor < 2; ++floor) {
        const int low = floor ? Rooms::kUpperFloor : Rooms::kGroundFloor, high = low + 23;
        const Swatch front = floor ? s.rose : s.green, back = floor ? s.tile : s.plaster;
        drawInnerWall(canvas, {62, low, 11}, {65, high, 54}, back, s.plaster, s.timber, s.wire);
        drawInnerWall(canvas, {62, low, 54}, {65, high, 101}, front, s.plaster, s.timber, s.wire);
        drawInnerWall(canvas, {11, low, 54}, {62, high, 57}, back, front, s.timber, s.wire);
        drawInnerWall(canvas, {65, low, 50}, {117, high, 53}, s.plaster, s.plaster, s.timber, s.wire);
        drawOpening(canvas, {62, low, 84}, {65, low + kDoorHeight, 95}, s.white);
        drawOpening(canvas, {44, low, 54}, {55, low + kDoorHeight, 57}, s.white);
        drawOpening(canvas, {100, low, 50}, {111, low + kDoorHeight, 53}, s.white);
        // Wallpaper on the inside of the outer walls of the front room, tiles in the room behind.
        const auto paper = [&](ivec3 a, ivec3 b, Swatch swatch) {
            canvas.fill(a, b, [&](ivec3 c) {
                return canvas.hasSwatch(c, s.plaster) ? PaletteBuilder::pick(swatch, c) : canvas.at(c);
            });
        };
        paper({10, low, 57}, {11, high, 102}, front);
        paper({10, low, 101}, {62, high, 102}, front);
        if (floor) paper({10, low, 10}, {62, low + 14, 11}, back), paper({10, low, 10}, {11, low + 14, 54}, back);
        // A skirting board along the inner walls.
        canvas.box({61, low, 57}, {62, low + 1, 84}, s.white);
        canvas.box({11, low, 57}, {44, low + 1, 58}, s.white);
    }
    canvas.box({11, Rooms::kUpperFloor - 1, 11}, {62, Rooms::kUpperFloor, 54}, s.tile);
}

/// Stairs along the wall behind the hall, below an opening of the same length: from there on the upper floor is a
/// landing, and the railing leaves room to step onto it.
void drawStairs(Canvas& canvas, const HouseSwatches& s) {
    constexpr int kFoot = 67, kRun = 38, kTop = kFoot + kRun, kRailingEnd = kTop - 4;
    canvas.clear({kFoot, kFloor1 - 3, 53}, {kTop, kFloor1 + 1, 62});
    for (int i = 0; i < kRun; ++i) {
        const int top = kFloor0 + 1 + i / 2 * 2 * kStorey / kRun;
        canvas.box({kFoot + i, std::max(top - 3, kFloor0), 53}, {kFoot + i + 1, top, 62}, s.timber);
        canvas.box({kFoot + i, top, 53}, {kFoot + i + 1, top + 1, 62}, i % 2 ? s.floors.seam : s.floors.board);
    }
    canvas.box({kFoot, kFloor1 + 1, 62}, {kRailingEnd, kFloor1 + 2, 63}, s.white);
    for (int x = kFoot; x < kRailingEnd; x += 4) canvas.box({x, kFloor1 + 2, 62}, {x + 1, kFloor1 + 10, 63}, s.white);
    canvas.box({kFoot, kFloor1 + 10, 62}, {kRailingEnd, kFloor1 + 11, 63}, s.timber);
}

/// A rug replaces the boards, one cell thick: it is part of the house's shape and moves with the floor.
void drawRug(Canvas& canvas, ivec3 low, ivec3 high, Swatch field, Swatch edge) {
    canvas.fill(low, high, [&](ivec3 c) {
        const int border = std::min({c.x - low.x, high.x - 1 - c.x, c.z - low.z, high.z - 1 - c.z});
        const bool figure = (c.x + c.z) % 8 == 0 || (c.x - c.z + 800) % 8 == 0;
        return PaletteBuilder::pick(border == 1 || (border > 3 && figure) ? edge : field, c);
    });
}

void drawPorch(Canvas& canvas, const HouseFrame& frame, const HouseSwatches& s) {
    const int z0 = frame.high.z, z1 = z0 + 19, x0 = 74, x1 = 112;
    canvas.box({x0, 0, z0}, {x1, kFloor0, z1}, s.concrete);
    canvas.fill({x0, kFloor0, z0}, {x1, kFloor0 + 1, z1}, [&](ivec3 c) {
        return PaletteBuilder::pickFor(c.x % 4 == 3 ? s.floors.seam : s.floors.board, uint32_t(c.x / 4));
    });
    canvas.box({86, 0, z1}, {102, kFloor0, z1 + 3}, s.concrete);
    for (int x : {x0, x1 - 2})
        for (int z : {z0 + 1, z1 - 2}) canvas.box({x, kFloor0 + 1, z}, {x + 2, kFloor0 + 24, z + 2}, s.white);
    // Railings on three sides, open before the steps.
    const auto rail = [&](ivec3 a, ivec3 b) {
        const bool alongX = b.x - a.x > b.z - a.z;
        for (int y : {kFloor0 + 3, kFloor0 + 9}) canvas.box({a.x, y, a.z}, {b.x, y + 1, b.z}, s.white);
        for (int i = 0; i < (alongX ? b.x - a.x : b.z - a.z); i += 3) {
            const ivec3 foot = a + (alongX ? ivec3(i, kFloor0 + 1, 0) : ivec3(0, kFloor0 + 1, i));
            canvas.box(foot, foot + ivec3(1, 8, 1), s.white);
        }
    };
    rail({x0, 0, z0}, {x0 + 1, 0, z1});
    rail({x1 - 1, 0, z0}, {x1, 0, z1});
    rail({x0, 0, z1 - 1}, {86, 0, z1});
    rail({102, 0, z1 - 1}, {x1, 0, z1});
    // A lean-to roof, its tiles in rows.
    canvas.box({x0 - 1, kFloor0 + 24, z0}, {x1 + 1, kFloor0 + 26, z1 + 1}, s.timber);
    for (int z = z0; z < z1 + 3; ++z) {
        const int y = kFloor0 + 26 + (z1 + 2 - z) / 4;
        for (int x = x0 - 3; x < x1 + 3; ++x) {
            const uint32_t tile = hashCell(x / 3, z / 4, 3, 72);
            for (int d = 0; d < 2; ++d)
                canvas.setEntry({x, y + d, z},
                                PaletteBuilder::pickFor(x % 3 == 0 ? s.roof.tileDark : s.roof.tile, tile >> 8));
        }
    }
}

void drawChimney(Canvas& canvas, const HouseFrame& frame, const HouseSwatches& s) {
    const ivec3 low(frame.high.x - 26, kFloor2 + 1, frame.low.z + 30);
    const int top = canvas.size().y - 2;
    for (int y = low.y; y < top; ++y)
        for (int x = low.x; x < low.x + 10; ++x)
            for (int z = low.z; z < low.z + 8; ++z) {
                const bool flue = x > low.x + 2 && x < low.x + 7 && z > low.z + 1 && z < low.z + 6;
                const uint32_t brick = hashCell((x + z + y % 2 * 2) / 4, y, 1, 73);
                if (flue)
                    canvas.setEntry({x, y, z}, 0);
                else
                    canvas.setEntry({x, y, z}, PaletteBuilder::pickFor((x + z + y % 2 * 2) % 4 == 0 ? s.walls.joint
                                                                       : y > top - 4                ? s.walls.dirty
                                                                                                    : s.walls.stone,
                                                                       brick));
            }
    canvas.box({low.x - 1, top, low.z - 1}, {low.x + 11, top + 1, low.z + 9}, s.concrete);
    canvas.clear({low.x + 3, top, low.z + 2}, {low.x + 7, top + 1, low.z + 6});
}

/// A light that hangs from a ceiling, higher than a head; the voxels of its bulb glow and belong to the light's group.
void drawCeilingLight(Level& level, Canvas& canvas, const std::string& house, const std::string& name, ivec3 hook,
                      float strength, const HouseSwatches& s) {
    const uint32_t group = addLightGroup(level, name);
    const Swatch glow = canvas.addSurface(kBulbGlow, 100, group);
    canvas.box(hook - ivec3(0, 1, 0), hook + ivec3(1), s.wire);
    canvas.box(hook - ivec3(2, 2, 2), hook + ivec3(3, -1, 3), s.rugEdge);
    canvas.box(hook - ivec3(1, 3, 1), hook + ivec3(2, -2, 2), glow);
    addLight(level, house, group, LightKind::Sphere, glm::dvec3(hook) + glm::dvec3(0.5, -4.0, 0.5),
             kWarmLight * strength, 8.0f, 0.12f);
}

/// A door that opens to either side, and stays where it was pushed to. corner, cell: of the house and of the door's
/// leaf.
void addFrontDoor(Level& level, const std::string& house, ivec3 corner, ivec3 cell, const SurfaceStyle& style) {
    constexpr double kSwing = 1.75, kFriction = 20.0;  // radians; N m
    Joint& hinge = addHinged(level, house, corner, makeDoorLeaf(house + " door", style), corner + cell,
                             {0.0, 0.5 * kDoorHeight, 1.5});
    hinge.limits = {true, -kSwing, kSwing};
    hinge.friction = kFriction;
}

}  // namespace

void addHouse(Level& level, const std::string& name, ivec3 cell, const HouseStyle& style) {
    const int peak = kRoofBase + gableHeight(style.depth / 2 + kEaves, 0, style.depth + 2 * kEaves) + 4;
    Canvas canvas(
        {style.width + 2 * kHouseMargin, peak + (style.rooms ? 10 : 4), style.depth + kHouseMargin + kHouseFront});
    const HouseSwatches s(canvas, style);
    HouseFrame frame;
    frame.low = {kHouseMargin, 0, kHouseMargin};
    frame.high = frame.low + ivec3(style.width, 0, style.depth);
    frame.walls = wallFrames(frame.low, frame.high);
    drawShell(canvas, frame, s);
    if (style.rooms) drawRooms(canvas, s);
    drawWindows(canvas, frame, s, style);
    const int door = style.width * 3 / 4 - 5;
    if (style.rooms)
        drawDoorFrame(canvas, frame.walls.front, door, kFloor0 + 1, s.white);
    else
        drawDoor(canvas, frame.walls.front, door, kFloor0 + 1, s.door, s.white, s.steel);
    drawChimney(canvas, frame, s);
    if (style.rooms) {
        drawStairs(canvas, s);
        drawPorch(canvas, frame, s);
        drawRug(canvas, {18, kFloor0, 66}, {48, kFloor0 + 1, 92}, s.rug, s.rugEdge);
        drawRug(canvas, {22, kFloor1, 70}, {46, kFloor1 + 1, 90}, s.rugBlue, s.rugEdge);
        drawCeilingLight(level, canvas, name, name + " living room light", {36, HouseRooms::kLiving.high.y - 1, 79},
                         16.0f, s);
        drawCeilingLight(level, canvas, name, name + " bedroom light", {36, HouseRooms::kBedroom.high.y - 1, 79}, 16.0f,
                         s);
        drawCeilingLight(level, canvas, name, name + " hall light", {92, HouseRooms::kHall.high.y - 1, 84}, 14.0f, s);
        drawCeilingLight(level, canvas, name, name + " porch light", {93, kFloor0 + 23, frame.high.z + 10}, 26.0f, s);
    }
    const ivec3 corner = cell - ivec3(kHouseMargin, kFooting, kHouseMargin);
    addStatic(level, canvas.finish(name), corner);
    if (style.rooms) addFrontDoor(level, name, corner, frame.walls.front.cell(door, kFloor0 + 1, 2), *style.door);
}

}  // namespace rubble::scenes
