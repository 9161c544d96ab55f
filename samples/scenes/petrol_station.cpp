#include "samples/scenes/petrol_station.h"

#include <algorithm>

#include "runtime/core/random.h"
#include "samples/scenes/building.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr int kY = kFooting;  // of the yard's surface
constexpr ivec3 kCanopyLow{24, kY + 46, 8}, kCanopyHigh{176, kY + 55, 88};
constexpr ivec3 kShopLow{44, 0, 104}, kShopHigh{160, 0, 148};
constexpr int kShopRoof = kY + 30;

/// Plates below and above, with a band of colour around.
void drawCanopy(Level& level, Canvas& c) {
    const Swatch white = c.addSurface(kWhiteEnamel), red = c.addSurface(kStationRed), steel = c.addSurface(kSteel);
    const uint32_t group = addLightGroup(level, "petrol canopy", 0.5f);
    const Swatch glow = c.addSurface(kShopGlow, 100, group);
    const ivec3 low = kCanopyLow, high = kCanopyHigh;
    for (const int y : {low.y, high.y - 1}) c.box({low.x, y, low.z}, {high.x, y + 1, high.z}, white);
    c.fill(low, high, [&](ivec3 cell) {
        const int edge = std::min({cell.x - low.x, high.x - 1 - cell.x, cell.z - low.z, high.z - 1 - cell.z});
        if (edge > 0) return c.at(cell);
        return PaletteBuilder::pick(cell.y >= low.y + 2 && cell.y < low.y + 6 ? red : white, cell);
    });
    for (int x = low.x + 12; x < high.x; x += 14) c.box({x, low.y + 1, low.z}, {x + 1, high.y - 1, high.z}, steel);
    for (int z = low.z + 12; z < high.z; z += 14) c.box({low.x, low.y + 1, z}, {high.x, high.y - 1, z + 1}, steel);
    for (const int x : {54, 142})
        for (const int z : {30, 62}) {
            c.box({x, 0, z}, {x + 4, low.y, z + 4}, white);
            c.box({x, kY, z}, {x + 4, kY + 10, z + 4}, red);
        }
    for (const int x : {38, 76, 112, 150})
        for (const int z : {20, 46, 72}) {
            c.box({x, low.y, z}, {x + 12, low.y + 1, z + 4}, glow);
            if (z == 46)
                addLight(level, "petrol station", group, LightKind::Cone, glm::dvec3(x + 6, low.y - 1, z + 2),
                         glm::vec3(1.0f, 0.95f, 0.86f) * 90.0f, 10.0f, 0.3f);
        }
}

/// A flat-roofed shop with a front of glass toward the pumps, and shelves.
void drawKiosk(Level& level, Canvas& c) {
    const Swatch wall = c.addSurface(kPlaster), brick = c.addSurface(kBrickGrey), glass = c.addSurface(kGlass),
                 frame = c.addSurface(kDarkSteel), roof = c.addSurface(kRoofFelt), red = c.addSurface(kStationRed, 92),
                 wood = c.addSurface(kTimber), goods = c.addSurface(kGoods), tile = c.addSurface(kTileWhite);
    const uint32_t group = addLightGroup(level, "petrol shop");
    const Swatch glow = c.addSurface(kShopGlow, 96, group);
    const ivec3 low = kShopLow, high = kShopHigh;
    c.box({low.x, 0, low.z}, {high.x, kY, high.z}, tile);
    c.fill({low.x, kY, low.z}, {high.x, kShopRoof + 5, high.z}, [&](ivec3 cell) {
        const int edge = std::min({cell.x - low.x, high.x - 1 - cell.x, cell.z - low.z, high.z - 1 - cell.z});
        if (edge > 2) return uint8_t(0);
        return PaletteBuilder::pick(edge < 2 ? brick : wall, cell);
    });
    c.box({low.x, kShopRoof - 2, low.z}, {high.x, kShopRoof, high.z}, wall);
    c.box({low.x + 3, kShopRoof, low.z + 3}, {high.x - 3, kShopRoof + 1, high.z - 3}, roof);
    c.box({low.x, kShopRoof + 1, low.z}, {high.x, kShopRoof + 4, low.z + 1}, red);
    c.fill({low.x + 6, kY + 1, low.z}, {high.x - 6, kY + 24, low.z + 3}, [&](ivec3 cell) {
        const int u = cell.x - low.x - 6;
        const bool isDoor = u >= 44 && u < 60;
        if (isDoor && (cell.z != low.z + 1 || (u != 44 && u != 59 && cell.y < kY + 22))) return uint8_t(0);
        if (cell.z != low.z + 1) return cell.y < kY + 5 ? c.at(cell) : uint8_t(0);
        const bool isPost = u % 15 == 14 || u == 0 || cell.y == kY + 23 || cell.y == kY + 5 || isDoor;
        if (cell.y < kY + 5 && !isDoor) return c.at(cell);
        return PaletteBuilder::pick(isPost ? frame : glass, cell);
    });
    for (int row = 0; row < 3; ++row) {
        const int x = low.x + 14 + row * 24 + (row > 1 ? 18 : 0);
        for (int y = kY; y < kY + 16; y += 5) c.box({x, y, low.z + 14}, {x + 14, y + 1, high.z - 10}, wood);
        c.box({x + 6, kY, low.z + 14}, {x + 8, kY + 16, high.z - 10}, wood);
        c.fill({x + 1, kY + 1, low.z + 15}, {x + 13, kY + 15, high.z - 11}, [&](ivec3 cell) {
            const uint32_t dice = hashCell(cell.x / 2, (cell.y - kY) / 5, cell.z / 2, 207);
            const bool isEmpty = c.at(cell) || (cell.y - kY) % 5 > 2 + int(dice >> 9 & 1) || dice % 5 == 0;
            return isEmpty ? c.at(cell) : PaletteBuilder::pickFor(goods, dice >> 4);
        });
    }
    for (const int x : {low.x + 22, low.x + 58, low.x + 94}) {
        c.box({x - 6, kShopRoof - 3, low.z + 20}, {x + 6, kShopRoof - 2, low.z + 22}, glow);
        addLight(level, "petrol station", group, LightKind::Sphere, glm::dvec3(x, kShopRoof - 5, low.z + 21),
                 glm::vec3(1.0f, 0.9f, 0.74f) * 8.0f, 7.0f, 0.25f);
    }
}

/// A post with a board of prices.
void drawSign(Level& level, Canvas& c) {
    const Swatch post = c.addSurface(kSteel, 96), board = c.addSurface(kStationRed, 104);
    const uint32_t group = addLightGroup(level, "petrol sign", 0.3f);
    const Swatch glow = c.addSurface(kSignAmber, 100, group);
    c.box({8, 0, 4}, {10, kY + 40, 7}, post);
    c.box({2, kY + 36, 4}, {16, kY + 66, 7}, board);
    for (int row = 0; row < 3; ++row)
        for (int x = 0; x < 10; ++x)
            for (int y = 0; y < 5; ++y)
                if (hashCell(x, y, row, 219) % 8 < 5 && x % 4 != 3)
                    for (const int z : {3, 7}) c.set({4 + x, kY + 40 + row * 9 + y, z}, glow);
}

LevelShape makePump(std::string name) {
    Canvas c({9, 17, 6});
    const Swatch white = c.addSurface(kWhiteEnamel), red = c.addSurface(kStationRed),
                 dark = c.addSurface(kPlasticBlack), steel = c.addSurface(kSteel);
    c.box({0, 0, 0}, {9, 1, 6}, steel);
    c.box({1, 1, 1}, {8, 16, 5}, white);
    c.box({1, 9, 1}, {8, 11, 5}, red);
    c.box({1, 15, 1}, {8, 17, 5}, red);
    for (const int z : {1, 4}) c.box({2, 12, z}, {7, 14, z + 1}, dark);
    c.box({0, 3, 2}, {1, 9, 3}, dark);
    c.box({0, 8, 2}, {1, 11, 4}, steel);
    LevelShape pump = c.finish(std::move(name));
    pump.tags = {"explosive"};
    return pump;
}

}  // namespace

void addPetrolStation(Level& level, ivec3 cell) {
    Canvas c({200, kY + 70, 150});
    drawCanopy(level, c);
    drawKiosk(level, c);
    drawSign(level, c);
    const Swatch kerb = c.addSurface(kKerb);
    for (const int z : {28, 60})
        for (const int x : {66, 106}) c.box({x, 0, z}, {x + 30, kY + 2, z + 8}, kerb);
    c.removeUnanchored();
    const ivec3 corner = cell - ivec3(0, kFooting, 0);
    addStatic(level, c.finish("petrol station"), corner);
    int count = 0;
    for (const int z : {29, 61})
        for (const int x : {74, 118})
            addDynamic(level, makePump("petrol pump " + std::to_string(++count)), corner + ivec3(x, kY + 2, z));
}

}  // namespace rubble::scenes
