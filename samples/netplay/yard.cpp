#include "samples/netplay/yard.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace netplay {
namespace {

constexpr uint8_t kWood = 5, kConcrete = 6, kBrick = 7, kGlass = 15;  // entries of a new shape's palette
constexpr int kSide = 60, kStorey = 26, kHeight = 80;                 // of a house, in cells of 10 cm
constexpr int kWall = 2, kPane = 12;                                  // thickness; width of a window

/// Gives a shape of white materials their colours.
void paint(rubble::World& world, rubble_shape shape) {
    struct Look {
        uint8_t entry, color[3], opacity, roughness;
    };
    static constexpr Look kLooks[] = {{kWood, {150, 100, 55}, 255, 200},
                                      {kConcrete, {150, 148, 142}, 255, 230},
                                      {kBrick, {142, 92, 76}, 255, 230},
                                      {kGlass, {170, 210, 215}, 80, 10}};
    for (const Look& look : kLooks) {
        rubble_palette_range range{};
        range.shape = shape, range.first = look.entry, range.count = 1;
        rubble_palette_entry entry{};
        std::copy_n(look.color, 3, entry.color);
        entry.opacity = look.opacity, entry.roughness = look.roughness, entry.reflectivity = 10;
        entry.material = look.entry;
        world.set_palette(range, &entry);
    }
}

rubble_body makeStatic(rubble::World& world, double x, double y, double z) {
    rubble_body_settings settings{};
    settings.flags = RUBBLE_BODY_STATIC;
    settings.position[0] = x, settings.position[1] = y, settings.position[2] = z;
    return world.create_body(settings);
}

bool isWindow(int along, int height) {
    const int inStorey = height % kStorey;
    return along % (2 * kPane) >= kPane / 2 && along % (2 * kPane) < kPane / 2 + kPane && inStorey >= 9 &&
           inStorey < 19;
}

/// What a cell of a house is made of; 0: nothing.
uint8_t houseCell(int x, int y, int z) {
    const bool isWallX = x < kWall || x >= kSide - kWall, isWallZ = z < kWall || z >= kSide - kWall;
    if (y % kStorey >= kStorey - 2) return kConcrete;
    if (isWallX && isWallZ) return kBrick;
    if (isWallX || isWallZ) {
        if (!isWindow(isWallX ? z : x, y)) return kBrick;
        return (isWallX ? x : z) % (kSide - 1) == 0 ? kGlass : 0;
    }
    return x / 2 == kSide / 4 && y % kStorey < 10 && z > 20 && z < 40 ? kWood : 0;
}

/// floor: has the palette.
void buildHouse(rubble::World& world, rubble_shape floor, double x, double z) {
    rubble_shape_settings house{};
    house.body = makeStatic(world, x - 0.05 * kSide, 0.0, z - 0.05 * kSide);
    house.source = RUBBLE_SHAPE_INDICES, house.palette_of = floor;
    house.size[0] = kSide, house.size[1] = kHeight, house.size[2] = kSide;
    std::vector<uint8_t> cells(size_t(kSide) * kHeight * kSide);
    for (int cz = 0, i = 0; cz < kSide; ++cz)
        for (int cy = 0; cy < kHeight; ++cy)
            for (int cx = 0; cx < kSide; ++cx, ++i) cells[size_t(i)] = houseCell(cx, cy, cz);
    house.indices = cells.data(), house.count = cells.size();
    world.create_shape(house);
}

}  // namespace

double housePlace(int index, int rows) {
    return 14.0 * (index - 0.5 * (rows - 1));
}

void buildYard(rubble::World& world, int rows) {
    rubble_bounds bounds{};
    bounds.low[0] = bounds.low[2] = -kYardHalf - 16.0, bounds.low[1] = -4.0;
    bounds.high[0] = bounds.high[2] = kYardHalf + 16.0, bounds.high[1] = 64.0;
    world.set_bounds(bounds);
    rubble_shape_settings floor{};
    floor.body = makeStatic(world, -kYardHalf, -0.4, -kYardHalf);
    floor.source = RUBBLE_SHAPE_BOX;
    floor.size[0] = floor.size[2] = int32_t(20 * kYardHalf), floor.size[1] = 4;
    floor.index = kConcrete;
    const rubble_shape ground = world.create_shape(floor);
    paint(world, ground);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < rows; ++column)
            buildHouse(world, ground, housePlace(row, rows), housePlace(column, rows));
    world.step();
}

}  // namespace netplay
