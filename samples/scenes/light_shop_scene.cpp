// A light shop at night: a dozen lights, each in a light group of its own. They are shot one after the other, and the
// shop grows darker with each.
#include "runtime/core/random.h"
#include "samples/scenes/building.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/lettering.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/script_clock.h"
#include "samples/scenes/street_light.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr int kWidth = 110, kDepth = 60, kHeight = 32, kMargin = 4;
constexpr int kFloor = kFooting + 1, kCeiling = kFloor + kHeight;
constexpr ivec3 kShopLow{105, -kFooting, 120};
constexpr int kGlobes = 5, kCubes = 4;

constexpr int globeX(int i) {
    return kMargin + 17 + i * 19;
}
constexpr int globeY(int i) {
    return kCeiling - 9 - i % 2 * 4;
}
constexpr int cubeX(int i) {
    return kMargin + 16 + i * 24;
}

struct Tint {
    uint32_t color;
    glm::vec3 light;
};
constexpr Tint kTints[] = {{0xffc890, {1.0f, 0.66f, 0.36f}},
                           {0x80d8d0, {0.25f, 0.9f, 0.85f}},
                           {0xffb0c8, {1.0f, 0.35f, 0.55f}},
                           {0xffe0a0, {1.0f, 0.78f, 0.45f}},
                           {0xa8b8ff, {0.42f, 0.52f, 1.0f}}};

Swatch glowing(Canvas& c, const Tint& tint, uint32_t group) {
    return c.addSurface({"glass", {tint.color}, 120, 0, 10, 255, 0, 1.5f}, 100, group);
}

void drawShopLights(Level& level, Canvas& c, Swatch wire, Swatch wood) {
    for (int i = 0; i < kGlobes; ++i) {
        const std::string name = "globe " + std::to_string(i);
        const uint32_t group = addLightGroup(level, name, 0.25f);
        const ivec3 center(globeX(i), globeY(i), kMargin + 36);
        c.box({center.x, center.y + 3, center.z}, {center.x + 1, kCeiling, center.z + 1}, wire);
        const Swatch glow = glowing(c, kTints[i % 5], group);
        c.fill(center - 3, center + 4, [&](ivec3 cell) {
            const ivec3 d = cell - center;
            return d.x * d.x + d.y * d.y + d.z * d.z <= 11 ? PaletteBuilder::pick(glow, cell) : c.at(cell);
        });
        addLight(level, "shop", group, LightKind::Sphere, glm::dvec3(center) + glm::dvec3(0.5, -4.5, 0.5),
                 kTints[i % 5].light * 6.0f, 7.0f, 0.3f);
    }
    // Boxes of light on a counter.
    for (int i = 0; i < kCubes; ++i) {
        const uint32_t group = addLightGroup(level, "cube " + std::to_string(i), 0.25f);
        const ivec3 low(cubeX(i), kFloor + 11, kMargin + 14);
        c.box(low - ivec3(1, 1, 1), low + ivec3(7, 0, 7), wood);
        c.box(low, low + ivec3(6, 7, 6), glowing(c, kTints[(i + 2) % 5], group));
        addLight(level, "shop", group, LightKind::Sphere, glm::dvec3(low) + glm::dvec3(3, 4, 8.5),
                 kTints[(i + 2) % 5].light * 2.5f, 5.0f, 0.3f);
    }
}

void addShopFront(Level& level, Canvas& c) {
    const uint32_t group = addLightGroup(level, "sign", 0.2f);
    const Swatch board = c.addSurface(kPlasticBlack),
                 glow = c.addSurface({"glass", {0x1a7068}, 120, 0, 10, 255, 0, 9.0f}, 100, group);
    const int z = kMargin + kDepth;
    c.box({kMargin + 10, kCeiling + 3, z}, {kMargin + 100, kCeiling + 22, z + 2}, board);
    drawLettering(c, {kMargin + 20, kCeiling + 6, z + 2}, "RUBBLE", 2, glow);
    for (int x : {30, 78})
        addLight(level, "shop", group, LightKind::Sphere, glm::dvec3(kMargin + x, kCeiling + 11, z + 9),
                 glm::vec3(0.25f, 0.95f, 0.85f) * 7.0f, 8.0f, 0.3f);
}

void addLightShop(Level& level) {
    Canvas c({kWidth + 2 * kMargin, kCeiling + 24, kDepth + 2 * kMargin + 4});
    const Swatch concrete = c.addSurface(kConcrete), plaster = c.addSurface(kPlaster),
                 tile = c.addSurface(kTileWhite, 90), tileDark = c.addSurface(kTileWhite, 66),
                 wood = c.addSurface(kDarkWood), steel = c.addSurface(kDarkSteel), wire = c.addSurface(kWire),
                 glass = c.addSurface(kGlass), goods = c.addSurface(kGoods);
    WallSwatches walls{c.addSurface(kBrick),
                       c.addSurface(kBrickJoint),
                       plaster,
                       c.addSurface(kBrick, 78),
                       wire,
                       c.addSurface(kCopperPipe),
                       true};
    const int x0 = kMargin, x1 = x0 + kWidth, z0 = kMargin, z1 = z0 + kDepth;
    c.box({x0, 0, z0}, {x1, kFloor, z1}, concrete);
    const WallFrames frames = wallFrames({x0, 0, z0}, {x1, 0, z1});
    for (const WallFrame* wall : {&frames.left, &frames.right, &frames.back})
        drawWall(c, *wall, kFloor, kCeiling + 6, walls);
    c.fill({x0 + 3, kFloor, z0 + 3}, {x1 - 3, kFloor + 1, z1},
           [&](ivec3 cell) { return PaletteBuilder::pick((cell.x / 5 + cell.z / 5) % 2 ? tile : tileDark, cell); });
    c.box({x0 + 3, kCeiling, z0 + 3}, {x1 - 3, kCeiling + 2, z1 - 3}, plaster);
    c.box({x0, kCeiling, z1 - 3}, {x1, kCeiling + 6, z1}, concrete);
    // Open front: two posts, a low sill of brick, panes at the sides.
    for (int x : {x0, x0 + 28, x1 - 31, x1 - 3}) c.box({x, kFloor, z1 - 3}, {x + 3, kCeiling, z1}, steel);
    for (int x : {x0 + 3, x1 - 28}) {
        c.box({x, kFloor, z1 - 3}, {x + 25, kFloor + 6, z1}, walls.stone);
        c.box({x, kFloor + 6, z1 - 2}, {x + 25, kCeiling, z1 - 1}, glass);
    }
    // A counter along the back with its shelves above.
    c.box({x0 + 6, kFloor + 1, z0 + 10}, {x1 - 6, kFloor + 10, z0 + 22}, wood);
    for (int y : {14, 20}) {
        c.box({x0 + 6, kFloor + y, z0 + 3}, {x1 - 6, kFloor + y + 1, z0 + 7}, wood);
        for (int x = x0 + 8; x < x1 - 8; x += 4)
            if (hashCell(x, y, 0, 161) % 4)
                c.box({x, kFloor + y + 1, z0 + 3}, {x + 2, kFloor + y + 3 + int(hashCell(x, y, 1, 161) % 3), z0 + 6},
                      goods);
    }
    drawShopLights(level, c, wire, wood);
    addShopFront(level, c);
    addStatic(level, c.finish("shop"), kShopLow - ivec3(kMargin, 0, kMargin));
}

Level lightShopLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {320, 0, 320};
    ground.areas = {area(Paving, 0, 176, 320, 214), area(Road, 0, 214, 320, 320)};
    Level level = makePlot("light shop", ground, seed);
    Environment& air = level.environment;
    air.sunDirection = {-0.6f, 0.5f, 0.35f};  // the moon
    air.sunColor = {0.10f, 0.13f, 0.19f};
    air.skyColor = {0.012f, 0.020f, 0.045f};
    air.horizonColor = {0.035f, 0.040f, 0.060f};
    air.groundColor = {0.01f, 0.01f, 0.012f};
    air.fogColor = {0.02f, 0.024f, 0.036f};
    air.exposure = 1.7f;
    addLightShop(level);
    addStreetLight(level, "street light", {84, 0, 206}, false);
    addDynamic(level, makeBench("bench"), {226, 0, 192});
    addDynamic(level, makeBin("bin"), {216, 0, 194});
    addDynamic(level, makePlantPot("plant"), {96, 0, 186});
    return level;
}

glm::dvec3 inShop(double x, double y, double z) {
    return (glm::dvec3(kShopLow - ivec3(kMargin, 0, kMargin)) + glm::dvec3(x, y, z)) * kVoxel;
}

Edits lightShopScript(int step, uint64_t) {
    ScriptClock clock(step);
    static constexpr int kOrder[kGlobes] = {1, 3, 0, 4, 2};
    for (int i = 0; i < kGlobes; ++i)
        if (clock.at(1.0 + 0.55 * i))
            clock.add(carveSphere(inShop(globeX(kOrder[i]) + 0.5, globeY(kOrder[i]) - 0.5, kMargin + 38.0),
                                  {0.28, 0.2, 0.0}));
    for (int i = 0; i < kCubes; ++i)
        if (clock.at(3.9 + 0.4 * i))
            clock.add(ExplodeEdit{inShop(cubeX(i) + 3.0, kFloor + 15.0, kMargin + 20.0), 0.5, 60.0});
    if (clock.at(5.6)) clock.add(ExplodeEdit{inShop(48, kCeiling + 12.0, kMargin + kDepth + 3.0), 1.3, 900.0});
    if (clock.at(6.3))
        clock.add(carveSphere((glm::dvec3(84, 0, 206) + glm::dvec3(0.5, 51.0, 13.0)) * kVoxel, {0.45, 0.45, 0.45}));
    return clock.take();
}

Pose lightShopCamera(double seconds) {
    return lookAt({12.0 + 0.08 * seconds, 2.2, 29.0}, {15.9, 2.7, 15.0});
}

}  // namespace

Scene lightShopScene() {
    Scene scene{"light_shop", "a light shop at night whose lights are shot out", lightShopLevel, lightShopScript,
                lightShopCamera};
    scene.steps = 450;
    return scene;
}

}  // namespace rubble::scenes
