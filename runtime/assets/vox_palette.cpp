#include "runtime/assets/vox_palette.h"

#include <algorithm>
#include <locale>
#include <sstream>

#include "runtime/voxel/material.h"

namespace rubble {
namespace {

constexpr uint8_t kMinOpacity = 26;  // of 255: clear glass stays visible

/// An attribute as a number in [low, high]; `fallback` if it is missing or no number.
float number(const VoxAttributes& attributes, const char* key, float fallback, float low, float high) {
    const auto found = attributes.find(key);
    if (found == attributes.end()) return fallback;
    std::istringstream in(found->second);
    in.imbue(std::locale::classic());  // numbers have points, whatever the host's language
    float value = 0;
    return in >> value ? std::clamp(value, low, high) : fallback;
}

uint8_t toByte(float fraction) {
    return uint8_t(fraction * 255.0f + 0.5f);
}

/// Sets the optical properties that a MATL chunk gives. Old files have one `_weight` for the property that `_type`
/// names, newer files have an attribute for each property. Reflectivity is that of Fresnel at normal incidence: ((n -
/// 1) / (n + 1))^2.
void applyMaterial(const VoxAttributes& attributes, PaletteEntry& entry) {
    const auto found = attributes.find("_type");
    const std::string type = found == attributes.end() ? "" : found->second;
    if (type.empty() || type == "_diffuse") return;
    const float weight = number(attributes, "_weight", 1.0f, 0.0f, 1.0f);
    entry.roughness = toByte(number(attributes, "_rough", 0.1f, 0.0f, 1.0f));
    if (type == "_metal" || type == "_blend") {
        const bool plastic = number(attributes, "_plastic", 0.0f, 0.0f, 1.0f) > 0.5f;
        entry.metallic =
            plastic ? uint8_t(0) : toByte(number(attributes, "_metal", type == "_metal" ? weight : 0.0f, 0.0f, 1.0f));
    }
    if (type == "_glass" || type == "_blend" || type == "_media" || type == "_cloud") {
        const float alpha = number(attributes, "_alpha", type == "_blend" ? 0.0f : weight, 0.0f, 1.0f);
        const float transparency = number(attributes, "_trans", alpha, 0.0f, 1.0f);
        entry.opacity = std::max(kMinOpacity, toByte(1.0f - transparency));
        const float index = 1.0f + number(attributes, "_ior", 0.5f, 0.0f, 2.0f);
        const float fresnel = (index - 1.0f) / (index + 1.0f);
        entry.reflectivity = toByte(fresnel * fresnel);
    }
    if (type == "_emit") {
        const float power = number(attributes, "_flux", 0.0f, 0.0f, 4.0f);
        entry.emission = kVoxEmissionScale * number(attributes, "_emit", weight, 0.0f, 1.0f) * (1.0f + power);
    }
}

/// The material that an entry's attributes name; 0: none of ours.
uint8_t namedMaterial(const VoxAttributes& attributes) {
    const auto found = attributes.find(kVoxMaterialKey);
    return found == attributes.end() ? uint8_t(0) : defaultMaterials().find(found->second);
}

}  // namespace

std::array<uint8_t, 256> voxPaletteSlots(const VoxFile& file) {
    std::array<uint8_t, 256> slots{};
    for (size_t i = 1; i < 256; ++i) slots[file.indexMap ? (*file.indexMap)[i - 1] : i] = uint8_t(i);
    slots[0] = 0;
    return slots;
}

Palette voxPalette(const VoxFile& file, const std::array<bool, 256>& used, bool teardownPalette) {
    Palette palette;
    const std::array<uint8_t, 256> slots = voxPaletteSlots(file);
    for (size_t stored = 1; stored < 256; ++stored) {
        const uint8_t slot = slots[stored];
        if (slot == 0) continue;
        PaletteEntry& entry = palette[slot];
        entry.red = file.colors[stored][0];
        entry.green = file.colors[stored][1];
        entry.blue = file.colors[stored][2];
        const auto material = file.materials.find(int32_t(stored));
        const bool isDescribed = material != file.materials.end();
        if (isDescribed) applyMaterial(material->second, entry);
        if (!used[slot]) continue;
        if (isDescribed) entry.material = namedMaterial(material->second);
        if (!entry.material) entry.material = teardownPalette ? teardownMaterial(slot) : guessMaterial(entry);
    }
    return palette;
}

uint8_t guessMaterial(const PaletteEntry& entry) {
    const MaterialTable& table = defaultMaterials();
    if (entry.opacity < 230) return table.find("glass");
    if (entry.metallic >= 128) return table.find("metal");
    const int red = entry.red, green = entry.green, blue = entry.blue;
    const int value = std::max({red, green, blue}), chroma = value - std::min({red, green, blue});
    if (entry.emission > 0.0f) return table.find(value > 160 ? "glass" : "plastic");
    if (value < 36) return table.find("plastic");
    if (chroma * 100 < value * 16) return table.find(value > 215 ? "plaster" : "concrete");
    // Hue in degrees, red 0, green 120, blue 240.
    const int hue = value == red     ? (60 * (green - blue) / chroma + 360) % 360
                    : value == green ? 120 + 60 * (blue - red) / chroma
                                     : 240 + 60 * (red - green) / chroma;
    const bool vivid = chroma * 100 > value * 75 && value > 190;
    if (hue >= 65 && hue < 170) return table.find(vivid && hue > 150 ? "plastic" : "foliage");
    if (vivid || (hue >= 170 && hue < 335)) return table.find("plastic");
    if (hue < 17 || hue >= 335) return table.find("brick");
    if (hue < 50) return table.find("wood");
    return table.find(value < 120 ? "dirt" : "wood");
}

}  // namespace rubble
