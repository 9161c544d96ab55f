#pragma once
#include <map>
#include <utility>
#include <vector>

#include "runtime/world/world.h"

namespace rubble {

/// The palettes that are drawn: those of the shapes, with the emission that a shape's factor leaves of it, and none of
/// light groups that are switched off. The World keeps what entries emit, so that a switch forgets nothing. Shapes that
/// share a palette and a factor share what is drawn. Without factors and switches the shapes' own palettes are drawn,
/// and nothing is kept. [main-thread]
class ShownPalettes {
public:
    /// Takes over which groups are off. To be called each step before of().
    void update(const FrameChanges& changes, const World& world);
    /// What to draw a shape of the world with.
    PaletteRef of(const Shape& shape);

private:
    std::vector<bool> m_isOff;  ///< by slot of the group; empty: all are on
    /// By palette and factor. The key holds the palette, so that no other one gets its address.
    std::map<std::pair<PaletteRef, float>, PaletteRef> m_shown;
    size_t m_pruneAt = 64;  ///< when so many are kept, those of palettes that are gone are dropped
};

}  // namespace rubble
