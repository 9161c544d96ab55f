#include "runtime/world/objects/character.h"

#include "runtime/world/objects/object_hash.h"

namespace rubble {

uint64_t Character::hash() const {
    uint64_t hash = 0;
    for (const double value : {radius, height, crouchedHeight, stepHeight, maxSlope, mass, walkSpeed, crouchSpeed,
                               jumpSpeed, swimSpeed, maxPushForce})
        addToHash(hash, value);
    for (const glm::dvec3& value : {wish, position, velocity, groundVelocity}) addToHash(hash, value);
    const uint64_t flags = uint64_t(wantsJump) | uint64_t(wantsCrouch) << 1 | uint64_t(grounded) << 2 |
                           uint64_t(crouched) << 3 | uint64_t(swimming) << 4;
    return hashValue(flags | uint64_t(collisionLayer) << 8 | uint64_t(collisionMask) << 16,
                     hashValue(ground ? ground.slot() + 1 : 0, hash));
}

}  // namespace rubble
