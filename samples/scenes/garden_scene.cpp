// A model garden: small monuments of 5 cm voxels on plinths. Each is destroyed with another tool.
#include <glm/geometric.hpp>

#include "runtime/core/random.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/script_clock.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr double kFine = 0.05;  // metres per voxel
constexpr int kPlinth = 12;     // height in cells of 0.1 m
constexpr ivec3 kPlaces[] = {{92, 0, 176}, {134, 0, 154}, {176, 0, 178}, {218, 0, 152}, {150, 0, 206}};
constexpr int kModels = 5;

void addPlinth(Level& level, int i) {
    Canvas c({28, kPlinth + 3, 28});
    const Swatch stone = c.addSurface(kKerb), dark = c.addSurface(kKerb, 80), moss = c.addSurface(kMoss);
    c.box({2, 0, 2}, {26, 5, 26}, dark);
    c.box({4, 5, 4}, {24, kPlinth, 24}, stone);
    c.box({2, kPlinth, 2}, {26, kPlinth + 3, 26}, stone);
    c.stain({0, 3, 0}, {28, 7, 28}, moss, 40);
    addStatic(level, c.finish("plinth " + std::to_string(i)), kPlaces[i] - ivec3(14, 3, 14));
}

/// A static shape of fine voxels, centred on a plinth.
void addModel(Level& level, Canvas& canvas, int i, const std::string& name) {
    LevelBody body;
    LevelShape shape = canvas.finish(name);
    shape.voxelSize = float(kFine);
    const glm::dvec3 size = glm::dvec3(shape.grid.size()) * kFine;
    body.name = name;
    body.pose.position = glm::dvec3(kPlaces[i]) * kVoxel + glm::dvec3(-size.x / 2, kPlinth * kVoxel, -size.z / 2);
    body.shapes.push_back(std::move(shape));
    level.bodies.push_back(std::move(body));
}

void addCastle(Level& level, int i) {
    Canvas c({44, 44, 44});
    const Swatch stone = c.addSurface(kPlasterOchre), dark = c.addSurface(kPlasterOchre, 78),
                 roof = c.addSurface(kRoofTileRed), wood = c.addSurface(kDarkWood), flag = c.addSurface(kClothRed);
    c.box({4, 0, 4}, {40, 16, 40}, stone);
    c.clear({8, 1, 8}, {36, 16, 36});
    for (int u = 4; u < 40; u += 4)
        for (ivec3 cell : {ivec3(u, 16, 4), ivec3(u, 16, 39), ivec3(4, 16, u), ivec3(39, 16, u)})
            c.box(cell, cell + ivec3(2, 2, 1), stone);
    for (int x : {10, 78})
        for (int z : {10, 78}) {
            c.ring(1, 0, 24, {x, 0, z}, 6, 11, stone);
            for (int y = 0; y < 11; ++y) c.ring(1, 24 + y, 25 + y, {x, 0, z}, -1, 13 - y, roof);
        }
    c.box({16, 0, 16}, {28, 30, 28}, stone);
    c.clear({18, 1, 18}, {26, 29, 26});
    for (int y = 0; y < 9; ++y) c.box({15 + y, 30 + y, 15 + y}, {29 - y, 31 + y, 29 - y}, roof);
    c.box({22, 36, 22}, {23, 44, 23}, wood);
    c.box({23, 40, 22}, {28, 44, 23}, flag);
    c.clear({19, 0, 38}, {25, 9, 41});
    c.box({19, 0, 39}, {25, 8, 40}, wood);
    for (int x : {18, 25})
        for (int y : {12, 22}) c.box({x, y, 27}, {x + 1, y + 4, 28}, dark);
    addModel(level, c, i, "castle");
}

void addGlobe(Level& level, int i) {
    Canvas c(ivec3(41, 45, 41));
    const Swatch sea = c.addSurface(kPlasticGrey), land = c.addSurface(kCopperPipe), ring = c.addSurface(kDarkSteel),
                 foot = c.addSurface(kDarkWood);
    c.ring(1, 0, 4, {41, 0, 41}, -1, 22, foot);
    const Swatch blue = c.addSurface(kCarBlue);
    c.fill({0, 4, 0}, {41, 45, 41}, [&](ivec3 cell) {
        const ivec3 d = cell - ivec3(20, 24, 20);
        const int r2 = d.x * d.x + d.y * d.y + d.z * d.z;
        if (d.x * d.x + d.y * d.y <= 400 && d.x * d.x + d.y * d.y > 350 && std::abs(d.z) < 2)
            return PaletteBuilder::pick(ring, cell);
        if (r2 > 290 || r2 < 200) return d.x * d.x + d.z * d.z < 6 ? PaletteBuilder::pick(foot, cell) : uint8_t(0);
        const int noise = int(hashCell(d.x / 7 + 20, d.y / 6 + 20, d.z / 7 + 20, 181) % 100) +
                          int(hashCell(d.x / 3 + 20, d.y / 3 + 20, d.z / 3 + 20, 182) % 40);
        return PaletteBuilder::pick(noise > 84 ? land : std::abs(d.y) > 13 ? sea : blue, cell);
    });
    addModel(level, c, i, "globe");
}

void addShip(Level& level, int i) {
    Canvas c({52, 44, 22});
    const Swatch hull = c.addSurface(kDarkWood), deck = c.addSurface(kFloorBoard), sail = c.addSurface(kClothCream),
                 mast = c.addSurface(kTimber), red = c.addSurface(kClothRed), stand = c.addSurface(kConcreteDark);
    for (int x : {14, 36}) c.box({x, 0, 6}, {x + 3, 5, 16}, stand);
    for (int x = 0; x < 52; ++x) {
        // The hull narrows toward bow (high x) and stern.
        const int along = x - 22, beam = std::max(1, 10 - (x > 22 ? along * along / 95 : along * along / 130));
        const int sheer = 12 + along * along / 130;
        for (int y = 3; y < sheer; ++y) {
            const int half = std::max(1, beam * (y + 5) / (sheer + 5));
            c.box({x, y, 11 - half}, {x + 1, y + 1, 11 + half}, y == sheer - 1 ? deck : hull);
        }
        c.box({x, sheer, 11 - beam}, {x + 1, sheer + 2, 11 - beam + 1}, red);
        c.box({x, sheer, 11 + beam - 1}, {x + 1, sheer + 2, 11 + beam}, red);
    }
    for (int x : {12, 28, 41}) {
        const int top = x == 28 ? 44 : 38;
        c.box({x, 10, 10}, {x + 1, top, 12}, mast);
        for (int y = 18; y < top - 2; ++y) {
            const int half = y < top - 12 ? 9 : 6;
            const int bulge = (y - 18) % 12 < 9 ? 2 : 1;
            if ((y - 18) % 13 == 12) continue;
            c.box({x, y, 11 - half}, {x + bulge, y + 1, 11 + half}, sail);
        }
    }
    addModel(level, c, i, "ship");
}

void addTemple(Level& level, int i) {
    Canvas c({48, 36, 34});
    const Swatch marble = c.addSurface(kPlaster), shade = c.addSurface(kPlaster, 86), gold = c.addSurface(kClothOchre);
    for (int y = 0; y < 3; ++y) c.box({y, y, y}, {48 - y, y + 1, 34 - y}, y % 2 ? shade : marble);
    for (int x = 6; x <= 42; x += 6)
        for (int z : {6, 27}) c.ring(1, 3, 22, {2 * x, 0, 2 * z + 1}, -1, 4, marble);
    for (int z : {13, 20})
        for (int x : {6, 42}) c.ring(1, 3, 22, {2 * x, 0, 2 * z + 1}, -1, 4, marble);
    c.box({3, 22, 3}, {45, 25, 31}, shade);
    for (int z = 2; z < 32; ++z) {
        const int rise = std::min(z - 2, 31 - z) / 2;
        c.box({2, 25, z}, {46, 26 + rise, z + 1}, z % 3 ? marble : shade);
    }
    c.box({20, 3, 13}, {28, 14, 21}, gold);
    addModel(level, c, i, "temple");
}

void addFountain(Level& level, int i) {
    Canvas c({40, 36, 40});
    const Swatch stone = c.addSurface(kConcrete), water = c.addSurface(kGlass), bronze = c.addSurface(kCopperPipe),
                 dark = c.addSurface(kConcreteDark);
    c.ring(1, 0, 2, {40, 0, 40}, -1, 39, dark);
    c.ring(1, 2, 9, {40, 0, 40}, 33, 39, stone);
    c.ring(1, 2, 7, {40, 0, 40}, -1, 33, water);
    c.ring(1, 2, 18, {40, 0, 40}, -1, 7, stone);
    c.ring(1, 17, 18, {40, 0, 40}, -1, 19, stone);
    c.ring(1, 18, 21, {40, 0, 40}, 15, 19, stone);
    c.ring(1, 18, 30, {40, 0, 40}, -1, 4, bronze);
    for (int y = 0; y < 6; ++y) c.ring(1, 30 + y, 31 + y, {40, 0, 40}, -1, y < 3 ? 4 + y * 2 : 14 - y * 2, bronze);
    addModel(level, c, i, "fountain");
}

Level gardenLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {320, 0, 320};
    ground.areas = {area(Paving, 60, 196, 250, 216), area(Paving, 142, 216, 160, 320), area(Paving, 112, 130, 126, 196),
                    area(Paving, 192, 130, 206, 196)};
    Level level = makePlot("model garden", ground, seed);
    level.environment.sunDirection = {-0.75f, 0.5f, 0.3f};
    for (int i = 0; i < kModels; ++i) addPlinth(level, i);
    addCastle(level, 0);
    addGlobe(level, 1);
    addShip(level, 2);
    addTemple(level, 3);
    addFountain(level, 4);
    addDynamic(level, makeBench("bench 1"), {70, 0, 220});
    addDynamic(level, makeBench("bench 2"), {226, 0, 220});
    for (int i = 0; i < 5; ++i) addDynamic(level, makePlantPot("plant " + std::to_string(i)), {84 + i * 34, 0, 222});
    return level;
}

/// A point of a model, in metres from the middle of its plinth's top.
glm::dvec3 onPlinth(int i, double x, double y, double z) {
    return glm::dvec3(kPlaces[i]) * kVoxel + glm::dvec3(x, kPlinth * kVoxel + y, z);
}

Edits gardenScript(int step, uint64_t) {
    ScriptClock clock(step);
    // Castle: a charge in the keep. Globe: cut into slices. Ship: shot through. Temple: its columns are carved away.
    // Fountain: a charge.
    if (clock.at(1.0)) clock.add(ExplodeEdit{onPlinth(0, 0.3, 0.5, 0.7), 0.9, 250});
    for (int i = 0; i < 4; ++i)
        if (clock.at(1.6 + 0.25 * i)) {
            CarveEdit slice;
            slice.kind = BrushKind::Box;
            slice.position = onPlinth(1, -0.6 + 0.4 * i, 1.25, 0);
            slice.halfSize = {0.04, 1.1, 1.2};
            slice.rotation = glm::normalize(glm::dquat(1.0, 0.0, 0.0, 0.12 - 0.08 * i));
            clock.add(slice);
        }
    for (int i = 0; i < 6; ++i)
        if (clock.at(2.7 + 0.15 * i))
            clock.add(carveCapsule(onPlinth(2, -1.0 + 0.34 * i, 0.25 + 0.22 * (i % 3), 0.9),
                                   onPlinth(2, -0.9 + 0.3 * i, 0.25 + 0.22 * (i % 3), -0.9), {0.13, 0.13, 0.1}));
    for (int i = 0; i < 7; ++i)
        if (clock.at(3.6 + 0.2 * i))
            clock.add(carveSphere(onPlinth(3, -0.9 + 0.3 * i, 0.5, i % 2 ? 0.5 : -0.5), {0.24, 0.24, 0.2}));
    if (clock.at(5.25)) clock.add(ExplodeEdit{onPlinth(4, 0.2, 0.3, 0.3), 1.0, 200});
    return clock.take();
}

Pose gardenCamera(double seconds) {
    return lookAt({11.6 + 0.12 * seconds, 3.9, 30.6}, {15.2, 1.7, 17.0});
}

}  // namespace

Scene gardenScene() {
    Scene scene{"garden", "a model garden of fine voxels, one tool for each", gardenLevel, gardenScript, gardenCamera};
    scene.steps = 420;
    return scene;
}

}  // namespace rubble::scenes
