#include "samples/scenes/test_scenes.h"

#include "runtime/core/random.h"
#include "samples/scenes/placement.h"
#include "samples/scenes/surface_styles.h"

namespace rubble {
namespace {

using namespace scenes;

LevelShape block(std::string name, ivec3 size, const SurfaceStyle& style) {
    Canvas canvas(size);
    canvas.box(ivec3(0), size, canvas.addSurface(style));
    return canvas.finish(std::move(name));
}

Level withFloor(std::string name) {
    Level level;
    level.name = std::move(name);
    Canvas canvas({80, 4, 80});
    canvas.box(ivec3(0), {80, 4, 80}, canvas.addSurface(kRock));
    addStatic(level, canvas.finish("floor"), {0, -4, 0});
    return level;
}

}  // namespace

Level makeSingleCube(int size, double height) {
    Level level = withFloor("lone cube");
    addDynamic(level, block("cube", ivec3(size), kTimber), {40 - size / 2, 0, 40 - size / 2});
    level.bodies.back().pose.position.y = height;
    return level;
}

Level makeClosedRoom(int inner) {
    Level level;
    level.name = "closed room";
    Canvas canvas(ivec3(inner + 2));
    canvas.box(ivec3(0), ivec3(inner + 2), canvas.addSurface(kPlaster));
    canvas.clear(ivec3(1), ivec3(inner + 1));
    addStatic(level, canvas.finish("room"), ivec3(0));
    return level;
}

Level makeWall() {
    Level level = withFloor("wall");
    addStatic(level, block("wall", {40, 24, 3}, kBrick), {20, 0, 39});
    return level;
}

Level makeTestTower(int storeys) {
    Level level = withFloor("tower");
    Canvas canvas({24, storeys * 12, 24});
    const Swatch concrete = canvas.addSurface(kConcrete), slab = canvas.addSurface(kConcreteDark);
    for (int storey = 0; storey < storeys; ++storey) {
        const int y = storey * 12;
        for (int x : {0, 21})
            for (int z : {0, 21}) canvas.box({x, y, z}, {x + 3, y + 10, z + 3}, concrete);
        canvas.box({0, y + 10, 0}, {24, y + 12, 24}, slab);
    }
    addStatic(level, canvas.finish("tower"), {28, 0, 28});
    return level;
}

Level makeCubeRain(int count, int size, uint64_t seed) {
    Level level = withFloor("cube rain");
    Random random(seed);
    const int columns = 60 / (size + 2);
    for (int i = 0; i < count; ++i) {
        const int x = i % columns, z = i / columns % columns, y = i / (columns * columns);
        addDynamic(level, block("cube " + std::to_string(i), ivec3(size), i % 2 ? kTimber : kBrick),
                   {10 + x * (size + 2), 4 + y * (size + 2), 10 + z * (size + 2)});
        const float turn = random.unit() - 0.5f;
        level.bodies.back().angularVelocity = {turn, 0.0f, -turn};
    }
    return level;
}

}  // namespace rubble
