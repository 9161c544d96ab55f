// A breaker's yard: two blocks and a container come down on a car.
#include "runtime/core/random.h"
#include "samples/scenes/car.h"
#include "samples/scenes/fence.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/script_clock.h"
#include "samples/scenes/street_light.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr ivec3 kCar{136, 0, 168};

/// A block of concrete with lifting eyes and hazard stripes on its edges.
LevelShape makeBlock(std::string name) {
    constexpr ivec3 kSize{22, 16, 18};
    Canvas c(kSize);
    const Swatch concrete = c.addSurface(kConcrete), yellow = c.addSurface(kCarYellow),
                 black = c.addSurface(kPlasticBlack), steel = c.addSurface(kDarkSteel);
    c.box(ivec3(0), kSize, concrete);
    for (int y : {0, kSize.y - 2})
        c.fill({0, y, 0}, {kSize.x, y + 2, kSize.z}, [&](ivec3 cell) {
            const bool rim = cell.x == 0 || cell.z == 0 || cell.x == kSize.x - 1 || cell.z == kSize.z - 1;
            if (!rim) return c.at(cell);
            return PaletteBuilder::pick((cell.x + cell.z + cell.y) / 3 % 2 ? yellow : black, cell);
        });
    for (int x : {5, 15}) c.box({x, kSize.y - 1, 8}, {x + 2, kSize.y, 10}, steel);
    c.stain(ivec3(0), kSize, c.addSurface(kConcrete, 80), 22);
    return c.finish(std::move(name));
}

/// A steel container with corrugated sides and a frame; its doors toward +x.
LevelShape makeContainer(std::string name, const SurfaceStyle& paint) {
    constexpr ivec3 kSize{60, 26, 24};
    Canvas c(kSize);
    const Swatch side = c.addSurface(paint), shade = c.addSurface(paint, 84), frame = c.addSurface(paint, 70),
                 rust = c.addSurface(kRust), floor = c.addSurface(kTimber);
    c.fill(ivec3(0), kSize, [&](ivec3 cell) {
        const bool x = cell.x == 0 || cell.x == kSize.x - 1, y = cell.y == 0 || cell.y == kSize.y - 1,
                   z = cell.z == 0 || cell.z == kSize.z - 1;
        if (int(x) + int(y) + int(z) > 1) return PaletteBuilder::pick(frame, cell);
        if (cell.y == 0) return PaletteBuilder::pick(floor, cell);
        if (x || y || z) return PaletteBuilder::pick((x ? cell.z : cell.x) % 4 < 2 ? side : shade, cell);
        return uint8_t(0);
    });
    c.stain(ivec3(0), {kSize.x, 5, kSize.z}, rust, 26);
    c.stain(ivec3(0), kSize, rust, 8);
    return c.finish(std::move(name));
}

Level crushLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {320, 0, 320};
    ground.areas = {area(Concrete, 30, 86, 290, 320), area(Earth, 0, 200, 30, 320)};
    Level level = makePlot("breaker's yard", ground, seed);
    addDynamic(level, makeCar("car", kCarRed), kCar);
    addDynamic(level, makeBlock("block 1"), kCar + ivec3(6, 62, 1), Turn::Askew);
    addDynamic(level, makeBlock("block 2"), kCar + ivec3(22, 150, -1));
    addDynamic(level, makeContainer("falling container", kCarBlue), kCar + ivec3(-8, 330, -3), Turn::Askew);
    for (LevelBody& body : level.bodies)
        if (!body.isStatic) body.velocity.y = -0.3f;  // a moving body does not fall asleep in the air
    addDynamic(level, makeContainer("container 1", kCarYellow), {60, 0, 100});
    addDynamic(level, makeContainer("container 2", kCarCream), {150, 0, 98}, Turn::Askew);
    addDynamic(level, makeContainer("container 3", kTankPaint), {70, 26, 100});
    addDynamic(level, makeCar("wreck 1", kCarCream), {226, 0, 120}, Turn::Quarter);
    addDynamic(level, makeCar("wreck 2", kCarYellow), {226, 15, 121}, Turn::Quarter);
    addDynamic(level, makeCar("wreck 3", kCarBlue), {252, 0, 124}, Turn::ThreeQuarters);
    addStatic(level, makeConcreteWall("yard wall", 250, 18), {34, -kFenceFoot, 86});
    addStreetLight(level, "street light", {214, 0, 176}, true);
    for (int i = 0; i < 4; ++i)
        addDynamic(level, makeBarrel("barrel " + std::to_string(i), i % 2 ? kCarRed : kCarBlue),
                   {100 + i % 2 * 8, 0, 150 + i / 2 * 9});
    return level;
}

Edits crushScript(int, uint64_t) {
    return {};  // gravity does all of it
}

Pose crushCamera(double seconds) {
    return lookAt({10.4 + 0.12 * seconds, 2.7, 27.5}, {15.8, 2.0, 17.0});
}

}  // namespace

Scene crushScene() {
    Scene scene{"crush", "a car under falling blocks", crushLevel, crushScript, crushCamera};
    scene.steps = 360;
    return scene;
}

}  // namespace rubble::scenes
