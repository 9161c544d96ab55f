#pragma once
#include <bit>

#include "runtime/core/byte_bits.h"
#include "runtime/voxel/brick.h"

namespace rubble {

/// Calls f(entry, layer, bits) for the solid voxels among `voxels`: layer by layer (z), and once in a layer for each
/// palette entry, with the bits of its voxels.
template <class F>
void forEachEntry(const Brick& brick, const BrickBits& voxels, F&& f) {
    for (size_t z = 0; z < 8; ++z) {
        uint64_t left = voxels[z] & brick.occupancy[z];
        if (!brick.indices) {
            if (left) f(brick.uniform, z, left);
            continue;
        }
        const uint8_t* layer = brick.indices->data() + 64 * z;
        while (left) {
            const uint8_t entry = layer[std::countr_zero(left)];
            const uint64_t bits = equalBits(layer, entry) & left;
            f(entry, z, bits);
            left &= ~bits;
        }
    }
}

}  // namespace rubble
