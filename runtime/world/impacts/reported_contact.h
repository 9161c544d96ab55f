#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "runtime/core/handle.h"

namespace rubble {

/// What physics reports of a step to those who ask; see PhysicsWorld::report().
struct ReportFilter {
    bool begun = false, slid = false, hit = false;  ///< contacts of these kinds
    bool water = false;                             ///< bodies that get into water
    double minImpulse = 0.0;                        ///< N s in the step, of contacts of all kinds
    double minHitSpeed = 0.5;                       ///< m/s at which two bodies meet, to be a hit
    double minSlipSpeed = 0.1;                      ///< m/s along each other, to slide

    /// Whether contacts of any kind are asked for.
    bool contacts() const { return begun || slid || hit; }
    /// Whether anything is asked for.
    bool any() const { return contacts() || water; }
};

/// The slot of what is no shape of World: the ground around the level.
inline constexpr uint32_t kNoShapeSlot = ~0u;

/// One side of a contact.
struct ContactSide {
    BodyHandle body;                    ///< empty: the ground around the level
    uint32_t shapeSlot = kNoShapeSlot;  ///< of the shape that is touched
    glm::ivec3 cell{-1};                ///< of its grid, nearest to where the contact is hardest; negative: none near
};

/// Two bodies that touch each other, or a body and one shape of a static body.
struct ReportedContact {
    std::array<ContactSide, 2> sides;
    bool begun = false, slid = false, hit = false;  ///< of those that were asked for
    glm::dvec3 position{0.0};                       ///< world: the middle of its points, weighted by impulse
    glm::dvec3 normal{0.0};                         ///< unit vector, towards the first body
    double impulse = 0.0;                           ///< N s along the normal, in the step
    double hitSpeed = 0.0;                          ///< m/s at which they approached each other before the step
    double slipSpeed = 0.0;                         ///< m/s along each other after it
    double size = 0.0;                              ///< metres: of its points the two farthest apart; a voxel at least
};

/// A body that got into water.
struct WaterEntry {
    BodyHandle body;
    uint32_t waterSlot = 0;
    glm::dvec3 position{0.0};  ///< world: over or under the centre of mass, at the water's surface
    double speed = 0.0;        ///< m/s relative to the water's flow
    double mass = 0.0;         ///< kg, of the body
};

}  // namespace rubble
