#include "runtime/voxel/ray_walk.h"

#include "runtime/voxel/cell_walk.h"

// Hierarchical grid traversal: an empty directory node (32^3 cells) or an empty brick (8^3) is left in one step, and
// only in bricks that hold voxels does the ray go from cell to cell. CellWalk computes every crossing from its integer
// plane, so these leaps arrive at the same cells as single steps.

namespace rubble {

CellHit walkRay(const VoxelGrid& grid, const CellRay& ray, const std::array<bool, 256>* accepted) {
    CellHit out;
    CellWalk walk;
    bool inside = walk.start(ray, grid.size());
    while (inside) {
        ++out.steps;
        const glm::ivec3 cell = walk.cell();
        const glm::ivec3 position = brickOfCell(cell);
        const Brick* brick = grid.brickAt(position);
        if (!brick) {
            const int size = grid.nodeEmpty(nodeOfBrick(position)) ? kNodeSize : kBrickSize;
            const glm::ivec3 low = cell & ~(size - 1);
            inside = walk.leave(low, low + size);
            continue;
        }
        for (glm::ivec3 at = cell; inside && brickOfCell(at) == position; at = walk.cell()) {
            const int i = voxelIndex(cellInBrick(at));
            if (brick->solid(i) && (!accepted || (*accepted)[brick->at(i)]))
                return {true, at, walk.t(), walk.axis(), walk.sign(), out.steps};
            inside = walk.step();
            if (inside && brickOfCell(walk.cell()) == position) ++out.steps;
        }
    }
    return out;
}

}  // namespace rubble
