#include "runtime/world/stages/palette_merge.h"

#include <algorithm>

namespace rubble {

std::optional<std::array<uint8_t, 256>> mergePalette(Palette& into, UsedEntries usedInto, const Palette& from,
                                                     const UsedEntries& usedFrom) {
    std::array<uint8_t, 256> map{};
    bool fits = true;
    usedFrom.forEach([&](size_t i) {
        size_t place = into[i] == from[i] ? i : size_t(std::find(into.begin() + 1, into.end(), from[i]) - into.begin());
        if (place == into.size()) {
            place = 1;
            while (place < into.size() && (into[place].material || usedInto.contains(place))) ++place;
        }
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
