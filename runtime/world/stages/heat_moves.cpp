#include "runtime/world/stages/heat_moves.h"

#include <algorithm>
#include <bit>

#include "runtime/voxel/brick_box.h"

namespace rubble {
namespace {

/// Bricks of a shape that hold voxels of a brick of its parent.
struct Holder {
    ShapeHandle shape;
    glm::ivec3 brick;
    int64_t voxels;  ///< of the parent's brick
};

/// Appends the bricks of a grid that hold voxels of the cells [low, low + kBrickSize).
void findHolders(ShapeHandle shape, const VoxelGrid& grid, glm::ivec3 low, std::vector<Holder>& out) {
    const CellBox cells{low, low + kBrickSize};
    const glm::ivec3 first = glm::max(brickOfCell(low), 0),
                     last = glm::min(brickOfCell(low + kBrickSize - 1), grid.sizeInBricks() - 1);
    for (int z = first.z; z <= last.z; ++z)
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x) {
                const glm::ivec3 brick(x, y, z);
                const Brick* content = grid.brickAt(brick);
                if (!content) continue;
                const BrickBits inside = cellsInBox(brick, cells);
                int64_t voxels = 0;
                for (size_t i = 0; i < 8; ++i) voxels += std::popcount(content->occupancy[i] & inside[i]);
                if (voxels) out.push_back({shape, brick, voxels});
            }
}

/// Adds a part of a hot brick to a brick that may be hot already.
void addHeat(HotBrick& to, const HotBrick& part) {
    to.heat = std::min(to.heat + part.heat, kMaxHeat);
    to.burned = std::max(to.burned, part.burned);
    to.burningFor = std::max(to.burningFor, part.burningFor);
    to.wet = std::max(to.wet, part.wet);
    to.charred = std::max(to.charred, part.charred);
}

}  // namespace

void moveHeat(EditContext& context, const ShapeSplit& split) {
    FireState& fire = context.world.fire;
    const std::vector<HotBrick> before = fire.take(split.parent);
    if (before.empty()) return;
    std::vector<Holder> holders;
    for (const HotBrick& hot : before) {
        holders.clear();
        const glm::ivec3 low = hot.brick * kBrickSize;
        findHolders(split.parent, context.world.shapes.at(split.parent).grid, low, holders);
        for (size_t i = 0; i < split.children.size(); ++i)
            findHolders(split.children[i], context.world.shapes.at(split.children[i]).grid, low - split.parentOffset[i],
                        holders);
        int64_t sum = 0;
        for (const Holder& holder : holders) sum += holder.voxels;
        for (const Holder& holder : holders) {
            HotBrick part = hot;
            part.heat = hot.heat / sum * holder.voxels;
            addHeat(*fire.findOrAdd(holder.shape, holder.brick, ~0u), part);
        }
    }
    fire.compact();
}

void dropHeat(EditContext& context, ShapeHandle shape) {
    for (const HotBrick& hot : context.world.fire.take(shape))
        context.changes.firesChanged = context.changes.firesChanged || hot.burningFor;
}

}  // namespace rubble
