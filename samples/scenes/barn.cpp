#include "samples/scenes/barn.h"

#include <algorithm>

#include "runtime/core/random.h"
#include "samples/scenes/building.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr int kWidth = 124, kDepth = 96, kEaves = kFooting + 34, kMargin = 6;
constexpr int kLeafWidth = 16, kDoorTop = 28;  // of each leaf
constexpr int kDoorLow = kMargin + kWidth / 2 - kLeafWidth;
constexpr ivec3 kLow{kMargin, 0, kMargin}, kHigh{kMargin + kWidth, 0, kMargin + kDepth};

struct BarnSwatches {
    explicit BarnSwatches(Canvas& c)
        : plank(c.addSurface(kRedWood)),
          seam(c.addSurface(kRedWood, 72)),
          timber(c.addSurface(kTimber)),
          white(c.addSurface(kWhiteWood)),
          stone(c.addSurface(kRock)),
          board(c.addSurface(kFenceWood)),
          hay(c.addSurface(kHay)) {}
    Swatch plank, seam, timber, white, stone, board, hay;
};

uint8_t plank(const BarnSwatches& s, int u, ivec3 cell) {
    return u % 5 == 0 ? PaletteBuilder::pick(s.seam, cell)
                      : PaletteBuilder::pickFor(s.plank, hashCell(u / 5, 0, cell.z > 50, 241));
}

/// Planks on a frame of posts, rails and braces, on a foot of stone; gables up to the roof.
void drawWalls(Canvas& c, const BarnSwatches& s) {
    for (const int z : {kLow.z, kHigh.z - 1})
        for (int x = kLow.x; x < kHigh.x; ++x) {
            const auto height = [&](int at) { return kEaves + gableHeight(at, kLow.z - kMargin, kHigh.z + kMargin); };
            for (int y = 0; y < height(z); ++y)
                c.setEntry({x, y, z}, y < 6 ? PaletteBuilder::pick(s.stone, {x, y, z}) : plank(s, x, {x, y, z}));
        }
    for (const int x : {kLow.x, kHigh.x - 1})
        for (int z = kLow.z; z < kHigh.z; ++z) {
            const int top = kEaves + gableHeight(z, kLow.z - kMargin, kHigh.z + kMargin);
            for (int y = 0; y < top; ++y)
                c.setEntry({x, y, z}, y < 6 ? PaletteBuilder::pick(s.stone, {x, y, z}) : plank(s, z, {x, y, z}));
        }
    for (int x = kLow.x; x < kHigh.x; x += 24) {
        const int wide = 3, at = std::min(x, kHigh.x - wide - 1);
        for (const int z : {kLow.z + 1, kHigh.z - 4}) c.box({at, 0, z}, {at + wide, kEaves + 4, z + wide}, s.timber);
    }
    for (int z = kLow.z + 1; z < kHigh.z - 4; z += 23)
        for (const int x : {kLow.x + 1, kHigh.x - 4}) {
            const int top = kEaves + gableHeight(z, kLow.z - kMargin, kHigh.z + kMargin);
            c.box({x, 0, z}, {x + 3, top, z + 3}, s.timber);
        }
    for (const int y : {kFooting + 16, kEaves - 2}) {
        for (const int z : {kLow.z + 1, kHigh.z - 3}) c.box({kLow.x, y, z}, {kHigh.x, y + 2, z + 2}, s.timber);
        for (const int x : {kLow.x + 1, kHigh.x - 3}) c.box({x, y, kLow.z}, {x + 2, y + 2, kHigh.z}, s.timber);
    }
}

/// Trusses over the posts carry the roof; boards on their ties are a loft over one half.
void drawTrusses(Canvas& c, const BarnSwatches& s) {
    for (int x = kLow.x; x < kHigh.x; x += 24) {
        const int at = std::min(x, kHigh.x - 4);
        c.box({at, kEaves, kLow.z}, {at + 3, kEaves + 3, kHigh.z}, s.timber);
        const int middle = (kLow.z + kHigh.z) / 2;
        c.box({at, kEaves, middle - 1},
              {at + 3, kEaves + gableHeight(middle, kLow.z - kMargin, kHigh.z + kMargin), middle + 2}, s.timber);
        for (const int side : {-1, 1})
            c.bar({at, kEaves + 2, middle + side * 2},
                  {at, kEaves + gableHeight(middle + side * 22, kLow.z - kMargin, kHigh.z + kMargin) - 2,
                   middle + side * 22},
                  2, s.timber);
    }
    const int loft = kLow.x + 49;
    c.fill({kLow.x + 1, kEaves + 3, kLow.z + 1}, {loft, kEaves + 4, kHigh.z - 1},
           [&](ivec3 cell) { return PaletteBuilder::pickFor(s.board, hashCell(0, 0, cell.z / 4, 243)); });
    for (const int z : {kLow.z + 24, kLow.z + 68}) c.box({loft - 3, kFooting, z}, {loft, kEaves + 3, z + 3}, s.timber);
    for (int x = 0; x < 3; ++x)  // hay in the loft
        for (int z = 0; z < 4; ++z)
            if (hashCell(x, 0, z, 247) % 4)
                c.box({kLow.x + 6 + x * 13, kEaves + 4, kLow.z + 26 + z * 11},
                      {kLow.x + 18 + x * 13, kEaves + 10, kLow.z + 36 + z * 11}, s.hay);
    for (const int z : {kLow.z + 40, kLow.z + 46})
        c.bar({loft + 4, kFooting, z}, {loft - 1, kEaves + 8, z}, 1, s.timber);
    for (int i = 1; i < 9; ++i)  // a ladder
        c.box({loft + 4 - i * 5 / 9, kFooting + i * 4, kLow.z + 40},
              {loft + 5 - i * 5 / 9, kFooting + i * 4 + 1, kLow.z + 47}, s.timber);
}

void drawOpenings(Canvas& c, const BarnSwatches& s) {
    const int high = kDoorLow + 2 * kLeafWidth, z = kHigh.z;
    c.box({kDoorLow - 2, kFooting, z - 1}, {high + 2, kFooting + kDoorTop + 2, z}, s.white);
    c.clear({kDoorLow, kFooting, z - 4}, {high, kFooting + kDoorTop, z});
    const auto window = [&](int x, int wall) {  // without panes
        c.box({x - 1, kFooting + 13, wall - 1}, {x + 13, kFooting + 25, wall}, s.white);
        c.clear({x, kFooting + 14, wall - 1}, {x + 12, kFooting + 24, wall});
        c.box({x + 5, kFooting + 14, wall - 1}, {x + 7, kFooting + 24, wall}, s.white);
    };
    for (const int x : {kLow.x + 14, kHigh.x - 26}) window(x, z);
    for (const int x : {kLow.x + 8, kLow.x + 56, kLow.x + 104}) window(x, kLow.z + 1);
    c.box({kLow.x, kFooting + 3, z - 1}, {kLow.x + 2, kEaves, z}, s.white);
    c.box({kHigh.x - 2, kFooting + 3, z - 1}, {kHigh.x, kEaves, z}, s.white);
}

void addBulb(Level& level, Canvas& c, const BarnSwatches& s) {
    const uint32_t group = addLightGroup(level, "barn light");
    const Swatch glow = c.addSurface(kBulbGlow, 100, group);
    const ivec3 at{kLow.x + 73, kEaves - 4, (kLow.z + kHigh.z) / 2};
    c.box({at.x, at.y, at.z}, {at.x + 1, kEaves, at.z + 1}, s.timber);
    c.box(at - ivec3(1, 3, 1), at + ivec3(2, 0, 2), glow);
    addLight(level, "barn", group, LightKind::Sphere, glm::dvec3(at) + glm::dvec3(0.5, -1.5, 0.5), kWarmLight * 26.0f,
             9.0f, 0.2f);
}

/// A leaf of the door with its cross, on a hinge at its outer edge.
void addLeaf(Level& level, ivec3 corner, bool isLeft) {
    constexpr int kHeight = kDoorTop - 1;
    const int width = isLeft ? kLeafWidth : kLeafWidth - 1;  // a gap between both, or their edges would jam
    Canvas c({width, kHeight, 2});
    const BarnSwatches s(c);
    for (int x = 0; x < width; ++x)
        for (int y = 0; y < kHeight; ++y) c.setEntry({x, y, 0}, plank(s, x + 1, {x, y, 0}));
    c.bar({0, 1, 1}, {width - 2, kHeight - 3, 1}, 1, s.white);
    for (const int y : {0, kHeight / 2, kHeight - 2}) c.box({0, y, 1}, {width, y + 2, 2}, s.white);
    for (const int x : {0, width - 2}) c.box({x, 0, 1}, {x + 2, kHeight, 2}, s.white);
    const std::string name = isLeft ? "barn door left" : "barn door right";
    const ivec3 at = corner + ivec3(isLeft ? kDoorLow : kDoorLow + 2 * kLeafWidth - width, kFooting + 1, kHigh.z - 2);
    addHinged(level, "barn", corner, c.finish(name), at, {isLeft ? 0.0 : width, 0.5 * kHeight, 0.5});
}

LevelShape makeBale(std::string name) {
    Canvas c({12, 7, 8});
    const Swatch hay = c.addSurface(kHay), cord = c.addSurface(kTimber);
    c.box({0, 0, 0}, {12, 7, 8}, hay);
    for (const int x : {3, 8}) {
        c.box({x, 0, 0}, {x + 1, 7, 1}, cord);
        c.box({x, 0, 7}, {x + 1, 7, 8}, cord);
        c.box({x, 6, 0}, {x + 1, 7, 8}, cord);
    }
    return c.finish(std::move(name));
}

}  // namespace

void addBarn(Level& level, ivec3 cell) {
    Canvas c({kWidth + 2 * kMargin, kEaves + 48, kDepth + 2 * kMargin});
    const BarnSwatches s(c);
    drawWalls(c, s);
    drawTrusses(c, s);
    drawOpenings(c, s);
    addBulb(level, c, s);
    const RoofSwatches roof{c.addSurface(kRust, 118), c.addSurface(kRust, 96), s.timber, c.addSurface(kRust, 84),
                            s.white};
    drawGableRoof(c, {0, 0, 0}, {kWidth + 2 * kMargin, 0, kDepth + 2 * kMargin}, kEaves, roof);
    c.removeUnanchored();
    const ivec3 corner = cell - ivec3(kMargin, kFooting, kMargin);
    addStatic(level, c.finish("barn"), corner);
    addLeaf(level, corner, true);
    addLeaf(level, corner, false);
    int count = 0;
    for (int i = 0; i < 9; ++i)
        addDynamic(level, makeBale("bale " + std::to_string(++count)),
                   cell + ivec3(80 + i % 3 * 12, i / 6 * 7, 20 + i / 3 % 2 * 9));
    for (const ivec3 at : {ivec3(150, 0, 40), ivec3(164, 0, 52), ivec3(152, 0, 62)})
        addDynamic(level, makeBale("bale " + std::to_string(++count)), cell + at);
}

}  // namespace rubble::scenes
