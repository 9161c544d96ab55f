#include "samples/scenes/district.h"

#include <algorithm>

#include "samples/scenes/barn.h"
#include "samples/scenes/building_site.h"
#include "samples/scenes/car.h"
#include "samples/scenes/fence.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/harbour.h"
#include "samples/scenes/house.h"
#include "samples/scenes/museum.h"
#include "samples/scenes/neighbourhood.h"
#include "samples/scenes/office_tower.h"
#include "samples/scenes/petrol_station.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/power_line.h"
#include "samples/scenes/steel_bridge.h"
#include "samples/scenes/street_light.h"
#include "samples/scenes/town.h"
#include "samples/scenes/town_plan.h"
#include "samples/scenes/tree.h"

namespace rubble::scenes {
namespace {

using namespace plan;
using Surface = GroundPlan::Surface;

constexpr ivec3 kSize{1440, 0, 1280};
constexpr int kEastLow = 700, kEastHigh = 782;  // x of the second street along z
constexpr int kQuayLow = 900;                   // z at which the quays' paving begins
constexpr CellBox kCanal{{60, -22, 960}, {1380, 0, 1122}};
constexpr double kCanalSurface = -0.35;  // metres
constexpr ivec3 kBridge{(kEastLow + kEastHigh - SteelBridge::kWidth) / 2, 0, 949};
constexpr ivec3 kOfficeTower{880, 0, 250}, kSite{1060, 0, 150}, kStation{180, 0, 586}, kMuseum{900, 0, 640},
    kBarn{240, 0, 1150};

/// Streets of the town, longer, with another one that crosses the canal.
GroundPlan districtGround() {
    GroundPlan ground = crossingStreets(kSize);
    ground.depth = 28;
    const int middle = (kEastLow + kEastHigh) / 2, streetMiddle = (kStreetLow + kStreetHigh) / 2;
    const auto add = [&](Surface surface, int x0, int z0, int x1, int z1) {
        ground.areas.push_back({surface, groundArea(x0, z0, x1, z1)});
    };
    add(Surface::Paving, kEastLow - kPavement, 0, kEastHigh + kPavement, kSize.z);
    add(Surface::Paving, 40, kQuayLow, kSize.x - 40, kCanal.low.z + 10);
    add(Surface::Paving, 40, kCanal.high.z - 10, kSize.x - 40, kCanal.high.z + 26);
    add(Surface::Paving, kMuseum.x - 20, kMuseum.z + MuseumPlan::kDepth, kMuseum.x + MuseumPlan::kWidth + 20, kQuayLow);
    add(Surface::Paving, kOfficeTower.x - 16, kOfficeTower.z - 10, kOfficeTower.x + OfficeTower::kSide + 16,
        kStreetLow - kPavement);
    add(Surface::Concrete, kStation.x - 6, kStreetHigh + 8, kStation.x + 206, kStation.z + 156);
    add(Surface::Earth, kSite.x, kSite.z, kSite.x + 260, kSite.z + 240);
    add(Surface::Earth, kBarn.x + 30, kBarn.z + 90, kBarn.x + 110, kSize.z);
    add(Surface::Road, kEastLow, 0, kEastHigh, kSize.z);
    add(Surface::Road, 0, kStreetLow, kSize.x, kStreetHigh);
    add(Surface::Road, kSideLow, kSideEnd, kSideHigh, kQuayLow);
    add(Surface::Paving, 0, kQuayLow, kSideHigh + kPavement, kQuayLow + 40);
    add(Surface::Paving, kBridge.x, kCanal.low.z - 12, kBridge.x + SteelBridge::kWidth, kCanal.low.z);
    ground.lanesAlongX = {groundArea(kSideHigh + 44, streetMiddle - 1, kEastLow - 44, streetMiddle + 1),
                          groundArea(kEastHigh + 44, streetMiddle - 1, kSize.x, streetMiddle + 1)};
    ground.lanesAlongZ.push_back(groundArea(middle - 1, 0, middle + 1, kStreetLow - 44));
    ground.lanesAlongZ.push_back(groundArea(middle - 1, kStreetHigh + 44, middle + 1, kBridge.z));
    ground.lanesAlongZ.push_back(groundArea(middle - 1, kBridge.z + SteelBridge::kLength, middle + 1, kSize.z));
    for (int i = 0; i < 8; ++i) {
        for (const int x : {kEastLow - 32, kEastHigh + 8})
            ground.solidLines.push_back(groundArea(x, kStreetLow + 4 + i * 10, x + 24, kStreetLow + 9 + i * 10));
        for (const int z : {kStreetLow - 32, kStreetHigh + 8})
            ground.solidLines.push_back(groundArea(kEastLow + 4 + i * 10, z, kEastLow + 9 + i * 10, z + 24));
    }
    ground.manholes.insert(ground.manholes.end(), {{740, 0, 300}, {720, 0, 820}, {1080, 0, 520}});
    ground.foundations = {
        kCanal,
        {kBridge - ivec3(0, SteelBridge::kDepth, 0), kBridge + ivec3(SteelBridge::kWidth, 0, SteelBridge::kLength)}};
    return ground;
}

void addRowOfHouses(Level& level) {
    static constexpr const SurfaceStyle* kWalls[] = {&kPlasterRose, &kBrick, &kPlasterOchre, &kPlasterBlue};
    static constexpr const SurfaceStyle* kRoofs[] = {&kRoofTileRed, &kRoofTile, &kRoofTileBrown, &kRoofTileRed};
    static constexpr const SurfaceStyle* kDoors[] = {&kBlueWood, &kGreenWood, &kRedWood, &kGreenWood};
    for (int i = 0; i < 4; ++i) {
        HouseStyle style;
        style.wall = kWalls[i], style.roof = kRoofs[i], style.door = kDoors[i], style.courses = i == 1;
        addHouse(level, "quay house " + std::to_string(i + 1), {146 + i * 132, 0, 764}, style);
    }
    addStatic(level, makePicketFence("quay fence 1", 250, 10, false), {140, -kFenceFoot, 890});
    addStatic(level, makePicketFence("quay fence 2", 250, 10, false), {404, -kFenceFoot, 890});
}

void addCanal(Level& level) {
    addQuay(level, "canal", kCanal, kCanalSurface);
    addPier(level, "canal pier", {kCanal.low.x + 4, 0, 1010}, 21);
    addSteelBridge(level, kBridge);
    for (int i = 0; i < 4; ++i)
        addDynamic(level, makeBench("quay bench " + std::to_string(i + 1)), {220 + i * 130, 0, 930}, Turn::Half);
    int lights = 0;
    for (const int x : {200, 400, 610, 850, 1060, 1270})
        addStreetLight(level, "quay light " + std::to_string(++lights), {x, 0, 940}, false);
}

/// Trees along the quays, around the museum and on the far bank.
void addTrees(Level& level, uint64_t seed) {
    static constexpr const SurfaceStyle* kCrowns[] = {&kLeaves, &kLeavesDark, &kLeavesAutumn, &kLeaves};
    int count = 0;
    const auto tree = [&](int x, int z, int height) {
        addTree(level, "district tree " + std::to_string(count), {x, 0, z}, height, *kCrowns[count % 4],
                seed + 100 + uint64_t(count));
        ++count;
    };
    for (const int x : {850, 1140})
        for (const int z : {660, 730, 810, 880}) tree(x, z, 72 + z % 17);
    for (int x = 470; x < 1400; x += 84 + x % 23) tree(x, 1196 + x % 31, 74 + x % 21);
    for (int x = 840; x < 1400; x += 92 + x % 19) tree(x, 40 + x % 23, 78 + x % 15);
    for (const int x : {1180, 1250, 1330})
        for (const int z : {640, 740, 840}) tree(x + z % 29, z, 70 + x % 23);
    for (const int x : {150, 410, 640}) tree(x, 720, 66 + x % 13);
    for (const int z : {300, 400}) tree(650, z, 76);
    tree(180, 1220, 84), tree(430, 1236, 70);
}

void addTraffic(Level& level) {
    addDynamic(level, makeCar("district car 1", kCarBlue), {900, -kRoadDrop, 478});
    addDynamic(level, makeCar("district car 2", kCarYellow), {1180, -kRoadDrop, 528}, Turn::Half);
    addDynamic(level, makeCar("district car 3", kCarCream), {760, -kRoadDrop, 640}, Turn::ThreeQuarters);
    addDynamic(level, makeCar("district car 4", kCarRed), {246, 0, 626});
    addDynamic(level, makeVan("district van", kCarYellow), {704, -kRoadDrop, 330}, Turn::Quarter);
    addDynamic(level, makeCar("bridge car", kCarBlue), {720, -kRoadDrop, 1010}, Turn::Quarter);
}

}  // namespace
}  // namespace rubble::scenes

namespace rubble {

Level makeDistrict(uint64_t seed) {
    using namespace scenes;
    Level level = makeTown(seed);
    level.name = "town of four blocks";
    std::erase_if(level.bodies, [](const LevelBody& body) { return body.name == "ground"; });
    const GroundPlan ground = districtGround();
    addGround(level, ground);
    std::rotate(level.bodies.begin(), level.bodies.end() - 1, level.bodies.end());  // the ground comes first
    addSlopes(level, ground, 72);
    addOfficeTowerWithLift(level, kOfficeTower);
    addBuildingSite(level, kSite);
    addPetrolStation(level, kStation);
    addRowOfHouses(level);
    addMuseum(level, kMuseum);
    addCanal(level);
    addBarn(level, kBarn);
    addPowerLine(level, {840, 0, 566}, 5, 130);
    addTrees(level, seed);
    addTraffic(level);
    level.locations.insert(level.locations.end(), {{"camera_district", lookAt({150.0, 46.0, 150.0}, {70.0, 0.0, 62.0})},
                                                   {"camera_canal", lookAt({58.0, 4.0, 93.0}, {84.0, 3.0, 104.0})},
                                                   {"camera_museum", lookAt({92.0, 2.2, 91.0}, {100.0, 5.0, 70.0})},
                                                   {"camera_station", lookAt({14.0, 3.0, 53.0}, {28.0, 2.5, 63.0})},
                                                   {"camera_site", lookAt({104.0, 6.0, 45.0}, {122.0, 5.0, 24.0})}});
    return level;
}

}  // namespace rubble
