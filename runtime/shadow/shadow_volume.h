#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "runtime/core/block_pool.h"

namespace rubble {

/// The cells of a brick: 4x4x4 words, word (x + 4 y + 16 z), of 4x4x4 cells, bit (x + 4 y + 16 z).
using ShadowWords = std::array<uint64_t, 64>;

/// 16x16x16 shadow cells (of 0.1 m, along the world's axes) as rays read them.
///
/// The texel of a word that holds cells is the word itself. The texel of an empty word says how far a ray may skip: for
/// each octant of directions (bit a of its number: down axis a) the size in words of an empty box that begins with this
/// word and ends within the brick. Size - 1 takes two bits: x at bit 2 * octant, y at 16 + 2 * octant, z at 32 + 2 *
/// octant.
struct ShadowBrick {
    ShadowWords texels{};
    uint64_t occupied = 0;  ///< which words hold cells
    /// The cells of a word by its number, x + 4 y + 16 z; 0 if it is empty.
    uint64_t cells(int word) const { return occupied >> word & 1 ? texels[size_t(word)] : 0; }
};
using ShadowBrickRef = std::shared_ptr<const ShadowBrick>;

/// A brick of these cells; null if there are none. isTransient: shapes move through it, so it will soon be replaced;
/// its empty boxes are found faster and some are smaller. pool: of such bricks alone; null: none.
ShadowBrickRef makeShadowBrick(const ShadowWords& cells, bool isTransient = false,
                               const std::shared_ptr<BlockPool>& pool = nullptr);
/// Whether a brick has exactly these cells.
bool sameCells(const ShadowBrick& brick, const ShadowWords& cells);
/// The size in words of the empty box of an empty word in an octant.
inline glm::ivec3 emptyBox(const ShadowBrick& brick, int word, int octant) {
    const uint64_t texel = brick.texels[size_t(word)] >> (2 * octant);
    return glm::ivec3(int(texel & 3), int(texel >> 16 & 3), int(texel >> 32 & 3)) + 1;
}

/// How much of a brick has changed, at the most.
struct ShadowChange {
    uint64_t words = ~0ull;  ///< those whose cells differ, a bit each
    uint32_t cells = 4096;   ///< that differ
};
/// What differs between two bricks; null: an empty one.
ShadowChange changeBetween(const ShadowBrick* before, const ShadowBrick* after);

inline constexpr float kShadowCell = 0.1f;  ///< metres
inline constexpr int kShadowBrickCells = 16;
inline constexpr int kShadowBrickWords = 4;  ///< along each axis

/// A brick of the world's shadow volume that an update changed. Coordinates in bricks, of any sign. Null: empty now.
struct ShadowPatch {
    glm::ivec3 brick;
    ShadowBrickRef content;
    bool wasEmpty = false;  ///< there was nothing before: if it is empty again, nobody needs to hear of it
    ShadowChange change = {};
};

/// A publication of the worker: the bricks that differ from the one before.
struct ShadowPatches {
    uint64_t version = 0;      ///< the step whose world this volume equals exactly; increases
    bool replacesAll = false;  ///< a level was loaded: all earlier bricks are gone
    std::vector<ShadowPatch> patches;
};

}  // namespace rubble
