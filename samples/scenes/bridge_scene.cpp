// A road bridge on four pillars. One pillar is blown up, and the spans on it fall on the road below.
#include "runtime/core/random.h"
#include "samples/scenes/car.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/script_clock.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr int kFoot = 3;    // cells of the footings in the ground
constexpr int kDeck = 66;   // height of the deck's underside over the ground
constexpr int kWidth = 46;  // of the deck
constexpr int kSpan = 112;  // from pillar to pillar
constexpr int kPillars = 4;
constexpr int kFirst = 10, kZ = 140;  // x of the first pillar's axis; z of the deck's near edge
constexpr int kBlownPillar = 2;       // index

constexpr int pillarX(int i) {
    return kFirst + i * kSpan;
}

/// One pillar with half a span of deck on either side. An open joint separates it from the next part.
LevelShape makePart(std::string name) {
    constexpr int kHalf = kSpan / 2, kY = kFoot + kDeck;
    Canvas c({kSpan, kY + 24, kWidth});
    const Swatch concrete = c.addSurface(kConcrete), dark = c.addSurface(kConcreteDark),
                 dirty = c.addSurface(kConcrete, 80), rebar = c.addSurface(kRebar);
    const Swatch asphalt = c.addSurface(kAsphalt), white = c.addSurface(kLaneWhite), steel = c.addSurface(kSteel),
                 kerb = c.addSurface(kKerb), rust = c.addSurface(kRust);
    c.box({kHalf - 12, 0, 4}, {kHalf + 12, kFoot + 2, kWidth - 4}, dark);
    // The shaft: a slab on edge with chamfered corners and bars inside.
    c.box({kHalf - 5, kFoot + 2, 9}, {kHalf + 5, kY, kWidth - 9}, concrete);
    for (int x : {kHalf - 5, kHalf + 4})
        for (int z : {9, kWidth - 10}) c.clear({x, kFoot + 4, z}, {x + 1, kY - 10, z + 1});
    for (int x = kHalf - 3; x <= kHalf + 2; x += 5)
        for (int z = 11; z < kWidth - 10; z += 6) c.box({x, 0, z}, {x + 1, kY + 4, z + 1}, rebar);
    // Girders, deep over the pillar and shallow at the joint, under a slab with kerbs and railings.
    for (int x = 1; x < kSpan; ++x) {
        const int fromPillar = std::abs(2 * x - kSpan) / 2,
                  depth = 5 + std::max(0, kHalf - fromPillar) * std::max(0, kHalf - fromPillar) * 15 / (kHalf * kHalf);
        for (int z : {6, 20, 34}) c.box({x, kY + 5 - depth, z}, {x + 1, kY + 5, z + 6}, concrete);
        for (int z : {8, 22, 36}) c.box({x, kY + 3, z}, {x + 1, kY + 4, z + 1}, rebar);
        c.box({x, kY + 5, 1}, {x + 1, kY + 8, kWidth - 1}, concrete);
        c.box({x, kY + 8, 0}, {x + 1, kY + 9, kWidth}, x % 14 == 0 ? dark : concrete);
        c.fill({x, kY + 9, 5}, {x + 1, kY + 10, kWidth - 5}, [&](ivec3 cell) {
            const bool line = cell.z == kWidth / 2 && cell.x % 20 < 12;
            return PaletteBuilder::pick(line ? white : asphalt, cell);
        });
        for (int z : {0, kWidth - 5}) c.box({x, kY + 9, z}, {x + 1, kY + 11, z + 5}, kerb);
        for (int z : {1, kWidth - 2}) {
            for (int y : {15, 19}) c.box({x, kY + y, z}, {x + 1, kY + y + 1, z + 1}, steel);
            if (x % 8 == 4) c.box({x, kY + 11, z}, {x + 1, kY + 20, z + 1}, x % 24 == 4 ? rust : steel);
        }
    }
    c.stain({0, kFoot, 0}, {kSpan, kY + 10, kWidth}, dirty, 24);
    c.stain({kHalf - 6, kFoot + 2, 0}, {kHalf + 6, kFoot + 14, kWidth}, dirty, 50);
    return c.finish(std::move(name));
}

/// The bridge's end: a stone block with a grassy bank behind it.
LevelShape makeAbutment(std::string name, int length) {
    constexpr int kTop = kFoot + kDeck + 9;
    Canvas c({length, kTop + 12, kWidth + 80});
    const Swatch stone = c.addSurface(kKerb), joint = c.addSurface(kKerb, 76), grass = c.addSurface(kGrass),
                 dark = c.addSurface(kGrass, 82), dirt = c.addSurface(kDirt), asphalt = c.addSurface(kAsphalt),
                 steel = c.addSurface(kSteel);
    const auto block = [&](ivec3 cell) {
        const int row = cell.y / 6, shifted = cell.x + cell.z + row % 2 * 5;
        return cell.y % 6 == 0 || shifted % 10 == 0
                   ? PaletteBuilder::pick(joint, cell)
                   : PaletteBuilder::pickFor(stone, hashCell(shifted / 10, row, 0, 191));
    };
    for (int x = 0; x < length; ++x) {
        // The bank slopes down to both sides, and toward the bridge behind the block's wings.
        for (int z = 0; z < kWidth + 80; ++z) {
            const int aside = std::max({40 - z, z - kWidth - 39, 0}),
                      top = std::min(kTop, kTop - aside * 2 + 4) - std::max(0, 12 - x) * (aside > 0 ? 3 : 0);
            if (top <= 0) continue;
            c.fill({x, 0, z}, {x + 1, top, z + 1}, [&](ivec3 cell) {
                if (aside == 0)
                    return x < 6 || z < 43 || z > kWidth + 36 ? block(cell) : PaletteBuilder::pick(dirt, cell);
                return cell.y < top - 1 ? dirt.first
                                        : PaletteBuilder::pick(hashCell(x / 5, 0, z / 5, 192) % 3 ? grass : dark, cell);
            });
        }
        c.box({x, kTop, 45}, {x + 1, kTop + 1, kWidth + 35}, asphalt);
        for (int z : {41, kWidth + 38}) {
            for (int y : {5, 9}) c.box({x, kTop + y, z}, {x + 1, kTop + y + 1, z + 1}, steel);
            if (x % 8 == 4) c.box({x, kTop, z}, {x + 1, kTop + 10, z + 1}, steel);
        }
    }
    return c.finish(std::move(name));
}

Level bridgeLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {448, 0, 448};
    const int middle = (pillarX(kBlownPillar) + pillarX(kBlownPillar - 1)) / 2;
    ground.areas = {area(Paving, middle - 50, 0, middle + 50, 448), area(Road, middle - 34, 0, middle + 34, 448),
                    area(Earth, 0, kZ - 6, middle - 50, kZ + kWidth + 6),
                    area(Earth, middle + 50, kZ - 6, 448, kZ + kWidth + 6)};
    ground.lanesAlongZ = {{{middle - 1, 0, 0}, {middle + 1, 0, 448}}};
    Level level = makePlot("bridge", ground, seed);
    for (int i = 0; i < kPillars; ++i)
        addStatic(level, makePart("bridge part " + std::to_string(i)), {pillarX(i) - kSpan / 2, -kFoot, kZ});
    addStatic(level, makeAbutment("abutment", 448 - pillarX(kPillars - 1) - kSpan / 2 - 1),
              {pillarX(kPillars - 1) + kSpan / 2 + 1, -kFoot, kZ - 40});
    const int top = kDeck + 10;
    addDynamic(level, makeVan("van", kCarYellow), {pillarX(kBlownPillar) - 40, top, kZ + 24});
    addDynamic(level, makeCar("car on bridge", kCarCream), {pillarX(kBlownPillar) + 24, top, kZ + 6}, Turn::Half);
    addDynamic(level, makeCar("car red", kCarRed), {middle + 8, -kRoadDrop, 176}, Turn::Quarter);
    addDynamic(level, makeCar("car blue", kCarBlue), {middle - 28, -kRoadDrop, 222}, Turn::ThreeQuarters);
    for (int i = 0; i < 5; ++i)
        addDynamic(level, makeBarrel("barrel " + std::to_string(i), i % 2 ? kCarRed : kCarBlue),
                   {pillarX(kBlownPillar) + 24 + i * 7, 0, 176 + i % 2 * 6});
    addDynamic(level, makeCrate("crate"), {pillarX(kBlownPillar) + 40, 0, 190});
    return level;
}

Edits bridgeScript(int step, uint64_t) {
    ScriptClock clock(step);
    const double x = pillarX(kBlownPillar);
    // Three charges along the shaft, then a carve of what remains between them.
    for (int i = 0; i < 3; ++i)
        if (clock.at(1.0 + 0.12 * i)) clock.add(ExplodeEdit{atCell(x, 12.0 + i % 2 * 6, kZ + 12.0 + i * 11), 1.8});
    if (clock.at(1.4)) {
        CarveEdit rest;
        rest.kind = BrushKind::Box;
        rest.position = atCell(x, 14.0, kZ + kWidth / 2.0);
        rest.halfSize = {0.8, 0.5, 2.4};
        clock.add(rest);
    }
    return clock.take();
}

Pose bridgeCamera(double seconds) {
    return lookAt({13.0 + 0.12 * seconds, 2.6, 38.5}, {22.6, 4.9, 16.0});
}

}  // namespace

Scene bridgeScene() {
    Scene scene{"bridge", "a bridge that loses a pillar", bridgeLevel, bridgeScript, bridgeCamera};
    scene.steps = 300;
    scene.settings.stress.on = true;
    return scene;
}

}  // namespace rubble::scenes
