// A field of walls, barrels and crates under a barrage: craters, and more debris than the debris budget keeps.
#include "runtime/core/random.h"
#include "samples/scenes/fence.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/script_clock.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr int kBlasts = 18;

/// A concrete bunker with a slit, half in the ground.
LevelShape makeBunker(std::string name) {
    constexpr ivec3 kSize{52, 28, 40};
    Canvas c(kSize);
    const Swatch concrete = c.addSurface(kConcrete), dark = c.addSurface(kConcreteDark), rebar = c.addSurface(kRebar),
                 moss = c.addSurface(kMoss), dirty = c.addSurface(kConcrete, 80);
    c.box(ivec3(0), kSize, concrete);
    c.clear({5, 3, 5}, {47, 22, 35});
    c.clear({6, 13, 35}, {46, 17, 40});
    c.clear({0, 3, 12}, {5, 20, 22});
    for (int x = 2; x < kSize.x; x += 6)
        for (int z : {2, 37}) c.box({x, 0, z}, {x + 1, 26, z + 1}, rebar);
    for (int x = 2; x < kSize.x; x += 6) c.box({x, 24, 2}, {x + 1, 25, 38}, rebar);
    c.clear({0, 26, 0}, {3, 28, 40});
    c.clear({49, 26, 0}, {52, 28, 40});
    c.stain({0, 0, 0}, kSize, dirty, 30);
    c.stain({0, 24, 0}, kSize, moss, 24);
    c.box({0, 0, 0}, {52, 3, 40}, dark);
    return c.finish(std::move(name));
}

LevelShape makeRuin(std::string name, int length) {
    Canvas c({length, 26, 4});
    const Swatch brick = c.addSurface(kBrick), joint = c.addSurface(kBrickJoint);
    c.fill(ivec3(0), {length, 26, 4}, [&](ivec3 cell) {
        const int top = 12 + int(hashCell(cell.x / 5, 0, length, 171) % 13);
        if (cell.y >= top || (cell.x % 26 > 9 && cell.x % 26 < 18 && cell.y > 9 && cell.y < 18)) return uint8_t(0);
        const int shifted = cell.x + cell.y % 2 * 2;
        return PaletteBuilder::pickFor(shifted % 4 == 0 ? joint : brick,
                                       hashCell(shifted / 4, cell.y, cell.z / 2, 42) >> 8);
    });
    c.removeUnanchored();
    return c.finish(std::move(name));
}

Level cratersLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {448, 0, 320};
    ground.areas = {area(Earth, 40, 96, 420, 250), area(Lawn, 60, 110, 150, 140), area(Lawn, 250, 190, 360, 230)};
    Level level = makePlot("blast field", ground, seed);
    addStatic(level, makeBunker("bunker"), {210, -6, 110});
    addStatic(level, makeRuin("ruin 1", 70), {90, -2, 150});
    addStatic(level, makeRuin("ruin 2", 60), {300, -2, 140});
    addStatic(level, makeConcreteWall("concrete wall", 90, 13), {150, -kFenceFoot, 200});
    Random random(seed, 32);
    for (int i = 0; i < 26; ++i) {
        const int x = random.between(70, 380), z = random.between(160, 240);
        if (x > 140 && x < 250 && z > 190 && z < 214) continue;
        const std::string name = (i % 2 ? "barrel " : "crate ") + std::to_string(i);
        addDynamic(level, i % 2 ? makeBarrel(name, i % 4 == 1 ? kCarRed : kCarBlue) : makeCrate(name), {x, 0, z});
    }
    return level;
}

Edits cratersScript(int step, uint64_t seed) {
    ScriptClock clock(step);
    Random random(seed, 33);
    for (int i = 0; i < kBlasts; ++i) {
        const double x = 8.0 + 28.0 * random.unit(), z = 12.5 + 11.0 * random.unit(), size = 1.2 + 1.3 * random.unit();
        if (clock.at(0.6 + 0.3 * i)) clock.add(ExplodeEdit{{x, 0.3 + 0.5 * (i % 3), z}, size});
    }
    if (clock.at(3.1)) clock.add(ExplodeEdit{atCell(236, 10, 128), 2.6});
    if (clock.at(4.6)) clock.add(ExplodeEdit{atCell(196, 8, 203), 1.8});
    return clock.take();
}

Pose cratersCamera(double seconds) {
    return lookAt({17.0 + 0.2 * seconds, 5.2, 36.0}, {22.0, 1.2, 16.0});
}

}  // namespace

Scene cratersScene() {
    Scene scene{"craters", "a field under a barrage, its debris on a budget", cratersLevel, cratersScript,
                cratersCamera};
    scene.steps = 480;
    scene.settings.minPieceVoxels = 4;
    return scene;
}

}  // namespace rubble::scenes
