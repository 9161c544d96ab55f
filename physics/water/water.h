#pragma once
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "physics/bodies/dynamic_body.h"
#include "runtime/world/objects/water.h"

namespace rubble {

/// What of some voxels is under water.
struct Submersion {
    double volume = 0.0;     ///< m3
    double total = 0.0;      ///< m3, with what is above
    double waterline = 0.0;  ///< m2 of surface that the voxels take
    glm::dvec3 moment{0.0};  ///< volume times place, about the collider's origin, world axes
};

/// Adds up what of a part is in a water. Bricks, layers and rows that are whole above or below count by integer sums; a
/// voxel that the surface cuts counts by how far it is under, as if it stood upright: exact for aligned voxels and,
/// over many, for turned ones. Outline and floor are looked up brick by brick. origin: of the collider, world.
void addSubmersion(const VoxelPart& part, const CellTransform& cells, glm::dvec3 origin, const Water& water,
                   Submersion& sum);

/// The waters of a World, and what they do to bodies.
class WaterVolumes {
public:
    /// Null: there is none in the slot any more. Returns the bounds of what was or is there.
    std::optional<WorldBox> set(uint32_t slot, const Water* water);
    bool empty() const { return m_count == 0; }
    /// Buoyancy and drag of one step, before gravity and contacts: drag is implicit and acts on what gravity is about
    /// to add too, so that it gains no energy, however strong, and ends at the terminal velocity. True if the body is
    /// wet.
    bool act(DynamicBody& body, glm::dvec3 gravity, double seconds) const;
    /// The water that a point is in; null: none.
    const Water* at(glm::dvec3 point) const;

private:
    std::vector<std::optional<Water>> m_waters;  ///< by slot
    BoundsTree m_tree;
    size_t m_count = 0;
};

}  // namespace rubble
