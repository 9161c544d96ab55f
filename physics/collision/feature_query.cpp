#include "physics/collision/feature_query.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rubble {
namespace {

/// Cells by which the exit may be longer than through a face that the feature does not accept.
constexpr float kMaxDetour = 0.15f;
constexpr int kMaxExitDepth = 4;  ///< cells below a surface to which an exit is searched

/// The exit of a point in a notch: its cell has no exposed face, but a cell across an edge or a corner is empty. The
/// point is behind all the planes that meet at that edge or corner, so it leaves through the plane that it is deepest
/// behind, of the closest such cell.
Face nearestExitFaceOfNotch(Occupancy& occupancy, Cell cell, const glm::vec3& p, const FeatureQuery& query) {
    Face best;
    float closest = 1e9f;
    for (int i = 0; i < 27; ++i) {
        const Cell d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (d.x * d.x + d.y * d.y + d.z * d.z < 2) continue;
        float distance = 0.0f, deepest = -1.0f;
        int axis = -1;
        for (int k = 0; k < 3; ++k) {
            if (!d[k]) continue;
            const float depth = distanceToSide(cell, p, k, d[k]);
            distance += depth * depth;
            if (depth > deepest && query.accepts(k, float(d[k]))) deepest = depth, axis = k;
        }
        if (axis < 0 || distance >= closest || !occupancy.open(cell + d)) continue;
        closest = distance;
        best = {axis, float(d[axis]), -deepest, cell};
    }
    return best;
}

/// Visits the cells along a line (Amanatides and Woo, "A Fast Voxel Traversal Algorithm", 1987). `next` is the fraction
/// of the displacement at which the line leaves the cell across each axis.
struct CellWalk {
    Cell cell, step;
    glm::vec3 next, delta;

    CellWalk(Cell from, const glm::vec3& p, const glm::vec3& displacement) : cell(from) {
        for (int axis = 0; axis < 3; ++axis) {
            step[axis] = displacement[axis] > 0 ? 1 : -1;
            delta[axis] = displacement[axis] != 0.0f ? std::abs(1.0f / displacement[axis]) : 1e30f;
            next[axis] = displacement[axis] != 0.0f ? distanceToSide(cell, p, axis, step[axis]) * delta[axis] : 1e30f;
        }
    }
    /// Across which the line leaves the cell.
    int axis() const { return next.x < next.y ? (next.x < next.z ? 0 : 2) : (next.y < next.z ? 1 : 2); }
    void cross(int side) {
        cell[side] += step[side];
        next[side] += delta[side];
    }
    /// Whether the line has left the box for good, after it crossed `side`.
    bool isPast(const CellBox& box, int side) const {
        return step[side] > 0 ? cell[side] >= box.high[side] : cell[side] < box.low[side];
    }
    /// Leaps over most of a long way to a box. Lines that never meet it end beyond their last cell.
    void approach(const CellBox& box) {
        float entry = 0.0f;  // at which it is a cell away from the box, or nearer
        for (int axis = 0; axis < 3; ++axis) {
            const int cells = step[axis] > 0 ? box.low[axis] - 1 - cell[axis] : cell[axis] - box.high[axis];
            if (cells > kMaxApproach) entry = std::max(entry, next[axis] + float(cells - 1) * delta[axis]);
        }
        entry = std::min(entry, 2.0f);  // the line ends at 1
        for (int axis = 0; axis < 3; ++axis) {
            if (!(next[axis] < entry)) continue;
            const int cells = int((entry - next[axis]) / delta[axis]);
            cell[axis] += step[axis] * cells;
            next[axis] += delta[axis] * float(cells);
        }
    }

    static constexpr int kMaxApproach = 64;  ///< cells that are walked one by one
};

/// Whether a feature accepts any of the faces that it can meet along a displacement.
bool acceptsAhead(const FeatureQuery& query, const glm::vec3& displacement) {
    for (int axis = 0; axis < 3; ++axis)
        if (displacement[axis] != 0.0f && query.accepts(axis, displacement[axis] > 0.0f ? -1.0f : 1.0f)) return true;
    return false;
}

}  // namespace

Face nearestExitFace(Occupancy& occupancy, Cell cell, const glm::vec3& p, const FeatureQuery& query) {
    Face best;
    best.separation = -1e9f;
    float shortestExit = -1e9f;  // separation of the closest face, whether the feature accepts it or not
    for (int crossed = 0; crossed < kMaxExitDepth; ++crossed) {
        for (int axis = 0; axis < 3; ++axis)
            for (const int sign : {-1, 1}) {
                const float separation = -distanceToSide(cell, p, axis, sign) - float(crossed);
                if (separation <= best.separation) continue;
                Cell owner = cell;
                owner[axis] += sign * crossed;
                if (!occupancy.exposed(owner, p, axis, sign)) continue;
                shortestExit = std::max(shortestExit, separation);
                if (query.accepts(axis, float(sign))) best = {axis, float(sign), separation, owner};
            }
        if (shortestExit > best.separation + kMaxDetour) return {};
        if (best.axis < 0 && crossed == 0) best = nearestExitFaceOfNotch(occupancy, cell, p, query);
        if (best.axis >= 0) return best;
        best.separation = -1e9f;
    }
    return best;
}

float depthBelowSurface(Occupancy& occupancy, Cell cell, const glm::vec3& p) {
    float depth = 1.5f;
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1})
            if (occupancy.exposed(cell, p, axis, sign)) depth = std::min(depth, distanceToSide(cell, p, axis, sign));
    return depth;
}

Face closestFace(Occupancy& occupancy, Cell cell, const glm::vec3& p, float margin, const FeatureQuery& query) {
    Face best;
    best.separation = margin;
    uint32_t near = 0;  // bit 2 * axis: the cell before this one is near; the next bit: the one behind
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, 1})
            near |= uint32_t(distanceToSide(cell, p, axis, side ? 1 : -1) < margin) << (2 * axis + side);
    for (near = occupancy.solidNeighbours(cell, near); near; near &= near - 1) {
        const int axis = std::countr_zero(near) / 2, side = std::countr_zero(near) % 2 ? 1 : -1;
        const float away = distanceToSide(cell, p, axis, side), sign = float(-side);
        if (away >= best.separation || !query.accepts(axis, sign)) continue;
        Cell below = cell;
        below[axis] += side;
        if (occupancy.exposed(below, p, axis, -side)) best = {axis, sign, away, below};
    }
    return best;
}

Face sweepToFace(Occupancy& occupancy, Cell cell, const glm::vec3& p, const glm::vec3& displacement,
                 const FeatureQuery& query) {
    if (!acceptsAhead(query, displacement)) return {};
    bool wasInside = occupancy.solid(cell);
    CellWalk walk(cell, p, displacement);
    if (!wasInside) walk.approach(occupancy.bounds());
    for (;;) {
        const int axis = walk.axis();
        const float at = walk.next[axis];
        if (!(at <= 1.0f)) return {};
        walk.cross(axis);
        if (walk.isPast(occupancy.bounds(), axis)) return {};
        const bool isInside = occupancy.solid(walk.cell), enters = isInside && !wasInside;
        wasInside = isInside;
        if (!enters) continue;
        const float sign = float(-walk.step[axis]);
        if (!occupancy.exposed(walk.cell, p + displacement * at, axis, -walk.step[axis])) continue;
        if (!query.accepts(axis, sign)) return {};
        const float plane = float(sign > 0 ? walk.cell[axis] + 1 : walk.cell[axis]);
        return {axis, sign, (p[axis] - plane) * sign, walk.cell};
    }
}

float timeOfEntry(Occupancy& occupancy, const glm::vec3& p, const glm::vec3& displacement) {
    CellWalk walk(cellOf(p), p, displacement);
    walk.approach(occupancy.bounds());
    for (;;) {
        const int axis = walk.axis();
        const float t = walk.next[axis];
        if (!(t <= 1.0f)) return 2.0f;
        walk.cross(axis);
        if (walk.isPast(occupancy.bounds(), axis)) return 2.0f;
        if (occupancy.solid(walk.cell)) return t;
    }
}

bool findSolidInterval(Occupancy& occupancy, const FeatureQuery& query, float& from, float& to) {
    const glm::vec3 displacement = query.along * query.length, start = query.point - displacement * 0.5f;
    CellWalk walk(cellOf(start), start, displacement);
    bool inside = occupancy.solid(walk.cell), any = inside, all = inside;
    from = 0.0f, to = 1.0f;
    for (;;) {
        const int axis = walk.axis();
        const float t = walk.next[axis];
        if (!(t < 1.0f)) break;
        walk.cross(axis);
        const bool now = occupancy.solid(walk.cell);
        all = all && now;
        if (now == inside) continue;
        if (now && !any) from = t;
        if (!now) {
            to = t;
            break;  // the first interval is enough
        }
        inside = any = true;
    }
    from -= 0.5f, to -= 0.5f;
    return any && !all;
}

}  // namespace rubble
