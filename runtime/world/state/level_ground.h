#pragma once
#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

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

/// A few slabs. Every query asks for them, so they take no memory.
class GroundSlabs {
public:
    /// Adds one.
    void push_back(const GroundSlab& slab) { m_slabs[m_count++] = slab; }
    /// Their number.
    size_t size() const { return m_count; }
    /// Whether there are none.
    bool empty() const { return m_count == 0; }
    /// The first, for loops over all.
    const GroundSlab* begin() const { return m_slabs.data(); }
    /// Behind the last.
    const GroundSlab* end() const { return m_slabs.data() + m_count; }
    friend bool operator==(const GroundSlabs&, const GroundSlabs&) = default;

private:
    std::array<GroundSlab, 5> m_slabs;  ///< one on each side of a level, and one below it
    size_t m_count = 0;
};

/// The solid ground that BoundsRule::Ground asks for; empty with another rule. It lies at kFieldsHeight, from the
/// level's footprint to the bounds, but at most 4 km from the footprint's middle. Below a footprint that reaches deeper
/// than that it lies at the footprint's lowest point, so that what falls through the level rests there.
GroundSlabs groundSlabs(const WorldState& world);

}  // namespace rubble
