#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <unordered_map>
#include <vector>

namespace rubble {

/// 16x16x16 shadow cells (voxels of 0.1 m on the world's axes), one bit each: 4x4x4 words of 4x4x4 cells.
/// Word (x + 4 y + 16 z); bit inside a word (x + 4 y + 16 z).
struct ShadowBrick {
    std::array<uint64_t, 64> words{};
    /// Bit (x + 4 y + 16 z) set where the word holds anything: the next coarser level.
    uint64_t occupiedWords() const {
        uint64_t mask = 0;
        for (int i = 0; i < 64; ++i) mask |= uint64_t(words[size_t(i)] != 0) << i;
        return mask;
    }
    friend bool operator==(const ShadowBrick&, const ShadowBrick&) = default;
};
using ShadowBrickRef = std::shared_ptr<const ShadowBrick>;

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
