#include "tests/physics/baseline/overlap.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rubble {
namespace {

struct Item {
    const LevelShape* shape;
    bool isStatic;
    Pose pose;  ///< grid corner -> world
    glm::dvec3 low, high;
    std::vector<glm::vec3> points;  ///< on the surface, in cells
};

bool exposed(const VoxelGrid& grid, glm::ivec3 c) {
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1}) {
            glm::ivec3 next = c;
            next[axis] += sign;
            if (!grid.at(next)) return true;
        }
    return false;
}

std::vector<glm::vec3> surfacePoints(const VoxelGrid& grid) {
    std::vector<glm::vec3> points;
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        forEachVoxel(brick->occupancy, [&](int v) {
            const glm::ivec3 c = position * kBrickSize + voxelInBrick(v);
            if (!exposed(grid, c)) return;
            for (int i = 0; i < 125; ++i) {
                const glm::ivec3 at(i % 5, i / 5 % 5, i / 25);
                const bool onFace = at.x % 4 == 0 || at.y % 4 == 0 || at.z % 4 == 0;
                if (onFace) points.push_back(glm::vec3(c) + glm::vec3(at) * 0.25f);
            }
        });
    });
    return points;
}

/// Cells to the nearest empty one; 0: outside.
double depthAt(const VoxelGrid& grid, const glm::dvec3& p) {
    const glm::ivec3 cell(glm::floor(p));
    if (!grid.at(cell)) return 0.0;
    double best = 1e9;
    for (int reach = 1; best > 1e8; ++reach)  // all cells nearer than `reach` are in the box
        for (int z = -reach; z <= reach; ++z)
            for (int y = -reach; y <= reach; ++y)
                for (int x = -reach; x <= reach; ++x) {
                    const glm::ivec3 next = cell + glm::ivec3(x, y, z);
                    if (grid.at(next)) continue;
                    const glm::dvec3 d = glm::max(glm::max(glm::dvec3(next) - p, p - glm::dvec3(next + 1)), 0.0);
                    best = std::min(best, glm::dot(d, d));
                }
    return std::sqrt(best);
}

double deepest(const Item& from, const Item& into) {
    double depth = 0.0;
    const double fromSize = from.shape->voxelSize, intoSize = into.shape->voxelSize;
    const glm::dmat3 turn = glm::mat3_cast(glm::conjugate(into.pose.rotation) * from.pose.rotation);
    const glm::dvec3 corner = into.pose.inversePoint(from.pose.position);
    for (const glm::vec3& point : from.points) {
        const glm::dvec3 p = (corner + turn * (glm::dvec3(point) * fromSize)) / intoSize;
        depth = std::max(depth, depthAt(into.shape->grid, p) * intoSize);
    }
    return depth;
}

}  // namespace

Overlaps measureOverlaps(const Level& level, std::span<const Pose> poses) {
    std::vector<Item> items;
    for (size_t i = 0; i < level.bodies.size(); ++i) {
        const LevelBody& body = level.bodies[i];
        Item item{&body.shapes.at(0), body.isStatic, poses[i] * body.shapes.at(0).local, glm::dvec3(1e30), glm::dvec3(-1e30), {}};
        const glm::ivec3 size = item.shape->grid.size();
        for (int k = 0; k < 8; ++k) {
            const glm::dvec3 c =
                item.pose.transformPoint(glm::dvec3(k & 1 ? size.x : 0, k & 2 ? size.y : 0, k & 4 ? size.z : 0) * double(item.shape->voxelSize));
            item.low = glm::min(item.low, c);
            item.high = glm::max(item.high, c);
        }
        if (!body.isStatic) item.points = surfacePoints(item.shape->grid);
        items.push_back(std::move(item));
    }
    Overlaps result;
    size_t bodies = 0;
    for (const Item& item : items) {
        if (item.isStatic) continue;
        const double height = (item.low.y + item.high.y) * 0.5;
        result.high = std::max(result.high, height);
        result.middle += height;
        ++bodies;
    }
    result.middle /= double(std::max<size_t>(bodies, 1));
    std::vector<double> depths;
    for (size_t i = 0; i < items.size(); ++i)
        for (size_t j = i + 1; j < items.size(); ++j) {
            const Item &a = items[i], &b = items[j];
            if ((a.isStatic && b.isStatic) || glm::any(glm::lessThan(a.high, b.low)) || glm::any(glm::lessThan(b.high, a.low))) continue;
            const double depth = std::max(deepest(a, b), deepest(b, a));
            if (depth <= 1e-6) continue;
            depths.push_back(depth);
            result.mean += depth;
            result.worst = std::max(result.worst, depth);
        }
    result.pairs = depths.size();
    if (depths.empty()) return result;
    result.mean /= double(depths.size());
    std::nth_element(depths.begin(), depths.begin() + std::ptrdiff_t(depths.size() / 2), depths.end());
    result.median = depths[depths.size() / 2];
    return result;
}

}  // namespace rubble
