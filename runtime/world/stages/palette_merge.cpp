#include "runtime/world/stages/palette_merge.h"

#include <algorithm>

namespace rubble {

std::optional<std::array<uint8_t, 256>> mergePalette(Palette& into, const Palette& from, const EntryCounts& used) {
    std::array<uint8_t, 256> map{};
    for (size_t i = 1; i < 256; ++i) {
        if (!used[i]) continue;
        auto place =
            into[i] == from[i] ? into.begin() + ptrdiff_t(i) : std::find(into.begin() + 1, into.end(), from[i]);
        if (place == into.end())
            place = std::find_if(into.begin() + 1, into.end(),
                                 [](const PaletteEntry& entry) { return entry.material == 0; });
        if (place == into.end()) return std::nullopt;
        *place = from[i];
        map[i] = uint8_t(place - into.begin());
    }
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
