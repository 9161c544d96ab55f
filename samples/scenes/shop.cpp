#include "samples/scenes/shop.h"

#include "runtime/core/random.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/lettering.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

using Plan = ShopPlan;
constexpr int kFloor = kFooting + 1;
constexpr int kCeiling = kFloor + 31;
constexpr int kRoof = kCeiling + 4;
constexpr int kX0 = Plan::kMargin, kX1 = kX0 + Plan::kWidth, kZ0 = Plan::kMargin, kZ1 = kZ0 + Plan::kDepth;

struct ShopSwatches {
    explicit ShopSwatches(Canvas& c)
        : concrete(c.addSurface(kConcrete)),
          plaster(c.addSurface(kPlaster)),
          steel(c.addSurface(kDarkSteel)),
          glass(c.addSurface(kGlass)),
          tile(c.addSurface(kTileWhite)),
          tileDark(c.addSurface(kTileWhite, 72)),
          wood(c.addSurface(kDarkWood)),
          red(c.addSurface(kClothRed)),
          cream(c.addSurface(kClothCream)),
          felt(c.addSurface(kRoofFelt)),
          board(c.addSurface(kPlasticBlack)),
          goods(c.addSurface(kGoods)),
          joist(c.addSurface(kSteel)),
          pipe(c.addSurface(kCopperPipe)),
          white(c.addSurface(kWhiteWood)) {
        walls = {c.addSurface(kBrickYellow),
                 c.addSurface(kBrickYellow, 84),
                 plaster,
                 c.addSurface(kBrickYellow, 76),
                 c.addSurface(kWire),
                 pipe,
                 true};
        windows = {white, glass, concrete, cream, walls.dirty};
    }
    Swatch concrete, plaster, steel, glass, tile, tileDark, wood, red, cream, felt, board, goods, joist, pipe, white;
    WallSwatches walls;
    WindowSwatches windows;
};

void drawShell(Canvas& c, const WallFrames& walls, const ShopSwatches& s) {
    c.box({kX0 - 1, 0, kZ0 - 1}, {kX1 + 1, kFooting - 1, kZ1 + 1}, s.concrete);  // below the pavement
    c.box({kX0, kFooting - 1, kZ0}, {kX1, kFloor, kZ1}, s.concrete);
    for (const WallFrame* wall : {&walls.left, &walls.right, &walls.back, &walls.front})
        drawWall(c, *wall, kFloor, kRoof + 6, s.walls);
    c.fill({kX0 + 3, kFloor, kZ0 + 3}, {kX1 - 3, kFloor + 1, kZ1 - 3},
           [&](ivec3 cell) { return PaletteBuilder::pick((cell.x / 5 + cell.z / 5) % 2 ? s.tile : s.tileDark, cell); });
    // Ceiling, steel joists, roof deck, and felt under a parapet with a coping.
    c.box({kX0 + 3, kCeiling, kZ0 + 3}, {kX1 - 3, kCeiling + 1, kZ1 - 3}, s.plaster);
    for (int x = kX0 + 6; x < kX1 - 3; x += 9) c.box({x, kCeiling + 1, kZ0 + 3}, {x + 1, kRoof - 1, kZ1 - 3}, s.joist);
    c.box({kX0 + 3, kRoof - 1, kZ0 + 3}, {kX1 - 3, kRoof, kZ1 - 3}, s.wood);
    c.box({kX0 + 3, kRoof, kZ0 + 3}, {kX1 - 3, kRoof + 1, kZ1 - 3}, s.felt);
    for (int k = 0; k < 3; ++k) {
        const int a = k, b = k + 1;
        c.box({kX0 + a, kRoof + 6, kZ0 + a}, {kX1 - a, kRoof + 7, kZ0 + b}, s.concrete);
        c.box({kX0 + a, kRoof + 6, kZ1 - b}, {kX1 - a, kRoof + 7, kZ1 - a}, s.concrete);
        c.box({kX0 + a, kRoof + 6, kZ0 + a}, {kX0 + b, kRoof + 7, kZ1 - a}, s.concrete);
        c.box({kX1 - b, kRoof + 6, kZ0 + a}, {kX1 - a, kRoof + 7, kZ1 - a}, s.concrete);
    }
    // A ventilation box and its duct.
    c.box({kX0 + 70, kRoof + 1, kZ0 + 20}, {kX0 + 90, kRoof + 11, kZ0 + 34}, s.joist);
    c.clear({kX0 + 71, kRoof + 2, kZ0 + 21}, {kX0 + 89, kRoof + 10, kZ0 + 33});
    for (int x = kX0 + 72; x < kX0 + 88; x += 2) c.box({x, kRoof + 3, kZ0 + 33}, {x + 1, kRoof + 9, kZ0 + 34}, s.board);
}

/// The front is glass between steel posts, with a door in it.
void drawFront(Canvas& c, const WallFrame& front, const ShopSwatches& s) {
    constexpr int kLow = kFloor + 5, kHigh = kFloor + 25;
    for (int u = 8; u < Plan::kWidth - 8; ++u)
        for (int y = kFloor + 1; y < kHigh; ++y) {
            const bool door = u >= 52 && u < 68;
            if (!door && y < kLow) continue;
            for (int k = 0; k < 3; ++k) c.setEntry(front.cell(u, y, k), 0);
            const int pane = door ? (u - 52) % 8 : (u - 8) % 15;
            const bool post = pane == 0 || u == 52 || u == 67 || u == Plan::kWidth - 9 || y == kHigh - 1 ||
                              (!door && y == kLow) || (door && y == kFloor + 1);
            c.set(front.cell(u, y, 1), post ? s.steel : s.glass);
            if (door && y == kFloor + 11 && (pane == 6 || pane == 2)) c.set(front.cell(u, y, 0), s.steel);
        }
}

void drawAwning(Canvas& c, const ShopSwatches& s) {
    for (int x = kX0 + 6; x < kX1 - 6; ++x)
        for (int i = 0; i < 12; ++i) {
            const int y = kFloor + 29 - i / 3;
            const Swatch cloth = x / 6 % 2 ? s.red : s.cream;
            c.set({x, y, kZ1 + i}, cloth);
            c.set({x, y - 1, kZ1 + i}, cloth);
            if (i == 11 && x % 6 > 0 && x % 6 < 5) c.set({x, y - 2, kZ1 + i}, cloth);
        }
}

void drawSign(Level& level, Canvas& c, const std::string& name, const ShopSwatches& s) {
    constexpr std::string_view kText = "RUBBLE";
    constexpr int kScale = 2;
    constexpr int kTextWidth = (int(kText.size()) * kLetterAdvance - 1) * kScale;
    const int x0 = kX0 + (Plan::kWidth - kTextWidth) / 2, y0 = kRoof + 2;
    const uint32_t group = addLightGroup(level, name + " sign", 0.25f);
    const Swatch glow = c.addSurface(kSignGlow, 100, group);
    // A dark board that stands on the front's parapet, letters on its face.
    c.box({x0 - 5, y0 - 2, kZ1}, {x0 + kTextWidth + 5, y0 + kLetterHeight * kScale + 4, kZ1 + 2}, s.board);
    drawLettering(c, {x0, y0 + 1, kZ1 + 2}, kText, kScale, glow);
    for (int i : {1, 3})
        addLight(level, name, group, LightKind::Sphere, glm::dvec3(x0 + kTextWidth * i / 4, y0 + 6, kZ1 + 9),
                 glm::vec3(0.25f, 0.95f, 0.85f) * 7.0f, 8.0f, 0.3f);
}

void drawInside(Level& level, Canvas& c, const std::string& name, const ShopSwatches& s) {
    // Gondolas with goods, three rows deep, and shelves along the back wall.
    const auto shelf = [&](ivec3 low, int length, int height) {
        c.box(low, low + ivec3(length, height, 1), s.wood);
        for (int y = 0; y < height; y += 5) {
            c.box(low + ivec3(0, y, 0), low + ivec3(length, y + 1, 5), s.wood);
            for (int x = 0; x < length; ++x) {
                const uint32_t dice = hashCell(x / 2, y, low.z, 121);
                if (dice % 5 == 0 || y + 1 >= height) continue;
                const uint8_t entry = PaletteBuilder::pickFor(s.goods, dice >> 8);
                c.fill(low + ivec3(x, y + 1, 1), low + ivec3(x + 1, y + 2 + int(dice >> 4 & 1) * 2, 4),
                       [&](ivec3) { return entry; });
            }
        }
    };
    for (int z : {34, 52, 70})
        for (int x : {14, 78}) shelf({kX0 + x, kFloor + 1, kZ0 + z}, 28, 16);
    shelf({kX0 + 10, kFloor + 1, kZ0 + 3}, 100, 21);
    const uint32_t group = addLightGroup(level, name + " ceiling");
    const Swatch glow = c.addSurface(kShopGlow, 100, group);
    for (int x : {26, 60, 94})
        for (int z : {30, 72}) {
            c.box({kX0 + x - 6, kCeiling - 1, kZ0 + z}, {kX0 + x + 6, kCeiling, kZ0 + z + 2}, glow);
            if (z == 72)
                addLight(level, name, group, LightKind::Sphere, glm::dvec3(kX0 + x, kCeiling - 3, kZ0 + z + 1),
                         glm::vec3(1.0f, 0.86f, 0.66f) * 9.0f, 8.0f, 0.25f);
        }
}

}  // namespace

void addShop(Level& level, const std::string& name, ivec3 cell) {
    Canvas c({Plan::kWidth + 2 * Plan::kMargin, kRoof + 24, Plan::kDepth + Plan::kMargin + Plan::kFront});
    const ShopSwatches s(c);
    const WallFrames walls = wallFrames({kX0, 0, kZ0}, {kX1, 0, kZ1});
    drawShell(c, walls, s);
    drawFront(c, walls.front, s);
    for (int u : {16, 44, 72}) drawWindow(c, walls.left, u, kFloor + 12, 11, 9, s.windows, false);
    drawAwning(c, s);
    drawSign(level, c, name, s);
    drawInside(level, c, name, s);
    const ivec3 corner = cell - ivec3(Plan::kMargin, kFooting, Plan::kMargin);
    addStatic(level, c.finish(name), corner);
    addDynamic(level, makeCounter("shop counter", 20), corner + ivec3(kX0 + 92, kFloor + 1, kZ0 + 84));
    addDynamic(level, makeCrate("shop crate 1"), corner + ivec3(kX0 + 20, kFloor + 1, kZ0 + 86));
    addDynamic(level, makeCrate("shop crate 2"), corner + ivec3(kX0 + 30, kFloor + 1, kZ0 + 84));
    addDynamic(level, makePlantPot("shop plant"), corner + ivec3(kX0 + 70, kFloor + 1, kZ0 + 86));
}

}  // namespace rubble::scenes
