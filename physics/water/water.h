#pragma once
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "physics/water/submersion.h"
#include "runtime/world/objects/water.h"

namespace rubble {

/// The waters of a World, and their forces on bodies. Where waters overlap, the one with the lowest slot counts.
/// [main-thread]
class WaterVolumes {
public:
    /// Takes over the water of a slot; null: there is none any more. Returns the world bounds of the old and the new
    /// water together; none: there was no water and is none.
    std::optional<WorldBox> set(uint32_t slot, const Water* water);
    /// Whether there is no water.
    bool empty() const { return m_count == 0; }
    /// The forces of a step on an awake body, before contacts: lowers its gravityScale, sets its inWater and waterSlot,
    /// and changes its velocities; see water.cpp for the formulas. gravity: m/s2. Returns joules: the work of drag and
    /// torques.
    double applyForces(DynamicBody& body, glm::dvec3 gravity, double seconds);
    /// The water that a point is in, world; null: none.
    const Water* at(glm::dvec3 point) const;
    /// The water of a slot, which must have one.
    const Water& inSlot(uint32_t slot) const { return *m_waters[slot]; }

private:
    /// Finds the waters whose bounds meet a box.
    void findNear(const WorldBox& bounds);
    /// The mass of the water that a body wholly in those of m_near displaces, over its own.
    double mostDisplaced(const DynamicBody& body) const;
    /// The same of the part in the water, as a mean along the body's way in a step. most: see mostDisplaced().
    double meanDisplaced(const DynamicBody& body, glm::dvec3 gravity, double most, double seconds) const;

    std::vector<std::optional<Water>> m_waters;  ///< by slot
    BoundsTree m_tree;
    std::vector<uint32_t> m_near;            ///< slots of the waters near a body, ascending; scratch of applyForces()
    std::vector<const Water*> m_nearWaters;  ///< the same waters
    size_t m_count = 0;
};

/// Joules that buoyancy, and a gravity of its own, gave a body in the last solve beside gravity (m/s2).
double buoyancyWork(const DynamicBody& body, glm::dvec3 gravity);

}  // namespace rubble
