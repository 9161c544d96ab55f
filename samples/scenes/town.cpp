#include "samples/scenes/town.h"

#include "samples/scenes/car.h"
#include "samples/scenes/demolition.h"
#include "samples/scenes/environment.h"
#include "samples/scenes/fence.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/house.h"
#include "samples/scenes/neighbourhood.h"
#include "samples/scenes/shop.h"
#include "samples/scenes/street.h"
#include "samples/scenes/street_light.h"
#include "samples/scenes/town_plan.h"
#include "samples/scenes/tree.h"
#include "samples/scenes/water_tower.h"

namespace rubble::scenes {
namespace {

using namespace plan;
using Surface = GroundPlan::Surface;

GroundPlan townGround() {
    GroundPlan ground = crossingStreets({640, 0, 640});
    const ivec3 house = kHouse, shop = kShop;
    ground.areas.push_back({Surface::Paving, groundArea(house.x + 78, house.z + 118, house.x + 94,
                                                        kStreetLow - kPavement)});  // path to the porch
    ground.areas.push_back({Surface::Concrete, groundArea(300, house.z + 20, 330, kStreetLow - kPavement)});  // drive
    ground.areas.push_back({Surface::Paving, groundArea(330, shop.z, shop.x + ShopPlan::kWidth + 20,
                                                        kStreetLow - kPavement)});  // in front of the shop
    ground.areas.push_back({Surface::Earth, groundArea(kTower.x - 6, kTower.z - 6, kTower.x + 56, kTower.z + 56)});
    ground.areas.push_back(
        {Surface::Earth, groundArea(kHouse.x + 14, kHouse.z + 100, kHouse.x + 62, kHouse.z + 106)});  // flower bed
    return ground;
}

void addFences(Level& level) {
    addStatic(level, makeConcreteWall("concrete wall", kWallLength, kWallHeight), kWall - ivec3(0, kFenceFoot, 0));
    addStatic(level, makeGate("gate", 30, 15), {kWall.x + kWallLength, -kFenceFoot, kWall.z});
    addStatic(level, makeConcreteWall("concrete wall end", 18, kWallHeight),
              {kWall.x + kWallLength + 30, -kFenceFoot, kWall.z});
    addStatic(level, makePicketFence("side fence", 240, 11, true), {137, -kFenceFoot, 198});
    addStatic(level, makePicketFence("yard fence", 150, 14, false), {140, -kFenceFoot, 190});
    addStatic(level, makePicketFence("far fence", 130, 10, false), {500, -kFenceFoot, 440});
    addStatic(level, makeHedge("hedge front", {44, 9, 8}), {146, -kHedgeRoot, 424});
    addStatic(level, makeHedge("hedge shop", {8, 14, 110}), {482, -kHedgeRoot, 262});
    addStatic(level, makeHedge("hedge back left", {130, 13, 9}), {136, -kHedgeRoot, 140});
    addStatic(level, makeHedge("hedge back right", {250, 13, 9}), {376, -kHedgeRoot, 140});
}

void addYardTrees(Level& level, uint64_t seed) {
    addTree(level, "tree yard", {160, 0, 262}, 74, kLeaves, seed + 2);
    addTree(level, "tree behind", {246, 0, 226}, 92, kLeavesDark, seed + 7);
    addTree(level, "tree autumn", {500, 0, 420}, 72, kLeavesAutumn, seed + 11);
    addTree(level, "tree shop", {576, 0, 250}, 88, kLeaves, seed + 20);
}

void addProps(Level& level) {
    addStreetLight(level, "street light corner", kCornerStreetLight, false);
    addDynamic(level, makeCar("car red", kCarRed), kRedCar);
    addDynamic(level, makeCar("car blue", kCarBlue), {300, -2, 528}, Turn::Half);
    addDynamic(level, makeCar("car yellow", kCarYellow), {88, -2, 300}, Turn::Quarter);
    addDynamic(level, makeCar("car cream", kCarCream), {305, 0, 372}, Turn::ThreeQuarters);
    addDynamic(level, makeVan("van", kCarCream), {420, -2, 474});
    addDynamic(level, makeBin("bin 1"), {128, 0, 424});
    addDynamic(level, makeBin("bin 2"), {290, 0, 432});
    addDynamic(level, makeBench("bench"), {360, 0, 386});
    addDynamic(level, makeHydrant("hydrant"), {286, 0, 460});
    addDynamic(level, makeBarrel("barrel 1", kCarBlue), {296, 0, 240});
    addDynamic(level, makeBarrel("barrel 2", kCarRed), {296, 0, 250});
    addDynamic(level, makeCrate("crate 1"), {338, 0, 300});
    addDynamic(level, makeCrate("crate 2"), {338, 8, 300});
    addDynamic(level, makeCrate("crate 3"), {338, 0, 310});
}

}  // namespace
}  // namespace rubble::scenes

namespace rubble {

Level makeTown(uint64_t seed) {
    using namespace scenes;
    Level level;
    level.name = "town corner";
    level.environment = lateAfternoon();
    addGround(level, townGround());
    addHouse(level, "house", plan::kHouse, HouseStyle{});
    addHouseFurniture(level, plan::kHouse);
    addShop(level, "shop", plan::kShop);
    addWaterTower(level, "water tower", plan::kTower);
    addFences(level);
    addNeighbourhood(level, seed);
    addYardTrees(level, seed);
    addProps(level);
    level.locations = {{"camera", demolitionCamera(0.0)},
                       {"camera_house", lookAt({9.0, 4.2, 43.0}, {20.5, 3.2, 36.0})},
                       {"camera_street", lookAt({13.0, 1.7, 58.0}, {25.0, 3.0, 36.0})},
                       {"player", lookAt({15.0, 1.7, 50.0}, {20.0, 1.9, 40.0})}};
    return level;
}

}  // namespace rubble
