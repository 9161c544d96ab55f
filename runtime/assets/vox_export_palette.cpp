#include "runtime/assets/vox_export_palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/assets/vox_palette.h"
#include "runtime/voxel/used_entries.h"

namespace rubble {
namespace {

/// Light groups are found again by what glows.
PaletteEntry withoutGroup(PaletteEntry entry) {
    entry.lightGroup = 0;
    return entry;
}

int distance(const PaletteEntry& a, const PaletteEntry& b) {
    const int red = a.red - b.red, green = a.green - b.green, blue = a.blue - b.blue;
    return red * red + green * green + blue * blue + (a.material == b.material ? 0 : 1 << 16);
}

/// Entries of several palettes in one.
class Merger {
public:
    explicit Merger(const Palette& first) {
        for (size_t i = 1; i < 256; ++i) entries[i] = withoutGroup(first[i]);
    }
    /// The place of a shape's entry.
    uint8_t place(size_t index, const PaletteEntry& given) {
        const PaletteEntry entry = withoutGroup(given);
        if (entries[index] == entry) return take(index);
        for (size_t i = 1; i < 256; ++i)
            if (taken[i] && entries[i] == entry) return uint8_t(i);
        for (size_t n = 0; n < 255; ++n) {
            const size_t i = (index + n - 1) % 255 + 1;
            if (taken[i]) continue;
            entries[i] = entry;
            return take(i);
        }
        ++merged;
        const auto nearest = std::min_element(
            entries.begin() + 1, entries.end(),
            [&](const PaletteEntry& a, const PaletteEntry& b) { return distance(a, entry) < distance(b, entry); });
        return uint8_t(nearest - entries.begin());
    }
    Palette entries;
    std::array<bool, 256> taken{};
    int merged = 0;  ///< entries that found no place of their own

private:
    uint8_t take(size_t index) {
        taken[index] = true;
        return uint8_t(index);
    }
};

std::string fraction(uint8_t value) {
    return fmt::format("{}", float(value) / 255.0f);
}

/// The attributes of a MATL chunk that voxPalette() turns into this look, as nearly as they can.
VoxAttributes describeLook(const PaletteEntry& entry) {
    const PaletteEntry plain;
    VoxAttributes out;
    if (entry.emission > 0.0f) {
        const float power = std::clamp(std::ceil(entry.emission / kVoxEmissionScale) - 1.0f, 0.0f, 4.0f);
        const float full = kVoxEmissionScale * (1.0f + power);
        out = {{"_type", "_emit"}, {"_flux", fmt::format("{}", power)}};
        float share = std::min(entry.emission / full, 1.0f);
        for (const float other : {std::nextafter(share, 0.0f), std::nextafter(share, 1.0f)})
            if (kVoxEmissionScale * other * (1.0f + power) == entry.emission) share = other;
        out["_emit"] = out["_weight"] = fmt::format("{}", share);
    } else if (entry.opacity == 255 && entry.reflectivity == plain.reflectivity) {
        if (entry.roughness == plain.roughness && entry.metallic == 0) return out;
        out = {{"_type", "_metal"}, {"_metal", fraction(entry.metallic)}, {"_weight", fraction(entry.metallic)}};
    } else {
        const float fresnel = std::sqrt(float(entry.reflectivity) / 255.0f);
        const std::string clear = fraction(uint8_t(255 - entry.opacity));
        out = {{"_type", entry.metallic ? "_blend" : "_glass"}, {"_alpha", clear}, {"_trans", clear}};
        out["_ior"] = fmt::format("{}", std::min(2.0f, (1.0f + fresnel) / (1.0f - fresnel) - 1.0f));
        out["_weight"] = entry.metallic ? fraction(entry.metallic) : clear;
        if (entry.metallic) out["_metal"] = fraction(entry.metallic);
    }
    out["_rough"] = fraction(entry.roughness);
    return out;
}

bool looksAlike(const PaletteEntry& a, const PaletteEntry& b) {
    return a.opacity == b.opacity && a.roughness == b.roughness && a.metallic == b.metallic &&
           a.reflectivity == b.reflectivity && a.emission == b.emission;
}

/// Describes all entries, and names the materials that the import would not guess.
void describe(VoxExportPalette& out, const std::array<bool, 256>& used, const MaterialTable& materials) {
    VoxFile file;
    for (int i = 1; i < 256; ++i) {
        const PaletteEntry& entry = out.entries[size_t(i)];
        file.colors[size_t(i)] = {entry.red, entry.green, entry.blue, 255};
        if (VoxAttributes look = describeLook(entry); !look.empty()) file.materials[i] = std::move(look);
    }
    const Palette guessed = voxPalette(file, used, false);
    int looks = 0;
    for (int i = 1; i < 256; ++i) {
        if (!used[size_t(i)]) continue;
        const PaletteEntry &entry = out.entries[size_t(i)], &again = guessed[size_t(i)];
        looks += !looksAlike(entry, again);
        if (again.material == entry.material) continue;
        const std::string& name = materials[entry.material].name;
        file.materials[i][kVoxMaterialKey] = name;
        if (!defaultMaterials().find(name))
            out.lost.push_back(fmt::format("colour {}: the material '{}' of this level", i, name));
    }
    if (looks) out.lost.push_back(fmt::format("{} colours: looks that such files have no attributes for", looks));
    out.materials = std::move(file.materials);
}

}  // namespace

VoxExportPalette voxExportPalette(const std::vector<const LevelShape*>& shapes, const MaterialTable& materials) {
    VoxExportPalette out;
    if (shapes.empty()) return out;
    Merger merger(*shapes[0]->palette);
    for (const LevelShape* shape : shapes) {
        std::array<uint8_t, 256>& slots = out.slots.emplace_back();
        usedEntries(shape->grid).forEach([&](size_t i) { slots[i] = merger.place(i, (*shape->palette)[i]); });
    }
    out.entries = merger.entries;
    if (merger.merged)
        out.lost.push_back(fmt::format("{} colours beyond 255: the nearest ones stand for them", merger.merged));
    describe(out, merger.taken, materials);
    return out;
}

}  // namespace rubble
