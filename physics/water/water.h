#pragma once
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "physics/bodies/dynamic_body.h"
#include "runtime/world/objects/water.h"

namespace rubble {

/// The part of some voxels that is under water.
struct Submersion {
    double volume = 0.0;     ///< m3 under water
    double waterline = 0.0;  ///< m2 of the surface that the voxels cut
    glm::dvec3 moment{0.0};  ///< volume times its centroid, from the collider's origin, world axes
};

/// Adds the part of a voxel part that is in a water. origin: of the collider, world.
void addSubmersion(const ColliderPart& part, const CellTransform& cells, glm::dvec3 origin, const Water& water,
                   Submersion& sum);

/// The waters of a World, and their forces on bodies. [main-thread]
class WaterVolumes {
public:
    /// Takes over the water of a slot; null: there is none any more. Returns the world bounds of the old and the new
    /// water together; none: there was no water and is none.
    std::optional<WorldBox> set(uint32_t slot, const Water* water);
    /// Whether there is no water.
    bool empty() const { return m_count == 0; }
    /// Buoyancy and drag of a step, before gravity and contacts; see water.cpp for the formulas. gravity: m/s2. True if
    /// the body is in water.
    bool applyForces(DynamicBody& body, glm::dvec3 gravity, double seconds) const;
    /// The water that a point is in, world; null: none.
    const Water* at(glm::dvec3 point) const;

private:
    std::vector<std::optional<Water>> m_waters;  ///< by slot
    BoundsTree m_tree;
    size_t m_count = 0;
};

}  // namespace rubble
