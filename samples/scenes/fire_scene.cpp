// A wooden house burns down: planks on studs, boards on joists, shingles on rafters. The chimney remains.
#include <algorithm>

#include "runtime/core/random.h"
#include "samples/scenes/building.h"
#include "samples/scenes/environment.h"
#include "samples/scenes/fence.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/script_clock.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr int kMargin = 7, kPorch = 18;  // cells of the shape around the walls; in front of them
constexpr int kWidth = 78, kDepth = 58, kWallHeight = 26;
constexpr int kX0 = kMargin, kX1 = kX0 + kWidth, kZ0 = kMargin, kZ1 = kZ0 + kDepth;
constexpr int kFloor = kFooting + 2;          // boards
constexpr int kEaves = kFloor + kWallHeight;  // underside of the rafters
constexpr ivec3 kHouse{106, -kFooting, 104};  // low corner of the shape

struct CabinSwatches {
    explicit CabinSwatches(Canvas& c)
        : stone(c.addSurface(kBrickGrey)),
          plank(c.addSurface(kFenceWood)),
          plankDark(c.addSurface(kFenceWood, 84)),
          timber(c.addSurface(kTimber)),
          lining(c.addSurface(kFloorBoard, 108)),
          white(c.addSurface(kWhiteWood)),
          red(c.addSurface(kRedWood)),
          brick(c.addSurface(kBrick)),
          joint(c.addSurface(kBrickJoint)),
          iron(c.addSurface(kDarkSteel)) {
        windows = {white, c.addSurface(kGlass), white, c.addSurface(kClothCream), plankDark};
        floors = {c.addSurface(kFloorBoard), c.addSurface(kFloorSeam), timber, lining};
        roof = {c.addSurface(kDarkWood), c.addSurface(kDarkWood, 84), timber, c.addSurface(kDarkWood, 76), white};
    }
    Swatch stone, plank, plankDark, timber, lining, white, red, brick, joint, iron;
    WindowSwatches windows;
    FloorSwatches floors;
    RoofSwatches roof;
};

/// Palette entry of the overlapping planks; each row has its own tones.
uint8_t plankEntry(const CabinSwatches& s, int u, int y, int side) {
    const int row = y / 3;
    const uint32_t board = hashCell((u + int(hashCell(row, side, 3, 141) % 30)) / 26, row, side, 142);
    return PaletteBuilder::pickFor(y % 3 == 0 ? s.plankDark : s.plank, board + hashCell(u / 4, y, side, 143) % 2);
}

void drawWalls(Canvas& c, const WallFrames& walls, const CabinSwatches& s) {
    int side = 0;
    for (const WallFrame* wall : {&walls.left, &walls.right, &walls.back, &walls.front}) {
        ++side;
        const bool gable = side <= 2;
        for (int u = 0; u < wall->length; ++u) {
            const int top =
                gable ? std::max(kEaves, kEaves + gableHeight(wall->cell(u, 0, 0).z, kZ0 - 4, kZ1 + 4)) : kEaves + 2;
            for (int y = kFloor; y < top; ++y) {
                c.setEntry(wall->cell(u, y, 0), plankEntry(s, u, y, side));
                if (u % 7 == 0 || y % 24 == 0) c.set(wall->cell(u, y, 1), s.timber);
                if (y < kEaves) c.set(wall->cell(u, y, 2), s.lining);
            }
        }
        for (int y = kFloor; y < kEaves + 2; ++y)
            for (int u : {0, 1, wall->length - 2, wall->length - 1}) c.set(wall->cell(u, y, 0), s.white);
    }
}

void drawChimney(Canvas& c, const CabinSwatches& s) {
    const int top = c.size().y - 1;
    c.fill({kX1 - 16, 0, kZ0 + 12}, {kX1 - 6, top, kZ0 + 20}, [&](ivec3 cell) {
        const bool flue =
            cell.x > kX1 - 14 && cell.x < kX1 - 8 && cell.z > kZ0 + 13 && cell.z < kZ0 + 18 && cell.y > kFloor;
        if (flue) return uint8_t(0);
        const uint32_t brick = hashCell((cell.x + cell.z + cell.y % 2 * 2) / 4, cell.y, 1, 73);
        return PaletteBuilder::pickFor((cell.x + cell.z + cell.y % 2 * 2) % 4 == 0 ? s.joint : s.brick, brick >> 8);
    });
    c.clear({kX1 - 13, kFloor + 1, kZ0 + 19}, {kX1 - 9, kFloor + 7, kZ0 + 20});
}

void drawVeranda(Canvas& c, const CabinSwatches& s) {
    const int z1 = kZ1 + kPorch - 3;
    c.fill({kX0, kFloor, kZ1}, {kX1, kFloor + 1, z1},
           [&](ivec3 cell) { return PaletteBuilder::pickFor(s.plank, uint32_t(cell.x / 3)); });
    for (int x = kX0 + 1; x < kX1; x += 19) {
        c.box({x, 0, z1 - 2}, {x + 2, kEaves - 4, z1}, s.white);
        c.box({x, 0, kZ1 + 1}, {x + 2, kFloor, kZ1 + 3}, s.timber);
    }
    c.box({kX0, kEaves - 5, z1 - 2}, {kX1, kEaves - 3, z1}, s.timber);
    for (int z = kZ1; z < z1 + 3; ++z) {
        const int y = kEaves - 3 + (z1 + 2 - z) / 5;
        c.fill({kX0 - 2, y, z}, {kX1 + 2, y + 2, z + 1}, [&](ivec3 cell) {
            return PaletteBuilder::pickFor(cell.x % 4 ? s.roof.tile : s.roof.tileDark,
                                           hashCell(cell.x / 4, z / 3, 9, 72));
        });
        if (z > kZ1)
            for (int x = kX0 + 1; x < kX1; x += 19) c.box({x, y - 1, z}, {x + 1, y, z + 1}, s.timber);
    }
    for (int y : {4, 9}) {
        c.box({kX0 + 1, kFloor + y, z1 - 1}, {kX0 + 30, kFloor + y + 1, z1}, s.white);
        c.box({kX0 + 48, kFloor + y, z1 - 1}, {kX1, kFloor + y + 1, z1}, s.white);
    }
    for (int x = kX0 + 1; x < kX1; x += 3)
        if (x < kX0 + 30 || x >= kX0 + 48) c.box({x, kFloor + 1, z1 - 1}, {x + 1, kFloor + 9, z1}, s.white);
    c.box({kX0 + 30, 0, z1}, {kX0 + 48, kFloor - 1, z1 + 3}, s.timber);
}

void addCabin(Level& level) {
    const int peak = kEaves + gableHeight(kDepth / 2 + 4, 0, kDepth + 8) + 12;
    Canvas c({kWidth + 2 * kMargin, peak, kDepth + kMargin + kPorch});
    const CabinSwatches s(c);
    const WallFrames walls = wallFrames({kX0, 0, kZ0}, {kX1, 0, kZ1});
    for (int x : {kX0, kX0 + 36, kX1 - 6})
        for (int z : {kZ0, kZ0 + 26, kZ1 - 6}) c.box({x, 0, z}, {x + 6, kFloor - 1, z + 6}, s.stone);
    c.box({kX0, kFloor - 1, kZ0}, {kX1, kFloor, kZ0 + 3}, s.timber);
    c.box({kX0, kFloor - 1, kZ1 - 3}, {kX1, kFloor, kZ1}, s.timber);
    c.box({kX0, kFloor - 1, kZ0}, {kX0 + 3, kFloor, kZ1}, s.timber);
    c.box({kX1 - 3, kFloor - 1, kZ0}, {kX1, kFloor, kZ1}, s.timber);
    drawWalls(c, walls, s);
    drawFloor(c, {kX0 + 3, 0, kZ0 + 3}, {kX1 - 3, 0, kZ1 - 3}, kFloor, s.floors, false);
    drawFloor(c, {kX0 + 3, 0, kZ0 + 3}, {kX1 - 3, 0, kZ1 - 3}, kEaves, s.floors, true);
    drawGableRoof(c, {kX0 - 4, 0, kZ0 - 4}, {kX1 + 4, 0, kZ1 + 4}, kEaves, s.roof);
    for (int u : {8, 26, 60}) drawWindow(c, walls.front, u, kFloor + 9, 11, 12, s.windows, true);
    for (int u : {10, 36}) drawWindow(c, walls.left, u, kFloor + 9, 11, 12, s.windows, true);
    for (int u : {14, 34}) drawWindow(c, walls.right, u, kFloor + 9, 11, 12, s.windows, true);
    drawWindow(c, walls.left, kDepth / 2 - 5, kEaves + 4, 9, 8, s.windows, false);
    drawDoor(c, walls.front, 42, kFloor + 1, s.red, s.white, s.iron);
    drawVeranda(c, s);
    drawChimney(c, s);
    addStatic(level, c.finish("cabin"), kHouse);
}

Level fireLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {320, 0, 320};
    ground.areas = {area(Earth, 146, 180, 166, 320), area(Earth, 100, 98, 200, 184)};
    Level level = makePlot("burning house", ground, seed);
    level.environment = dusk();
    addCabin(level);
    const ivec3 floor = kHouse + ivec3(0, kFloor + 1, 0);
    addDynamic(level, makeTable("table"), floor + ivec3(kX0 + 12, 0, kZ0 + 14));
    addDynamic(level, makeChair("chair", kRedWood), floor + ivec3(kX0 + 10, 0, kZ0 + 32));
    addDynamic(level, makeSofa("sofa", kClothTeal), floor + ivec3(kX0 + 40, 0, kZ0 + 34));
    addDynamic(level, makeShelf("shelf", 5), floor + ivec3(kX0 + 34, 0, kZ0 + 4));
    addDynamic(level, makeBarrel("barrel 1", kCarBlue), {88, 0, 168});
    addDynamic(level, makeBarrel("barrel 2", kCarRed), {96, 0, 176});
    for (int i = 0; i < 3; ++i)
        addDynamic(level, makeCrate("crate " + std::to_string(i)), {206 + i % 2 * 4, i / 2 * 8, 150 + i % 2 * 10});
    addStatic(level, makePicketFence("fence left", 112, 10, false), {30, -kFenceFoot, 226});
    addStatic(level, makePicketFence("fence right", 112, 10, false), {172, -kFenceFoot, 226});
    return level;
}

glm::dvec3 inCabin(double x, double y, double z) {
    return (glm::dvec3(kHouse) + glm::dvec3(kX0 + x, y, kZ0 + z)) * kVoxel;
}

/// Fires are lit under the veranda's roof and in the room, and spread by themselves. At the end water is poured.
Edits fireScript(int step, uint64_t) {
    ScriptClock clock(step);
    if (clock.at(0.5)) clock.add(spawnFire(inCabin(26, kFloor + 2, kDepth + 8), 0.5));
    if (clock.at(0.8)) clock.add(spawnFire(inCabin(31, kFloor + 14, kDepth - 1), 0.5));
    if (clock.at(1.0)) clock.add(spawnFire(inCabin(46, kFloor + 4, 38), 0.6));
    if (clock.at(2.0))
        clock.add(HeatEdit{.position = inCabin(26, kFloor + 22, kDepth + 6), .radius = 1.2, .joules = 4.0e6});
    for (int i = clock.first(15.5, 12, 16.7); i < clock.last(15.5, 12, 16.7); ++i)
        clock.add(pourWater(inCabin(60 + i % 4 * 4, kFloor + 4 + i, kDepth + 6), 0.8));
    return clock.take();
}

Pose fireCamera(double seconds) {
    return lookAt({7.0 + 0.1 * seconds, 3.9, 31.0}, {15.0, 3.1, 14.0});
}

}  // namespace

Scene fireScene() {
    Scene scene{"fire", "a wooden house that burns", fireLevel, fireScript, fireCamera};
    scene.steps = 1080;
    // An hour's fire in eighteen seconds.
    scene.settings.fire.spread = 5.0f;
    scene.settings.fire.burnTime = 0.14f;
    scene.settings.stress.on = true;
    return scene;
}

}  // namespace rubble::scenes
