#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "runtime/world/state/world_state.h"

namespace rubble {

/// A slab of solid ground: cubes side by side, on axes of the world.
struct GroundSlab {
    glm::dvec3 low{0.0};  ///< its low corner, metres
    double side = 1.0;    ///< of a cube, metres
    glm::ivec2 cubes{1};  ///< along x and z; at most kMaxGroundCubes

    friend bool operator==(const GroundSlab&, const GroundSlab&) = default;
};
inline constexpr int kMaxGroundCubes = 32;

/// The solid ground that BoundsRule::Ground asks for; empty with another rule. It lies at kFieldsHeight, from the
/// level's footprint to the bounds, but at most 4 km from the footprint's middle. Below a footprint that reaches deeper
/// than that it lies at the footprint's lowest point, so that what falls through the level rests there.
std::vector<GroundSlab> groundSlabs(const WorldState& world);

}  // namespace rubble
