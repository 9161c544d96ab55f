#include "samples/scenes/office_tower.h"

#include <fmt/format.h>

#include "runtime/core/random.h"
#include "samples/scenes/building.h"
#include "samples/scenes/lettering.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr int kSide = OfficeTower::kSide, kHeight = OfficeTower::kHeight, kStoreys = OfficeTower::kStoreys,
              kColumn = OfficeTower::kColumn;
constexpr auto& kColumns = OfficeTower::kColumns;
constexpr int kRoof = kFooting + kStoreys * kHeight;
constexpr int kShaftLow = 24, kShaftHigh = 40;  // outer sides of the lift shaft
constexpr ivec3 kGrid{kSide, kRoof + 30, kSide + 1};

struct TowerSwatches {
    explicit TowerSwatches(Canvas& c)
        : concrete(c.addSurface(kConcrete)),
          slab(c.addSurface(kConcreteDark)),
          brick(c.addSurface(kBrickYellow)),
          joint(c.addSurface(kBrickYellow, 84)),
          plaster(c.addSurface(kPlaster)),
          frame(c.addSurface(kDarkSteel)),
          glass(c.addSurface(kGlass)),
          rebar(c.addSurface(kRebar)),
          carpet(c.addSurface(kClothTeal)),
          wood(c.addSurface(kTimber)),
          goods(c.addSurface(kGoods)),
          felt(c.addSurface(kRoofFelt)),
          steel(c.addSurface(kSteel)),
          rust(c.addSurface(kRust)) {}
    Swatch concrete, slab, brick, joint, plaster, frame, glass, rebar, carpet, wood, goods, felt, steel, rust;
};

void drawColumns(Canvas& c, int y, const TowerSwatches& s) {
    for (int x : kColumns)
        for (int z : kColumns) {
            if (x == kColumns[1] && z == kColumns[1]) continue;  // the lift shaft stands there
            c.box({x, y, z}, {x + kColumn, y + kHeight, z + kColumn}, s.concrete);
            for (int dx : {1, 3})
                for (int dz : {1, 3}) c.box({x + dx, y, z + dz}, {x + dx + 1, y + kHeight, z + dz + 1}, s.rebar);
        }
}

/// Between the columns: a brick sill, a band of windows with mullions, and a lintel. The ground floor has shop windows.
void drawFacade(Canvas& c, const WallFrame& wall, int y, bool ground, const TowerSwatches& s) {
    const int sill = ground ? 2 : 8, head = ground ? 21 : 19;
    for (int u = kColumn; u < kSide - kColumn; ++u) {
        if (u >= kColumns[1] && u < kColumns[1] + kColumn) continue;
        const int bay = (u - kColumn) % 24;
        for (int v = 0; v < kHeight; ++v) {
            const bool open = v >= sill && v < head;
            const bool mullion = bay % 6 == 0 || v == sill || v == head - 1 || (!ground && v == sill + 7);
            const uint32_t stone = hashCell((u + v % 2 * 2) / 4, y + v, wall.along.x, 42);
            if (open) {
                c.set(wall.cell(u, y + v, 1), mullion ? s.frame : s.glass);
                continue;
            }
            const Swatch face = (u + v % 2 * 2) % 4 == 0 ? s.joint : s.brick;
            for (int k = 0; k < 2; ++k) c.setEntry(wall.cell(u, y + v, k), PaletteBuilder::pickFor(face, stone >> 8));
            c.set(wall.cell(u, y + v, 2), s.plaster);
        }
        if (!ground) c.set(wall.cell(u, y + sill, 0), s.slab);
    }
}

/// Desks and shelves. They are part of the tower's shape and move with it.
void drawOffice(Canvas& c, int y, const TowerSwatches& s) {
    for (int i = 0; i < 8; ++i) {
        const uint32_t dice = hashCell(i, y, 7, 131);
        const ivec3 low(6 + int(dice % 3) + i % 2 * 36, y, 7 + i / 2 * 13 + int(dice >> 8 & 1));
        c.box(low + ivec3(0, 6, 0), low + ivec3(13, 7, 6), s.wood);
        for (int x : {0, 12}) c.box(low + ivec3(x, 0, 1), low + ivec3(x + 1, 6, 5), s.wood);
        c.box(low + ivec3(4, 7, 1), low + ivec3(9, 10, 2), s.goods);
    }
}

void drawLiftShaft(Canvas& c, int y, const TowerSwatches& s) {
    constexpr int kLow = kShaftLow, kHigh = kShaftHigh;
    for (int k = 0; k < 2; ++k) {
        c.box({kLow, y, kLow + k}, {kHigh, y + kHeight, kLow + k + 1}, s.concrete);
        c.box({kLow, y, kHigh - 1 - k}, {kHigh, y + kHeight, kHigh - k}, s.concrete);
        c.box({kLow + k, y, kLow}, {kLow + k + 1, y + kHeight, kHigh}, s.concrete);
        c.box({kHigh - 1 - k, y, kLow}, {kHigh - k, y + kHeight, kHigh}, s.concrete);
    }
    c.clear({28, y, kHigh - 2}, {37, y + 21, kHigh});
}

void drawRoof(Level& level, Canvas& c, const TowerSwatches& s) {
    c.box({1, kRoof, 1}, {kSide - 1, kRoof + 1, kSide - 1}, s.felt);
    for (int k = 0; k < 2; ++k) {
        c.box({k, kRoof, k}, {kSide - k, kRoof + 6, k + 1}, s.brick);
        c.box({k, kRoof, kSide - 1 - k}, {kSide - k, kRoof + 6, kSide - k}, s.brick);
        c.box({k, kRoof, k}, {k + 1, kRoof + 6, kSide - k}, s.brick);
        c.box({kSide - 1 - k, kRoof, k}, {kSide - k, kRoof + 6, kSide - k}, s.brick);
    }
    c.box({22, kRoof + 1, 20}, {42, kRoof + 14, 38}, s.brick);
    c.box({21, kRoof + 14, 19}, {43, kRoof + 15, 39}, s.slab);
    c.ring(1, kRoof + 15, kRoof + 24, {64, 0, 56}, 12, 16, s.steel);
    c.ring(1, kRoof + 24, kRoof + 25, {64, 0, 56}, -1, 18, s.rust);
    c.box({8, kRoof + 1, 8}, {9, kRoof + 28, 9}, s.steel);
    const uint32_t group = addLightGroup(level, "tower sign", 0.2f);
    const Swatch glow = c.addSurface(kSignGlow, 100, group);
    c.box({11, kRoof + 6, kSide - 2}, {54, kRoof + 17, kSide}, s.frame);
    drawLettering(c, {15, kRoof + 8, kSide}, "RUBBLE", 1, glow);
}

void drawTower(Level& level, Canvas& c) {
    const TowerSwatches s(c);
    c.box({0, 0, 0}, {kSide, kFooting, kSide}, s.slab);
    const WallFrames walls = wallFrames({0, 0, 0}, {kSide, 0, kSide});
    for (int storey = 0; storey < kStoreys; ++storey) {
        const int y = kFooting + storey * kHeight;
        for (const WallFrame* wall : {&walls.left, &walls.right, &walls.back, &walls.front})
            drawFacade(c, *wall, y, storey == 0, s);
        drawColumns(c, y, s);
        drawOffice(c, y, s);
        drawLiftShaft(c, y, s);
        c.box({1, y + kHeight - 3, 1}, {kSide - 1, y + kHeight - 1, kSide - 1}, s.slab);
        c.box({2, y + kHeight - 1, 2}, {kSide - 2, y + kHeight, kSide - 2}, storey + 1 == kStoreys ? s.slab : s.carpet);
        for (int x : kColumns)
            for (int z : kColumns)
                if (x != kColumns[1] || z != kColumns[1])
                    c.box({x, y + kHeight - 1, z}, {x + kColumn, y + kHeight, z + kColumn}, s.concrete);
    }
    drawRoof(level, c, s);
}

/// Opens the floors in the shaft, and draws a wire up its front wall to a light over the door of each storey.
void openShaft(Level& level, Canvas& c) {
    c.clear({kShaftLow + 2, kFooting, kShaftLow + 2}, {kShaftHigh - 2, kRoof - 3, kShaftHigh - 2});
    constexpr int kX = kShaftLow + 1, kZ = kShaftHigh - 2;
    const uint32_t group = addLightGroup(level, "lift power", 0.9f);
    LightGroup& record = level.lightGroups[group - 1];
    record.supplyShape = "tower";
    record.supplyCell = {kX, kFooting, kZ};
    const Swatch wire = c.addSurface(kCable), glow = c.addSurface(kBulbGlow, 100, group);
    c.box({kX, kFooting, kZ}, {kX + 1, kRoof - 3, kZ + 1}, wire);
    for (int storey = 0; storey < kStoreys; ++storey) {
        const int y = kFooting + storey * kHeight + 22;
        c.box({kX, y, kZ}, {kX + 6, y + 1, kZ + 1}, wire);
        c.box({kX + 5, y, kZ + 1}, {kX + 10, y + 1, kZ + 2}, glow);
        addLight(level, "tower", group, LightKind::Sphere, glm::dvec3(kX + 7.5, y + 0.5, kZ + 3.5), kWarmLight * 4.0f,
                 5.0f, 0.15f);
    }
}

/// A cabin that is open toward the doors, on a prismatic joint. Its brake is the motor of speed 0.
void addLiftCabin(Level& level, ivec3 corner) {
    constexpr int kSize = 10, kCabinHeight = 21, kGap = (kShaftHigh - kShaftLow - 4 - kSize) / 2 + 2;
    Canvas c({kSize, kCabinHeight, kSize});
    const Swatch side = c.addSurface(kPlasticGrey), floor = c.addSurface(kRoofFelt), panel = c.addSurface(kTimber),
                 lit = c.addSurface(kBulbGlow);
    c.box({0, 0, 0}, {kSize, 1, kSize}, floor);
    c.box({0, 1, 0}, {kSize, kCabinHeight, 1}, panel);
    for (const int x : {0, kSize - 1}) c.box({x, 1, 0}, {x + 1, kCabinHeight, kSize}, side);
    c.box({0, kCabinHeight - 1, 0}, {kSize, kCabinHeight, kSize}, side);
    c.box({3, kCabinHeight - 2, 3}, {7, kCabinHeight - 1, 7}, lit);
    LevelShape cabin = c.finish("lift");
    cabin.tags = {fmt::format("lift={} {}", kStoreys, kHeight * kVoxel)};
    const ivec3 inTower(kShaftLow + kGap, kFooting, kShaftLow + kGap);
    addDynamic(level, std::move(cabin), corner + inTower);
    const glm::dquat upright(kSqrtHalf, 0.0, 0.0, kSqrtHalf);  // turns x, the axis of the joint's frame, to y
    const glm::dvec3 pivot = kVoxel * glm::dvec3(kSize / 2.0, 5.0, -1.0);  // at the shaft's wall
    LevelJoint guide{{.name = "lift guide", .kind = JointKind::Prismatic}, {"tower", "lift"}};
    guide.joint.ends[0].frame = {pivot + kVoxel * glm::dvec3(inTower), upright};
    guide.joint.ends[1].frame = {pivot, upright};
    guide.joint.ends[0].radius = guide.joint.ends[1].radius = 0.3;
    guide.joint.limits = {true, 0.0, (kStoreys - 1) * kHeight * kVoxel};
    guide.joint.motor = {MotorMode::Speed, 0.0, 3.0e4};
    level.joints.push_back(guide);
}

}  // namespace

void addOfficeTower(Level& level, ivec3 cell) {
    Canvas c(kGrid);
    drawTower(level, c);
    addStatic(level, c.finish("tower"), cell - ivec3(0, kFooting, 0));
}

void addOfficeTowerWithLift(Level& level, ivec3 cell) {
    Canvas c(kGrid);
    drawTower(level, c);
    openShaft(level, c);
    const ivec3 corner = cell - ivec3(0, kFooting, 0);
    addStatic(level, c.finish("tower"), corner);
    addLiftCabin(level, corner);
}

}  // namespace rubble::scenes
