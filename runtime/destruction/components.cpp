#include "runtime/destruction/components.h"

#include <algorithm>

#include "runtime/core/union_find.h"
#include "runtime/destruction/run_sets.h"

namespace rubble {
namespace {

/// The nodes of a grid, and their parts numbered one after the other.
struct GridNodes {
    std::vector<glm::ivec3> positions;
    std::vector<const BrickNode*> nodes;
    std::vector<uint32_t> firstPart;  ///< by node; one more at the end
    std::vector<uint32_t> places;     ///< by position: a node's number plus one

    explicit GridNodes(const VoxelGrid& grid) : firstPart(1), places(size_t(grid.sizeInNodes().x) * grid.sizeInNodes().y * grid.sizeInNodes().z) {
        grid.forEachNode([&](glm::ivec3 position, const BrickNode& node) {
            positions.push_back(position);
            nodes.push_back(&node);
            firstPart.push_back(firstPart.back() + nodeParts(node).count);
            places[place(grid, position)] = uint32_t(nodes.size());
        });
    }
    static size_t place(const VoxelGrid& grid, glm::ivec3 position) {
        return (size_t(position.z) * grid.sizeInNodes().y + position.y) * grid.sizeInNodes().x + position.x;
    }
};

UnionFind<> joinParts(const VoxelGrid& grid, const GridNodes& all) {
    UnionFind<> sets(all.firstPart.back());
    for (uint32_t n = 0; n < all.nodes.size(); ++n)
        for (size_t face = 1; face < 6; face += 2) {
            const glm::ivec3 position = all.positions[n] + kFaceSteps[face];
            const BrickNode* other = grid.nodeAt(position);
            if (!other) continue;
            const uint32_t firstOther = all.firstPart[all.places[GridNodes::place(grid, position)] - 1];
            forEachContact(*all.nodes[n], *other, face, [&](uint16_t a, uint16_t b) {
                sets.unite(all.firstPart[n] + a, firstOther + b);
                return true;
            });
        }
    return sets;
}

glm::ivec3 lowestCell(glm::ivec3 brick, const BrickBits& voxels) {
    int z = 0;
    while (!voxels[size_t(z)]) ++z;
    const int bit = std::countr_zero(voxels[size_t(z)]);
    return brick * kBrickSize + glm::ivec3(bit & 7, bit >> 3, z);
}

/// Whether bricks hold so many parts that parts are no short cut; by a look at some of them.
bool isNoise(const VoxelGrid& grid) {
    constexpr size_t kEvery = 61, kMany = 12;
    size_t bricks = 0, looked = 0, parts = 0;
    std::vector<BrickPart> scratch;
    grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
        if (bricks++ % kEvery) return;
        ++looked;
        parts += brickParts(*brick, scratch).size();
    });
    return parts > kMany * looked;
}

/// componentSizes() without parts: the bricks' bits, eight planes at a time, as rows across the grid.
std::vector<uint64_t> sizesByRuns(const VoxelGrid& grid) {
    const glm::ivec3 bricks = grid.sizeInBricks();
    RunSets sets(bricks * kBrickSize);
    const size_t rows = size_t(bricks.y) * kBrickSize, words = sets.wordsARow();
    std::vector<uint64_t> bits(kBrickSize * rows * words);
    glm::ivec3 brick(0);
    for (; brick.z < bricks.z; ++brick.z) {
        std::fill(bits.begin(), bits.end(), 0);
        for (brick.y = 0; brick.y < bricks.y; ++brick.y)
            for (brick.x = 0; brick.x < bricks.x; ++brick.x) {
                const Brick* content = grid.brickAt(brick);
                if (!content) continue;
                for (size_t row = 0; row < 64; ++row) {
                    const size_t place = (row / 8 * rows + size_t(brick.y) * 8 + row % 8) * words + size_t(brick.x) / 8;
                    bits[place] |= (content->occupancy[row / 8] >> 8 * (row % 8) & 0xff) << 8 * (brick.x % 8);
                }
            }
        for (size_t row = 0; row < kBrickSize * rows; ++row) sets.add(std::span(bits).subspan(row * words, words));
    }
    std::vector<uint64_t> voxels;
    sets.number(voxels);
    return voxels;
}

}  // namespace

bool outranks(const Component& a, const Component& b) {
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
            if (component->nodes.empty() || component->nodes.back().node != position) component->nodes.push_back({position, 0});
            component->nodes.back().bricks |= BrickMask(1) << child;
            return;
        }
        const auto cells = brickParts(*node.bricks[size_t(child)], scratch);
        for (size_t i = first; i < end; ++i) {
            Component* component = owner(i);
            if (!component) continue;
            if (component->shares.empty() || component->shares.back().brick != brick) component->shares.push_back({brick, {}});
            for (size_t z = 0; z < 8; ++z) component->shares.back().voxels[z] |= cells[i - first].voxels[z];
        }
    });
}

glm::ivec3 findLowest(const Component& component, const VoxelGrid& grid) {
    glm::ivec3 best(kMaxGridSize);
    const auto look = [&](glm::ivec3 brick, const BrickBits& voxels) {
        if (cellBefore(best, brick * kBrickSize)) return;
        if (const glm::ivec3 cell = lowestCell(brick, voxels); cellBefore(cell, best)) best = cell;
    };
    for (const BrickShare& share : component.shares) look(share.brick, share.voxels);
    for (const NodeShare& share : component.nodes) {
        if (cellBefore(best, share.node * kNodeSize)) continue;
        const BrickNode& node = *grid.nodeAt(share.node);
        forEachChild(share.bricks, [&](int child) { look(share.node * kNodeBricks + childPosition(child), node.bricks[size_t(child)]->occupancy); });
    }
    return best;
}

std::vector<Component> findComponents(const VoxelGrid& grid) {
    const GridNodes all(grid);
    UnionFind<> sets = joinParts(grid, all);
    size_t count = 0;
    for (uint32_t i = 0; i < sets.size(); ++i) count += sets.root(i) == i;
    std::vector<Component> out(count);
    std::vector<Component*> owners(sets.size());
    size_t next = 0;
    for (uint32_t i = 0; i < owners.size(); ++i) {
        const uint32_t root = sets.root(i);  // a set's root is its first part
        owners[i] = root == i ? &out[next++] : owners[root];
    }
    for (uint32_t n = 0; n < all.nodes.size(); ++n)
        addNode(all.positions[n], *all.nodes[n], std::span(owners).subspan(all.firstPart[n], all.firstPart[n + 1] - all.firstPart[n]));
    for (Component& component : out) component.lowest = findLowest(component, grid);
    std::sort(out.begin(), out.end(), [](const Component& a, const Component& b) { return cellBefore(a.lowest, b.lowest); });
    return out;
}

std::vector<uint64_t> componentSizes(const VoxelGrid& grid) {
    if (isNoise(grid)) return sizesByRuns(grid);
    const GridNodes all(grid);
    UnionFind<> sets = joinParts(grid, all);
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
    for (const NodeShare& share : component.nodes) {
        const BrickNode& node = *grid.nodeAt(share.node);
        if (share.bricks == node.mask) {
            sum += nodeMoments(node, share.node, densities);
            continue;
        }
        forEachChild(share.bricks, [&](int child) {
            const Brick& brick = *node.bricks[size_t(child)];
            sum += brickMoments(brick, brick.occupancy, share.node * kNodeBricks + childPosition(child), densities);
        });
    }
    for (const BrickShare& share : component.shares) sum += brickMoments(*grid.brickAt(share.brick), share.voxels, share.brick, densities);
    return sum;
}

}  // namespace rubble
