#include "runtime/voxel/nearest_voxel.h"

#include <algorithm>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace rubble {
namespace {

/// Squared distance in cells from a point to the centre of the node's nearest voxel, if that is less than `best`.
double nearestInNodeSquared(glm::ivec3 position, const BrickNode& node, glm::dvec3 point, double best) {
    forEachChild(node.mask, [&](int child) {
        const glm::dvec3 low = glm::dvec3((position * kNodeBricks + childPosition(child)) * kBrickSize),
                         high = low + double(kBrickSize);
        const glm::dvec3 toBox = point - glm::clamp(point, low, high);
        if (glm::dot(toBox, toBox) >= best) return;
        forEachVoxel(node.bricks[size_t(child)]->occupancy, [&](int i) {
            const glm::dvec3 offset = point - (low + glm::dvec3(voxelInBrick(i)) + 0.5);
            best = std::min(best, glm::dot(offset, offset));
        });
    });
    return best;
}

}  // namespace

std::optional<glm::ivec3> nearestVoxel(const VoxelGrid& grid, glm::dvec3 point, const CellBox& range,
                                       double maxDistanceSquared) {
    const glm::ivec3 low = glm::max(range.low, 0), high = glm::min(range.high, grid.size());
    std::optional<glm::ivec3> nearest;
    double best = maxDistanceSquared;
    for (int z = low.z; z < high.z; ++z)
        for (int y = low.y; y < high.y; ++y)
            for (int x = low.x; x < high.x; ++x) {
                const glm::dvec3 offset = glm::dvec3(x, y, z) + 0.5 - point;
                const double distance = glm::dot(offset, offset);
                if (distance < best && grid.at({x, y, z})) nearest = {x, y, z}, best = distance;
            }
    return nearest;
}

double nearestVoxelSquared(const VoxelGrid& grid, glm::dvec3 point) {
    double best = std::numeric_limits<double>::infinity();
    const glm::ivec3 size = grid.sizeInNodes();
    const glm::ivec3 middle = glm::ivec3(glm::clamp(point / double(kNodeSize), glm::dvec3(0.0), glm::dvec3(size - 1)));
    const int last = std::max({size.x, size.y, size.z});
    for (int r = 0; r < last; ++r) {
        const double minDistance = double(std::max(r - 1, 0)) * kNodeSize;
        if (minDistance * minDistance >= best) break;
        const glm::ivec3 low = glm::max(middle - r, 0), high = glm::min(middle + r, size - 1);
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y) {
                const bool isSide = std::abs(z - middle.z) == r || std::abs(y - middle.y) == r;
                for (int x = isSide ? low.x : middle.x - r; x <= high.x; x += isSide || r == 0 ? 1 : 2 * r)
                    if (const BrickNode* node = x < 0 ? nullptr : grid.nodeAt({x, y, z}))
                        best = nearestInNodeSquared({x, y, z}, *node, point, best);
            }
    }
    return best;
}

}  // namespace rubble
