#pragma once
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "physics/shapes/voxel_collider.h"

namespace rubble {

/// Where the cells of a part are.
struct CellTransform {
    glm::dmat3 axes{1.0};    ///< of one cell, world
    glm::dvec3 corner{0.0};  ///< from the collider's frame origin, world axes
};

/// Where a body is and how it moves, as narrowphase needs it. The frame is that of its collider.
struct Motion {
    Pose pose;                                      ///< collider's frame -> world
    std::span<const CellTransform> cellTransforms;  ///< of the collider's parts
    glm::dvec3 velocity{0.0}, angularVelocity{0.0};
    double radius = 0.0;  ///< of the collider, metres; 0: it stands still
};

/// One point where two bodies touch or may touch within the step. Axes of the world, metres.
struct ContactPoint {
    glm::vec3 position{0.0f};  ///< from the first body's frame origin
    glm::vec3 normal{0.0f};    ///< from the second body to the first
    float separation = 0.0f;   ///< < 0: they overlap
    float friction = 0.0f, restitution = 0.0f;
    uint64_t feature = 0;  ///< which feature of which body it is: finds the point again in the next step
};

/// How far points of two bodies move against each other in a time, at most.
double maxRelativeDisplacement(const Motion& first, const Motion& second, double seconds);

struct NarrowphaseSettings {
    double margin = 0.02;  ///< metres apart at which bodies count as touching: contacts do not come and go
    double seconds = 1.0 / 60.0;
    double sweepThreshold = 0.02;  ///< metres of motion beyond which features are swept along it
};

/// Contacts of two bodies of voxels: the corners and edges of each against the occupancy of the other, swept along
/// their relative motion where that is fast. A normal is that of a face which is exposed in its own grid, and against
/// which the feature sticks out in its own: seams between voxels are no bumps, and aligned edges give no sideways push.
/// Appended in a fixed order.
/// axis: a unit vector along which the two may be apart, or 0; comes back as a better one to start from in the next
/// step. The contacts do not depend on it. Returns whether they are near each other; if not, nothing can touch.
bool findContacts(const VoxelCollider& first, const Motion& firstMotion, const VoxelCollider& second,
                  const Motion& secondMotion, const NarrowphaseSettings& settings, glm::vec3& axis,
                  std::vector<ContactPoint>& out);

}  // namespace rubble
