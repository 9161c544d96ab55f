#pragma once
#include <cstdint>

#include "runtime/core/hash.h"
#include "runtime/world/objects/world_objects.h"

namespace rubble {

/// Chains value after value into one hash.
struct StateHasher {
    uint64_t state = 0;
    /// A number, or bits.
    void add(uint64_t value) { state = hashValue(value, state); }
    /// The bytes of a vector.
    void add(const glm::dvec3& v) { state = hashBytes(&v, sizeof v, state); }
    /// The bytes of a quaternion.
    void add(const glm::dquat& q) { state = hashBytes(&q, sizeof q, state); }
    /// Position, then rotation.
    void add(const Pose& pose) {
        add(pose.position);
        add(pose.rotation);
    }
};

// What resolvedHash() takes of one object, chained into a hash: its state, without its slot. Costs no voxels.

/// Pose, motion and what it is.
uint64_t hashState(const Body& body, uint64_t seed);
/// Voxels by the hash of the grid.
uint64_t hashState(const Shape& shape, uint64_t seed);
/// All of it.
uint64_t hashState(const Light& light, uint64_t seed);
/// All of it but its name.
uint64_t hashState(const LightGroup& group, uint64_t seed);
/// All of it.
uint64_t hashState(const Water& water, uint64_t seed);
/// All of it.
uint64_t hashState(const Trigger& trigger, uint64_t seed);
/// All of it.
uint64_t hashState(const Character& character, uint64_t seed);
/// All but the points of ropes.
uint64_t hashState(const Joint& joint, uint64_t seed);
/// All of it.
uint64_t hashState(const Note& note, uint64_t seed);
/// The same of a shape whose palette has this hash.
uint64_t hashState(const Shape& shape, uint64_t paletteHash, uint64_t seed);

}  // namespace rubble
