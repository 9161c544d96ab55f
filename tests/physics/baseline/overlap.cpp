#include "tests/physics/baseline/overlap.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/grids.h"

namespace rubble {
namespace {

struct Item {
    const LevelShape* shape;
    bool isStatic;
    Pose pose;  ///< grid corner -> world
    glm::dvec3 low, high;
    std::vector<glm::ivec3> surface;  ///< cells with an exposed face
};

std::vector<glm::ivec3> surfaceCells(const VoxelGrid& grid) {
    std::vector<glm::ivec3> cells;
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        forEachVoxel(brick->occupancy, [&](int v) {
            const glm::ivec3 c = position * kBrickSize + voxelInBrick(v);
            if (isExposed(grid, c)) cells.push_back(c);
        });
    });
    return cells;
}

/// Whether any cell within `radius` of a point is solid.
bool anySolid(const VoxelGrid& grid, const glm::dvec3& p, double radius) {
    const glm::ivec3 low = glm::max(glm::ivec3(glm::floor(p - radius)), 0),
                     high = glm::min(glm::ivec3(glm::floor(p + radius)), grid.size() - 1);
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x)
                if (grid.at({x, y, z})) return true;
    return false;
}

/// The distance to the nearest empty cell, in cells; 0: the point is outside.
double depthAt(const VoxelGrid& grid, const glm::dvec3& p) {
    const glm::ivec3 cell(glm::floor(p));
    if (!grid.at(cell)) return 0.0;
    double best = 1e9;
    for (int radius = 1; best > 1e8; ++radius)  // all cells nearer than `radius` are in the box
        for (int z = -radius; z <= radius; ++z)
            for (int y = -radius; y <= radius; ++y)
                for (int x = -radius; x <= radius; ++x) {
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
    const double scale = fromSize / intoSize, around = 0.87 * scale;  // half a diagonal of a cell
    const glm::dvec3 size(into.shape->grid.size());
    for (const glm::ivec3& cell : from.surface) {
        const glm::dvec3 middle = corner / intoSize + turn * ((glm::dvec3(cell) + 0.5) * scale);
        if (glm::any(glm::lessThan(middle, glm::dvec3(-around))) || glm::any(glm::greaterThan(middle, size + around)))
            continue;
        if (!anySolid(into.shape->grid, middle, around)) continue;
        for (int i = 0; i < 125; ++i) {
            const glm::ivec3 at(i % 5, i / 5 % 5, i / 25);
            if (at.x % 4 && at.y % 4 && at.z % 4) continue;  // not on a face
            const glm::dvec3 p = (corner + turn * ((glm::dvec3(cell) + glm::dvec3(at) * 0.25) * fromSize)) / intoSize;
            depth = std::max(depth, depthAt(into.shape->grid, p) * intoSize);
        }
    }
    return depth;
}

}  // namespace

Overlaps measureOverlaps(const Level& level, std::span<const Pose> poses) {
    std::vector<Item> items;
    for (size_t i = 0; i < level.bodies.size(); ++i) {
        const LevelBody& body = level.bodies[i];
        Item item{&body.shapes.at(0), body.isStatic,     poses[i] * body.shapes.at(0).local,
                  glm::dvec3(1e30),   glm::dvec3(-1e30), {}};
        const glm::ivec3 size = item.shape->grid.size();
        for (int k = 0; k < 8; ++k) {
            const glm::dvec3 c = item.pose.transformPoint(
                glm::dvec3(k & 1 ? size.x : 0, k & 2 ? size.y : 0, k & 4 ? size.z : 0) * double(item.shape->voxelSize));
            item.low = glm::min(item.low, c);
            item.high = glm::max(item.high, c);
        }
        if (!body.isStatic) item.surface = surfaceCells(item.shape->grid);
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
            if ((a.isStatic && b.isStatic) || glm::any(glm::lessThan(a.high, b.low)) ||
                glm::any(glm::lessThan(b.high, a.low)))
                continue;
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
