#include "runtime/voxel/brick_node.h"

#include "runtime/core/hash.h"
#include "runtime/voxel/mass_properties.h"
#include "runtime/voxel/node_parts.h"

namespace rubble {

BrickNode::BrickNode() = default;
BrickNode::BrickNode(const BrickNode& other)
    : mask(other.mask), full(other.full), voxels(other.voxels), hash(other.hash), bricks(other.bricks) {}
BrickNode::~BrickNode() = default;

void BrickNode::set(int child, BrickRef value) {
    cachedParts.forget();
    cachedMoments.forget();
    const BrickMask bit = BrickMask(1) << child;
    BrickRef& place = bricks[size_t(child)];
    if (place) {
        voxels -= uint32_t(place->count());
        hash -= hashValue(child, hashBrick(*place));
    }
    mask &= ~bit, full &= ~bit;
    place = value && value->count() ? std::move(value) : nullptr;
    if (!place) return;
    mask |= bit;
    if (place->full()) full |= bit;
    voxels += uint32_t(place->count());
    hash += hashValue(child, hashBrick(*place));
}

}  // namespace rubble
