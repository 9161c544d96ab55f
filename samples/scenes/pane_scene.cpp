// A pavilion with a glass front. A steel ball is thrown through one of its panes.
#include "runtime/core/random.h"
#include "samples/scenes/building.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/neighbourhood.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/surface_styles.h"
#include "samples/scenes/tree.h"

namespace rubble::scenes {
namespace {

constexpr int kWidth = 124, kDepth = 70, kHeight = 34, kMargin = 8;
constexpr int kFloor = kFooting + 2, kTop = kFloor + kHeight;
constexpr ivec3 kHouse{90, -kFooting, 110};
constexpr int kPanes = 4, kPane = (kWidth - 8) / kPanes;  // panes, and cells per pane

void addPavilion(Level& level) {
    Canvas c({kWidth + 2 * kMargin, kTop + 6, kDepth + 2 * kMargin});
    const Swatch concrete = c.addSurface(kConcrete), board = c.addSurface(kFloorBoard), seam = c.addSurface(kFloorSeam),
                 steel = c.addSurface(kDarkSteel), glass = c.addSurface(kGlass), wood = c.addSurface(kDarkWood),
                 white = c.addSurface(kPlaster), felt = c.addSurface(kRoofFelt), brick = c.addSurface(kBrick),
                 joint = c.addSurface(kBrickJoint);
    const int x0 = kMargin, x1 = x0 + kWidth, z0 = kMargin, z1 = z0 + kDepth;
    c.box({x0 - 4, 0, z0 - 2}, {x1 + 4, kFloor, z1 + 6}, concrete);
    c.fill({x0, kFloor, z0}, {x1, kFloor + 1, z1}, [&](ivec3 cell) {
        const int plank = cell.z / 4;
        return PaletteBuilder::pickFor(cell.z % 4 == 3 ? seam : board,
                                       hashCell((cell.x + int(hashCell(plank, 0, 0, 5) % 30)) / 30, plank, 1, 64));
    });
    // A brick wall behind and a plastered one to the right; glass in front and to the left, under a thin wide roof.
    c.fill({x0, kFloor + 1, z0}, {x1, kTop, z0 + 3}, [&](ivec3 cell) {
        const int shifted = cell.x + cell.y % 2 * 2;
        return PaletteBuilder::pickFor(shifted % 4 == 0 ? joint : brick, hashCell(shifted / 4, cell.y, 0, 42) >> 8);
    });
    c.box({x1 - 3, kFloor + 1, z0}, {x1, kTop, z1 - 2}, white);
    c.box({x0 - 7, kTop, z0 - 4}, {x1 + 4, kTop + 3, z1 + 8}, wood);
    c.box({x0 - 6, kTop + 3, z0 - 3}, {x1 + 3, kTop + 4, z1 + 7}, felt);
    c.box({x0 - 7, kTop, z1 + 7}, {x1 + 4, kTop + 4, z1 + 8}, steel);
    c.box({x0 - 7, kTop, z0 - 4}, {x0 - 6, kTop + 4, z1 + 8}, steel);
    for (int i = 0; i <= kPanes; ++i)
        c.box({x0 + 2 + i * kPane, kFloor + 1, z1 - 3}, {x0 + 4 + i * kPane, kTop, z1 - 1}, steel);
    c.box({x0 + 2, kFloor + 1, z1 - 2}, {x1 - 3, kTop, z1 - 1}, glass);
    c.box({x0 + 2, kFloor + 1, z1 - 3}, {x1 - 3, kFloor + 2, z1 - 1}, steel);
    c.box({x0 + 2, kTop - 1, z1 - 3}, {x1 - 3, kTop, z1 - 1}, steel);
    for (int i = 0; i <= kPanes; ++i)
        c.box({x0 + 2 + i * kPane, kFloor + 1, z1 - 3}, {x0 + 4 + i * kPane, kTop, z1 - 1}, steel);
    c.box({x0 + 2, kFloor + 1, z0 + 3}, {x0 + 3, kTop, z1 - 2}, glass);
    c.box({x0 + 1, kFloor + 1, z0 + 34}, {x0 + 4, kTop, z0 + 36}, steel);
    addStatic(level, c.finish("pavilion"), kHouse - ivec3(kMargin, 0, kMargin));
}

/// A ball of steel, thrown at the third pane.
void addBall(Level& level) {
    constexpr int kRadius = 4;
    Canvas c(ivec3(2 * kRadius + 1));
    const Swatch red = c.addSurface(kBallRed), cream = c.addSurface(kBallCream);
    c.fill(ivec3(0), c.size(), [&](ivec3 cell) {
        const ivec3 d = cell - kRadius;
        if (d.x * d.x + d.y * d.y + d.z * d.z > kRadius * kRadius + 3) return uint8_t(0);
        return PaletteBuilder::pick(std::abs(d.x) < 2 || std::abs(d.y) < 2 ? cream : red, cell);
    });
    addDynamic(level, c.finish("ball"), {160, 15, 206});
    level.bodies.back().velocity = {0.3f, 1.2f, -10.0f};
    level.bodies.back().angularVelocity = {-9.0f, 0.5f, -1.0f};
}

Level paneLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {320, 0, 320};
    ground.areas = {area(Paving, 74, 184, 246, 206), area(Paving, 146, 206, 176, 320)};
    Level level = makePlot("window", ground, seed);
    addPavilion(level);
    addBall(level);
    const ivec3 floor = kHouse + ivec3(0, kFloor + 1, 0);
    addDynamic(level, makeSofa("sofa", kClothTeal), floor + ivec3(8, 0, 8));
    addDynamic(level, makeTable("table"), floor + ivec3(66, 0, 42));
    addDynamic(level, makeChair("chair 1", kRedWood), floor + ivec3(84, 0, 44), Turn::Quarter);
    addDynamic(level, makeShelf("shelf", 11), floor + ivec3(82, 0, 4));
    addDynamic(level, makePlantPot("plant 1"), floor + ivec3(10, 0, 52));
    addDynamic(level, makePlantPot("plant 2"), floor + ivec3(104, 0, 54));
    addDynamic(level, makeTelevision("television"), floor + ivec3(44, 0, 6));
    addDynamic(level, makeBench("bench"), {216, 0, 214}, Turn::Askew);
    addFloorLight(level, "floor light", floor + ivec3(110, 0, 40));
    addStatic(level, makeHedge("hedge in front", {300, 12, 9}), {10, -kHedgeRoot, 300});
    addTree(level, "tree in front 1", {210, 0, 284}, 84, kLeavesAutumn, seed + 20);
    addTree(level, "tree in front 2", {106, 0, 290}, 74, kLeaves, seed + 21);
    return level;
}

Edits paneScript(int, uint64_t) {
    return {};  // the ball is already in the air
}

Pose paneCamera(double seconds) {
    return lookAt({13.6 + 0.1 * seconds, 1.6, 13.2}, {16.3, 1.5, 18.0});
}

}  // namespace

Scene paneScene() {
    Scene scene{"pane", "a window wall that a ball goes through", paneLevel, paneScript, paneCamera};
    scene.steps = 84;
    scene.verticalFov = 0.9f;
    return scene;
}

}  // namespace rubble::scenes
