#include "runtime/world/queries/voxel_accounting.h"

namespace rubble {

VoxelAccounting voxelAccounting(const WorldState& world) {
    VoxelAccounting out{.imported = world.imported, .removed = world.removed};
    world.shapes.forEach([&](ShapeHandle, const Shape& shape) {
        (shape.isPiece ? out.inPieces : out.standing) += shape.grid.voxelCount();
    });
    return out;
}

}  // namespace rubble
