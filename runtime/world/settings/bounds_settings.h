#pragma once
#include <cstdint>
#include <glm/vec3.hpp>

namespace rubble {

/// World height, in metres, of the fields that are drawn around a level: a little below the ground of most, at 0.
inline constexpr double kFieldsHeight = -0.05;

/// What becomes of bodies beyond the level.
enum class BoundsRule : uint8_t {
    Dust,    ///< a free body outside the bounds with all of its voxels is removed in the next step, and becomes dust
    Keep,    ///< nothing: it goes on for ever, and what lies far out casts no shadow (ShadowDirectory::kMaxSectors)
    Ground,  ///< as Dust; and within the bounds the fields are solid, so that what leaves the level rests on them
};

/// Where the world ends. Without an end, whatever falls off a level falls for ever, at the cost of a body that moves.
struct BoundsSettings {
    BoundsRule rule = BoundsRule::Dust;
    glm::dvec3 low{0.0}, high{0.0};  ///< metres: a box instead of the level's (WorldState::bounds); equal: the level's

    friend bool operator==(const BoundsSettings&, const BoundsSettings&) = default;
};

}  // namespace rubble
