#include "samples/scenes/neighbourhood.h"

#include <algorithm>

#include "samples/scenes/house.h"
#include "samples/scenes/street_light.h"
#include "samples/scenes/town_plan.h"
#include "samples/scenes/tree.h"

namespace rubble::scenes {

using namespace plan;
using Surface = GroundPlan::Surface;

GroundPlan crossingStreets(ivec3 size) {
    GroundPlan ground;
    ground.size = size;
    const int edge = std::max(size.x, size.z);
    ground.areas = {
        {Surface::Paving, groundArea(0, kStreetLow - kPavement, edge, kStreetHigh + kPavement)},
        {Surface::Paving, groundArea(kSideLow - kPavement, kSideEnd - kPavement, kSideHigh + kPavement, edge)},
        {Surface::Road, groundArea(0, kStreetLow, edge, kStreetHigh)},
        {Surface::Road, groundArea(kSideLow, kSideEnd, kSideHigh, edge)},
    };
    const int middleZ = (kStreetLow + kStreetHigh) / 2, middleX = (kSideLow + kSideHigh) / 2;
    ground.lanesAlongX = {groundArea(kSideHigh + 44, middleZ - 1, edge, middleZ + 1)};
    ground.lanesAlongZ = {groundArea(middleX - 1, kSideEnd, middleX + 1, kStreetLow - 44),
                          groundArea(middleX - 1, kStreetHigh + 44, middleX + 1, edge)};
    // Zebra crossings on two arms of the crossing.
    for (int i = 0; i < 8; ++i) {
        ground.solidLines.push_back(
            groundArea(kSideHigh + 8, kStreetLow + 4 + i * 10, kSideHigh + 32, kStreetLow + 9 + i * 10));
        ground.solidLines.push_back(
            groundArea(kSideLow + 4 + i * 10, kStreetLow - 32, kSideLow + 9 + i * 10, kStreetLow - 8));
    }
    ground.manholes = {{176, 0, 530}, {70, 0, 392}, {420, 0, 492}};
    return ground;
}

void addTree(Level& level, const std::string& name, ivec3 foot, int height, const SurfaceStyle& leaves, uint64_t seed) {
    LevelShape tree = makeTree(name, height, leaves, seed);
    const int half = tree.grid.size().x / 2;
    addStatic(level, std::move(tree), foot - ivec3(half, kTreeRoot, half));
}

namespace {

void addHouses(Level& level) {
    HouseStyle style;
    style.rooms = false;
    style.courses = false;
    style.width = 92, style.depth = 70;
    style.wall = &kPlasterOchre, style.roof = &kRoofTileRed, style.door = &kBlueWood;
    addHouse(level, "house ochre", {512, 0, 318}, style);
    style.wall = &kPlaster, style.roof = &kRoofTileRed, style.door = &kGreenWood;
    addHouse(level, "row house 0", {24, 0, 40}, style);
    style.wall = &kPlasterRose, style.roof = &kRoofTileBrown;
    addHouse(level, "row house 1", {140, 0, 46}, style);
    style.wall = &kPlaster, style.roof = &kRoofTileRed, style.door = &kRedWood;
    addHouse(level, "row house 2", {250, 0, 40}, style);
    style.wall = &kBrickGrey, style.roof = &kRoofTile, style.courses = true;
    addHouse(level, "row house 3", {362, 0, 46}, style);
    style.wall = &kPlasterBlue, style.roof = &kRoofTileBrown, style.courses = false, style.door = &kGreenWood;
    addHouse(level, "row house 4", {472, 0, 40}, style);
}

}  // namespace

void addNeighbourhood(Level& level, uint64_t seed) {
    addHouses(level);
    addStreetLight(level, "street light far", {540, 0, 456}, false);
    addStreetLight(level, "street light side", {122, 0, 236}, true);
    addTree(level, "tree far 1", {590, 0, 190}, 96, kLeavesDark, seed + 33);
    addTree(level, "tree far 2", {150, 0, 168}, 80, kLeavesAutumn, seed + 54);
    addTree(level, "tree far 3", {600, 0, 130}, 84, kLeaves, seed + 60);
    addTree(level, "tree back", {350, 0, 170}, 78, kLeavesDark, seed + 69);
}

}  // namespace rubble::scenes
