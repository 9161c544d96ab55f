#include "runtime/destruction/blend_palette.h"

#include <algorithm>
#include <cstdlib>

#include "runtime/voxel/equal_entries.h"

namespace rubble {
namespace {

constexpr int kMinStep = 8;        ///< change of a channel in one step: bounds how many entries a blend can use
constexpr int kNearColor = 3;      ///< channels that differ by no more count as equal
constexpr int kPaintReserve = 24;  ///< free entries kept for the paint itself

/// The squared distance of two entries' colours in sRGB.
int distance2(const PaletteEntry& a, const PaletteEntry& b) {
    const int red = a.red - b.red, green = a.green - b.green, blue = a.blue - b.blue;
    return red * red + green * green + blue * blue;
}

PaletteEntry withColor(PaletteEntry entry, std::array<uint8_t, 3> color) {
    entry.red = color[0], entry.green = color[1], entry.blue = color[2];
    return entry;
}

bool differsInColorOnly(const PaletteEntry& a, const PaletteEntry& b) {
    return withColor(a, {b.red, b.green, b.blue}) == b;
}

/// One channel moved from `from` toward `to` by `strength` / 255 of the difference, but by kMinStep at least.
uint8_t stepped(int from, int to, int strength) {
    const int difference = to - from;
    const int step = std::max(std::abs(difference) * strength / 255, std::min(std::abs(difference), kMinStep));
    return uint8_t(difference < 0 ? from - step : from + step);
}

}  // namespace

BlendPalette::BlendPalette(const VoxelGrid& grid, const Palette& palette, const Paint& paint)
    : m_used(usedEntries(grid)), m_palette(palette), m_paint(paint) {
    m_blended.fill(-1);
}

uint8_t BlendPalette::blended(uint8_t source) {
    if (m_blended[source] < 0) {
        m_blended[source] = choose(source);
        m_isTaken[size_t(m_blended[source])] = true;
    }
    return uint8_t(m_blended[source]);
}

uint8_t BlendPalette::choose(uint8_t source) {
    const PaletteEntry from = m_palette[source];
    const PaletteEntry goal = withColor(from, m_paint.color);
    if (from == goal || from.material == 0) return source;
    const PaletteEntry wanted = withColor(
        from, {stepped(from.red, goal.red, m_paint.strength), stepped(from.green, goal.green, m_paint.strength),
               stepped(from.blue, goal.blue, m_paint.strength)});
    if (const auto near = findNear(source, wanted)) return *near;
    if (freeCount() <= kPaintReserve) freeUnused();
    const auto nearest = nearestCloser(source, wanted);
    if (freeCount() > kPaintReserve || !nearest)
        if (const auto made = allocate(freeCount() > kPaintReserve ? wanted : goal)) return *made;
    ++m_merges;
    return nearest.value_or(source);
}

/// An entry of nearly the wanted colour. Only one that is closer to the paint than the source: else the paint would
/// never be reached.
std::optional<uint8_t> BlendPalette::findNear(uint8_t source, const PaletteEntry& wanted) const {
    const auto near = nearestCloser(source, wanted);
    if (!near) return std::nullopt;
    const PaletteEntry& found = m_palette[*near];
    const int largest = std::max(
        {std::abs(found.red - wanted.red), std::abs(found.green - wanted.green), std::abs(found.blue - wanted.blue)});
    const bool wantsPaint = wanted == withColor(wanted, m_paint.color);
    return largest <= (wantsPaint ? 0 : kNearColor) ? near : std::nullopt;
}

std::optional<uint8_t> BlendPalette::nearestCloser(uint8_t source, const PaletteEntry& wanted) const {
    const PaletteEntry goal = withColor(wanted, m_paint.color);
    const int startDistance = distance2(m_palette[source], goal);
    std::optional<uint8_t> best;
    for (int i = 1; i < 256; ++i) {
        const PaletteEntry& entry = m_palette[size_t(i)];
        if (!differsInColorOnly(entry, wanted) || distance2(entry, goal) >= startDistance) continue;
        if (!best || distance2(entry, wanted) < distance2(m_palette[*best], wanted)) best = uint8_t(i);
    }
    return best;
}

std::optional<uint8_t> BlendPalette::allocate(const PaletteEntry& entry) {
    for (size_t i = 1; i < 256; ++i) {
        if (!isFree(i)) continue;
        m_palette[i] = entry;
        m_hasChanged = true;
        return uint8_t(i);
    }
    return std::nullopt;
}

/// Voxels may have entries without a material too.
bool BlendPalette::isFree(size_t entry) const {
    return m_palette[entry].material == 0 && !m_used.contains(entry) && !m_isTaken[entry];
}

int BlendPalette::freeCount() const {
    int count = 0;
    for (size_t i = 1; i < 256; ++i) count += isFree(i);
    return count;
}

/// First those that equal another one, which nobody misses; if they are not enough, all.
void BlendPalette::freeUnused() {
    for (; m_freeings < 2 && freeCount() <= kPaintReserve; ++m_freeings)
        for (size_t i = 255; i > 0; --i)
            if (!m_used.contains(i) && !m_isTaken[i] && (m_freeings == 1 || equalsEarlierEntry(m_palette, i)))
                m_palette[i] = {.material = 0};
}

}  // namespace rubble
