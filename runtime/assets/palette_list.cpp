#include "runtime/assets/palette_list.h"

namespace rubble {

uint32_t PaletteList::add(const PaletteRef& palette) {
    static const PaletteRef empty = std::make_shared<Palette>();
    const PaletteRef& used = palette ? palette : empty;
    if (const auto found = m_byAddress.find(used); found != m_byAddress.end()) return found->second;
    const uint64_t hash = hashPalette(*used);
    const auto [first, last] = m_byHash.equal_range(hash);
    for (auto candidate = first; candidate != last; ++candidate)
        if (*m_palettes[candidate->second] == *used) return m_byAddress[used] = candidate->second;
    const uint32_t number = uint32_t(m_palettes.size());
    m_palettes.push_back(used);
    m_byAddress[used] = number;
    m_byHash.emplace(hash, number);
    return number;
}

}  // namespace rubble
