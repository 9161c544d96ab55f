#include "samples/scenes/office_tower.h"

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
    constexpr int kLow = 24, kHigh = 40;
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

}  // namespace

void addOfficeTower(Level& level, ivec3 cell) {
    Canvas c({kSide, kRoof + 30, kSide + 1});
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
    addStatic(level, c.finish("tower"), cell - ivec3(0, kFooting, 0));
}

}  // namespace rubble::scenes
