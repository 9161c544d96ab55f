#include "runtime/destruction/components.h"

#include <algorithm>

#include "runtime/core/union_find.h"
#include "runtime/destruction/run_label_sizes.h"

// Connected component labelling in three levels, each cached where it does not change: the components of each brick
// (flood fill on words of bits, brick_parts.cpp), those of each node (union-find over its bricks' components,
// node_parts.cpp), and here a union-find over the nodes' components. Two components of neighbouring nodes are one if
// the AND of their cells on the common face is not zero. After an edit only changed bricks and nodes are labelled
// again. Roots are lowest members (see UnionFind) and nodes are visited in order, so the result depends on the grid
// alone. Labelling with union-find: A. Rosenfeld and J. Pfaltz, JACM 13 (1966), 471-494.

namespace rubble {
namespace {

/// The nodes of a grid with their components numbered consecutively, and which of those are connected.
struct GridNodes {
    std::vector<glm::ivec3> positions;
    std::vector<const BrickNode*> nodes;
    std::vector<uint32_t> firstPart;  ///< by node: the number of its first component; one more entry at the end
    UnionFind<> sets;                 ///< of node components

    explicit GridNodes(const VoxelGrid& grid) : firstPart(1) {
        const glm::ivec3 size = grid.sizeInNodes();
        const auto index = [&](glm::ivec3 node) { return (size_t(node.z) * size.y + node.y) * size.x + node.x; };
        std::vector<uint32_t> numbers(size_t(size.x) * size.y * size.z);  // in `nodes`, by index of the node
        grid.forEachNode([&](glm::ivec3 position, const BrickNode& node) {
            const uint32_t first = firstPart.back();
            numbers[index(position)] = uint32_t(nodes.size());
            positions.push_back(position);
            nodes.push_back(&node);
            firstPart.push_back(first + nodeParts(node).count);
            sets.grow(firstPart.back());
            for (const size_t face : {0, 2, 4}) {  // towards the nodes visited before
                const glm::ivec3 neighbor = position + kFaceOffsets[face];
                if (const BrickNode* other = grid.nodeAt(neighbor))
                    forEachContact(node, *other, face, [&](uint16_t a, uint16_t b) {
                        sets.unite(first + a, firstPart[numbers[index(neighbor)]] + b);
                        return true;
                    });
            }
        });
    }
};

glm::ivec3 lowestCell(glm::ivec3 brick, const BrickBits& voxels) {
    int z = 0;
    while (!voxels[size_t(z)]) ++z;
    const int bit = std::countr_zero(voxels[size_t(z)]);
    return brick * kBrickSize + voxelInBrick(64 * z + bit);
}

/// Whether bricks have so many components, on average over a sample of bricks, that run-length labelling is faster.
bool hasManyParts(const VoxelGrid& grid) {
    constexpr size_t kSampleStride = 251, kMaxMeanParts = 12;
    size_t bricks = 0, sampled = 0, parts = 0;
    std::vector<BrickPart> scratch;
    grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
        if (bricks++ % kSampleStride) return;
        ++sampled;
        parts += brickParts(*brick, scratch).size();
    });
    return parts > kMaxMeanParts * sampled;
}

}  // namespace

CellBox voxelBounds(glm::ivec3 brick, const BrickBits& voxels) {
    uint64_t layers = 0;
    glm::ivec3 low(0, 0, 8), high(0);
    for (int z = 0; z < 8; ++z) {
        if (!voxels[size_t(z)]) continue;
        layers |= voxels[size_t(z)];
        low.z = std::min(low.z, z);
        high.z = z + 1;
    }
    uint64_t row = layers | layers >> 32;
    row |= row >> 16;
    row = (row | row >> 8) & 0xff;
    low.x = std::countr_zero(row);
    high.x = 64 - std::countl_zero(row);
    low.y = std::countr_zero(layers) / 8;
    high.y = (63 - std::countl_zero(layers)) / 8 + 1;
    return {brick * kBrickSize + low, brick * kBrickSize + high};
}

bool isLargerComponent(const Component& a, const Component& b) {
    return a.voxels != b.voxels ? a.voxels > b.voxels : cellBefore(a.lowest, b.lowest);
}

void addNode(glm::ivec3 position, const BrickNode& node, std::span<Component* const> componentOfPart) {
    const NodeParts& parts = nodeParts(node);
    for (size_t i = 0; i < parts.count; ++i)
        if (componentOfPart[i]) componentOfPart[i]->voxels += parts.voxels[i];
    if (parts.count == 1) {
        if (componentOfPart[0]) componentOfPart[0]->nodes.push_back({position, node.mask});
        return;
    }
    std::vector<BrickPart> scratch;
    forEachChild(node.mask, [&](int child) {
        const glm::ivec3 brick = position * kNodeBricks + childPosition(child);
        const size_t first = parts.detail->firstPart[size_t(child)], end = parts.detail->firstPart[size_t(child) + 1];
        const auto owner = [&](size_t part) { return componentOfPart[parts.detail->component[part]]; };
        bool isWhole = true;
        for (size_t i = first + 1; i < end; ++i) isWhole = isWhole && owner(i) == owner(first);
        if (isWhole) {
            Component* component = owner(first);
            if (!component) return;
            if (component->nodes.empty() || component->nodes.back().node != position)
                component->nodes.push_back({position, 0});
            component->nodes.back().bricks |= BrickMask(1) << child;
            return;
        }
        const auto cells = brickParts(*node.bricks[size_t(child)], scratch);
        for (size_t i = first; i < end; ++i) {
            Component* component = owner(i);
            if (!component) continue;
            if (component->subsets.empty() || component->subsets.back().brick != brick)
                component->subsets.push_back({brick, {}});
            for (size_t z = 0; z < 8; ++z) component->subsets.back().voxels[z] |= cells[i - first].voxels[z];
        }
    });
}

glm::ivec3 findLowest(const Component& component, const VoxelGrid& grid) {
    glm::ivec3 best(kMaxGridSize);
    const auto look = [&](glm::ivec3 brick, const BrickBits& voxels) {
        if (cellBefore(best, brick * kBrickSize)) return;
        if (const glm::ivec3 cell = lowestCell(brick, voxels); cellBefore(cell, best)) best = cell;
    };
    for (const BrickSubset& subset : component.subsets) look(subset.brick, subset.voxels);
    for (const NodeSubset& subset : component.nodes) {
        if (cellBefore(best, subset.node * kNodeSize)) continue;
        const BrickNode& node = *grid.nodeAt(subset.node);
        forEachChild(subset.bricks, [&](int child) {
            look(subset.node * kNodeBricks + childPosition(child), node.bricks[size_t(child)]->occupancy);
        });
    }
    return best;
}

std::vector<Component> findComponents(const VoxelGrid& grid) {
    GridNodes all(grid);
    UnionFind<>& sets = all.sets;
    size_t count = 0;
    for (uint32_t i = 0; i < sets.size(); ++i) count += sets.root(i) == i;
    std::vector<Component> out(count);
    std::vector<Component*> owners(sets.size());
    size_t next = 0;
    for (uint32_t i = 0; i < owners.size(); ++i) {
        const uint32_t root = sets.root(i);  // <= i, so it has its component already
        owners[i] = root == i ? &out[next++] : owners[root];
    }
    for (uint32_t n = 0; n < all.nodes.size(); ++n)
        addNode(all.positions[n], *all.nodes[n],
                std::span(owners).subspan(all.firstPart[n], all.firstPart[n + 1] - all.firstPart[n]));
    for (Component& component : out) component.lowest = findLowest(component, grid);
    std::sort(out.begin(), out.end(),
              [](const Component& a, const Component& b) { return cellBefore(a.lowest, b.lowest); });
    return out;
}

std::vector<uint64_t> componentSizes(const VoxelGrid& grid) {
    if (hasManyParts(grid)) return componentSizesByRuns(grid);
    GridNodes all(grid);
    UnionFind<>& sets = all.sets;
    std::vector<uint64_t> out;
    std::vector<uint32_t> numbers(sets.size());
    for (uint32_t n = 0; n < all.nodes.size(); ++n)
        for (uint32_t i = all.firstPart[n]; i < all.firstPart[n + 1]; ++i) {
            const uint32_t root = sets.root(i);
            if (root == i) {
                numbers[i] = uint32_t(out.size());
                out.push_back(0);
            } else {
                numbers[i] = numbers[root];
            }
            out[numbers[i]] += nodeParts(*all.nodes[n]).voxels[i - all.firstPart[n]];
        }
    return out;
}

MassMoments componentMoments(const VoxelGrid& grid, const Component& component, const Densities& densities) {
    MassMoments sum;
    for (const NodeSubset& subset : component.nodes) {
        const BrickNode& node = *grid.nodeAt(subset.node);
        if (subset.bricks == node.mask) {
            sum += nodeMoments(node, subset.node, densities);
            continue;
        }
        forEachChild(subset.bricks, [&](int child) {
            const Brick& brick = *node.bricks[size_t(child)];
            sum += brickMoments(brick, brick.occupancy, subset.node * kNodeBricks + childPosition(child), densities);
        });
    }
    for (const BrickSubset& subset : component.subsets)
        sum += brickMoments(*grid.brickAt(subset.brick), subset.voxels, subset.brick, densities);
    return sum;
}

}  // namespace rubble
