#include "samples/scenes/demolition.h"

#include <glm/geometric.hpp>

#include "samples/scenes/house.h"
#include "samples/scenes/lettering.h"
#include "samples/scenes/script_clock.h"
#include "samples/scenes/shop.h"
#include "samples/scenes/town_plan.h"
#include "samples/scenes/water_tower.h"

namespace rubble {
namespace {

using namespace scenes;
using glm::dvec3;

/// A point in the world, in metres, given in cells of the house's shape.
dvec3 inHouse(double x, double y, double z) {
    return (dvec3(plan::kHouse) - dvec3(kHouseMargin, kFooting, kHouseMargin) + dvec3(x, y, z)) * kVoxel;
}

/// A smile on the sunlit brick wall, and the word BOOM on the concrete one.
void spray(ScriptClock& clock) {
    constexpr std::array<uint8_t, 3> kYellow{250, 205, 30}, kBlue{20, 40, 120}, kPink{240, 30, 130};
    const dvec3 face = inHouse(8.5, 31.0, 45.0);
    for (int i = clock.first(0.45, 40, 0.9); i < clock.last(0.45, 40, 0.9); ++i) {
        // Strokes from side to side, a disc of 0.9 m in all.
        const double y = -0.8 + 1.6 * (i / 5) / 7.0, half = glm::sqrt(std::max(0.0, 0.81 - y * y)),
                     z = half * (i % 5 - 2) / 2.0;
        clock.add(PaintEdit{face + dvec3(0, y, i / 5 % 2 ? -z : z), 0.24, kYellow, 215, 235, uint32_t(i)});
    }
    static constexpr int kFace[][2] = {{-3, 3},  {-3, 2}, {3, 3},  {3, 2},  {-5, -1}, {-4, -3}, {-3, -4},
                                       {-1, -5}, {0, -5}, {1, -5}, {3, -4}, {4, -3},  {5, -1}};
    for (int i = clock.first(0.95, 13, 1.25); i < clock.last(0.95, 13, 1.25); ++i)
        clock.add(
            PaintEdit{face + dvec3(0.0, kFace[i][1] * 0.1, kFace[i][0] * 0.1), 0.13, kBlue, 250, 255, uint32_t(i)});

    constexpr std::string_view kWord = "BOOM";
    const dvec3 wall = (dvec3(plan::kWall) + dvec3(8.5, 3.5, 3.5)) * kVoxel;
    for (int letter = clock.first(0.5, 4, 1.4); letter < clock.last(0.5, 4, 1.4); ++letter)
        for (int row = 0; row < kLetterHeight; ++row)
            for (int column = 0; column < kLetterWidth; ++column)
                if (letterRows(kWord[size_t(letter)])[row] >> (kLetterWidth - 1 - column) & 1)
                    clock.add(
                        PaintEdit{wall + dvec3(letter * kLetterAdvance + column, kLetterHeight - 1 - row, 0) * kVoxel,
                                  0.08, kPink, 255, 255, 0});
}

void hammer(ScriptClock& clock) {
    static constexpr double kHits[][3] = {{8.5, 20, 96}, {8.5, 26, 92}, {8.5, 40, 78}, {8.5, 16, 66}, {8.5, 22, 70}};
    for (int i = clock.first(1.45, 5, 1.8); i < clock.last(1.45, 5, 1.8); ++i)
        clock.add(carveSphere(inHouse(kHits[i][0], kHits[i][1], kHits[i][2]), {0.42, 0.3, 0.0}));
}

/// Charges inside the rooms blow out the walls that face the sun: ground floor, upper floor, then the front. Sunlight
/// enters the rooms.
void blowWalls(ScriptClock& clock) {
    const dvec3 low = inHouse(9.5, 17.0, 80.0), high = inHouse(9.5, 43.0, 78.0), front = inHouse(34.0, 29.0, 102.5);
    if (clock.at(2.58)) clock.add(ExplodeEdit{low + dvec3(0.9, -0.3, 0.1), 2.5});
    if (clock.at(3.47)) clock.add(ExplodeEdit{high + dvec3(0.9, -0.3, 0.1), 2.3});
    if (clock.at(4.36)) clock.add(ExplodeEdit{front + dvec3(0.1, -1.0, -0.9), 2.4});
}

/// A cut round the upper floor of the front room; when the last edge is cut, the floor falls with the furniture on it.
void cutFloor(ScriptClock& clock) {
    const double y = 29.9;
    const dvec3 corners[4] = {inHouse(12.5, y, 58.5), inHouse(12.5, y, 99.5), inHouse(60.5, y, 99.5),
                              inHouse(60.5, y, 58.5)};
    constexpr int kCuts = 8;
    for (int side = 0; side < 4; ++side) {
        const double start = 4.15 + side * 0.2;
        const dvec3 from = corners[side], to = corners[(side + 1) % 4];
        for (int i = clock.first(start, kCuts, start + 0.2); i < clock.last(start, kCuts, start + 0.2); ++i)
            clock.add(carveCapsule(from + (to - from) * (double(i) / kCuts),
                                   from + (to - from) * (double(i + 1) / kCuts), {0.27, 0.0, 0.0}));
    }
    // Removes what is still connected to the inner faces of the bricks.
    if (clock.at(5.02))
        for (int side = 0; side < 4; ++side)
            clock.add(carveCapsule(corners[side], corners[(side + 1) % 4], {0.28, 0.12, 0.0}));
}

/// Shoots the street light's head and the porch light: their light groups go out.
void shootLights(ScriptClock& clock) {
    const dvec3 head = (dvec3(plan::kCornerStreetLight) + dvec3(0.5, 51.0, 13.0)) * kVoxel;
    if (clock.at(5.95)) clock.add(carveSphere(head, {0.45, 0.45, 0.45}));
    if (clock.at(6.1)) clock.add(carveSphere(inHouse(93.5, 23.5, 114.5), {0.35, 0.3, 0.0}));
}

/// Cuts a long gap into the leg next to the shop and a short one into the farthest: the tower tips over onto the shop.
void fellTower(ScriptClock& clock) {
    const auto leg = [&](int i, double low, double high) {
        const dvec3 foot = (dvec3(plan::kTower) + dvec3(WaterTowerPlan::kLegs[i]) + dvec3(1.5, 0, 1.5)) * kVoxel;
        clock.add(carveCapsule(foot + dvec3(0, low, 0), foot + dvec3(0, high, 0), {0.4, 0.4, 0.4}));
    };
    if (clock.at(5.5)) leg(2, 0.6, 4.2);
    if (clock.at(5.62)) leg(3, 0.8, 2.4);
    if (clock.at(5.74)) leg(0, 0.8, 2.4);
    if (clock.at(5.9)) {
        const dvec3 pipe = (dvec3(plan::kTower) + dvec3(24, 0, 24)) * kVoxel;
        clock.add(carveCapsule(pipe + dvec3(0, 0.7, 0), pipe + dvec3(0, 3.6, 0), {0.5, 0.5, 0.5}));
    }
    if (clock.at(6.05)) leg(1, 1.0, 1.3);
}

void breakShop(ScriptClock& clock) {
    const dvec3 front = (dvec3(plan::kShop) + dvec3(30, 15, ShopPlan::kDepth - 1.5)) * kVoxel;
    if (clock.at(7.15)) clock.add(ExplodeEdit{front + dvec3(1.0, -0.4, -1.2), 1.6});
}

/// After the tower has landed on the shop, a charge puts out the shop's sign.
void breakSign(ScriptClock& clock) {
    const dvec3 sign = (dvec3(plan::kShop) + dvec3(60, 46, ShopPlan::kDepth + 2)) * kVoxel;
    if (clock.at(8.75)) clock.add(ExplodeEdit{sign, 1.8});
}

void blowCarAndWall(ScriptClock& clock) {
    const dvec3 car = (dvec3(plan::kRedCar) + dvec3(16.0, -5.0, 7.0)) * kVoxel;
    if (clock.at(7.9)) clock.add(ExplodeEdit{car, 1.2, 1.6e5});
    const dvec3 wall = (dvec3(plan::kWall) + dvec3(64, 7, 2.5)) * kVoxel;
    if (clock.at(8.88)) clock.add(ExplodeEdit{wall + dvec3(0, -0.2, -0.5), 1.6});
}

/// Last, the roof over the open rooms is blown up.
void blowRoof(ScriptClock& clock) {
    const dvec3 roof = inHouse(36.0, 70.0, 86.0);
    if (clock.at(9.55)) clock.add(ExplodeEdit{roof - dvec3(0, 0.9, 0.2), 2.3});
}

}  // namespace

Edits demolition(int step, uint64_t) {
    ScriptClock clock(step);
    spray(clock);
    hammer(clock);
    blowWalls(clock);
    cutFloor(clock);
    fellTower(clock);
    shootLights(clock);
    breakShop(clock);
    blowCarAndWall(clock);
    breakSign(clock);
    blowRoof(clock);
    return clock.take();
}

Pose demolitionCamera(double seconds) {
    const double drift = seconds * 0.06;  // metres: a little parallax, with frames that can still be compared
    return lookAt({4.6 + drift, 6.8, 54.0 - drift * 0.5}, {25.0, 3.7, 33.5});
}

}  // namespace rubble
