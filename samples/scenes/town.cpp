#include "samples/scenes/town.h"

#include "samples/scenes/car.h"
#include "samples/scenes/environment.h"
#include "samples/scenes/fence.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/house.h"
#include "samples/scenes/lamp.h"
#include "samples/scenes/recipes.h"
#include "samples/scenes/shop.h"
#include "samples/scenes/street.h"
#include "samples/scenes/town_plan.h"
#include "samples/scenes/tree.h"
#include "samples/scenes/water_tower.h"

namespace rubble::scenes {
namespace {

using namespace plan;
using Surface = GroundPlan::Surface;

CellBox area(int x0, int z0, int x1, int z1) { return {{x0, 0, z0}, {x1, 0, z1}}; }

GroundPlan streets() {
    GroundPlan ground;
    const int edge = ground.size.x;
    ground.areas = {
        {Surface::Paving, area(0, kStreetLow - kPavement, edge, kStreetHigh + kPavement)},
        {Surface::Paving, area(kSideLow - kPavement, 0, kSideHigh + kPavement, edge)},
        {Surface::Road, area(0, kStreetLow, edge, kStreetHigh)},
        {Surface::Road, area(kSideLow, 0, kSideHigh, edge)},
    };
    const int middleZ = (kStreetLow + kStreetHigh) / 2, middleX = (kSideLow + kSideHigh) / 2;
    ground.lanesAlongX = {area(kSideHigh + 44, middleZ - 1, edge, middleZ + 1)};
    ground.lanesAlongZ = {area(middleX - 1, 0, middleX + 1, kStreetLow - 44), area(middleX - 1, kStreetHigh + 44, middleX + 1, edge)};
    // Zebra crossings on the two arms of the corner.
    for (int i = 0; i < 8; ++i) {
        ground.solidLines.push_back(area(kSideHigh + 8, kStreetLow + 4 + i * 10, kSideHigh + 32, kStreetLow + 9 + i * 10));
        ground.solidLines.push_back(area(kSideLow + 4 + i * 10, kStreetLow - 32, kSideLow + 9 + i * 10, kStreetLow - 8));
    }
    ground.manholes = {{176, 0, 530}, {70, 0, 392}, {420, 0, 492}};
    return ground;
}

GroundPlan townGround() {
    GroundPlan ground = streets();
    const ivec3 house = kHouse, shop = kShop;
    ground.areas.push_back({Surface::Paving, area(house.x + 78, house.z + 118, house.x + 94, kStreetLow - kPavement)});     // path to the porch
    ground.areas.push_back({Surface::Concrete, area(300, house.z + 20, 330, kStreetLow - kPavement)});                      // drive
    ground.areas.push_back({Surface::Paving, area(330, shop.z, shop.x + ShopPlan::kWidth + 20, kStreetLow - kPavement)});    // before the shop
    ground.areas.push_back({Surface::Earth, area(kTower.x - 6, kTower.z - 6, kTower.x + 56, kTower.z + 56)});
    ground.areas.push_back({Surface::Earth, area(kHouse.x + 14, kHouse.z + 100, kHouse.x + 62, kHouse.z + 106)});            // flower bed
    return ground;
}

void addFences(Level& level) {
    addStatic(level, makeConcreteWall("concrete wall", kWallLength, kWallHeight), kWall - ivec3(0, kFenceFoot, 0));
    addStatic(level, makeGate("gate", 30, 15), {kWall.x + kWallLength, -kFenceFoot, kWall.z});
    addStatic(level, makeConcreteWall("concrete wall end", 18, kWallHeight), {kWall.x + kWallLength + 30, -kFenceFoot, kWall.z});
    addStatic(level, makePicketFence("side fence", 240, 11, true), {137, -kFenceFoot, 198});
    addStatic(level, makePicketFence("yard fence", 150, 14, false), {140, -kFenceFoot, 190});
    addStatic(level, makePicketFence("far fence", 130, 10, false), {500, -kFenceFoot, 440});
    addStatic(level, makeHedge("hedge front", {44, 9, 8}), {146, -kHedgeRoot, 424});
    addStatic(level, makeHedge("hedge shop", {8, 14, 110}), {482, -kHedgeRoot, 262});
    addStatic(level, makeHedge("hedge back left", {130, 13, 9}), {136, -kHedgeRoot, 140});
    addStatic(level, makeHedge("hedge back right", {250, 13, 9}), {376, -kHedgeRoot, 140});
}

void addNeighbours(Level& level) {
    HouseStyle style;
    style.rooms = false;
    style.courses = false;
    style.width = 92, style.depth = 70;
    style.wall = &kPlasterOchre, style.roof = &kRoofTileRed, style.door = &kBlueWood;
    addHouse(level, "house ochre", {512, 0, 318}, style);
    style.wall = &kPlasterRose, style.roof = &kRoofTileBrown;
    addHouse(level, "row house 1", {140, 0, 46}, style);
    style.wall = &kPlaster, style.roof = &kRoofTileRed, style.door = &kRedWood;
    addHouse(level, "row house 2", {250, 0, 40}, style);
    style.wall = &kBrickGrey, style.roof = &kRoofTile, style.courses = true;
    addHouse(level, "row house 3", {362, 0, 46}, style);
    style.wall = &kPlasterBlue, style.roof = &kRoofTileBrown, style.courses = false, style.door = &kGreenWood;
    addHouse(level, "row house 4", {472, 0, 40}, style);
}

void addTree(Level& level, const std::string& name, ivec3 foot, int height, const Recipe& leaves, uint32_t seed) {
    LevelShape tree = makeTree(name, height, leaves, seed);
    const int half = tree.grid.size().x / 2;
    addStatic(level, std::move(tree), foot - ivec3(half, kTreeRoot, half));
}

void addTrees(Level& level) {
    addTree(level, "tree yard", {160, 0, 262}, 74, kLeaves, 3);
    addTree(level, "tree behind", {246, 0, 226}, 92, kLeavesDark, 8);
    addTree(level, "tree autumn", {500, 0, 420}, 72, kLeavesAutumn, 12);
    addTree(level, "tree shop", {470, 0, 216}, 88, kLeaves, 21);
    addTree(level, "tree far 1", {570, 0, 220}, 96, kLeavesDark, 34);
    addTree(level, "tree far 2", {90 + 60, 0, 168}, 80, kLeavesAutumn, 55);
    addTree(level, "tree far 3", {600, 0, 130}, 84, kLeaves, 61);
    addTree(level, "tree back", {420, 0, 160}, 78, kLeavesDark, 70);
}

void addStreetThings(Level& level) {
    addStreetLamp(level, "lamp corner", kCornerLamp, false);
    addStreetLamp(level, "lamp shop", kShopLamp, false);
    addStreetLamp(level, "lamp far", {540, 0, 456}, false);
    addStreetLamp(level, "lamp side", {122, 0, 236}, true);
    addLoose(level, makeCar("car red", kCarRed), kRedCar);
    addLoose(level, makeCar("car blue", kCarBlue), {300, -2, 528}, Turn::Half);
    addLoose(level, makeCar("car yellow", kCarYellow), {88, -2, 300}, Turn::Quarter);
    addLoose(level, makeCar("car cream", kCarCream), {305, 0, 372}, Turn::ThreeQuarters);
    addLoose(level, makeVan("van", kCarCream), {420, -2, 474});
    addLoose(level, makeBin("bin 1"), {128, 0, 424});
    addLoose(level, makeBin("bin 2"), {290, 0, 432});
    addLoose(level, makeBench("bench"), {360, 0, 372 + 14});
    addLoose(level, makeHydrant("hydrant"), {286, 0, 460});
    addLoose(level, makeBarrel("barrel 1", kCarBlue), {296, 0, 240});
    addLoose(level, makeBarrel("barrel 2", kCarRed), {296, 0, 250});
    addLoose(level, makeCrate("crate 1"), {338, 0, 300});
    addLoose(level, makeCrate("crate 2"), {338, 8, 300});
    addLoose(level, makeCrate("crate 3"), {338, 0, 310});
}

}  // namespace

Level town() {
    Level level;
    level.name = "town corner";
    level.environment = lateAfternoon();
    GroundPlan ground = townGround();
    addGround(level, ground);
    HouseStyle brickHouse;
    addHouse(level, "house", kHouse, brickHouse);
    addHouseFurniture(level, kHouse);
    addShop(level, "shop", kShop);
    addWaterTower(level, "water tower", kTower);
    addFences(level);
    addNeighbours(level);
    addTrees(level);
    addStreetThings(level);
    level.locations = {{"camera", lookAt({10.5, 7.2, 60.5}, {25.5, 3.4, 33.0})},
                       {"camera_house", lookAt({9.0, 4.2, 43.0}, {20.5, 3.2, 36.0})},
                       {"camera_street", lookAt({13.0, 1.7, 58.0}, {25.0, 3.0, 36.0})},
                       {"player", lookAt({15.0, 1.7, 50.0}, {20.0, 1.9, 40.0})}};
    return level;
}

}  // namespace rubble::scenes
