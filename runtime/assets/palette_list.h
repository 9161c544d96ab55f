#pragma once
#include <map>
#include <vector>

#include "runtime/voxel/palette.h"

namespace rubble {

/// The different palettes of a level, in the order in which they are first used; a file holds each once.
class PaletteList {
public:
    /// The number of a palette with this content; a null one counts as the default palette.
    uint32_t add(const PaletteRef& palette);
    std::vector<PaletteRef>& palettes() { return m_palettes; }
    const std::vector<PaletteRef>& palettes() const { return m_palettes; }

private:
    std::vector<PaletteRef> m_palettes;
    std::map<PaletteRef, uint32_t> m_byAddress;  ///< held, so that no other palette gets the address
    std::multimap<uint64_t, uint32_t> m_byHash;
};

}  // namespace rubble
