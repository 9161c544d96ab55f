// A hall at night with one light of each kind, fog in the air, and a floodlight behind a cracked wall. The lights go
// out one by one; then the wall is blown open.
#include "runtime/core/random.h"
#include "samples/scenes/building.h"
#include "samples/scenes/environment.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/plot.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/script_clock.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

constexpr int kWidth = 136, kDepth = 74, kHeight = 36, kBehind = 40;
constexpr int kFloor = kFooting + 1, kCeiling = kFloor + kHeight, kBack = kBehind;  // in cells of the hall's grid
constexpr ivec3 kHall{90, -kFooting, 96};
constexpr int kMiddle = 66;  // x of the cracked part of the wall

constexpr ivec3 kGlobe{22, kCeiling - 10, kBack + 30};
constexpr ivec3 kTubes[] = {{44, kFloor + 4, kBack + 4}, {88, kFloor + 4, kBack + 4}};
constexpr int kTubeTall = 26;
constexpr ivec3 kPanel{24, kCeiling - 1, kBack + 46};  // low corner of the ceiling's panel, 24 x 12 cells
constexpr ivec3 kScreen{96, kFloor + 10, kBack + 3};   // low corner, 32 x 18 cells
constexpr glm::vec3 kCyan{0.12f, 0.85f, 1.0f}, kRose{1.0f, 0.16f, 0.42f};

/// The image on the screen: a sunset over hills, 16 x 9.
uint32_t screenColor(int x, int y) {
    static constexpr uint32_t kSky[] = {0x1c2a6a, 0x3a3f8c, 0x6b4a9a, 0xa8558c, 0xe0705c, 0xf79a48, 0xffc45a};
    static constexpr int kHills[] = {6, 6, 5, 5, 5, 6, 6, 7, 7, 6, 6, 5, 4, 5, 6, 6};
    const int dx = x - 9, dy = y - 4;
    if (y > kHills[x]) return 0x0c1a24;
    if (y == kHills[x]) return 0x17343c;
    return dx * dx + dy * dy <= 2 ? 0xfff2b0 : kSky[y];
}

LightImage sunsetImage() {
    LightImage image{16, {}};
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 16; ++x) image.texels.push_back(screenColor(x, y));
    return image;
}

Light& addTurned(Level& level, uint32_t group, LightKind kind, glm::dvec3 cell, glm::vec3 color, float reach,
                 float radius, glm::dquat rotation) {
    addLight(level, "hall", group, kind, cell, color, reach, radius);
    level.lights.back().light.local.rotation = rotation;
    return level.lights.back().light;
}

const glm::dquat kForward{0, 0, 1, 0};                    // points along +z
const glm::dquat kDownward{kSqrtHalf, -kSqrtHalf, 0, 0};  // points along -y
const glm::dquat kUpright{kSqrtHalf, 0, 0, kSqrtHalf};    // turns x to y

SurfaceStyle glow(uint32_t color, float emission) {
    return {"glass", {color}, 120, 0, 10, 255, 0, emission};
}

void addHallLights(Level& level, Canvas& c) {
    const Swatch wire = c.addSurface(kWire), steel = c.addSurface(kDarkSteel);
    const uint32_t globe = addLightGroup(level, "globe", 0.25f);
    const Swatch warm = c.addSurface(glow(0xffc890, 3.0f), 100, globe);
    c.box({kGlobe.x, kGlobe.y, kGlobe.z}, {kGlobe.x + 1, kCeiling, kGlobe.z + 1}, wire);
    c.fill(kGlobe - 3, kGlobe + 4, [&](ivec3 cell) {
        const ivec3 d = cell - kGlobe;
        return d.x * d.x + d.y * d.y + d.z * d.z <= 11 ? PaletteBuilder::pick(warm, cell) : c.at(cell);
    });
    addLight(level, "hall", globe, LightKind::Sphere, glm::dvec3(kGlobe) + 0.5, kWarmLight * 9.0f, 9.0f, 0.38f);

    const glm::vec3 colors[] = {kCyan, kRose};
    const uint32_t glows[] = {0x60e8ff, 0xff4a80};
    for (int i = 0; i < 2; ++i) {
        const uint32_t group = addLightGroup(level, "tube " + std::to_string(i), 0.2f);
        const ivec3 low = kTubes[i];
        c.box(low - ivec3(1, 1, 1), low + ivec3(2, 0, 2), steel);
        c.box(low, low + ivec3(1, kTubeTall, 1), c.addSurface(glow(glows[i], 6.0f), 100, group));
        c.box(low + ivec3(-1, kTubeTall, -1), low + ivec3(2, kTubeTall + 1, 2), steel);
        addTurned(level, group, LightKind::Capsule, glm::dvec3(low) + glm::dvec3(0.5, kTubeTall / 2.0, 0.5),
                  colors[i] * 4.5f, 8.0f, 0.06f, kUpright)
            .width = kTubeTall * float(kVoxel);
    }

    const uint32_t panel = addLightGroup(level, "panel", 0.2f);
    c.box(kPanel - ivec3(1, 0, 1), kPanel + ivec3(25, 1, 13), steel);
    c.box(kPanel, kPanel + ivec3(24, 1, 12), c.addSurface(glow(0xfff4e4, 2.4f), 100, panel));
    Light& ceiling = addTurned(level, panel, LightKind::Area, glm::dvec3(kPanel) + glm::dvec3(12, -0.1, 6),
                               glm::vec3(1.0f, 0.93f, 0.82f) * 6.0f, 9.0f, 0.1f, kDownward);
    ceiling.width = 2.4f;
    ceiling.height = 1.2f;
}

void addScreen(Level& level, Canvas& c) {
    const uint32_t group = addLightGroup(level, "screen", 0.15f);
    const Swatch frame = c.addSurface(kPlasticBlack);
    c.box(kScreen - ivec3(1, 1, 0), kScreen + ivec3(33, 19, 2), frame);
    std::vector<std::pair<uint32_t, Swatch>> paints;
    const auto paint = [&](uint32_t color) {
        for (const auto& [known, swatch] : paints)
            if (known == color) return swatch;
        return paints.emplace_back(color, c.addSurface(glow(color, 2.6f), 100, group)).second;
    };
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 16; ++x) {
            const ivec3 low = kScreen + ivec3(2 * x, 16 - 2 * y, 2);
            c.box(low, low + ivec3(2, 2, 1), paint(screenColor(x, y)));
        }
    Light& light = addTurned(level, group, LightKind::Screen, glm::dvec3(kScreen) + glm::dvec3(16, 9, 3.1),
                             glm::vec3(15.0f), 9.0f, 0.1f, kForward);
    light.width = 3.2f;
    light.height = 1.8f;
    light.image = sunsetImage();
}

/// Cracks: each runs upward with random turns, and is wider or forks in places.
void crackWall(Canvas& c) {
    for (int crack = 0; crack < 7; ++crack) {
        int x = kMiddle - 15 + crack * 5;
        for (int y = kFloor + 3 + int(hashCell(crack, 0, 0, 301) % 5);
             y < kCeiling - 3 - int(hashCell(crack, 1, 0, 301) % 6); ++y) {
            const uint32_t dice = hashCell(crack, y, 2, 301);
            x += int(dice % 3) - 1;
            const int wide = 1 + int(dice >> 8 & 7) / 6;
            if ((dice >> 12 & 15) > 1) c.clear({x, y, kBack}, {x + wide, y + 1, kBack + 3});
            if ((dice >> 20 & 7) == 0) c.clear({x - 3, y, kBack}, {x + 4, y + 1, kBack + 3});
        }
    }
    c.fill({kMiddle - 8, kFloor + 14, kBack}, {kMiddle + 8, kFloor + 26, kBack + 3}, [&](ivec3 cell) {
        const int dx = cell.x - kMiddle, dy = cell.y - kFloor - 20,
                  jitter = int(hashCell(cell.x / 2, cell.y, 0, 302) % 12);
        return dx * dx + dy * dy * 2 < 16 + jitter ? uint8_t(0) : c.at(cell);
    });
}

void addFlood(Level& level, Canvas& c) {
    const uint32_t group = addLightGroup(level, "flood", 0.2f);
    const Swatch steel = c.addSurface(kDarkSteel), bright = c.addSurface(glow(0xfff0d0, 20.0f), 100, group);
    const ivec3 low{kMiddle - 4, kFloor + 18, 6};
    c.box({kMiddle - 1, 0, 6}, {kMiddle + 1, low.y, 8}, steel);
    c.box(low - ivec3(1, 1, 2), low + ivec3(9, 7, 1), steel);
    c.box(low + ivec3(0, 0, 1), low + ivec3(8, 6, 2), bright);
    Light& light = addTurned(level, group, LightKind::Cone, glm::dvec3(low) + glm::dvec3(4, 3, 2.2),
                             glm::vec3(1.0f, 0.86f, 0.62f) * 200.0f, 22.0f, 0.2f, kForward);
    light.coneInner = 0.55f;
    light.coneOuter = 0.8f;
}

void addHall(Level& level) {
    Canvas c({kWidth + 4, kCeiling + 4, kBack + kDepth + 4});
    const Swatch concrete = c.addSurface(kConcrete), dark = c.addSurface(kConcreteDark),
                 plaster = c.addSurface(kPlaster, 80), brick = c.addSurface(kBrick), joint = c.addSurface(kBrickJoint),
                 steel = c.addSurface(kSteel);
    // The smooth floor mirrors the lights.
    const Swatch polished = c.addSurface({"concrete", {0x55565a, 0x5c5d60, 0x4e4f53}, 90, 0, 40, 255, 4});
    c.box({0, 0, 0}, {kWidth, kFooting, kBack + kDepth}, dark);
    c.box({0, kFooting, kBack}, {kWidth, kFloor, kBack + kDepth}, polished);
    c.fill({0, kFloor, kBack}, {kWidth, kCeiling, kBack + 3}, [&](ivec3 cell) {
        const int shifted = cell.x + cell.y % 2 * 2;
        return PaletteBuilder::pickFor(shifted % 4 == 0 ? joint : brick, hashCell(shifted / 4, cell.y, 0, 42) >> 8);
    });
    c.box({0, kFloor, kBack}, {3, kCeiling, kBack + kDepth}, plaster);
    c.box({kWidth - 3, kFloor, kBack}, {kWidth, kCeiling, kBack + kDepth}, plaster);
    c.box({0, kCeiling, kBack}, {kWidth, kCeiling + 3, kBack + kDepth}, concrete);
    for (int x = 18; x < kWidth; x += 33) c.box({x, kCeiling - 3, kBack + 3}, {x + 2, kCeiling, kBack + kDepth}, steel);
    crackWall(c);
    addHallLights(level, c);
    addScreen(level, c);
    addFlood(level, c);
    addStatic(level, c.finish("hall"), kHall);
}

ivec3 onFloor(int x, int z) {
    return kHall + ivec3(x, kFloor, z);
}

Level lightsLevel(uint64_t seed) {
    GroundPlan ground;
    using enum GroundPlan::Surface;
    ground.size = {320, 0, 320};
    ground.areas = {area(Paving, 0, 90, 320, 320)};
    Level level = makePlot("lights", ground, seed);
    level.environment = night();
    level.environment.fogDensity = 0.035f;
    level.environment.fogHeight = 40.0f;
    level.environment.fogForward = 0.55f;
    level.environment.exposure = 1.5f;
    addHall(level);
    addDynamic(level, makeTable("table"), onFloor(28, kBack + 48));
    addDynamic(level, makeCrate("crate 1"), onFloor(60, kBack + 34));
    addDynamic(level, makeCrate("crate 2"), onFloor(69, kBack + 38));
    addDynamic(level, makeCrate("crate 3"), onFloor(62, kBack + 34) + ivec3(0, 8, 0));
    addDynamic(level, makeBarrel("barrel 1", kCarBlue), onFloor(86, kBack + 30));
    addDynamic(level, makeSofa("sofa", kClothTeal), onFloor(100, kBack + 34));
    addDynamic(level, makePlantPot("plant"), onFloor(10, kBack + 14));
    return level;
}

glm::dvec3 inHall(glm::dvec3 cell) {
    return (glm::dvec3(kHall) + cell) * kVoxel;
}

Edits lightsScript(int step, uint64_t) {
    ScriptClock clock(step);
    if (clock.at(2.2)) clock.add(carveSphere(inHall(glm::dvec3(kGlobe) + 0.5), {0.3, 0.2, 0.0}));
    for (int i = 0; i < 2; ++i)
        if (clock.at(2.8 + 0.5 * i))
            clock.add(carveSphere(inHall(glm::dvec3(kTubes[i]) + glm::dvec3(0.5, 12.0, 0.5)), {0.45, 0.2, 0.0}));
    if (clock.at(3.9)) clock.add(ExplodeEdit{inHall(glm::dvec3(kPanel) + glm::dvec3(12, -2, 6)), 0.8, 120.0});
    if (clock.at(4.5)) clock.add(carveSphere(inHall(glm::dvec3(kScreen) + glm::dvec3(14, 9, 3)), {0.7, 0.3, 0.0}));
    if (clock.at(5.2)) clock.add(ExplodeEdit{inHall(glm::dvec3(kMiddle, kFloor + 14, kBack + 1)), 2.0, 700.0});
    if (clock.at(7.2)) clock.add(carveSphere(inHall(glm::dvec3(kMiddle, kFloor + 21, 8)), {0.6, 0.5, 0.4}));
    return clock.take();
}

Pose lightsCamera(double seconds) {
    return lookAt({15.0 + 0.05 * seconds, 1.9, 23.8}, {15.5, 1.95, 13.6});
}

}  // namespace

Scene lightsScene() {
    Scene scene{"lights", "a ball, tubes, a cone, a panel and a screen of light in mist, put out one after the other",
                lightsLevel, lightsScript, lightsCamera};
    scene.steps = 480;
    scene.verticalFov = 0.9f;
    return scene;
}

}  // namespace rubble::scenes
