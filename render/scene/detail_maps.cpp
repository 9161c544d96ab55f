#include "render/scene/detail_maps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/core/random.h"
#include "runtime/voxel/material.h"

namespace rubble {
namespace {

/// How the faces of a material vary. All numbers but `streak` are shares of 1.
struct Grain {
    const char* material;
    float speckle;       ///< colour variation from voxel to voxel
    float blotch;        ///< colour variation over patches of several voxels
    float tilt;          ///< of faces, as a share of kMaxTilt
    float roughness;     ///< variation of roughness
    int streak = 1;      ///< voxels along the map's first axis that share their speckle: grain of wood, brushed metal
    float pores = 0.0f;  ///< share of voxels that are dark pores
};
constexpr Grain kGrains[] = {
    {"brick", 0.10f, 0.10f, 0.45f, 0.10f},
    {"wood", 0.12f, 0.05f, 0.22f, 0.14f, 9},
    {"concrete", 0.05f, 0.12f, 0.25f, 0.08f, 1, 0.05f},
    {"plaster", 0.025f, 0.06f, 0.22f, 0.04f},
    {"metal", 0.03f, 0.04f, 0.0f, 0.20f, 12},
    {"foliage", 0.14f, 0.16f, 0.95f, 0.06f},
    {"dirt", 0.14f, 0.14f, 0.80f, 0.05f},
    {"rock", 0.08f, 0.12f, 0.65f, 0.08f},
    {"hard masonry", 0.05f, 0.10f, 0.30f, 0.08f, 1, 0.03f},
    {"snow", 0.02f, 0.04f, 0.35f, 0.04f},
};

/// A random number in [-1, 1) for a texel of a map; `which` tells several apart.
float randomAt(int x, int y, int which, int map) {
    return float(hashCell(x, y, map, 900 + which) >> 8) * 0x1p-23f - 1.0f;
}

/// Tileable value noise with this many cells along a side, in [-1, 1).
float valueNoise(int x, int y, int cells, int which, int map) {
    const int step = DetailMaps::kSide / cells;
    const auto smooth = [](float t) { return t * t * (3.0f - 2.0f * t); };
    const float fx = smooth(float(x % step) / float(step)), fy = smooth(float(y % step) / float(step));
    const auto at = [&](int dx, int dy) {
        return randomAt((x / step + dx) % cells, (y / step + dy) % cells, which, map);
    };
    const float low = at(0, 0) + (at(1, 0) - at(0, 0)) * fx, high = at(0, 1) + (at(1, 1) - at(0, 1)) * fx;
    return low + (high - low) * fy;
}

/// From [-1, 1] to a byte around 128.
uint8_t byteOf(float value) {
    return uint8_t(std::clamp(128.0f + 127.0f * value, 0.0f, 255.0f));
}

std::array<uint8_t, 4> texelOf(const Grain& grain, int map, int x, int y) {
    // In each row the streaks begin at another place.
    const int shifted = (x + int(hashCell(y, map, 0, 910) % uint32_t(DetailMaps::kSide))) % DetailMaps::kSide;
    const float own = randomAt(grain.streak > 1 ? shifted / grain.streak : x, y, 0, map);
    const float patch = 0.6f * valueNoise(x, y, 4, 1, map) + 0.4f * valueNoise(x, y, 8, 2, map);
    const bool pore = randomAt(x, y, 3, map) < 2.0f * grain.pores - 1.0f;
    const float color = 2.0f * (grain.speckle * own + grain.blotch * patch) - (pore ? 0.30f : 0.0f);
    return {byteOf(color), byteOf(2.0f * grain.roughness * (0.6f * own + 0.4f * patch)),
            byteOf(grain.tilt * randomAt(x, y, 4, map)), byteOf(grain.tilt * randomAt(x, y, 5, map))};
}

}  // namespace

std::array<uint8_t, 256> DetailMaps::mapsOf(std::span<const std::string> materials) {
    if (materials.empty()) {
        std::vector<std::string> names;
        for (const Material& each : defaultMaterials().materials) names.push_back(each.name);
        return mapsOf(names);
    }
    std::array<uint8_t, 256> maps{};
    for (size_t i = 0; i < std::min(materials.size(), maps.size()); ++i) {
        const auto grain = std::find_if(std::begin(kGrains), std::end(kGrains),
                                        [&](const Grain& each) { return materials[i] == each.material; });
        if (grain != std::end(kGrains)) maps[i] = uint8_t(grain - std::begin(kGrains) + 1);
    }
    return maps;
}

int DetailMaps::count() {
    return int(std::size(kGrains));
}

std::vector<uint8_t> DetailMaps::make() {
    std::vector<uint8_t> texels;
    texels.reserve(size_t(count() * kSide * kSide * 4));
    for (int map = 0; map < count(); ++map)
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x)
                for (const uint8_t channel : texelOf(kGrains[map], map, x, y)) texels.push_back(channel);
    return texels;
}

Texture DetailMaps::none() {
    return Texture::none(GL_RGBA8, {kSide, kSide * count()});
}

DetailMaps::DetailMaps() : m_texture(GL_RGBA8, {kSide, kSide * count()}) {
    m_texture.upload(make().data());
}

}  // namespace rubble
