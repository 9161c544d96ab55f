#pragma once
#include <rubble/rubble.hpp>
#include <vector>

namespace editor {

/// Entries of a shape's palette, to read or to set.
inline rubble_palette_range paletteRange(rubble_shape shape, uint32_t first, uint32_t count, bool allEqual = false) {
    rubble_palette_range range{};
    range.struct_size = sizeof range;
    range.flags = allEqual ? RUBBLE_PALETTE_ALL_EQUAL : 0;
    range.shape = shape;
    range.first = first;
    range.count = count;
    range.entry_size = sizeof(rubble_palette_entry);
    return range;
}

/// All entries: [0] is that of no voxel.
inline std::vector<rubble_palette_entry> paletteOf(const rubble::World& world, rubble_shape shape) {
    std::vector<rubble_palette_entry> entries = world.get_palette(paletteRange(shape, 1, 255));
    entries.insert(entries.begin(), rubble_palette_entry{});
    return entries;
}

}  // namespace editor
