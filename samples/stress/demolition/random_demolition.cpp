#include "samples/stress/demolition/random_demolition.h"

#include <fmt/format.h>

#include "samples/scenes/canvas.h"
#include "samples/scenes/placement.h"
#include "samples/scenes/surface_styles.h"
#include "samples/scenes/town.h"
#include "samples/stress/demolition/machines.h"

namespace rubble {
namespace {

constexpr int kHoppers = 6, kHopperSide = 3;  ///< a hopper has side^3 pieces

std::string hopperName(int hopper) {
    return fmt::format("hopper {}", hopper);
}

/// A random cell of a shape's grid, in metres in the world.
glm::dvec3 randomPosition(const World& world, ShapeHandle handle, Random& random) {
    const Shape& shape = world.shapes().at(handle);
    const glm::ivec3 size = shape.grid.size();
    const int x = random.between(0, size.x - 1), y = random.between(0, size.y - 1), z = random.between(0, size.z - 1);
    return shapeToWorld(world, handle).transformPoint(glm::dvec3(x, y, z) * double(shape.voxelSize));
}

ShapeHandle randomShape(const World& world, Random& random) {
    std::vector<ShapeHandle> shapes;
    world.shapes().forEach([&](ShapeHandle handle, const Shape&) { shapes.push_back(handle); });
    return shapes.empty() ? ShapeHandle{} : shapes[random.below(uint32_t(shapes.size()))];
}

glm::dvec3 randomDirection(Random& random) {
    const double x = random.unit(), y = random.unit(), z = random.unit();
    return glm::dvec3(x, y, z) * 2.0 - 1.0;
}

CarveEdit randomCarve(glm::dvec3 place, double radius, Random& random) {
    CarveEdit carve;
    carve.position = place;
    carve.radii = {radius, radius * 0.8, radius * 0.5};
    const uint32_t kind = random.below(3);
    if (kind == 1) {
        carve.kind = BrushKind::Box;
        carve.halfSize = glm::dvec3(radius, radius * 0.3, radius * 0.6);
    } else if (kind == 2) {
        carve.kind = BrushKind::Capsule;
        carve.end = place + randomDirection(random) * 3.0;
    }
    return carve;
}

/// Wakes the pieces of a hopper that still sleep in the air: a tiny impulse each, and they fall.
Edits pour(const World& world, int hopper) {
    Edits edits;
    world.bodies().forEach([&](BodyHandle handle, const Body& body) {
        if (body.name == hopperName(hopper) && body.asleep)
            edits.push_back(ImpulseEdit{handle, body.pose.position, {0, -1e-3, 0}});
    });
    return edits;
}

}  // namespace

Level makeStressLevel(uint64_t seed) {
    using namespace scenes;
    Level level = makeTown(seed);
    addMachines(level);
    Random random(seed, 78);
    for (int hopper = 0; hopper < kHoppers; ++hopper) {
        const ivec3 corner(90 + hopper % 3 * 200, 250, 120 + hopper / 3 * 250);
        for (int i = 0; i < kHopperSide * kHopperSide * kHopperSide; ++i) {
            const int x = random.between(2, 8), y = random.between(2, 8), z = random.between(2, 8);
            Canvas canvas({x, y, z});
            canvas.box(ivec3(0), {x, y, z}, canvas.addSurface(i % 3 ? kBrick : kTimber));
            addDynamic(
                level, canvas.finish(hopperName(hopper)),
                corner + ivec3(i % kHopperSide, i / kHopperSide % kHopperSide, i / kHopperSide / kHopperSide) * 12);
            level.bodies.back().name = hopperName(hopper);
        }
    }
    return level;
}

WorldSettings stressSettings() {
    WorldSettings settings;
    settings.stress.on = true;
    settings.debris.awakeBodies = 40;
    settings.debris.bodies = 250;
    return settings;
}

Edits randomEdits(const World& world, Random& random) {
    const ShapeHandle shape = randomShape(world, random);
    if (!world.shapes().find(shape)) return {};
    const glm::dvec3 place = randomPosition(world, shape, random);
    const double radius = 0.2 + 1.3 * double(random.unit());
    switch (random.below(20)) {
        case 0:
        case 1:
            return {ExplodeEdit{place, 0.5 + radius}};
        case 2:
        case 3: {
            const double force = 1e3 + 1e5 * double(random.unit());
            return {ImpactLoadEdit{shape, place, randomDirection(random) * force}};
        }
        case 4:
            return {BreakEdit{.position = place, .radii = {radius, radius * 0.7, radius * 0.4}, .seed = random.next()}};
        case 5:
            return {PaintEdit{.position = place, .radius = radius, .seed = random.next()}};
        case 6:
            return {HeatEdit{.position = place, .radius = radius, .joules = 1e5, .ignite = true}};
        case 7:
            return {pourWater(place, radius)};
        case 8:
        case 9: {
            const BodyHandle body = world.shapes().at(shape).body;
            const double mass = bodyMass(world, body).mass, speed = 10.0 * double(random.unit());
            return {ImpulseEdit{body, place, randomDirection(random) * (mass * speed)}};
        }
        case 10:
            return pour(world, int(random.below(kHoppers)));
        case 16:
        case 17:
        case 18:
        case 19:
            return randomCommand(world, random);
        default:
            return {randomCarve(place, radius, random)};
    }
}

}  // namespace rubble
