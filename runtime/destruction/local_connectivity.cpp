#include "runtime/destruction/local_connectivity.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <optional>

#include "runtime/core/union_find.h"
#include "runtime/destruction/box_connectivity.h"
#include "runtime/voxel/cell_box.h"

// Most cuts detach nothing, and a look at their surroundings proves it: union-find over the components of the carved
// bricks and of the bricks that share a face with one. If all components that touch a carved brick are in one set,
// whatever was connected through the removed voxels is still connected.

namespace rubble {
namespace {

constexpr int kMaxBricks = 343;      ///< in the box around the cut: AttachmentSearch is better for a larger cut
constexpr uint8_t kCarved = 1 << 6;  ///< a role: the brick was carved
constexpr uint8_t kAllFaces = 0x3f;  ///< a role: one bit for each face beyond which a carved brick lies

/// The bricks around a cut: the carved bricks, and those that share a face with one. Arrays are by brickIndex().
struct Surroundings {
    CellBox box;                                               ///< of bricks
    std::array<uint8_t, kMaxBricks> roles{};                   ///< 0: neither carved nor beside a carved brick
    std::array<std::span<const BrickPart>, kMaxBricks> parts;  ///< components of the bricks with a role
    std::array<uint16_t, kMaxBricks + 1> firstPart{};          ///< number of a brick's first component

    glm::ivec3 size() const { return box.high - box.low; }
    int brickCount() const { return size().x * size().y * size().z; }
    int brickIndex(glm::ivec3 brick) const {
        const glm::ivec3 at = brick - box.low;
        return (at.z * size().y + at.y) * size().x + at.x;
    }
    bool contains(glm::ivec3 brick) const {
        return glm::all(glm::greaterThanEqual(brick, box.low)) && glm::all(glm::lessThan(brick, box.high));
    }
};

/// The bricks within one brick of a carved one.
CellBox boxAround(const VoxelGrid& grid, const BrickSet& carved) {
    CellBox box{grid.sizeInBricks(), glm::ivec3(0)};
    carved.forEachNode([&](glm::ivec3 node, BrickMask bricks) {
        forEachChild(bricks, [&](int child) {
            const glm::ivec3 brick = node * kNodeBricks + childPosition(child);
            box = {glm::min(box.low, brick - 1), glm::max(box.high, brick + 2)};
        });
    });
    return {glm::max(box.low, 0), glm::min(box.high, grid.sizeInBricks())};
}

/// Labels the bricks. False if one has so many components that it does not cache them.
bool findParts(const VoxelGrid& grid, Surroundings& near) {
    std::vector<BrickPart> scratch;
    int brickIndex = 0;
    for (int z = near.box.low.z; z < near.box.high.z; ++z)
        for (int y = near.box.low.y; y < near.box.high.y; ++y)
            for (int x = near.box.low.x; x < near.box.high.x; ++x, ++brickIndex) {
                auto& parts = near.parts[size_t(brickIndex)];
                if (near.roles[size_t(brickIndex)])
                    if (const Brick* brick = grid.brickAt({x, y, z})) parts = brickParts(*brick, scratch);
                if (!parts.empty() && parts.data() == scratch.data()) return false;
                near.firstPart[size_t(brickIndex) + 1] = uint16_t(near.firstPart[size_t(brickIndex)] + parts.size());
            }
    return true;
}

/// Unites the components that touch along an axis.
void joinAlong(const Surroundings& near, size_t axis, UnionFind<uint16_t>& sets) {
    const int step = axis == 0 ? 1 : axis == 1 ? near.size().x : near.size().x * near.size().y;
    const size_t face = 2 * axis + 1;
    for (int brickIndex = 0; brickIndex + step < near.brickCount(); ++brickIndex) {
        const auto a = near.parts[size_t(brickIndex)], b = near.parts[size_t(brickIndex + step)];
        if (a.empty() || b.empty() || brickIndex / step % near.size()[int(axis)] == near.size()[int(axis)] - 1)
            continue;
        forEachTouchingPair(a, b, face, [&](size_t i, size_t j) {
            sets.unite(uint16_t(near.firstPart[size_t(brickIndex)] + i),
                       uint16_t(near.firstPart[size_t(brickIndex + step)] + j));
            return true;
        });
    }
}

}  // namespace

bool isLocallyConnected(const VoxelGrid& grid, const CellBox& lost, std::span<const CellBox> anchors) {
    if (lost.empty()) return false;
    const CellBox box{glm::max(lost.low - 1, 0), glm::min(lost.high + 1, grid.size())};
    for (const CellBox& anchor : anchors)
        if (glm::all(glm::lessThan(anchor.low, lost.high)) && glm::all(glm::lessThan(lost.low, anchor.high)))
            return false;
    return isConnectedInBox(grid, box);
}

bool isLocallyConnected(const VoxelGrid& grid, const BrickSet& carved) {
    Surroundings near;
    near.box = boxAround(grid, carved);
    if (near.box.empty() || near.size().x > kMaxBricks || near.size().y > kMaxBricks || near.brickCount() > kMaxBricks)
        return false;
    carved.forEach([&](glm::ivec3 brick) {
        near.roles[size_t(near.brickIndex(brick))] |= kCarved | kAllFaces;
        for (size_t face = 0; face < 6; ++face)
            if (const glm::ivec3 other = brick + kFaceOffsets[face]; near.contains(other))
                near.roles[size_t(near.brickIndex(other))] |= uint8_t(1 << (face ^ 1));
    });
    if (!findParts(grid, near)) return false;
    UnionFind<uint16_t> sets(near.firstPart[size_t(near.brickCount())]);
    for (size_t axis = 0; axis < 3; ++axis) joinAlong(near, axis, sets);
    std::optional<uint16_t> whole;
    for (int brickIndex = 0; brickIndex < near.brickCount(); ++brickIndex)
        for (size_t i = 0; i < near.parts[size_t(brickIndex)].size(); ++i) {
            const uint8_t role = near.roles[size_t(brickIndex)];
            bool touches = role & kCarved;
            for (size_t face = 0; face < 6 && !touches; ++face)
                touches = (role >> face & 1) && near.parts[size_t(brickIndex)][i].faces[face];
            if (!touches) continue;
            const uint16_t set = sets.root(uint16_t(near.firstPart[size_t(brickIndex)] + i));
            if (whole && *whole != set) return false;
            whole = set;
        }
    return true;
}

}  // namespace rubble
