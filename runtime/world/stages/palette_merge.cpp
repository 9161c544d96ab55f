#include "runtime/world/stages/palette_merge.h"

#include <algorithm>

#include "runtime/voxel/equal_entries.h"

namespace rubble {

namespace {

/// The entry that is missed least: one without a voxel and a material, or that equals another one, or any without a
/// voxel. The palette's size if there is none.
size_t findPlace(const Palette& palette, const UsedEntries& used) {
    const auto first = [&](auto&& isFree) {
        size_t place = 1;
        while (place < palette.size() && (used.contains(place) || !isFree(place))) ++place;
        return place;
    };
    if (const size_t place = first([&](size_t i) { return palette[i].material == 0; }); place < palette.size())
        return place;
    if (const size_t place = first([&](size_t i) { return equalsEarlierEntry(palette, i); }); place < palette.size())
        return place;
    return first([](size_t) { return true; });
}

}  // namespace

std::optional<std::array<uint8_t, 256>> mergePalette(Palette& into, UsedEntries usedInto, const Palette& from,
                                                     const UsedEntries& usedFrom) {
    std::array<uint8_t, 256> map{};
    bool fits = true;
    usedFrom.forEach([&](size_t i) {
        size_t place = into[i] == from[i] ? i : size_t(std::find(into.begin() + 1, into.end(), from[i]) - into.begin());
        if (place == into.size()) place = findPlace(into, usedInto);
        fits = fits && place < into.size();
        if (!fits) return;
        into[place] = from[i];
        usedInto.insert(place);
        map[i] = uint8_t(place);
    });
    if (!fits) return std::nullopt;
    return map;
}

std::array<uint8_t, 16> mergePaintColors(PaintColors& into, const PaintColors& from) {
    std::array<uint8_t, 16> map{};
    for (size_t i = 0; i < from.count; ++i) {
        const auto known = into.colors.begin() + into.count;
        auto place = std::min_element(into.colors.begin(), known, [&](const Srgb& a, const Srgb& b) {
            return distanceSquared(a, from.colors[i]) < distanceSquared(b, from.colors[i]);
        });
        if ((place == known || *place != from.colors[i]) && into.count < kPaintColors) {
            place = known;
            *place = from.colors[i];
            ++into.count;
        }
        map[i + 1] = uint8_t(place - into.colors.begin() + 1);
    }
    return map;
}

}  // namespace rubble
