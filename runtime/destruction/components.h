#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/mass_properties.h"
#include "runtime/voxel/node_parts.h"
#include "runtime/voxel/voxel_grid.h"

namespace rubble {

/// Bricks of one directory node of which all voxels belong to a component.
struct NodeSubset {
    glm::ivec3 node;
    BrickMask bricks = 0;
};

/// Some voxels of one brick.
struct BrickSubset {
    glm::ivec3 brick;
    BrickBits voxels;
};

/// A 6-connected set of voxels of one grid.
struct Component {
    std::vector<NodeSubset> nodes;     ///< whole bricks; each node at most once
    std::vector<BrickSubset> subsets;  ///< parts of bricks that hold other voxels too; each brick at most once
    uint64_t voxels = 0;               ///< their number
    glm::ivec3 lowest{0};              ///< the cell that is first by cellBefore()
};

/// The smallest box that holds these voxels of a brick, at least one. In cells of the grid.
CellBox voxelBounds(glm::ivec3 brick, const BrickBits& voxels);

/// Whether cell `a` comes before cell `b` by z, then y, then x.
inline bool cellBefore(glm::ivec3 a, glm::ivec3 b) {
    return a.z != b.z ? a.z < b.z : a.y != b.y ? a.y < b.y : a.x < b.x;
}
/// Which of two components stays when a shape splits: the one of more voxels; of equal ones that with the lower cell.
bool isLargerComponent(const Component& a, const Component& b);

/// Adds the voxels of a node to the components that its parts (see NodeParts) belong to; null skips a part. Call it
/// once for each node. Does not update Component::lowest.
void addNode(glm::ivec3 position, const BrickNode& node, std::span<Component* const> componentOfPart);
/// The first cell of a component by cellBefore().
glm::ivec3 findLowest(const Component& component, const VoxelGrid& grid);

/// The 6-connected components of a grid, ordered by their lowest cell. The algorithm is at the top of components.cpp.
std::vector<Component> findComponents(const VoxelGrid& grid);

/// The voxels of each component, in an order that depends only on the grid. Cheaper than findComponents().
std::vector<uint64_t> componentSizes(const VoxelGrid& grid);

/// The moments of a component's voxels, in cells of the grid.
MassMoments componentMoments(const VoxelGrid& grid, const Component& component, const Densities& densities);

/// Calls f(glm::ivec3 brick, const Brick&, const BrickBits& voxels) for every brick that holds voxels of the component.
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
