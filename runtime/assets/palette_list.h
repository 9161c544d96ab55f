#pragma once
#include <map>
#include <vector>

#include "runtime/voxel/palette.h"

namespace rubble {

/// The different palettes of a level, numbered in the order in which they are first used; a file holds each once.
class PaletteList {
public:
    /// The number of the palette with this content, which is added if it is new. Null means the default palette.
    uint32_t add(const PaletteRef& palette);
    /// All palettes by number.
    std::vector<PaletteRef>& palettes() { return m_palettes; }
    /// All palettes by number.
    const std::vector<PaletteRef>& palettes() const { return m_palettes; }

private:
    std::vector<PaletteRef> m_palettes;
    std::map<PaletteRef, uint32_t> m_byAddress;  ///< keeps them alive, so that no other palette gets the same address
    std::multimap<uint64_t, uint32_t> m_byHash;
};

}  // namespace rubble
