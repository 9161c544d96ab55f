#include "samples/scenes/museum.h"

#include <algorithm>
#include <cstdlib>

#include "runtime/core/random.h"
#include "samples/scenes/building.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

using Plan = MuseumPlan;
constexpr int kFloor = kFooting + 6;   // y of the hall's floor
constexpr int kCornice = kFloor + 58;  // top of the walls
constexpr ivec3 kHallLow{10, 0, 6}, kHallHigh{190, 0, 98};
constexpr int kWall = 4;                         // thickness
constexpr ivec3 kVaultMiddle{0, kCornice, 104};  // doubled in z: the axis of the vault
constexpr int kVaultRadius = 27;

struct MuseumSwatches {
    explicit MuseumSwatches(Canvas& c)
        : stone(c.addSurface(kLimestone)),
          joint(c.addSurface(kLimestone, 80)),
          shade(c.addSurface(kLimestone, 90)),
          marble(c.addSurface(kMarble)),
          black(c.addSurface(kPlasticBlack, 120)),
          glass(c.addSurface(kGlass)),
          frame(c.addSurface(kDarkSteel)),
          plaster(c.addSurface(kPlaster)),
          lead(c.addSurface(kTankPaint, 84)) {}
    Swatch stone, joint, shade, marble, black, glass, frame, plaster, lead;
};

uint8_t ashlar(const MuseumSwatches& s, ivec3 cell) {
    const int row = cell.y / 8, shifted = cell.x + cell.z + row % 2 * 8;
    if (cell.y % 8 == 0 || shifted % 16 == 0) return PaletteBuilder::pick(s.joint, cell);
    return PaletteBuilder::pickFor(s.stone, hashCell(shifted / 16, row, cell.z > 50, 231));
}

/// The plinth, a floor of black and white squares, and steps as wide as the portico.
void drawPlinth(Canvas& c, const MuseumSwatches& s) {
    c.fill({0, 0, 0}, {Plan::kWidth, kFloor - 1, Plan::kDepth}, [&](ivec3 cell) { return ashlar(s, cell); });
    c.box({0, kFloor - 1, 0}, {Plan::kWidth, kFloor, Plan::kDepth}, s.marble);
    c.fill({kHallLow.x, kFloor - 1, kHallLow.z}, {kHallHigh.x, kFloor, kHallHigh.z},
           [&](ivec3 cell) { return PaletteBuilder::pick((cell.x / 8 + cell.z / 8) % 2 ? s.black : s.marble, cell); });
    for (int step = 0; step < 3; ++step)
        c.box({34, 0, Plan::kDepth}, {166, kFloor - 2 * step - 1, Plan::kDepth + 4 * (step + 1)}, s.shade);
}

/// Walls with tall windows; the front is open between piers and glazed.
void drawWalls(Canvas& c, const MuseumSwatches& s) {
    const ivec3 low = kHallLow, high = kHallHigh;
    c.fill({low.x, kFloor, low.z}, {high.x, kCornice, high.z}, [&](ivec3 cell) {
        const int edge = std::min({cell.x - low.x, high.x - 1 - cell.x, cell.z - low.z, high.z - 1 - cell.z});
        if (edge >= kWall) return uint8_t(0);
        return edge == kWall - 1 ? PaletteBuilder::pick(s.plaster, cell) : ashlar(s, cell);
    });
    const WallFrames walls = wallFrames({low.x, 0, low.z}, {high.x, 0, high.z});
    const auto glaze = [&](const WallFrame& wall, int from, int to, int bay, int open, int foot) {
        for (int u = from; u < to; ++u) {
            if ((u - from) % bay >= open) continue;
            for (int y = foot; y < kCornice - 8; ++y) {
                const int across = (u - from) % bay;
                const bool isBar = across == 0 || across == open - 1 || across == open / 2 || (y - foot) % 14 == 0 ||
                                   y == kCornice - 9;
                for (int k = 0; k < kWall; ++k) c.setEntry(wall.cell(u, y, k), 0);
                c.set(wall.cell(u, y, 1), isBar ? s.frame : s.glass);
            }
        }
    };
    glaze(walls.front, 14, high.x - low.x - 14, 22, 16, kFloor + 1);
    glaze(walls.left, 14, high.z - low.z - 14, 22, 10, kFloor + 14);
    glaze(walls.right, 14, high.z - low.z - 14, 22, 10, kFloor + 14);
    for (int u = 92; u < 102; ++u)  // the door stands open
        for (int y = kFloor; y < kFloor + 26; ++y)
            for (int k = 0; k < kWall; ++k) c.setEntry(walls.front.cell(u - kHallLow.x + 8, y, k), 0);
}

/// Columns before the front, an entablature on them, and a pediment.
void drawPortico(Canvas& c, const MuseumSwatches& s) {
    constexpr int kLow = 100, kHigh = 122, kColumnZ = 114;
    for (int x = 42; x <= 158; x += 29) {
        c.box({x - 5, kFloor, kColumnZ - 5}, {x + 5, kFloor + 3, kColumnZ + 5}, s.shade);
        c.ring(1, kFloor + 3, kCornice - 6, {2 * x, 0, 2 * kColumnZ}, -1, 7, s.stone);
        for (int y = kFloor + 3; y < kCornice - 6; ++y)  // flutes
            for (const int d : {-3, 2}) c.set({x + d, y, kColumnZ - 1}, s.shade);
        c.box({x - 5, kCornice - 6, kColumnZ - 5}, {x + 5, kCornice - 3, kColumnZ + 5}, s.shade);
    }
    c.box({32, kCornice - 3, kLow - 4}, {168, kCornice + 4, kHigh}, s.stone);
    c.box({30, kCornice + 4, kLow - 4}, {170, kCornice + 6, kHigh + 2}, s.shade);
    for (int x = 31; x < 169; ++x) {
        const int top = kCornice + 6 + std::min(x - 30, 169 - x) / 3;
        c.box({x, kCornice + 6, kHigh - 6}, {x + 1, top, kHigh - 3}, s.stone);
        c.box({x, top, kLow - 4}, {x + 1, top + 2, kHigh + 2}, s.lead);
    }
}

/// A flat roof with a parapet around a barrel vault of glass on ribs.
void drawRoof(Canvas& c, const MuseumSwatches& s) {
    const ivec3 low = kHallLow, high = kHallHigh;
    const int from = low.x + 16, to = high.x - 16;
    const int zLow = kVaultMiddle.z / 2 - kVaultRadius, zHigh = kVaultMiddle.z / 2 + kVaultRadius;
    for (int x = from; x < to; ++x) {
        const bool isRib = (x - from) % 12 == 0 || x == to - 1;
        for (int z = zLow; z < zHigh; ++z)
            for (int y = 0; y < kVaultRadius + 1; ++y) {
                const int dz = 2 * z + 1 - kVaultMiddle.z, dy = 2 * y + 1, square = dz * dz + dy * dy;
                if (square > 4 * kVaultRadius * kVaultRadius || square <= 4 * (kVaultRadius - 2) * (kVaultRadius - 2))
                    if (!(x == from || x == to - 1) || square > 4 * kVaultRadius * kVaultRadius) continue;
                const bool isPurlin = z % 9 == 0 || y < 2;
                c.set({x, kCornice + 3 + y, z}, isRib && square > 4 * (kVaultRadius - 2) * (kVaultRadius - 2) ? s.frame
                                                : isPurlin                                                    ? s.frame
                                                           : s.glass);
            }
    }
    c.fill({low.x, kCornice, low.z}, {high.x, kCornice + 3, high.z}, [&](ivec3 cell) {
        const bool isUnderVault = cell.x > from && cell.x < to - 1 && cell.z > zLow + 1 && cell.z < zHigh - 2;
        return isUnderVault ? uint8_t(0) : PaletteBuilder::pick(cell.y == kCornice ? s.plaster : s.lead, cell);
    });
    c.fill({low.x - 3, kCornice, low.z - 3}, {high.x + 3, kCornice + 8, high.z + 3}, [&](ivec3 cell) {
        const int edge = std::min({cell.x - low.x + 3, high.x + 2 - cell.x, cell.z - low.z + 3, high.z + 2 - cell.z});
        if (edge > 5) return c.at(cell);
        return cell.y < kCornice + 3 || edge > 2 ? ashlar(s, cell) : c.at(cell);
    });
    for (const int x : {low.x + 62, low.x + 118})  // beams under the vault's feet
        c.box({x, kCornice - 4, low.z + 2}, {x + 3, kCornice + 3, high.z - 2}, s.frame);
}

void addHallLights(Level& level, Canvas& c, const MuseumSwatches& s) {
    const uint32_t group = addLightGroup(level, "museum hall");
    const Swatch glow = c.addSurface(kBulbGlow, 100, group);
    for (const int x : {kHallLow.x + 63, kHallLow.x + 119})
        for (const int z : {30, 70}) {
            c.box({x, kCornice - 20, z}, {x + 1, kCornice - 4, z + 1}, s.frame);
            c.box({x - 2, kCornice - 24, z - 2}, {x + 3, kCornice - 20, z + 3}, glow);
            addLight(level, "museum", group, LightKind::Sphere, glm::dvec3(x + 0.5, kCornice - 22, z + 0.5),
                     kWarmLight * 22.0f, 10.0f, 0.25f);
        }
}

/// The skeleton of a long-necked animal, which stands on its legs.
LevelShape makeSkeleton() {
    Canvas c({92, 50, 22});
    const Swatch bone = c.addSurface(kBone);
    const auto spine = [](int x) { return 24 - (x - 46) * (x - 46) / 240; };
    for (int x = 24; x < 68; ++x) c.box({x, spine(x), 10}, {x + 1, spine(x) + 3, 12}, bone);
    c.bar({24, spine(24), 10}, {2, 9, 10}, 2, bone);    // tail
    c.bar({66, spine(66), 10}, {82, 42, 10}, 2, bone);  // neck
    c.box({80, 42, 9}, {91, 46, 13}, bone);             // skull
    c.clear({84, 43, 9}, {86, 45, 10});
    c.clear({84, 43, 12}, {86, 45, 13});
    for (int x = 34; x < 62; x += 4)  // ribs
        for (const int side : {-1, 1}) {
            const int z = 10 + (side > 0 ? 1 : 0);
            c.bar({x, spine(x), z}, {x, spine(x) - 5, z + side * 7}, 1, bone);
            c.bar({x, spine(x) - 5, z + side * 7}, {x, spine(x) - 13, z + side * 4}, 1, bone);
        }
    for (const int x : {30, 62})  // legs
        for (const int side : {-1, 1}) {
            const int z = side < 0 ? 3 : 17;
            c.bar({x, spine(x), 10}, {x, spine(x) - 2, z}, 2, bone);
            c.bar({x, spine(x) - 2, z}, {x + 3, 10, z}, 2, bone);
            c.bar({x + 3, 10, z}, {x, 0, z}, 2, bone);
            c.box({x - 1, 0, z - 1}, {x + 5, 2, z + 3}, bone);
        }
    c.removeUnanchored();
    return c.finish("skeleton");
}

/// A thing turned on a lathe: radii[y] is half its width at that height.
LevelShape makeTurned(std::string name, std::initializer_list<int> radii, const SurfaceStyle& style) {
    const int widest = 2 * std::max(radii) + 1;
    Canvas c({widest, int(radii.size()), widest});
    const Swatch swatch = c.addSurface(style);
    int y = 0;
    for (const int radius : radii) {
        c.ring(1, y, y + 1, {widest, 0, widest}, -1, 2 * radius + 1, swatch);
        ++y;
    }
    return c.finish(std::move(name));
}

void addExhibits(Level& level, ivec3 corner) {
    const ivec3 floor = corner + ivec3(0, kFloor, 0);
    addStatic(level, makeSkeleton(), floor + ivec3(54, 0, 42));
    int count = 0;
    const auto exhibit = [&](int x, int z, LevelShape shape) {
        Canvas c({11, 11, 11});
        const Swatch marble = c.addSurface(kMarble), dark = c.addSurface(kDarkWood);
        c.box({0, 0, 0}, {11, 1, 11}, dark);
        c.box({1, 1, 1}, {10, 10, 10}, marble);
        c.box({0, 10, 0}, {11, 11, 11}, dark);
        addDynamic(level, c.finish("pedestal " + std::to_string(++count)), floor + ivec3(x, 0, z));
        const ivec3 size = shape.grid.size();
        addDynamic(level, std::move(shape), floor + ivec3(x + (11 - size.x) / 2, 11, z + (11 - size.z) / 2));
    };
    exhibit(24, 22, makeTurned("amphora", {2, 2, 3, 4, 4, 4, 3, 2, 1, 1, 2}, kRoofTileRed));
    exhibit(60, 16, makeTurned("blue vase", {2, 3, 4, 4, 3, 2, 2, 3}, kClothBlue));
    exhibit(96, 16, makeTurned("golden urn", {3, 2, 1, 2, 4, 4, 4, 3, 4}, kBallRed));
    exhibit(132, 16, makeTurned("bust", {3, 4, 4, 3, 2, 2, 3, 3, 3, 3, 2}, kMarble));
    exhibit(164, 24, makeTurned("meteorite", {2, 4, 4, 4, 3, 2}, kCastSteel));
    exhibit(24, 66, makeTurned("green vase", {2, 3, 3, 4, 4, 3, 2, 1, 2}, kPlasticGreen));
    exhibit(164, 66, makeTurned("white vase", {2, 2, 3, 4, 3, 2, 1, 1, 2, 3}, kWhiteEnamel));
}

}  // namespace

void addMuseum(Level& level, ivec3 cell) {
    Canvas c({Plan::kWidth, kCornice + 40, Plan::kDepth + Plan::kSteps});
    const MuseumSwatches s(c);
    drawPlinth(c, s);
    drawWalls(c, s);
    drawRoof(c, s);
    drawPortico(c, s);
    addHallLights(level, c, s);
    c.removeUnanchored();
    const ivec3 corner = cell - ivec3(0, kFooting, 0);
    addStatic(level, c.finish("museum"), corner);
    addExhibits(level, corner);
}

}  // namespace rubble::scenes
