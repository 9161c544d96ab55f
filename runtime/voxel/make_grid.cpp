#include "runtime/voxel/make_grid.h"

#include <algorithm>
#include <cstring>
#include <glm/common.hpp>

#include "runtime/voxel/cell_box.h"

namespace rubble {
namespace {

/// Calls f(position) for each of the nodes or bricks of a box of them.
template <class F>
void forEachPosition(glm::ivec3 low, glm::ivec3 high, F&& f) {
    for (int z = low.z; z < high.z; ++z)
        for (int y = low.y; y < high.y; ++y)
            for (int x = low.x; x < high.x; ++x) f(glm::ivec3(x, y, z));
}

/// A node of which brickAt(brick) gives the bricks, null for empty ones.
template <class F>
NodeRef makeNode(glm::ivec3 node, glm::ivec3 sizeInBricks, F&& brickAt) {
    NodeRef out;
    const glm::ivec3 low = node * kNodeBricks;
    forEachPosition(low, glm::min(low + kNodeBricks, sizeInBricks), [&](glm::ivec3 brick) {
        if (BrickRef content = brickAt(brick)) out.own().set(childIndex(brick), std::move(content));
    });
    return out;
}

template <class F>
VoxelGrid makeGrid(glm::ivec3 size, F&& nodeAt) {
    VoxelGrid grid(size);
    forEachPosition(glm::ivec3(0), grid.sizeInNodes(), [&](glm::ivec3 node) {
        if (NodeRef content = nodeAt(grid, node)) grid.putNode(node, std::move(content));
    });
    return grid;
}

BrickRef fullBrick(uint8_t entry) {
    BrickIndices indices;
    indices.fill(entry);
    return makeBrick(indices);
}

enum class Part { None, Some, All };

/// A grid of one entry where covers(box) says Part::All; Part::Some is asked again for the parts of the box, down to
/// single cells, of which it is all or none.
template <class Covers>
VoxelGrid solidGrid(glm::ivec3 size, uint8_t entry, Covers&& covers) {
    const BrickRef full = fullBrick(entry);
    NodeRef fullNode;
    for (int i = 0; i < 64; ++i) fullNode.own().set(i, full);
    const auto partOf = [&](glm::ivec3 low, int cells) {
        const CellBox box{low, glm::min(low + cells, size)};
        const Part part = covers(box);
        return part == Part::All && box.high != low + cells ? Part::Some : part;
    };
    const auto brickAt = [&](glm::ivec3 brick) -> BrickRef {
        const glm::ivec3 low = brick * kBrickSize;
        const Part part = partOf(low, kBrickSize);
        if (part == Part::None) return nullptr;
        if (part == Part::All) return full;
        BrickIndices indices{};
        forEachPosition(low, glm::min(low + kBrickSize, size), [&](glm::ivec3 cell) {
            if (covers(CellBox{cell, cell + 1}) == Part::All) indices[size_t(voxelIndex(cellInBrick(cell)))] = entry;
        });
        return makeBrick(indices);
    };
    return makeGrid(size, [&](const VoxelGrid& grid, glm::ivec3 node) {
        const Part part = partOf(node * kNodeSize, kNodeSize);
        if (part == Part::None) return NodeRef();
        return part == Part::All ? fullNode : makeNode(node, grid.sizeInBricks(), brickAt);
    });
}

}  // namespace

VoxelGrid gridOf(glm::ivec3 size, std::span<const uint8_t> entries) {
    RUBBLE_ASSERT(entries.size() == size_t(size.x) * size_t(size.y) * size_t(size.z));
    const auto brickAt = [&](glm::ivec3 brick) {
        const glm::ivec3 low = brick * kBrickSize, cells = glm::min(size - low, kBrickSize);
        BrickIndices indices{};
        for (int z = 0; z < cells.z; ++z)
            for (int y = 0; y < cells.y; ++y) {
                const size_t from =
                    (size_t(low.z + z) * size_t(size.y) + size_t(low.y + y)) * size_t(size.x) + size_t(low.x);
                std::memcpy(&indices[size_t(voxelIndex({0, y, z}))], entries.data() + from, size_t(cells.x));
            }
        return makeBrick(indices);
    };
    return makeGrid(
        size, [&](const VoxelGrid& grid, glm::ivec3 node) { return makeNode(node, grid.sizeInBricks(), brickAt); });
}

VoxelGrid solidBox(glm::ivec3 size, uint8_t entry) {
    return solidGrid(size, entry, [](const CellBox&) { return Part::All; });
}

VoxelGrid solidEllipsoid(glm::ivec3 size, uint8_t entry) {
    // Centres of cells, doubled and about the middle: whole numbers, which the quotients below order exactly enough
    // on every machine, because each is rounded alike.
    const auto distance2 = [&](glm::ivec3 doubled) {
        double sum = 0.0;
        for (int a = 0; a < 3; ++a) sum += double(doubled[a] * doubled[a]) / double(size[a] * size[a]);
        return sum;
    };
    return solidGrid(size, entry, [&](const CellBox& box) {
        const glm::ivec3 first = 2 * box.low + 1 - size, last = 2 * box.high - 1 - size;
        glm::ivec3 nearest, farthest;
        for (int a = 0; a < 3; ++a) {
            nearest[a] = first[a] > 0 ? first[a] : last[a] < 0 ? last[a] : 0;
            farthest[a] = std::max(std::abs(first[a]), std::abs(last[a]));
        }
        if (distance2(nearest) > 1.0) return Part::None;
        return distance2(farthest) <= 1.0 ? Part::All : Part::Some;
    });
}

}  // namespace rubble
