#pragma once
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "physics/bodies/collision_object.h"
#include "physics/shapes/cell_transform.h"
#include "physics/shapes/voxel_collider.h"

namespace rubble {

/// Voxels: the contact margin is at most this, below 1/2, so that along each axis one face at most is within it.
constexpr float kMaxContactMargin = 0.4f;
/// Voxels of motion in a step, along one normal more than along another, that tell which of the two is right.
constexpr float kMinSlide = 0.01f;

/// The pose and velocity of a body, as narrowphase needs them. The frame is that of its collider.
struct Motion {
    Pose pose;                                      ///< collider's frame -> world
    std::span<const CellTransform> cellTransforms;  ///< of the collider's parts
    glm::dvec3 velocity{0.0}, angularVelocity{0.0};
    double radius = 0.0;  ///< of the collider about its frame's origin, metres; 0: it does not move
};

/// One point at which two bodies touch, or may touch within the step. World axes, metres.
struct ContactPoint {
    glm::vec3 position{0.0f};  ///< from the first body's frame origin
    glm::vec3 normal{0.0f};    ///< unit vector, from the second body to the first
    float separation = 0.0f;   ///< along the normal; negative: they overlap
    float friction = 0.0f, restitution = 0.0f;
    bool isPressed = false;  ///< see pressesOn(), manifold.h; here, where it takes no space
    uint64_t feature = 0;    ///< which feature of which body it is: identifies the point in the next step
};

/// An upper bound of how far points of two bodies move against each other in a time, metres.
double maxRelativeDisplacement(const Motion& first, const Motion& second, double seconds);

/// Contacts of two parts after which no more bricks are searched: a manifold keeps twelve at most.
inline constexpr size_t kEnoughContacts = 1024;
/// Bricks of a large part that are searched in a step, among those that may touch the other part.
inline constexpr size_t kMaxSearchedBricks = 768;

/// What the search for contacts of two bodies leaves for that of the next step.
struct ContactSearch {
    glm::vec3 axis{0.0f};    ///< unit vector along which the two may be separated; 0: none is known
    float clearance = 0.0f;  ///< metres that points of the two may move against each other before they are near
    uint32_t turn = 0;       ///< searches that left bricks out: each begins where the one before ended
    uint32_t leftOut = 0;    ///< bricks that may touch and were not searched
};

struct NarrowphaseSettings {
    double margin = 0.02;  ///< metres apart up to which bodies have contacts, so that contacts do not come and go
    double seconds = 1.0 / 60.0;
    double sweepThreshold = 0.02;  ///< metres of relative motion in the step above which features are swept along it
};

/// The static objects that the first body is paired with, the second included: they may lie flush against it.
struct StaticNeighbours {
    std::span<const ObjectPair> pairs;  ///< empty: there are none
    size_t own = 0;                     ///< which of the pairs is that of the second body
};

/// Appends the contacts of two bodies of voxels, in a fixed order, and returns whether they are near each other. If
/// they are not, nothing can touch within the step. search: of the step before, or a new one; contacts depend on it
/// only where it leaves bricks out. [any thread]
bool findContacts(const VoxelCollider& first, const Motion& firstMotion, const VoxelCollider& second,
                  const Motion& secondMotion, const NarrowphaseSettings& settings, ContactSearch& search,
                  std::vector<ContactPoint>& out, const StaticNeighbours& neighbours = {});

}  // namespace rubble
