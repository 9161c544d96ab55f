#pragma once
#include <cstdint>
#include <glm/common.hpp>
#include <vector>

#include "runtime/shadow/shadow_volume.h"
#include "runtime/world/level/level.h"

namespace rubble::rays {

/// A world's occupancy as a dense box of words of 4x4x4 cells: the source of every walk's data.
struct WorldBits {
    glm::ivec3 low{0};    ///< world cell of cell 0
    glm::ivec3 words{0};  ///< a multiple of 4 each: whole bricks
    std::vector<uint64_t> bits;

    /// Size in cells.
    glm::ivec3 cells() const { return words * 4; }
    /// Index of a word in `bits`.
    size_t wordAt(glm::ivec3 w) const {
        return (size_t(w.z) * size_t(words.y) + size_t(w.y)) * size_t(words.x) + size_t(w.x);
    }
    /// Whether a cell is in the box.
    bool inside(glm::ivec3 c) const {
        const glm::ivec3 n = cells();
        return c.x >= 0 && c.y >= 0 && c.z >= 0 && c.x < n.x && c.y < n.y && c.z < n.z;
    }
    /// Whether a cell is occupied; false outside.
    bool at(glm::ivec3 c) const {
        return inside(c) && (bits[wordAt(c >> 2)] >> ((c.x & 3) + (c.y & 3) * 4 + (c.z & 3) * 16) & 1);
    }
};

/// The smallest box of whole bricks around all patches.
WorldBits bitsOf(const std::vector<ShadowPatch>& patches);
/// The patches that the shadow worker makes for a level.
std::vector<ShadowPatch> patchesOf(const Level& level);

}  // namespace rubble::rays
