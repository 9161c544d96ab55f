#include "runtime/frame/shown_palettes.h"

#include <algorithm>
#include <memory>

namespace rubble {
namespace {

bool isOff(const std::vector<bool>& groups, const PaletteEntry& entry) {
    return entry.lightGroup && entry.lightGroup <= groups.size() && groups[entry.lightGroup - 1];
}

}  // namespace

void ShownPalettes::update(const FrameChanges& changes, const World& world) {
    if (changes.groups.empty() && !changes.levelReplaced) return;
    std::vector<bool> now;
    world.lightGroups().forEach([&](LightGroupHandle handle, const LightGroup& group) {
        if (!group.off) return;
        now.resize(world.lightGroups().slotCount());
        now[handle.slot()] = true;
    });
    if (now == m_isOff && !changes.levelReplaced) return;
    m_isOff = std::move(now);
    m_shown.clear();
}

PaletteRef ShownPalettes::of(const Shape& shape) {
    if (m_isOff.empty() && shape.emission == 1.0f) return shape.palette;
    const auto isOther = [&](const PaletteEntry& entry) {
        return entry.emission > 0.0f && (shape.emission != 1.0f || isOff(m_isOff, entry));
    };
    if (std::none_of(shape.palette->begin(), shape.palette->end(), isOther)) return shape.palette;
    PaletteRef& shown = m_shown[{shape.palette, shape.emission}];
    if (shown) return shown;
    auto palette = std::make_shared<Palette>(*shape.palette);
    for (PaletteEntry& entry : *palette)
        entry.emission = isOff(m_isOff, entry) ? 0.0f : entry.emission * shape.emission;
    shown = palette;
    const PaletteRef out = shown;
    if (m_shown.size() >= m_pruneAt) {
        std::erase_if(m_shown, [](const auto& kept) { return kept.first.first.use_count() == 1; });
        m_pruneAt = std::max<size_t>(64, 2 * m_shown.size());
    }
    return out;
}

}  // namespace rubble
