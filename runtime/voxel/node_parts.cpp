#include "runtime/voxel/node_parts.h"

#include "runtime/core/union_find.h"

// Connected components of a node: union-find over the parts of its bricks. Full bricks are connected by a flood on the
// node's mask, 64 bricks at a time; other neighbours by an AND of the faces of their parts.

namespace rubble {
namespace {

using PartSets = UnionFind<uint16_t>;

/// All full bricks that are connected to the seeds through full bricks.
BrickMask fillFull(BrickMask seeds, BrickMask full) {
    for (;;) {
        BrickMask grown = seeds;
        grown |= (grown << 1 & ~kFaceBricks[0]) | (grown >> 1 & ~kFaceBricks[1]);
        grown |= (grown << 4 & ~kFaceBricks[2]) | (grown >> 4 & ~kFaceBricks[3]);
        grown |= grown << 16 | grown >> 16;
        grown &= full;
        if (grown == seeds) return seeds;
        seeds = grown;
    }
}

void uniteFull(const BrickNode& node, const std::array<uint16_t, 65>& firstPart, PartSets& sets) {
    for (BrickMask left = node.full; left;) {
        const int first = std::countr_zero(left);
        const BrickMask reached = fillFull(left & -left, node.full);
        forEachChild(reached, [&](int child) { sets.unite(firstPart[size_t(child)], firstPart[size_t(first)]); });
        left &= ~reached;
    }
}

void uniteAcross(const BrickNode& node, size_t face, BrickPartCache& bricks, const std::array<uint16_t, 65>& firstPart,
                 PartSets& sets) {
    const int step = face == 1 ? 1 : face == 3 ? 4 : 16;
    BrickMask pairs = node.mask & ~kFaceBricks[face] & node.mask >> step;
    pairs &= ~(node.full & node.full >> step);  // uniteFull() has united these
    forEachChild(pairs, [&](int child) {
        forEachTouchingPair(bricks[child], bricks[child + step], face, [&](size_t i, size_t j) {
            sets.unite(uint16_t(firstPart[size_t(child)] + i), uint16_t(firstPart[size_t(child + step)] + j));
            return true;
        });
    });
}

std::unique_ptr<const NodeParts> findNodeParts(const BrickNode& node) {
    auto out = std::make_unique<NodeParts>();
    // Bricks are scattered in memory: fetch all of them into the cache at the same time.
    forEachChild(node.mask & ~node.full, [&](int child) {
        const Brick* brick = node.bricks[size_t(child)].get();
        __builtin_prefetch(&brick->occupancy);
        __builtin_prefetch(&brick->cachedParts);
    });
    BrickPartCache bricks(node);
    auto detail = std::make_unique<NodeParts::Detail>();
    for (int child = 0; child < 64; ++child)
        detail->firstPart[size_t(child) + 1] =
            uint16_t(detail->firstPart[size_t(child)] + (node.mask >> child & 1 ? bricks[child].size() : 0));
    PartSets sets(detail->firstPart[64]);
    uniteFull(node, detail->firstPart, sets);
    for (const size_t face : {1, 3, 5}) uniteAcross(node, face, bricks, detail->firstPart, sets);
    detail->component.resize(sets.size());
    for (size_t i = 0; i < sets.size(); ++i) {
        const uint16_t root = sets.root(uint16_t(i));  // <= i, so it has its component already
        detail->component[i] = root == i ? uint16_t(out->count++) : detail->component[root];
    }
    if (out->count == 1) {
        out->voxels = {node.voxels};
        return out;
    }
    out->voxels.resize(out->count);
    forEachChild(node.mask, [&](int child) {
        const auto parts = bricks[child];
        for (size_t i = 0; i < parts.size(); ++i) {
            uint32_t& sum = out->voxels[detail->component[detail->firstPart[size_t(child)] + i]];
            if (parts.size() == 1)
                sum += uint32_t(node.bricks[size_t(child)]->count());
            else
                for (const uint64_t layer : parts[i].voxels) sum += uint32_t(std::popcount(layer));
        }
    });
    out->detail = std::move(detail);
    return out;
}

}  // namespace

std::span<const BrickPart> BrickPartCache::operator[](int child) {
    auto& parts = m_parts[size_t(child)];
    const BrickMask bit = BrickMask(1) << child;
    if (m_known & bit) return parts;
    m_known |= bit;
    if (m_node.full & bit) return parts = fullBrickParts();  // without reading the brick
    parts = brickParts(*m_node.bricks[size_t(child)], m_scratch);
    if (parts.data() == m_scratch.data()) parts = m_kept.emplace_back(std::move(m_scratch));
    return parts;
}

const NodeParts& nodeParts(const BrickNode& node) {
    if (const NodeParts* known = node.cachedParts.find()) return *known;
    if (node.full == kAllBricks) {  // the most frequent node
        auto out = std::make_unique<NodeParts>();
        out->count = 1, out->voxels = {node.voxels};
        return node.cachedParts.keep(std::move(out));
    }
    return node.cachedParts.keep(findNodeParts(node));
}

}  // namespace rubble
