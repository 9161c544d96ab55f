// A car drives through a wooden house: in at one gable, out at the other, and into crates.
#include "runtime/core/random.h"
#include "samples/scenes/building.h"
#include "samples/scenes/car.h"
#include "samples/scenes/fence.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/script_clock.h"
#include "samples/scenes/street_light.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr int kMargin = 5, kWidth = 72, kDepth = 60, kEaves = 30;  // of the house, in cells
constexpr ivec3 kHouse{200, 0, 140};
constexpr int kLane = kHouse.z + kDepth / 2;  // z of the car's lane

struct HouseSwatches {
    explicit HouseSwatches(Canvas& c)
        : plank(c.addSurface(kRedWood)),
          plankDark(c.addSurface(kRedWood, 88)),
          post(c.addSurface(kTimber)),
          white(c.addSurface(kWhiteWood)) {
        windows = {white, c.addSurface(kGlass), white, c.addSurface(kClothCream), plankDark};
        roof = {c.addSurface(kDarkWood), c.addSurface(kDarkWood, 84), post, c.addSurface(kDarkWood, 76), white};
    }
    Swatch plank, plankDark, post, white;
    WindowSwatches windows;
    RoofSwatches roof;
};

/// Upright boards on posts and rails, with white corners; a gable reaches up to the roof.
void drawBoards(Canvas& c, const WallFrame& wall, bool isGable, const HouseSwatches& s) {
    for (int u = 0; u < wall.length; ++u) {
        const int top =
            isGable ? kEaves + gableHeight(wall.cell(u, 0, 0).z, kMargin - 4, kMargin + kDepth + 4) : kEaves + 2;
        for (int y = 0; y < top; ++y) {
            const Swatch& board = u % 4 == 0 ? s.plankDark : s.plank;
            c.setEntry(wall.cell(u, y, 0), PaletteBuilder::pickFor(board, hashCell(u / 4, isGable, y / 24, 61)));
            if (u % 12 == 6 || y % 15 == 7) c.set(wall.cell(u, y, 1), s.post);
        }
        if (u >= 2 && u < wall.length - 2) continue;
        for (int y = 0; y < kEaves + 2; ++y) c.set(wall.cell(u, y, 0), s.white);
    }
}

/// A wooden house of one room on bare ground.
void addWoodenHouse(Level& level) {
    Canvas c({kWidth + 2 * kMargin, kEaves + gableHeight(kMargin + kDepth / 2, kMargin - 4, kMargin + kDepth + 4) + 4,
              kDepth + 2 * kMargin});
    const HouseSwatches s(c);
    const WallFrames walls = wallFrames({kMargin, 0, kMargin}, {kMargin + kWidth, 0, kMargin + kDepth});
    for (const WallFrame* wall : {&walls.left, &walls.right}) drawBoards(c, *wall, true, s);
    for (const WallFrame* wall : {&walls.back, &walls.front}) drawBoards(c, *wall, false, s);
    drawGableRoof(c, {kMargin - 4, 0, kMargin - 4}, {kMargin + kWidth + 4, 0, kMargin + kDepth + 4}, kEaves, s.roof);
    for (const int u : {8, 52}) drawWindow(c, walls.front, u, 9, 11, 12, s.windows, true);
    for (const WallFrame* wall : {&walls.left, &walls.right})
        drawWindow(c, *wall, kDepth / 2 - 5, kEaves + 4, 9, 8, s.windows, false);
    drawDoor(c, walls.front, 31, 0, c.addSurface(kGreenWood), s.white, c.addSurface(kDarkSteel));
    addStatic(level, c.finish("house"), kHouse - ivec3(kMargin, 0, kMargin));
}

Level driveLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {480, 0, 360};
    ground.areas = {area(Concrete, 0, kLane - 22, 480, kLane + 22), area(Road, 0, 280, 480, 330),
                    area(Paving, 0, 270, 480, 280)};
    ground.lanesAlongX = {{{0, 0, 304}, {480, 0, 306}}};
    Level level = makePlot("drive", ground, seed);
    addDrivenCar(level, "driven car", kCarRed, {14, 0, kLane - 9}, 1.0);
    addWoodenHouse(level);
    for (int i = 0; i < 5; ++i)
        addDynamic(level, makeCrate("crate " + std::to_string(i)),
                   {346 + i % 2 * 10, i / 2 * 8, kLane - 8 + i % 2 * 3});
    addDynamic(level, makeTable("table"), {kHouse.x + 30, 0, kLane - 20});
    addDynamic(level, makeBench("bench"), {150, 0, kLane + 34}, Turn::Askew);
    addStreetLight(level, "street light", {120, 0, 266}, false);
    addDynamic(level, makeCar("parked car", kCarBlue), {150, -kRoadDrop, 284});
    return level;
}

/// Handle of the car's body. A level is loaded into slots 0, 1, ... in the order of its bodies.
BodyHandle drivenCar() {
    const Level level = driveLevel(0);
    for (uint32_t i = 0; i < level.bodies.size(); ++i)
        if (level.bodies[i].name == "driven car") return BodyHandle::make(1, 1, i);
    return {};
}

Edits driveScript(int step, uint64_t) {
    static const BodyHandle kCar = drivenCar();
    const double seconds = step / 60.0;
    if (seconds < 3.5) return {DriveEdit{kCar, 0.3, 0.0, 0.0}};  // faster, it would be crushed at the first gable
    if (seconds < 6.6) return {DriveEdit{kCar, 1.0, 0.0, 0.0}};
    if (seconds < 7.0) return {DriveEdit{kCar, 0.2, -0.6, 0.0}};
    return {DriveEdit{kCar, 0.0, -0.6, 1.0}};
}

Pose driveCamera(double seconds) {
    return lookAt({41.0 - 0.3 * seconds, 6.5, 33.5}, {20.5 + 1.2 * seconds, 2.2, 17.0});
}

}  // namespace

Scene driveScene() {
    Scene scene{"drive", "a car drives through a house", driveLevel, driveScript, driveCamera};
    scene.verticalFov = 0.75f;
    scene.steps = 540;
    scene.settings.impactThreshold = 8000.0;  // rolling tyres break nothing; the car of 15 t in a wall does
    scene.settings.impactRadius = 0.4;
    scene.settings.impactRadiusLimit = 1.4;
    scene.settings.stress.on = true;
    return scene;
}

}  // namespace rubble::scenes
