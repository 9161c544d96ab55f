#include "physics/shapes/box_surface.h"

namespace rubble {
namespace {

bool isFull(const SolidRows& rows) {
    const glm::ivec3 size = rows.box().high - rows.box().low;
    const uint64_t full = (~uint64_t(0) >> (64 - size.x)) << SolidRows::kPadding;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            if ((rows.row(y, z) & full) != full) return false;
    return true;
}

/// The palette entry of all voxels; 0: there are several.
uint8_t commonEntry(const VoxelGrid& grid) {
    uint8_t entry = 0;
    bool isCommon = true;
    grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
        forEachVoxel(brick->occupancy, [&](int i) {
            isCommon = isCommon && (entry == 0 || entry == brick->at(i));
            entry = brick->at(i);
        });
    });
    return isCommon ? entry : uint8_t(0);
}

}  // namespace

std::optional<BoxSurface> findBoxSurface(const VoxelGrid& grid, const SolidRows& rows) {
    if (rows.box().empty() || !isFull(rows)) return std::nullopt;
    const glm::vec3 low(rows.box().low), high(rows.box().high);
    return BoxSurface{(low + high) * 0.5f, (high - low) * 0.5f, commonEntry(grid)};
}

}  // namespace rubble
