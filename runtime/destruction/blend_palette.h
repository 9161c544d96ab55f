#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "runtime/destruction/paint.h"
#include "runtime/voxel/used_entries.h"

namespace rubble {

/// Finds or makes the palette entries for one step of paint (see paintPalette()).
class BlendPalette {
public:
    /// `paint` must outlive it.
    BlendPalette(const VoxelGrid& grid, const Palette& palette, const Paint& paint);

    /// The entry that voxels of entry `source` get in this step; `source` itself once it has the paint's colour.
    uint8_t blended(uint8_t source);
    /// The palette with the new entries.
    const Palette& palette() const { return m_palette; }
    /// Whether the palette has new entries.
    bool hasChanged() const { return m_hasChanged; }
    /// Blends that found no free entry and took the nearest one.
    uint64_t merges() const { return m_merges; }

private:
    uint8_t choose(uint8_t source);
    std::optional<uint8_t> findNear(uint8_t source, const PaletteEntry& wanted) const;
    std::optional<uint8_t> nearestCloser(uint8_t source, const PaletteEntry& wanted) const;
    std::optional<uint8_t> allocate(const PaletteEntry& entry);
    void freeUnused();
    bool isFree(size_t entry) const;
    int freeCount() const;

    UsedEntries m_used;  ///< by voxels, before this step
    Palette m_palette;
    const Paint& m_paint;
    std::array<int16_t, 256> m_blended;  ///< by source entry: the result of blended(); -1: none yet
    std::array<bool, 256> m_isTaken{};   ///< entries chosen in this step: they must not be freed
    int m_freeings = 0;                  ///< that freeUnused() has done in this step
    bool m_hasChanged = false;
    uint64_t m_merges = 0;
};

}  // namespace rubble
