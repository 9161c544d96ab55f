#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/mass_properties.h"
#include "runtime/voxel/node_parts.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// Bricks of one directory node that belong to a component with all that they hold.
struct NodeSubset {
    glm::ivec3 node;
    BrickMask bricks = 0;
};

/// A component's subset of a brick that others have voxels in, too.
struct BrickSubset {
    glm::ivec3 brick;
    BrickBits voxels;
};

/// A 6-connected set of voxels of one grid.
struct Component {
    std::vector<NodeSubset> nodes;     ///< each node once at most
    std::vector<BrickSubset> subsets;  ///< each brick once at most, and none that is in `nodes`
    uint64_t voxels = 0;
    glm::ivec3 lowest{0};  ///< the cell that comes first by z, then y, then x
};

/// The smallest box of cells that holds these voxels of a brick, which are some.
CellBox voxelBounds(glm::ivec3 brick, const BrickBits& voxels);

/// Whether cell a comes before cell b, by z, then y, then x.
inline bool cellBefore(glm::ivec3 a, glm::ivec3 b) {
    return a.z != b.z ? a.z < b.z : a.y != b.y ? a.y < b.y : a.x < b.x;
}
/// Which of two components keeps the name of what they came from: the larger, else the one with the lowest cell.
bool outranks(const Component& a, const Component& b);

/// Adds a node's voxels to the components that its parts (see NodeParts) belong to; null for those of no interest.
/// Once a node and component; leaves `lowest` alone.
void addNode(glm::ivec3 position, const BrickNode& node, std::span<Component* const> componentOfPart);
/// The component's lowest cell, from its subsets.
glm::ivec3 findLowest(const Component& component, const VoxelGrid& grid);

/// All components of a grid, ordered by their lowest cell. Components inside bricks, of these inside nodes, then a
/// union-find over the faces between nodes (Tarjan 1975, path halving).
std::vector<Component> findComponents(const VoxelGrid& grid);

/// The voxels of each component alone, in an order that depends on nothing but the grid: the labelling without subsets.
std::vector<uint64_t> componentSizes(const VoxelGrid& grid);

MassMoments componentMoments(const VoxelGrid& grid, const Component& component, const Densities& densities);

/// Calls f(ivec3 brick, const Brick&, const BrickBits& voxels) for every brick that holds some of the component.
template <class F>
void forEachSubset(const VoxelGrid& grid, const Component& component, F&& f) {
    for (const NodeSubset& subset : component.nodes) {
        const BrickNode& node = *grid.nodeAt(subset.node);
        forEachChild(subset.bricks, [&](int child) {
            const Brick& brick = *node.bricks[size_t(child)];
            f(subset.node * kNodeBricks + childPosition(child), brick, brick.occupancy);
        });
    }
    for (const BrickSubset& subset : component.subsets) f(subset.brick, *grid.brickAt(subset.brick), subset.voxels);
}

}  // namespace rubble
