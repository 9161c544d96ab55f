#include "runtime/destruction/split.h"

#include <bit>
#include <glm/common.hpp>

#include "runtime/core/planted_fault.h"

namespace rubble {
namespace {

/// The smallest box that holds a component. Looks only into bricks that can widen it.
CellBox componentBounds(const VoxelGrid& grid, const Component& component) {
    CellBox bounds{component.lowest, component.lowest + 1};
    const auto isInside = [&](glm::ivec3 low, int size) {
        return glm::all(glm::greaterThanEqual(low, bounds.low)) &&
               glm::all(glm::lessThanEqual(low + size, bounds.high));
    };
    const auto widen = [&](glm::ivec3 brick, const BrickBits& voxels) {
        if (isInside(brick * kBrickSize, kBrickSize)) return;
        bounds = joined(bounds, voxelBounds(brick, voxels));
    };
    for (const BrickSubset& subset : component.subsets) widen(subset.brick, subset.voxels);
    for (const NodeSubset& subset : component.nodes) {
        if (isInside(subset.node * kNodeSize, kNodeSize)) continue;
        const BrickNode& node = *grid.nodeAt(subset.node);
        forEachChild(subset.bricks, [&](int child) {
            widen(subset.node * kNodeBricks + childPosition(child), node.bricks[size_t(child)]->occupancy);
        });
    }
    return bounds;
}

/// Whether a node with several bricks belongs to the component as a whole.
bool hasWholeNode(const VoxelGrid& grid, const Component& component) {
    for (const NodeSubset& subset : component.nodes)
        if (std::popcount(subset.bricks) > 1 && grid.nodeAt(subset.node)->mask == subset.bricks) return true;
    return false;
}

}  // namespace

Piece takePiece(VoxelGrid& grid, const Component& component) {
    const CellBox bounds = componentBounds(grid, component);
    Piece piece;
    const int unit =
        glm::any(glm::greaterThan(bounds.high - bounds.low, glm::ivec3(kNodeSize))) && hasWholeNode(grid, component)
            ? kNodeSize
            : kBrickSize;
    piece.offset = bounds.low / unit * unit;
    piece.grid = VoxelGrid(bounds.high - piece.offset);
    const glm::ivec3 offsetBricks = piece.offset / kBrickSize;
    for (const NodeSubset& subset : component.nodes) {
        if (unit == kNodeSize && grid.nodeAt(subset.node)->mask == subset.bricks) {
            piece.grid.putNode(subset.node - piece.offset / kNodeSize, grid.takeNode(subset.node));
            continue;
        }
        forEachChild(subset.bricks, [&](int child) {
            const glm::ivec3 brick = subset.node * kNodeBricks + childPosition(child);
            piece.grid.setBrick(brick - offsetBricks, grid.shareBrick(brick));
            grid.setBrick(brick, nullptr);
        });
    }
    for (const BrickSubset& subset : component.subsets) {
        const BrickRef brick = grid.shareBrick(subset.brick);
        BrickBits rest;
        for (size_t z = 0; z < 8; ++z) rest[z] = brick->occupancy[z] & ~subset.voxels[z];
        grid.setBrick(subset.brick, maskBrick(*brick, rest));
        BrickBits taken = subset.voxels;
        if (isPlanted("lost-voxel")) taken[0] &= taken[0] - 1;
        piece.grid.setBrick(subset.brick - offsetBricks, maskBrick(*brick, taken));
    }
    return piece;
}

CellBox filledBounds(const VoxelGrid& grid) {
    Component all;
    grid.forEachNode([&](glm::ivec3 position, const BrickNode& node) { all.nodes.push_back({position, node.mask}); });
    all.lowest = findLowest(all, grid);
    return componentBounds(grid, all);
}

VoxelGrid cropped(const VoxelGrid& grid, const CellBox& box) {
    VoxelGrid out(box.high - box.low);
    GridWriter writer(out);
    const bool isAligned = cellInBrick(box.low) == glm::ivec3(0);
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        const glm::ivec3 cell = position * kBrickSize;
        const bool isInside =
            glm::all(glm::greaterThanEqual(cell, box.low)) && glm::all(glm::lessThanEqual(cell + kBrickSize, box.high));
        if (isAligned && isInside) return out.setBrick(brickOfCell(cell - box.low), brick);
        forEachVoxel(brick->occupancy,
                     [&](int i) { writer.set(cell + voxelInBrick(i) - box.low, brick->at(i), brick->paintAt(i)); });
    });
    writer.flush();
    return out;
}

}  // namespace rubble
