#include "runtime/voxel/ray_walk.h"

#include "runtime/voxel/cell_walk.h"

namespace rubble {

CellHit walkRay(const VoxelGrid& grid, const CellRay& ray, const std::array<bool, 256>* accepted) {
    CellHit out;
    CellWalk walk;
    bool inside = walk.start(ray, grid.size());
    while (inside) {
        ++out.steps;
        const glm::ivec3 cell = walk.cell();
        const glm::ivec3 position = cell >> 3;
        const Brick* brick = grid.brickAt(position);
        if (!brick) {
            const int size = grid.nodeEmpty(position >> 2) ? kNodeSize : kBrickSize;
            const glm::ivec3 low = cell & ~(size - 1);
            inside = walk.leave(low, low + size);
            continue;
        }
        for (glm::ivec3 at = cell; inside && (at >> 3) == position; at = walk.cell()) {
            const int i = voxelIndex(at & 7);
            if (brick->solid(i) && (!accepted || (*accepted)[brick->at(i)]))
                return {true, at, walk.t(), walk.axis(), walk.sign(), out.steps};
            inside = walk.step();
            if (inside && (walk.cell() >> 3) == position) ++out.steps;
        }
    }
    return out;
}

}  // namespace rubble
