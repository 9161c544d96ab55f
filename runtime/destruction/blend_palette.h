#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "runtime/destruction/paint.h"

namespace rubble {

/// Finds or makes the palette entries that one step of paint needs.
class BlendPalette {
public:
    BlendPalette(const VoxelGrid& grid, const Palette& palette, const Paint& paint);

    /// The entry that voxels of `source` take in this step; `source` itself once it has the paint's colour.
    uint8_t blended(uint8_t source);
    const Palette& palette() const { return m_palette; }
    bool hasChanged() const { return m_hasChanged; }
    uint64_t merges() const { return m_merges; }

private:
    uint8_t choose(uint8_t source);
    std::optional<uint8_t> findNear(uint8_t source, const PaletteEntry& wanted) const;
    std::optional<uint8_t> nearestCloser(uint8_t source, const PaletteEntry& wanted) const;
    std::optional<uint8_t> allocate(const PaletteEntry& entry);
    void freeUnused();
    int freeCount() const;

    const VoxelGrid& m_grid;
    Palette m_palette;
    const Paint& m_paint;
    std::array<int16_t, 256> m_blended;  ///< -1: not asked for yet
    std::array<bool, 256> m_isTaken{};   ///< chosen in this step: not to be freed
    bool m_hasFreedUnused = false;
    bool m_hasChanged = false;
    uint64_t m_merges = 0;
};

}  // namespace rubble
