#include <glm/mat3x3.hpp>

#include "runtime/core/hash.h"
#include "runtime/world/objects/character.h"
#include "runtime/world/objects/trigger.h"
#include "runtime/world/objects/water.h"

namespace rubble {
namespace {

template <class T>
void add(uint64_t& hash, const T& value) {
    hash = hashBytes(&value, sizeof value, hash);
}

void addArea(uint64_t& hash, const GroundPolygon& area) {
    hash = hashBytes(area.data(), area.size() * sizeof(GroundPoint), hashValue(area.size(), hash));
}

}  // namespace

uint64_t Water::hash() const {
    uint64_t hash = 0;
    addArea(hash, outline);
    for (const double value : {surface, depth, density, linearDrag, angularDrag}) add(hash, value);
    add(hash, flow);
    return hash;
}

uint64_t Trigger::hash() const {
    uint64_t hash = hashValue(uint64_t(kind) << 8 | layers);
    add(hash, pose);
    for (const double value : {radius, height}) add(hash, value);
    add(hash, halfSize);
    addArea(hash, outline);
    for (const BodyHandle body : inside) hash = hashValue(body.slot(), hash);
    return hash;
}

WorldBox Trigger::bounds() const {
    if (kind == TriggerKind::Sphere) return {pose.position - radius, pose.position + radius};
    if (kind == TriggerKind::Box) {
        const glm::dmat3 axes = glm::mat3_cast(pose.rotation);
        const glm::dvec3 halfExtent =
            glm::abs(axes[0]) * halfSize.x + glm::abs(axes[1]) * halfSize.y + glm::abs(axes[2]) * halfSize.z;
        return {pose.position - halfExtent, pose.position + halfExtent};
    }
    WorldBox box{{1e30, 0.0, 1e30}, {-1e30, height, -1e30}};
    for (const GroundPoint& p : outline) {
        box.low = glm::min(box.low, {p.x, 0.0, p.z});
        box.high = glm::max(box.high, {p.x, height, p.z});
    }
    return {pose.position + box.low, pose.position + box.high};
}

uint64_t Character::hash() const {
    uint64_t hash = 0;
    for (const double value : {radius, height, crouchedHeight, stepHeight, steepest, mass, walkSpeed, crouchSpeed,
                               jumpSpeed, swimSpeed, pushForce})
        add(hash, value);
    for (const glm::dvec3& value : {wish, position, velocity}) add(hash, value);
    const uint64_t flags = uint64_t(wantsJump) | uint64_t(wantsCrouch) << 1 | uint64_t(grounded) << 2 |
                           uint64_t(crouched) << 3 | uint64_t(swimming) << 4;
    return hashValue(flags | uint64_t(collisionLayer) << 8 | uint64_t(collisionMask) << 16,
                     hashValue(ground ? ground.slot() + 1 : 0, hash));
}

}  // namespace rubble
