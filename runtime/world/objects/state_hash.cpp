#include "runtime/world/objects/state_hash.h"

#include "runtime/core/hash.h"
#include "runtime/core/planted_fault.h"

namespace rubble {

uint64_t hashState(const Body& body, uint64_t seed) {
    StateHasher hasher{seed};
    hasher.add(body.pose);
    hasher.add(body.velocity);
    hasher.add(body.angularVelocity);
    hasher.add(uint64_t(body.waitsToWake) << 4 | uint64_t(body.broken) << 3 | uint64_t(body.settled) << 2 |
               uint64_t(body.isStatic) << 1 | uint64_t(body.asleep));
    hasher.add(body.createdStep);
    hasher.add(body.restingSince);
    hasher.add(glm::dvec3(body.gravityScale, body.linearDamping, body.angularDamping));
    return hasher.state;
}

uint64_t hashState(const Shape& shape, uint64_t paletteHash, uint64_t seed) {
    StateHasher hasher{seed};
    hasher.add(shape.body.slot());
    hasher.add(shape.local);
    hasher.add(glm::dvec3(shape.grid.size()));
    hasher.add(shape.grid.contentHash());
    hasher.add(paletteHash);
    hasher.add(glm::dvec3(isPlanted("unhashed-field") ? 0.0f : shape.strength, shape.density, shape.emission));
    hasher.add(double(shape.voxelSize));
    hasher.state = hashBytes(shape.anchors.data(), shape.anchors.size() * sizeof(CellBox), hasher.state);
    hasher.add(uint64_t(shape.broken) << 26 | uint64_t(shape.isPiece) << 25 | uint64_t(shape.loadBearing) << 24 |
               uint64_t(shape.collisionShape) << 16 | uint64_t(shape.collisionLayer) << 8 | shape.collisionMask);
    if (shape.paintColors) hasher.add(hashBytes(shape.paintColors.get(), sizeof(PaintColors)));
    return hasher.state;
}

uint64_t hashState(const Shape& shape, uint64_t seed) {
    return hashState(shape, hashPalette(*shape.palette), seed);
}

uint64_t hashState(const LightGroup& group, uint64_t seed) {
    StateHasher hasher{seed};
    hasher.add(group.removedVoxels << 1 | uint64_t(group.out));
    hasher.add(group.initialVoxels);
    hasher.add(group.failingSince << 2 | uint64_t(group.off) << 1 | uint64_t(group.dark));
    hasher.add(uint64_t(group.supply.slot()) << 32 | uint64_t(bool(group.supply)));
    hasher.state = hashBytes(&group.supplyCell, sizeof group.supplyCell, hasher.state);
    hasher.add(glm::dvec3(group.threshold));
    hasher.add(uint64_t(group.flickerSteps));
    return hasher.state;
}

uint64_t hashState(const Joint& joint, uint64_t seed) {
    return hashJoint(joint, seed);
}

uint64_t hashState(const Light& light, uint64_t seed) {
    return hashValue(light.hash(), seed);
}
uint64_t hashState(const Water& water, uint64_t seed) {
    return hashValue(water.hash(), seed);
}
uint64_t hashState(const Trigger& trigger, uint64_t seed) {
    return hashValue(trigger.hash(), seed);
}
uint64_t hashState(const Character& character, uint64_t seed) {
    return hashValue(character.hash(), seed);
}
uint64_t hashState(const Note& note, uint64_t seed) {
    return hashValue(note.hash(), seed);
}

}  // namespace rubble
