#include "physics/joints/rope_contact.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "runtime/voxel/cell_box.h"
#include "runtime/voxel/ray_walk.h"

// A place of a rope is a ball. Its centre is swept through the cells from where it was: at the first face that it goes
// in by, it is put back before that face and keeps its motion along it, up to three times, as in a corner. So a rope
// that is pulled hard comes out where it went in, also of what is thinner than its motion. A centre that was inside
// before takes the nearest face. Last the ball's radius is kept from the neighbours of its cell.

namespace rubble {
namespace {

constexpr int kMaxFaces = 3;  ///< that a centre is put back before, one after the other

const std::array<glm::ivec3, 6> kSides = {{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};

/// The displacement, in cells, that takes a ball whose centre is in an empty cell out of the solid neighbours that it
/// reaches into.
glm::dvec3 exitFromNeighbours(const VoxelGrid& grid, glm::ivec3 cell, glm::dvec3 center, double radius) {
    glm::dvec3 out(0.0);
    for (const glm::ivec3& side : kSides) {
        const glm::ivec3 next = cellAt(center + glm::dvec3(side) * radius);
        if (next == cell || !grid.at(next)) continue;
        for (int a = 0; a < 3; ++a) {
            if (side[a] > 0) out[a] += double(next[a]) - radius - center[a];
            if (side[a] < 0) out[a] += double(next[a] + 1) + radius - center[a];
        }
    }
    return out;
}

/// The shortest displacement along an axis, in cells, that takes a ball whose centre is in a solid cell out.
glm::dvec3 exitFromInside(const VoxelGrid& grid, glm::ivec3 cell, glm::dvec3 center, double radius) {
    glm::dvec3 out(0.0);
    double shortest = std::numeric_limits<double>::infinity();
    for (const glm::ivec3& side : kSides) {
        int depth = 1;
        while (grid.at(cell + side * depth) && depth < shortest + 1.0) ++depth;
        if (grid.at(cell + side * depth)) continue;
        double distance = 0.0;
        for (int a = 0; a < 3; ++a) {
            if (side[a] > 0) distance = double(cell[a] + depth) + radius - center[a];
            if (side[a] < 0) distance = center[a] - double(cell[a] - depth + 1) + radius;
        }
        if (distance < shortest) shortest = distance, out = glm::dvec3(side) * distance;
    }
    return out;
}

/// Whether a ball that moves in a straight line stays out of a grid's box, in cells.
bool misses(const VoxelGrid& grid, glm::dvec3 from, glm::dvec3 to, double radius) {
    const glm::dvec3 size(grid.size());
    for (int a = 0; a < 3; ++a)
        if (!(std::max(from[a], to[a]) > -radius && std::min(from[a], to[a]) < size[a] + radius)) return true;
    return false;
}

/// exitDisplacement() of a grid, in its cells.
glm::dvec3 exitFromGrid(const VoxelGrid& grid, glm::dvec3 before, glm::dvec3 center, double radius) {
    if (misses(grid, before, center, radius)) return glm::dvec3(0.0);
    glm::dvec3 place = center;
    for (int face = 0; face < kMaxFaces && place != before; ++face) {
        const CellHit hit = walkRay(grid, {before, place - before, 1.0});
        if (!hit.hit || hit.axis < 0) break;
        place[hit.axis] = double(hit.cell[hit.axis] + (hit.sign > 0 ? 1 : 0)) + hit.sign * radius;
    }
    const glm::ivec3 cell = cellAt(place);
    place += grid.at(cell) ? exitFromInside(grid, cell, place, radius) : exitFromNeighbours(grid, cell, place, radius);
    return place - center;
}

/// A place of the world in the cells of a part.
glm::dvec3 toCells(const CollisionObject& object, size_t part, glm::dvec3 place) {
    const CellTransform& cells = object.cellTransforms()[part];
    const double size = object.collider.parts[part]->voxelSize();
    const glm::dvec3 local = place - object.pose.position - cells.corner;
    return glm::dvec3(glm::dot(cells.axes[0], local), glm::dot(cells.axes[1], local), glm::dot(cells.axes[2], local)) /
           (size * size);
}

}  // namespace

glm::dvec3 exitDisplacement(const CollisionObject& object, glm::dvec3 before, glm::dvec3 center, double radius) {
    glm::dvec3 out(0.0);
    for (size_t i = 0; i < object.collider.parts.size(); ++i) {
        const ColliderPart& part = *object.collider.parts[i];
        const glm::dvec3 exit = exitFromGrid(part.grid(), toCells(object, i, before), toCells(object, i, center + out),
                                             radius / part.voxelSize());
        if (exit != glm::dvec3(0.0)) out += object.cellTransforms()[i].axes * exit;
    }
    return out;
}

double depthInside(const CollisionObject& object, glm::dvec3 place) {
    double depth = 0.0;
    for (size_t i = 0; i < object.collider.parts.size(); ++i) {
        const ColliderPart& part = *object.collider.parts[i];
        const glm::dvec3 center = toCells(object, i, place);
        const glm::ivec3 cell = cellAt(center);
        if (misses(part.grid(), center, center, 0.0) || !part.grid().at(cell)) continue;
        depth = std::max(depth, glm::length(exitFromInside(part.grid(), cell, center, 0.0)) * part.voxelSize());
    }
    return depth;
}

}  // namespace rubble
