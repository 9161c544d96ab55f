#include "runtime/world/objects/trigger.h"

#include "runtime/world/objects/object_hash.h"

namespace rubble {

uint64_t Trigger::hash() const {
    uint64_t hash = hashValue(uint64_t(kind) << 8 | layerMask);
    addToHash(hash, pose);
    for (const double value : {radius, height}) addToHash(hash, value);
    addToHash(hash, halfSize);
    addToHash(hash, outline);
    for (const BodyHandle body : inside) hash = hashValue(body.slot(), hash);
    return hash;
}

WorldBox Trigger::bounds() const {
    if (kind == TriggerKind::Sphere) return {pose.position - radius, pose.position + radius};
    if (kind == TriggerKind::Box) return boundsOfBox(pose.position, halfSize, pose.rotation);
    WorldBox box{{1e30, 0.0, 1e30}, {-1e30, height, -1e30}};
    for (const GroundPoint& p : outline) {
        box.low = glm::min(box.low, {p.x, 0.0, p.z});
        box.high = glm::max(box.high, {p.x, height, p.z});
    }
    return {pose.position + box.low, pose.position + box.high};
}

}  // namespace rubble
