#include <cmath>

#include "runtime/core/random.h"
#include "tests/golden/lit_scene.h"

namespace rubble {
namespace {

enum Entry : uint8_t {
    Asphalt = 1,
    AsphaltWorn,
    Kerb,
    Paving,
    PavingDark,
    Grass,
    GrassLight,
    Plaster,
    PlasterDirty,
    Timber,
    TimberDark,
    Glass,
    Paint,
    Tyre,
    Chrome,
    Steel,
    Bulb,
    Concrete,
    ConcreteDark,
    Bark,
    Leaf,
    LeafLight,
    Roof,
    RoofDark,
    LightGlow,
    White,
    Count
};

PaletteEntry color(uint32_t rgb, uint8_t roughness = 230, uint8_t reflectivity = 10) {
    PaletteEntry e;
    e.red = uint8_t(rgb >> 16), e.green = uint8_t(rgb >> 8), e.blue = uint8_t(rgb);
    e.roughness = roughness, e.reflectivity = reflectivity, e.material = 1;
    return e;
}

/// Noise of a cell in [0, 1).
double grain(glm::ivec3 c) {
    uint32_t h = uint32_t(c.x) * 0x8da6b343u ^ uint32_t(c.y) * 0xd8163841u ^ uint32_t(c.z) * 0xcb1ab31fu;
    h ^= h >> 13, h *= 0x5bd1e995u, h ^= h >> 15;
    return double(h & 0xffff) / 65536.0;
}

uint8_t groundAt(glm::ivec3 c) {
    const int road = 90, kerb = 93, pavement = 115;  // along z
    if (c.z < road) return c.y < 3 ? (grain(c / glm::ivec3(3, 1, 3)) < 0.8 ? Asphalt : AsphaltWorn) : 0;
    if (c.z < kerb) return Kerb;
    if (c.z < pavement) return c.y > 3 ? 0 : (c.x % 8 == 0 || c.z % 8 == 4 ? PavingDark : Paving);
    return c.y > 3 ? 0 : grain(c) < 0.6 ? Grass : GrassLight;
}

uint8_t roomAt(glm::ivec3 c) {
    const glm::ivec3 size(56, 30, 44);
    const bool wall = c.x < 2 || c.z < 2 || c.x >= size.x - 2 || c.z >= size.z - 2;
    if (c.y < 1) return c.x % 4 == 0 ? TimberDark : Timber;
    if (c.y >= 27) return c.y == 29 ? (c.x + c.z / 3 * 5) % 9 < 1 ? RoofDark : Roof : c.y < 29 ? Timber : 0;
    // The front wall (low z) has a window and a hole, the sunny wall (low x) a door.
    if (c.z < 2 && c.x > 8 && c.x < 24 && c.y > 8 && c.y < 20) {
        const bool frame = c.x == 9 || c.x == 23 || c.y == 9 || c.y == 19 || c.x == 16;
        return frame ? Timber : c.z == 1 ? Glass : 0;
    }
    const double dx = c.x - 41.0, dy = c.y - 12.0;
    if (c.z < 2 && dx * dx * 0.7 + dy * dy < 52.0 + 30.0 * grain({c.x / 2, c.y / 2, 7})) return 0;
    if (c.x < 2 && c.z > 14 && c.z < 24 && c.y < 21) return 0;
    if (wall) return c.y < 3 + 3 * grain({c.x / 2, 0, c.z / 2}) ? PlasterDirty : Plaster;
    // A table and a shelf.
    if (c.x > 30 && c.x < 46 && c.z > 14 && c.z < 24) {
        if (c.y == 8) return Timber;
        if (c.y < 8 && (c.x == 31 || c.x == 45) && (c.z == 15 || c.z == 23)) return TimberDark;
    }
    if (c.z >= size.z - 5 && c.x > 10 && c.x < 24 && (c.y % 6 == 5 || c.x == 11 || c.x == 23) && c.y < 20)
        return TimberDark;
    return 0;
}

uint8_t carAt(glm::ivec3 c) {
    const bool wheel = (c.y < 5) && (c.z < 3 || c.z > 14);
    for (int axle : {8, 32})
        if (wheel && (c.x - axle) * (c.x - axle) + (c.y - 3) * (c.y - 3) <= 10)
            return (c.x - axle) * (c.x - axle) + (c.y - 3) * (c.y - 3) <= 2 ? Chrome : Tyre;
    if (c.y < 3) return 0;
    if (c.y < 9) return c.z > 0 && c.z < 17 ? (c.y == 4 && (c.x == 0 || c.x == 41) ? Chrome : Paint) : 0;
    const int lean = c.y - 9;
    const bool cabin = c.x > 10 + lean && c.x < 36 - lean / 2 && c.z > 1 && c.z < 16;
    if (!cabin || c.y > 14) return 0;
    if (c.y == 14) return Paint;
    const bool edge = c.x <= 11 + lean || c.x >= 35 - lean / 2 || c.z == 2 || c.z == 15;
    return edge ? (c.x == 22 ? Paint : Glass) : 0;
}

uint8_t streetLightAt(glm::ivec3 c) {
    if (c.x >= 2 && c.x <= 3 && c.z >= 2 && c.z <= 3 && c.y < 40) return Steel;
    if (c.y == 40 || c.y == 41)
        return c.y == 40 && c.x > 0 && c.x < 5 && c.z > 0 && c.z < 5 ? LightGlow : c.y == 41 ? Steel : 0;
    return 0;
}

uint8_t treeAt(glm::ivec3 c) {
    const double x = c.x - 20, z = c.z - 20;
    if (c.y < 26 && x * x + z * z < 5) return Bark;
    const double r = std::sqrt(x * x + z * z + (c.y - 34.0) * (c.y - 34.0) * 1.3);
    if (r > 19.5 || grain(c / 3) < 0.42 + 0.3 * (r < 8) || grain(c) < 0.25) return 0;
    return grain(c) < 0.6 ? Leaf : LeafLight;
}

}  // namespace

PaletteRef streetPalette() {
    auto p = std::make_shared<Palette>();
    (*p)[Asphalt] = color(0x3b3d40), (*p)[AsphaltWorn] = color(0x45474a), (*p)[Kerb] = color(0x9a978f);
    (*p)[Paving] = color(0x8f8d86), (*p)[PavingDark] = color(0x77746c), (*p)[Grass] = color(0x5d7a3a),
    (*p)[GrassLight] = color(0x6d8a45);
    (*p)[Plaster] = color(0xd9cfbd), (*p)[PlasterDirty] = color(0xc0b39c), (*p)[Timber] = color(0x8b6845),
    (*p)[TimberDark] = color(0x6b4c31);
    (*p)[Glass] = color(0xdfeeee, 10), (*p)[Glass].opacity = 60;
    (*p)[Paint] = color(0xb23a2e, 40, 14), (*p)[Tyre] = color(0x26262a), (*p)[Chrome] = color(0xb0b4b8, 50, 120),
    (*p)[Chrome].metallic = 255;
    (*p)[Steel] = color(0x6f7780, 110, 120), (*p)[Steel].metallic = 200;
    (*p)[Concrete] = color(0x8f8d86), (*p)[ConcreteDark] = color(0x7d7a72), (*p)[Bark] = color(0x5b4630),
    (*p)[Leaf] = color(0x4e7a36);
    (*p)[LeafLight] = color(0x6b9440), (*p)[Roof] = color(0x5a4a45), (*p)[RoofDark] = color(0x4d4f57),
    (*p)[White] = color(0xffffff);
    (*p)[LightGlow] = color(0xffd9a0), (*p)[LightGlow].emission = 8.0f;
    return p;
}

LitScene streetScene() {
    LitScene scene(streetPalette());
    const double elevation = 20.0 * 0.01745329, azimuth = 35.0 * 0.01745329;  // from the left, a little from the front
    scene.environment.sunDirection = {float(-std::cos(elevation) * std::cos(azimuth)), float(std::sin(elevation)),
                                      float(-std::cos(elevation) * std::sin(azimuth))};
    scene.environment.sunColor = {11.5f, 8.7f, 5.7f};
    scene.environment.skyColor = {0.24f, 0.42f, 0.80f};
    scene.environment.horizonColor = {0.74f, 0.64f, 0.52f};
    scene.environment.fogColor = {0.46f, 0.50f, 0.56f};
    const glm::dquat level(1, 0, 0, 0);
    scene.add({240, 5, 240}, {{-12.0, -0.4, -12.0}, level}, groundAt);
    scene.add({56, 30, 44}, {{-2.0, 0.0, 1.0}, level}, roomAt);
    scene.add({42, 15, 18}, {{-5.0, -0.1, -5.4}, level}, carAt);
    scene.add({6, 42, 6}, {{-4.0, 0.0, -1.4}, level}, streetLightAt);
    scene.add({40, 60, 40}, {{-7.0, 0.0, 2.0}, level}, treeAt);
    const glm::dquat tilt = glm::normalize(glm::dquat(0.86, 0.21, 0.37, 0.28));
    scene.add({8, 8, 8}, {{1.2, 0.35, -3.6}, tilt},
              [](glm::ivec3 c) { return uint8_t(grain(c) < 0.5 ? Concrete : ConcreteDark); });
    SnapshotLight streetLight{LightKind::Cone,
                              {-3.7, 3.85, -1.1},
                              {0, -1, 0},
                              glm::vec3(1.0f, 0.72f, 0.43f) * 14.0f,
                              0.12f,
                              9.0f,
                              0.6f,
                              1.1f};
    scene.addLight(streetLight);
    return scene;
}

Camera streetCamera(int which) {
    Camera camera;
    camera.verticalFov = 1.0f;
    camera.position = which == 0   ? glm::dvec3(-3.0, 2.2, -11.0)
                      : which == 1 ? glm::dvec3(0.2, 1.6, -3.2)
                      : which == 2 ? glm::dvec3(1.0, 1.7, 4.6)
                                   : glm::dvec3(-11, 8, -11);
    camera.lookAt(which == 0   ? glm::dvec3(0.0, 1.5, 1.0)
                  : which == 1 ? glm::dvec3(2.6, 1.2, 2.0)
                  : which == 2 ? glm::dvec3(2.6, 1.0, 1.0)
                               : glm::dvec3(0, 0.5, 0));
    return camera;
}

}  // namespace rubble
