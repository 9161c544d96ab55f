#include "samples/scenes/yard.h"

#include <array>

#include "runtime/core/random.h"
#include "samples/scenes/fence.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/harbour.h"
#include "samples/scenes/house.h"
#include "samples/scenes/neighbourhood.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/street_light.h"
#include "samples/scenes/surface_styles.h"

namespace rubble {
namespace {

using namespace scenes;

constexpr CellBox kBasin{{400, -14, 110}, {620, 0, 460}};  // water, in cells
constexpr double kSurface = -0.25, kDraught = 0.45;        // metres: of the water; of the boat
constexpr ivec3 kHouse{200, 0, 70}, kPier{388, 0, 300};

/// A place of a vehicle: metres, and degrees to the left of -z.
void addPlace(Level& level, const char* kind, glm::dvec3 at, double degrees) {
    const glm::dquat turn = glm::angleAxis(glm::radians(degrees), glm::dvec3(0, 1, 0));
    level.locations.emplace_back(std::string("vehicle ") + kind, Pose{at, turn});
}

/// A round heap of earth.
void addHeap(Level& level, ivec3 cell, int across, int height) {
    Canvas c({across, height, across});
    const Swatch dirt = c.addSurface(kDirt), stone = c.addSurface(kDirt, 118);
    c.fill(ivec3(0), c.size(), [&](ivec3 at) {
        const double dx = at.x + 0.5 - 0.5 * across, dz = at.z + 0.5 - 0.5 * across;
        const double far = std::sqrt(dx * dx + dz * dz) / (0.5 * across);
        const double bump = 0.06 * double(hashCell(at.x / 3, 0, at.z / 3, 5) % 100) / 100.0;
        if (at.y > height * (1.0 - far * far - bump)) return uint8_t(0);
        return PaletteBuilder::pick(hashCell(at.x / 2, at.y / 2, at.z / 2, 9) % 7 == 0 ? stone : dirt, at);
    });
    addStatic(level, c.finish("heap"), cell);
}

/// A crate on a pallet, which a fork gets under.
LevelShape makePallet(std::string name) {
    Canvas c({10, 13, 10});
    const Swatch wood = c.addSurface(kFenceWood), side = c.addSurface(kTimber), rib = c.addSurface(kDarkWood);
    for (const int x : {0, 9}) c.box({x, 0, 0}, {x + 1, 3, 10}, wood);
    c.box({0, 3, 0}, {10, 4, 10}, wood);
    c.box({0, 4, 0}, {10, 13, 10}, side);
    c.clear({1, 5, 1}, {9, 12, 9});
    for (const int y : {4, 12})
        for (const int x : {0, 9}) c.box({x, y, 0}, {x + 1, y + 1, 10}, rib);
    for (const int x : {0, 9})
        for (const int z : {0, 9}) c.box({x, 4, z}, {x + 1, 13, z + 1}, rib);
    return c.finish(std::move(name));
}

}  // namespace

Level makeYard(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {640, 0, 480};
    ground.areas = {area(Concrete, 30, 180, 400, 460), area(Paving, 380, 90, 640, 480), area(Road, 0, 400, 380, 460),
                    area(Earth, 30, 180, 130, 300)};
    ground.lanesAlongX = {{{0, 0, 429}, {380, 0, 431}}};
    ground.foundations = {kBasin};
    Level level = makePlot("yard", ground, seed);
    addQuay(level, "quay", kBasin, kSurface);
    addPier(level, "pier", kPier, 13);
    HouseStyle style;
    style.rooms = false;
    addHouse(level, "house", kHouse, style);
    addHeap(level, {56, 0, 186}, 56, 16);
    for (int i = 0; i < 4; ++i)
        addDynamic(level, makePallet("pallet " + std::to_string(i)), {306 + i % 2 * 22, 0, 262 + i / 2 * 18});
    for (int i = 0; i < 5; ++i)
        addDynamic(level, makeBarrel("barrel " + std::to_string(i), i % 2 ? kCarRed : kCarBlue),
                   {352 + i % 3 * 9, 0, 330 + i / 3 * 9});
    addStreetLight(level, "street light 1", {200, 0, 388}, false);
    addStreetLight(level, "street light 2", {300, 0, 388}, false);
    addPlace(level, "car", {6.0, 0.02, 36.5}, 0.0);
    addPlace(level, "van", {10.5, 0.02, 36.5}, 0.0);
    addPlace(level, "truck", {15.5, 0.02, 36.0}, 0.0);
    addPlace(level, "forklift", {32.0, 0.02, 31.5}, 0.0);
    addPlace(level, "excavator", {8.4, 0.02, 28.5}, 0.0);
    addPlace(level, "crane", {23.0, 0.02, 29.0}, 12.0);
    addPlace(level, "boat", {51.0, kSurface - kDraught, 36.0}, 0.0);
    level.locations.emplace_back("player", lookAt({26.0, 0.4, 41.0}, {19.0, 1.8, 30.0}));
    return level;
}

void addDistrictVehicles(Level& level) {
    addPlace(level, "car", {40.5, -0.18, 53.8}, -90.0);
    addPlace(level, "truck", {4.4, -0.18, 22.0}, 180.0);
    addPlace(level, "van", {9.5, -0.18, 39.8}, 0.0);
    addPlace(level, "forklift", {33.0, 0.02, 28.0}, 0.0);
    addPlace(level, "excavator", {20.0, 0.02, 22.0}, 70.0);
    addPlace(level, "crane", {116.0, 0.02, 41.5}, 20.0);
    addPlace(level, "boat", {26.0, -0.35 - kDraught, 103.0}, -90.0);
}

}  // namespace rubble
