#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

namespace rubble {

/// The cells of one word: 4x4x4, bit (x + 4 y + 16 z). A brick's words: 4x4x4, word (x + 4 y + 16 z).
using ShadowWords = std::array<uint64_t, 64>;

/// 16x16x16 shadow cells (voxels of 0.1 m on the world's axes) as rays read them.
///
/// The texel of a word that holds anything is its cells. The texel of an empty word says how far a ray may leap: for
/// each of the eight octants of directions (bit a of its number set: down axis a) the sizes in words of a box that
/// begins with this word, ends within the brick and is empty. Size - 1 in two bits: x at bit 2 octant, y at 16 + 2
/// octant, z at 32 + 2 octant.
struct ShadowBrick {
    ShadowWords texels{};
    uint64_t occupied = 0;  ///< which words hold anything
    /// The cells of a word by its number, x + 4 y + 16 z; 0 if it is empty.
    uint64_t cells(int word) const { return occupied >> word & 1 ? texels[size_t(word)] : 0; }
};
using ShadowBrickRef = std::shared_ptr<const ShadowBrick>;

/// Null if all words are empty.
/// isTransient: what is in it moves on at once, so its boxes are made quickly, and some are smaller than they could be.
ShadowBrickRef makeShadowBrick(const ShadowWords& cells, bool isTransient = false);
/// Whether a brick holds just these cells.
bool sameCells(const ShadowBrick& brick, const ShadowWords& cells);
/// The empty box of an empty word in an octant, in words.
inline glm::ivec3 emptyBox(const ShadowBrick& brick, int word, int octant) {
    const uint64_t texel = brick.texels[size_t(word)] >> (2 * octant);
    return glm::ivec3(int(texel & 3), int(texel >> 16 & 3), int(texel >> 32 & 3)) + 1;
}

inline constexpr float kShadowCell = 0.1f;  ///< metres
inline constexpr int kShadowBrickCells = 16;

/// One brick of the world's shadow volume after an update; null content = empty now. Coordinates in bricks, any sign.
struct ShadowPatch {
    glm::ivec3 brick;
    ShadowBrickRef content;
};

/// What the worker publishes: the bricks that differ from its last publication, and which step they show.
struct ShadowPatches {
    uint64_t version = 0;      ///< the step whose snapshot this volume equals, bit for bit; only grows
    bool replacesAll = false;  ///< a level was loaded: forget every brick before these
    std::vector<ShadowPatch> patches;
};

}  // namespace rubble
