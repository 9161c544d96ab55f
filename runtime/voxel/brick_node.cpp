#include "runtime/voxel/brick_node.h"

#include "runtime/core/hash.h"
#include "runtime/voxel/mass_properties.h"
#include "runtime/voxel/node_parts.h"
#include "runtime/voxel/used_entries.h"

namespace rubble {

BrickNode::BrickNode() = default;
BrickNode::BrickNode(const BrickNode& other)
    : mask(other.mask), full(other.full), voxels(other.voxels), hash(other.hash), bricks(other.bricks) {}
BrickNode::~BrickNode() = default;

void BrickNode::set(int child, BrickRef value) {
    cachedParts.forget();
    cachedMoments.forget();
    cachedEntries.forget();
    const BrickMask bit = BrickMask(1) << child;
    BrickRef& brick = bricks[size_t(child)];
    if (brick) {
        voxels -= uint32_t(brick->count());
        hash -= hashValue(child, hashBrick(*brick));
    }
    mask &= ~bit, full &= ~bit;
    brick = value && value->count() ? std::move(value) : nullptr;
    if (!brick) return;
    mask |= bit;
    if (brick->full()) full |= bit;
    voxels += uint32_t(brick->count());
    hash += hashValue(child, hashBrick(*brick));
}

}  // namespace rubble
