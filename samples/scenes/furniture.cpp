#include "samples/scenes/furniture.h"

#include "runtime/core/random.h"
#include "samples/scenes/placement.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {

LevelShape makeTable(std::string name) {
    Canvas c({16, 8, 10});
    const Swatch top = c.addSurface(kFloorBoard), leg = c.addSurface(kTimber);
    c.box({0, 7, 0}, {16, 8, 10}, top);
    c.box({1, 6, 1}, {15, 7, 2}, leg);
    c.box({1, 6, 8}, {15, 7, 9}, leg);
    for (int x : {1, 13})
        for (int z : {1, 7}) c.box({x, 0, z}, {x + 2, 7, z + 2}, leg);
    return c.finish(std::move(name));
}

LevelShape makeChair(std::string name, const SurfaceStyle& seat) {
    Canvas c({5, 10, 5});
    const Swatch wood = c.addSurface(kTimber), cloth = c.addSurface(seat);
    for (int x : {0, 4})
        for (int z : {0, 4}) c.box({x, 0, z}, {x + 1, 4, z + 1}, wood);
    c.box({0, 4, 0}, {5, 5, 5}, cloth);
    for (int x : {0, 4}) c.box({x, 5, 0}, {x + 1, 10, 1}, wood);
    c.box({0, 9, 0}, {5, 10, 1}, wood);
    c.box({0, 7, 0}, {5, 8, 1}, wood);
    return c.finish(std::move(name));
}

LevelShape makeShelf(std::string name, uint32_t seed) {
    Canvas c({14, 20, 4});
    const Swatch wood = c.addSurface(kDarkWood), books = c.addSurface(kBooks);
    c.box({0, 0, 0}, {14, 20, 1}, wood);
    for (int x : {0, 13}) c.box({x, 0, 0}, {x + 1, 20, 4}, wood);
    for (int y : {0, 5, 10, 15, 19}) c.box({0, y, 0}, {14, y + 1, 4}, wood);
    for (int shelf = 0; shelf < 4; ++shelf)
        for (int x = 1; x < 13; ++x) {
            const uint32_t dice = hashCell(x, shelf, 0, seed);
            if (dice % 6 == 0) continue;
            const int height = 2 + int(dice >> 8 & 1) + int(shelf == 3 ? 0 : dice >> 9 & 1);
            const int low = shelf * 5 + 1;
            const uint8_t entry = PaletteBuilder::pickFor(books, dice >> 12);
            c.fill({x, low, 1}, {x + 1, std::min(low + height, shelf == 3 ? 19 : low + 4), 3},
                   [&](ivec3) { return entry; });
        }
    return c.finish(std::move(name));
}

LevelShape makeBed(std::string name, const SurfaceStyle& blanket) {
    Canvas c({12, 9, 21});
    const Swatch wood = c.addSurface(kDarkWood), sheet = c.addSurface(kClothCream), cover = c.addSurface(blanket);
    for (int x : {0, 11})
        for (int z : {0, 20}) c.box({x, 0, z}, {x + 1, 3, z + 1}, wood);
    c.box({0, 2, 0}, {12, 3, 21}, wood);
    c.box({0, 3, 1}, {12, 5, 20}, sheet);
    c.box({0, 4, 7}, {12, 6, 20}, cover);
    c.box({1, 5, 1}, {5, 6, 5}, sheet);
    c.box({7, 5, 1}, {11, 6, 5}, sheet);
    c.box({0, 3, 0}, {12, 9, 1}, wood);
    c.box({0, 3, 20}, {12, 6, 21}, wood);
    return c.finish(std::move(name));
}

LevelShape makeSofa(std::string name, const SurfaceStyle& cloth) {
    Canvas c({21, 9, 9});
    const Swatch fabric = c.addSurface(cloth), cushion = c.addSurface(cloth, 112), wood = c.addSurface(kDarkWood),
                 pillow = c.addSurface(kClothOchre);
    for (int x : {1, 18})
        for (int z : {1, 6}) c.box({x, 0, z}, {x + 2, 1, z + 2}, wood);
    c.box({0, 1, 0}, {21, 3, 9}, fabric);
    c.box({0, 3, 0}, {2, 6, 9}, fabric);
    c.box({19, 3, 0}, {21, 6, 9}, fabric);
    c.box({0, 3, 0}, {21, 9, 2}, fabric);
    for (int x : {2, 8, 13}) c.box({x, 3, 2}, {x + (x == 2 ? 5 : x == 8 ? 4 : 6), 4, 9}, cushion);
    c.box({3, 4, 2}, {7, 7, 3}, pillow);
    return c.finish(std::move(name));
}

LevelShape makeBath(std::string name) {
    Canvas c({18, 8, 9});
    const Swatch enamel = c.addSurface(kWhiteEnamel), steel = c.addSurface(kSteel);
    for (int x : {1, 15})
        for (int z : {1, 6}) c.box({x, 0, z}, {x + 2, 1, z + 2}, steel);
    c.box({1, 1, 1}, {17, 7, 8}, enamel);
    c.box({0, 6, 0}, {18, 7, 9}, enamel);
    c.clear({2, 2, 2}, {16, 7, 7});
    c.box({1, 7, 4}, {2, 8, 5}, steel);
    c.box({2, 7, 4}, {3, 8, 5}, steel);
    return c.finish(std::move(name));
}

LevelShape makeToilet(std::string name) {
    Canvas c({4, 9, 7});
    const Swatch enamel = c.addSurface(kWhiteEnamel), wood = c.addSurface(kDarkWood);
    c.box({1, 0, 1}, {3, 3, 6}, enamel);
    c.box({0, 3, 2}, {4, 4, 7}, enamel);
    c.clear({1, 3, 3}, {3, 4, 6});
    c.box({0, 3, 0}, {4, 9, 2}, enamel);
    c.box({0, 4, 2}, {4, 8, 3}, wood);
    return c.finish(std::move(name));
}

LevelShape makeCounter(std::string name, int length) {
    Canvas c({length, 12, 7});
    const Swatch cupboard = c.addSurface(kWhiteWood), seam = c.addSurface(kWhiteWood, 70),
                 top = c.addSurface(kDarkWood), steel = c.addSurface(kSteel);
    c.box({0, 0, 0}, {length, 9, 6}, cupboard);
    c.clear({1, 1, 1}, {length - 1, 8, 5});
    for (int x = 0; x < length; x += 6) c.box({x, 0, 0}, {x + 1, 9, 6}, seam);
    for (int x = 4; x < length; x += 6) c.box({x, 6, 6}, {x + 1, 7, 7}, steel);
    c.box({0, 9, 0}, {length, 10, 7}, top);
    c.box({4, 9, 1}, {11, 10, 5}, steel);
    c.clear({5, 9, 2}, {10, 10, 4});
    c.box({5, 8, 2}, {10, 9, 4}, steel);
    c.box({7, 10, 1}, {8, 12, 2}, steel);
    return c.finish(std::move(name));
}

LevelShape makeFridge(std::string name) {
    Canvas c({7, 18, 7});
    const Swatch enamel = c.addSurface(kWhiteEnamel), seam = c.addSurface(kWhiteEnamel, 70),
                 steel = c.addSurface(kSteel);
    c.box({0, 0, 0}, {7, 18, 7}, enamel);
    c.clear({1, 1, 1}, {6, 17, 5});
    c.box({0, 12, 0}, {7, 13, 7}, seam);
    c.box({1, 6, 1}, {6, 7, 5}, seam);
    c.clear({1, 7, 1}, {6, 12, 5});
    c.box({5, 8, 6}, {6, 11, 7}, steel);
    return c.finish(std::move(name));
}

LevelShape makeWardrobe(std::string name) {
    Canvas c({13, 20, 6});
    const Swatch wood = c.addSurface(kTimber), panel = c.addSurface(kTimber, 112), steel = c.addSurface(kSteel),
                 clothes = c.addSurface(kGoods);
    c.box({0, 0, 0}, {13, 20, 6}, wood);
    c.clear({1, 1, 1}, {12, 19, 5});
    c.box({2, 2, 5}, {6, 18, 6}, panel);
    c.box({7, 2, 5}, {11, 18, 6}, panel);
    c.box({1, 16, 3}, {12, 17, 4}, steel);
    for (int x = 2; x < 11; x += 2) c.box({x, 6, 2}, {x + 1, 16, 4}, clothes);
    return c.finish(std::move(name));
}

LevelShape makeTelevision(std::string name) {
    Canvas c({14, 13, 5});
    const Swatch wood = c.addSurface(kDarkWood), black = c.addSurface(kPlasticBlack), screen = c.addSurface(kTyre);
    c.box({0, 0, 0}, {14, 4, 5}, wood);
    c.clear({1, 1, 1}, {13, 3, 5});
    c.box({6, 1, 1}, {7, 3, 5}, wood);
    c.box({5, 4, 1}, {9, 5, 4}, black);
    c.box({0, 5, 2}, {14, 13, 3}, black);
    c.box({1, 6, 2}, {13, 12, 3}, screen);
    return c.finish(std::move(name));
}

LevelShape makeCrate(std::string name) {
    Canvas c({8, 8, 8});
    const Swatch board = c.addSurface(kTimber, 112), edge = c.addSurface(kTimber, 88), straw = c.addSurface(kGrassDry);
    c.box(ivec3(0), ivec3(8), board);
    c.clear(ivec3(1), ivec3(7));
    c.box({1, 1, 1}, {7, 3, 7}, straw);
    const auto edges = [&](ivec3 cell) {
        const int rims = (cell.x % 7 == 0) + (cell.y % 7 == 0) + (cell.z % 7 == 0);
        const bool brace = rims == 1 && cell.x % 7 != 0 && cell.x == cell.y;
        return rims >= 2 || brace ? PaletteBuilder::pick(edge, cell) : c.at(cell);
    };
    c.fill(ivec3(0), ivec3(8), edges);
    return c.finish(std::move(name));
}

LevelShape makeBarrel(std::string name, const SurfaceStyle& paint) {
    Canvas c({7, 10, 7});
    const Swatch body = c.addSurface(paint), rim = c.addSurface(kDarkSteel), rust = c.addSurface(kRust);
    c.ring(1, 0, 10, {7, 0, 7}, 5, 7, body);
    c.ring(1, 0, 1, {7, 0, 7}, -1, 7, rim);
    c.ring(1, 9, 10, {7, 0, 7}, -1, 7, rim);
    for (int y : {3, 6}) c.ring(1, y, y + 1, {7, 0, 7}, 5, 7, rim);
    c.stain(ivec3(0), {7, 10, 7}, rust, 22);
    return c.finish(std::move(name));
}

LevelShape makeBin(std::string name) {
    Canvas c({7, 12, 7});
    const Swatch body = c.addSurface(kPlasticGreen), lid = c.addSurface(kPlasticGreen, 80), wheel = c.addSurface(kTyre),
                 rubbish = c.addSurface(kGoods);
    c.box({0, 1, 0}, {7, 10, 7}, body);
    c.clear({1, 2, 1}, {6, 10, 6});
    c.box({1, 2, 1}, {6, 6, 6}, rubbish);
    c.box({0, 10, 0}, {7, 11, 7}, lid);
    c.box({1, 11, 1}, {6, 12, 5}, lid);
    for (int x : {0, 5})
        for (int z : {0, 5}) c.box({x, 0, z}, {x + 2, 2, z + 2}, wheel);
    return c.finish(std::move(name));
}

LevelShape makeBench(std::string name) {
    Canvas c({18, 9, 6});
    const Swatch wood = c.addSurface(kTimber, 108), iron = c.addSurface(kDarkSteel);
    for (int x : {2, 15}) {
        c.box({x, 0, 0}, {x + 1, 9, 1}, iron);
        c.box({x, 0, 5}, {x + 1, 4, 6}, iron);
        c.box({x, 3, 0}, {x + 1, 4, 6}, iron);
    }
    for (int z : {1, 3, 5}) c.box({0, 4, z}, {18, 5, z + 1}, wood);
    for (int x : {2, 15}) c.box({x, 4, 1}, {x + 1, 5, 6}, iron);
    for (int y : {6, 8}) c.box({0, y, 1}, {18, y + 1, 2}, wood);
    for (int x : {2, 15}) c.box({x, 5, 1}, {x + 1, 9, 2}, iron);
    return c.finish(std::move(name));
}

LevelShape makePlantPot(std::string name) {
    Canvas c({7, 13, 7});
    const Swatch pot = c.addSurface(kRoofTileRed), soil = c.addSurface(kDirt), leaf = c.addSurface(kLeaves),
                 stem = c.addSurface(kBark);
    c.ring(1, 0, 4, {7, 0, 7}, -1, 5, pot);
    c.ring(1, 3, 4, {7, 0, 7}, -1, 4, soil);
    c.box({3, 4, 3}, {4, 10, 4}, stem);
    for (int y = 5; y < 13; ++y) c.ring(1, y, y + 1, {7, 0, 7}, -1, y < 7 || y > 10 ? 4 : 7, leaf);
    c.fill({0, 4, 0}, {7, 13, 7}, [&](ivec3 cell) {
        return hashCell(cell.x, cell.y, cell.z, 81) % 3 == 0 && c.hasSwatch(cell, leaf) ? uint8_t(0) : c.at(cell);
    });
    c.removeUnanchored();
    return c.finish(std::move(name));
}

LevelShape makeHydrant(std::string name) {
    Canvas c({5, 9, 5});
    const Swatch red = c.addSurface(kCarRed), dark = c.addSurface(kDarkSteel);
    c.box({0, 0, 0}, {5, 1, 5}, dark);
    c.box({1, 1, 1}, {4, 7, 4}, red);
    c.box({0, 4, 2}, {5, 6, 3}, dark);
    c.box({2, 4, 0}, {3, 6, 5}, dark);
    c.box({1, 7, 1}, {4, 8, 4}, red);
    c.box({2, 8, 2}, {3, 9, 3}, dark);
    return c.finish(std::move(name));
}

void addFloorLight(Level& level, const std::string& name, ivec3 cell) {
    const uint32_t group = addLightGroup(level, name);
    Canvas c({5, 17, 5});
    const Swatch iron = c.addSurface(kDarkSteel), shade = c.addSurface(kBulbGlow, 100, group);
    c.box({1, 0, 1}, {4, 1, 4}, iron);
    c.box({2, 1, 2}, {3, 13, 3}, iron);
    c.ring(1, 12, 16, {5, 0, 5}, -1, 5, shade);
    c.box({1, 16, 1}, {4, 17, 4}, iron);
    addDynamic(level, c.finish(name), cell);
    addLight(level, name, group, LightKind::Sphere, {2.5, 11.0, 2.5}, kWarmLight * 5.0f, 5.0f, 0.2f);
}

}  // namespace rubble::scenes
