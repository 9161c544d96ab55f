#include "runtime/destruction/components.h"

#include <algorithm>

namespace rubble {
namespace {

/// Numbers the bricks of a grid: a mask and a running count for each 4x4x4 of them, small even for a huge sparse grid.
class BrickNumbers {
public:
    explicit BrickNumbers(const VoxelGrid& grid) : m_size((grid.sizeInBricks() + 3) / 4) {
        m_blocks.resize(size_t(m_size.x) * m_size.y * m_size.z);
        grid.forEachBrick([&](glm::ivec3 brick, const BrickRef&) { block(brick).mask |= bit(brick); });
        uint32_t start = 0;
        for (Block& each : m_blocks) {
            each.start = start;
            start += uint32_t(std::popcount(each.mask));
        }
    }
    static constexpr uint32_t kNone = ~0u;
    uint32_t find(glm::ivec3 brick) const {
        if (brick.x < 0 || brick.y < 0 || brick.z < 0) return kNone;
        const glm::ivec3 at = brick >> 2;
        if (at.x >= m_size.x || at.y >= m_size.y || at.z >= m_size.z) return kNone;
        const Block& found = const_cast<BrickNumbers*>(this)->block(brick);
        return found.mask & bit(brick) ? found.start + uint32_t(std::popcount(found.mask & (bit(brick) - 1))) : kNone;
    }

private:
    struct Block {
        uint64_t mask = 0;
        uint32_t start = 0;
    };
    static uint64_t bit(glm::ivec3 brick) { return uint64_t(1) << ((brick.x & 3) + (brick.y & 3) * 4 + (brick.z & 3) * 16); }
    Block& block(glm::ivec3 brick) { return m_blocks[(size_t(brick.z >> 2) * m_size.y + (brick.y >> 2)) * m_size.x + (brick.x >> 2)]; }
    glm::ivec3 m_size;
    std::vector<Block> m_blocks;
};

struct UnionFind {
    std::vector<uint32_t> parent;
    uint32_t root(uint32_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    }
    void unite(uint32_t a, uint32_t b) {
        a = root(a), b = root(b);
        if (a != b) parent[std::max(a, b)] = std::min(a, b);
    }
};

/// The parts of all bricks, brick after brick by number.
struct GridParts {
    std::vector<BrickPart> parts;
    std::vector<glm::ivec3> bricks;   ///< position by brick number
    std::vector<uint32_t> firstPart;  ///< by brick number; one more at the end
};

GridParts collectParts(const VoxelGrid& grid, const BrickNumbers& numbers) {
    std::vector<const Brick*> contents(grid.brickCount());
    GridParts out;
    out.bricks.resize(grid.brickCount());
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        const uint32_t number = numbers.find(position);
        contents[number] = brick.get();
        out.bricks[number] = position;
    });
    out.parts.reserve(contents.size());
    for (const Brick* brick : contents) {
        out.firstPart.push_back(uint32_t(out.parts.size()));
        findBrickParts(brick->occupancy, out.parts);
    }
    out.firstPart.push_back(uint32_t(out.parts.size()));
    return out;
}

UnionFind joinParts(const GridParts& all, const BrickNumbers& numbers) {
    UnionFind sets;
    sets.parent.resize(all.parts.size());
    for (uint32_t i = 0; i < sets.parent.size(); ++i) sets.parent[i] = i;
    for (uint32_t number = 0; number < all.bricks.size(); ++number)
        for (size_t face = 1; face < 6; face += 2) {
            const uint32_t other = numbers.find(all.bricks[number] + kFaceSteps[face]);
            if (other == BrickNumbers::kNone) continue;
            for (uint32_t a = all.firstPart[number]; a < all.firstPart[number + 1]; ++a)
                for (uint32_t b = all.firstPart[other]; all.parts[a].faces[face] && b < all.firstPart[other + 1]; ++b)
                    if (all.parts[a].faces[face] & all.parts[b].faces[face - 1]) sets.unite(a, b);
        }
    return sets;
}

}  // namespace

glm::ivec3 lowestCell(const BrickShare& share) {
    int z = 0;
    while (!share.voxels[size_t(z)]) ++z;
    const int bit = std::countr_zero(share.voxels[size_t(z)]);
    return share.brick * kBrickSize + glm::ivec3(bit & 7, bit >> 3, z);
}

bool outranks(const Component& a, const Component& b) {
    return a.voxels != b.voxels ? a.voxels > b.voxels : cellBefore(a.lowest, b.lowest);
}

std::vector<Component> findComponents(const VoxelGrid& grid) {
    const BrickNumbers numbers(grid);
    const GridParts all = collectParts(grid, numbers);
    UnionFind sets = joinParts(all, numbers);
    std::vector<Component> out;
    std::vector<uint32_t> componentOf(all.parts.size());
    for (uint32_t number = 0; number < all.bricks.size(); ++number)
        for (uint32_t i = all.firstPart[number]; i < all.firstPart[number + 1]; ++i) {
            const uint32_t root = sets.root(i);
            if (root == i) {  // a set's root is its first part
                componentOf[i] = uint32_t(out.size());
                out.emplace_back();
            }
            Component& component = out[componentOf[root]];
            // Two parts of a brick may meet outside it: they are one share then.
            if (!component.shares.empty() && component.shares.back().brick == all.bricks[number])
                for (size_t z = 0; z < 8; ++z) component.shares.back().voxels[z] |= all.parts[i].voxels[z];
            else
                component.shares.push_back({all.bricks[number], all.parts[i].voxels});
        }
    for (Component& component : out) {
        component.lowest = lowestCell(component.shares.front());
        for (const BrickShare& share : component.shares) {
            for (uint64_t layer : share.voxels) component.voxels += uint64_t(std::popcount(layer));
            if (const glm::ivec3 cell = lowestCell(share); cellBefore(cell, component.lowest)) component.lowest = cell;
        }
    }
    std::sort(out.begin(), out.end(), [](const Component& a, const Component& b) { return cellBefore(a.lowest, b.lowest); });
    return out;
}

}  // namespace rubble
