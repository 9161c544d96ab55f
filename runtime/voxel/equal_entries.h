#pragma once
#include <algorithm>
#include <cstddef>

#include "runtime/voxel/palette.h"

namespace rubble {

/// Whether an entry of a palette equals one before it: if no voxel has it, nobody misses it.
inline bool equalsEarlierEntry(const Palette& palette, size_t entry) {
    const auto here = palette.begin() + ptrdiff_t(entry);
    return std::find(palette.begin() + 1, here, *here) != here;
}

}  // namespace rubble
