#include "samples/scenes/yard.h"

#include <array>

#include "runtime/core/random.h"
#include "samples/scenes/fence.h"
#include "samples/scenes/furniture.h"
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

/// Quay walls around the basin, with fenders and bollards.
void addQuay(Level& level) {
    constexpr int kWall = 6;
    const ivec3 size = kBasin.high - kBasin.low + ivec3(0, 1, 0);
    Canvas c(size);
    const Swatch stone = c.addSurface(kConcreteDark), rim = c.addSurface(kKerb), mud = c.addSurface(kConcrete, 70),
                 fender = c.addSurface(kRubber), iron = c.addSurface(kDarkSteel), moss = c.addSurface(kMoss, 80);
    c.box({0, 0, 0}, {size.x, 1, size.z}, mud);
    c.fill({0, 1, 0}, size, [&](ivec3 cell) {
        const int edge = std::min({cell.x, size.x - 1 - cell.x, cell.z, size.z - 1 - cell.z});
        if (edge >= kWall) return uint8_t(0);
        if (cell.y >= size.y - 2) return PaletteBuilder::pick(rim, cell);
        const bool isWet = cell.y < size.y - 3 && hashCell(cell.x / 3, cell.y, cell.z / 3, 11) % 5 < 2;
        return PaletteBuilder::pick(isWet && edge == kWall - 1 ? moss : stone, cell);
    });
    for (int z = 20; z < size.z - 20; z += 30) {
        for (const int x : {kWall, size.x - kWall - 2}) c.box({x, 6, z}, {x + 2, size.y - 2, z + 3}, fender);
        c.box({2, size.y - 1, z + 12}, {4, size.y, z + 14}, iron);
    }
    addStatic(level, c.finish("quay"), kBasin.low);
    const double low = (kBasin.low.x + kWall) * kVoxel, high = (kBasin.high.x - kWall) * kVoxel,
                 near = (kBasin.low.z + kWall) * kVoxel, far = (kBasin.high.z - kWall) * kVoxel;
    level.waters.push_back({.name = "harbour",
                            .outline = {{low, near}, {high, near}, {high, far}, {low, far}},
                            .surface = kSurface,
                            .depth = kSurface - (kBasin.low.y + 1) * kVoxel,
                            .color = {0.20f, 0.42f, 0.44f},
                            .clarity = 1.6f,
                            .waves = {.height = 0.02f, .length = 1.9f, .speed = 0.5f, .direction = 0.7f}});
}

/// A pier of planks on piles, from the quay over the water.
void addPier(Level& level) {
    constexpr ivec3 kSize{100, 18, 24};
    Canvas c(kSize);
    const Swatch board = c.addSurface(kFenceWood), pile = c.addSurface(kBark), beam = c.addSurface(kTimber);
    for (int x = 24; x < kSize.x; x += 24)
        for (const int z : {2, kSize.z - 5}) c.box({x, 0, z}, {x + 3, x + 24 < kSize.x ? 14 : 18, z + 3}, pile);
    for (const int z : {2, kSize.z - 5}) c.box({0, 13, z}, {kSize.x, 14, z + 3}, beam);
    c.fill({0, 14, 0}, {kSize.x, 15, kSize.z}, [&](ivec3 cell) {
        return cell.x % 4 == 3 ? uint8_t(0) : PaletteBuilder::pickFor(board, hashCell(cell.x / 4, 0, 0, 23));
    });
    for (int z = 0; z < kSize.z; ++z) c.box({3, 14, z}, {4, 15, z + 1}, board);
    for (const int z : {4, kSize.z - 6}) c.box({0, 14, z}, {kSize.x, 15, z + 2}, board);  // holds the planks together
    addStatic(level, c.finish("pier"), kPier - ivec3(0, 13, 0));
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
    addQuay(level);
    addPier(level);
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

void addTownVehicles(Level& level) {
    addPlace(level, "car", {40.5, -0.18, 53.8}, -90.0);
    addPlace(level, "truck", {4.4, -0.18, 22.0}, 180.0);
    addPlace(level, "van", {9.5, -0.18, 39.8}, 0.0);
    addPlace(level, "forklift", {33.0, 0.02, 28.0}, 0.0);
    addPlace(level, "excavator", {20.0, 0.02, 22.0}, 70.0);
}

}  // namespace rubble
