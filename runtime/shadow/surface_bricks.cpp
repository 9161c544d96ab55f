#include "runtime/shadow/surface_bricks.h"

#include <cmath>

#include "runtime/shadow/rasterize.h"

namespace rubble {
namespace {

/// Calls f(cell, axis, isHigh) for each face of a solid voxel that no other solid voxel covers.
template <class F>
void forEachOpenFace(const VoxelGrid& grid, F&& f) {
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        forEachVoxel(brick->occupancy, [&](int i) {
            const glm::ivec3 cell = position * kBrickSize + voxelInBrick(i);
            for (int axis = 0; axis < 3; ++axis)
                for (const bool isHigh : {false, true}) {
                    glm::ivec3 beside = cell;
                    beside[axis] += isHigh ? 1 : -1;
                    if (!grid.at(beside)) f(cell, axis, isHigh);
                }
        });
    });
}

/// Pieces across a face.
double tilesPerSide(double voxelSize) {
    return std::ceil(voxelSize / (double(kShadowCell) * kShadowBrickCells));
}

}  // namespace

double surfaceTiles(const VoxelGrid& grid, double voxelSize) {
    const double perSide = tilesPerSide(voxelSize);
    double faces = 0.0;
    forEachOpenFace(grid, [&](glm::ivec3, int, bool) { ++faces; });
    return faces * perSide * perSide;
}

void listSurfaceBricks(const VoxelGrid& grid, const Pose& shapeToWorld, double voxelSize,
                       std::vector<glm::ivec3>& bricks) {
    const int tiles = int(tilesPerSide(voxelSize));
    const double side = 1.0 / tiles;  // voxels
    forEachOpenFace(grid, [&](glm::ivec3 cell, int axis, bool isHigh) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        glm::dvec3 low(cell);
        low[axis] += isHigh ? 1.0 : 0.0;
        for (int j = 0; j < tiles; ++j)
            for (int i = 0; i < tiles; ++i) {
                glm::dvec3 from = low, to = low;
                from[u] += i * side, to[u] += (i + 1) * side;
                from[v] += j * side, to[v] += (j + 1) * side;
                const CellBox box = shadowBricksOf(shadowBounds(shapeToWorld, voxelSize, from, to));
                for (int z = box.low.z; z < box.high.z; ++z)
                    for (int y = box.low.y; y < box.high.y; ++y)
                        for (int x = box.low.x; x < box.high.x; ++x) bricks.emplace_back(x, y, z);
            }
    });
}

}  // namespace rubble
