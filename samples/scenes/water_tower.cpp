#include "samples/scenes/water_tower.h"

#include "runtime/core/random.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

using Plan = WaterTowerPlan;
constexpr int kPad = 3;  // depth of the footings in cells
constexpr int kFoot = kPad + 1;
constexpr int kTankLow = kFoot + Plan::kLegHeight;
constexpr int kTankHigh = kTankLow + Plan::kTankHeight;

void drawLegs(Canvas& c, Swatch steel, Swatch rust, Swatch pad) {
    for (const ivec3& leg : Plan::kLegs) {
        c.box({leg.x - 2, 0, leg.z - 2}, {leg.x + 5, kFoot, leg.z + 5}, pad);
        c.box({leg.x, kFoot, leg.z}, {leg.x + 3, kTankLow, leg.z + 3}, steel);
        c.stain({leg.x, kFoot, leg.z}, {leg.x + 3, kFoot + 12, leg.z + 3}, rust, 55);
    }
    // Horizontal girts at thirds of the height, with crossed rods between them on each side.
    constexpr int kLow = 5, kHigh = 42;
    for (int level = 1; level <= 3; ++level) {
        const int y = kFoot + level * Plan::kLegHeight / 3 - 2, below = kFoot + (level - 1) * Plan::kLegHeight / 3 + 4;
        for (int side : {kLow, kHigh}) {
            c.bar({kLow, y, side}, {kHigh, y, side}, 1, steel);
            c.bar({side, y, kLow}, {side, y, kHigh}, 1, steel);
            if (level == 1) continue;
            c.bar({kLow, below, side}, {kHigh, y, side}, 1, rust);
            c.bar({kLow, y, side}, {kHigh, below, side}, 1, rust);
            c.bar({side, below, kLow}, {side, y, kHigh}, 1, rust);
            c.bar({side, y, kLow}, {side, below, kHigh}, 1, rust);
        }
    }
}

void drawTank(Canvas& c, Swatch paint, Swatch stripe, Swatch seam, Swatch rust, Swatch roof) {
    const ivec3 middle(Plan::kSide, 0, Plan::kSide);
    c.ring(1, kTankLow - 2, kTankLow, middle, -1, 47, seam);
    c.ring(1, kTankLow, kTankLow + 1, middle, -1, 46, paint);
    c.ring(1, kTankLow, kTankHigh, middle, 42, 46, paint);
    c.ring(1, kTankLow + 24, kTankLow + 30, middle, 42, 46, stripe);
    for (int y : {kTankLow + 9, kTankLow + 19, kTankHigh - 3}) c.ring(1, y, y + 1, middle, 42, 47, seam);
    for (int i = 0; i <= 23; ++i)
        c.ring(1, kTankHigh + i / 2, kTankHigh + i / 2 + 2, middle, i < 21 ? 44 - 2 * i : -1, 48 - 2 * i, roof);
    // Streaks of rust below the seams.
    c.fill({0, kTankLow, 0}, {Plan::kSide, kTankHigh, Plan::kSide}, [&](ivec3 cell) {
        const uint8_t entry = c.at(cell);
        if (!entry) return entry;
        const uint32_t streak = hashCell(cell.x / 2, 0, cell.z / 2, 101);
        const int below = (kTankHigh - 3 - cell.y) % 10;
        return streak % 5 == 0 && below < int(streak >> 8 & 15) / 2 + 2 ? PaletteBuilder::pick(rust, cell) : entry;
    });
}

/// A ladder, and a riser that stands on its own footing.
void drawPipeAndLadder(Canvas& c, Swatch steel, Swatch iron, Swatch pad) {
    c.box({20, 0, 20}, {28, kFoot, 28}, pad);
    c.box({22, kFoot, 22}, {26, kTankLow, 26}, steel);
    for (int z : {20, 24}) c.box({0, kTankLow - 2, z}, {1, kTankHigh, z + 1}, iron);
    for (int y = kTankLow - 1; y < kTankHigh; y += 3) c.box({0, y, 20}, {2, y + 1, 25}, iron);
    c.ring(1, kTankLow - 3, kTankLow - 2, {Plan::kSide, 0, Plan::kSide}, -1, 40, iron);
}

}  // namespace

void addWaterTower(Level& level, const std::string& name, ivec3 cell) {
    Canvas c({Plan::kSide, kTankHigh + 14, Plan::kSide});
    const Swatch steel = c.addSurface(kSteel), rust = c.addSurface(kRust), pad = c.addSurface(kConcrete),
                 iron = c.addSurface(kDarkSteel);
    const Swatch paint = c.addSurface(kTankPaint), stripe = c.addSurface(kCarRed, 96),
                 roof = c.addSurface(kTankPaint, 82), seam = c.addSurface(kSteel, 84);
    drawLegs(c, steel, rust, pad);
    drawTank(c, paint, stripe, seam, rust, roof);
    drawPipeAndLadder(c, steel, iron, pad);
    addStatic(level, c.finish(name), cell - ivec3(0, kPad, 0));
}

}  // namespace rubble::scenes
