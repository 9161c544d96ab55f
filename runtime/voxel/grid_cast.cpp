#include "runtime/voxel/grid_cast.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

// Shape casts against voxels.
//
// Bricks are visited in the order in which the shape's bounding box first meets them, in intervals of the path that are
// as long as a directory node, so a cast that hits early looks at few bricks. Against one voxel, a closed unit cube:
//   * A box moves without turning, so the separating axis theorem gives the exact time of contact (S. Gottschalk, M.
//     Lin and D. Manocha, "OBBTree", SIGGRAPH 1996). Along each of the 15 axes the two projections overlap during an
//     interval of t; the contact begins at the latest beginning, and its axis is the normal.
//   * The distance d(t) between a moving segment and a cube is a convex function of t, as both are convex. A sphere or
//     capsule touches where d(t) = radius. Newton's method, started before that zero, approaches it from one side and
//     never passes it: conservative advancement (B. Mirtich, PhD thesis, Berkeley 1996) with the exact gradient.

namespace rubble {
namespace {

constexpr double kContactTolerance = 1e-9;  ///< cells
constexpr double kMaxCoordinate = 1e7;      ///< cells: what is farther from the grid's origin is first moved near it
constexpr double kMaxSize = 4e7;            ///< cells: larger shapes hit nothing
constexpr double kNearMargin = 64.0;        ///< cells between a grid and what was moved near it
constexpr double kMaxOverlap = 1e13;        ///< the same of overlaps, which solve nothing: exact to 0.01 cells
constexpr int kMaxNewtonSteps = 64;         ///< three or four are enough, except where the shape grazes the voxel

/// An interval of t.
struct Span {
    double enter, leave;
    bool empty() const { return !(enter <= leave); }
};

/// The part of `span` in which a moving point is inside a box (slab test: T. Kay and J. Kajiya 1986).
Span spanInBox(glm::dvec3 point, glm::dvec3 direction, glm::dvec3 low, glm::dvec3 high, Span span) {
    for (int a = 0; a < 3; ++a) {
        if (direction[a] == 0.0) {
            if (point[a] < low[a] || point[a] > high[a]) return {1.0, 0.0};
            continue;
        }
        const double first = (low[a] - point[a]) / direction[a], second = (high[a] - point[a]) / direction[a];
        span.enter = std::max(span.enter, std::min(first, second));
        span.leave = std::min(span.leave, std::max(first, second));
    }
    return span;
}

/// Voxels of which at least one face is not covered by another voxel of the brick.
BrickBits outerVoxels(const BrickBits& solid) {
    BrickBits outer = solid;
    for (size_t z = 1; z < 7; ++z) {
        const uint64_t w = solid[z];
        outer[z] &=
            ~((w << 1 & ~kFirstColumn) & (w >> 1 & ~kLastColumn) & w << 8 & w >> 8 & solid[z - 1] & solid[z + 1]);
    }
    return outer;
}

BrickBits acceptedVoxels(const Brick& brick, EntryFilter accepted) {
    if (!accepted) return brick.occupancy;
    BrickBits bits{};
    if (!brick.indices) return (*accepted)[brick.uniform] ? brick.occupancy : bits;
    forEachVoxel(brick.occupancy, [&](int i) {
        if ((*accepted)[(*brick.indices)[size_t(i)]]) setVoxel(bits, i);
    });
    return bits;
}

/// Clears the voxels of a brick that are outside a box. The box is in cells of the grid.
void clip(BrickBits& bits, glm::ivec3 brick, glm::dvec3 low, glm::dvec3 high) {
    const glm::dvec3 base(brick * kBrickSize);
    const glm::ivec3 from(glm::clamp(glm::floor(low - base), 0.0, 8.0)),
        to(glm::clamp(glm::floor(high - base), -1.0, 7.0));
    if (from.x > to.x || from.y > to.y || from.z > to.z) return bits.fill(0);
    const uint64_t row = (2ull << to.x) - (1ull << from.x);
    uint64_t layer = 0;
    for (int y = from.y; y <= to.y; ++y) layer |= row << (8 * y);
    for (int z = 0; z < 8; ++z) bits[size_t(z)] &= z >= from.z && z <= to.z ? layer : 0;
}

/// Calls f(brick, content) for the bricks of a grid that may have cells in a box. The box is in cells of the grid.
template <class F>
void forEachBrickIn(const VoxelGrid& grid, glm::dvec3 low, glm::dvec3 high, F&& f) {
    const glm::dvec3 size(grid.size());
    if (!(high.x >= 0.0 && high.y >= 0.0 && high.z >= 0.0 && low.x <= size.x && low.y <= size.y && low.z <= size.z))
        return;
    const glm::ivec3 last = grid.sizeInBricks() - 1;
    const glm::ivec3 from(glm::clamp(glm::floor(low / 8.0 - 1e-9), glm::dvec3(0.0), glm::dvec3(last)));
    const glm::ivec3 to(glm::clamp(glm::floor(high / 8.0 + 1e-9), glm::dvec3(0.0), glm::dvec3(last)));
    const glm::ivec3 firstNode = nodeOfBrick(from), lastNode = nodeOfBrick(to);
    for (int z = firstNode.z; z <= lastNode.z; ++z)
        for (int y = firstNode.y; y <= lastNode.y; ++y)
            for (int x = firstNode.x; x <= lastNode.x; ++x) {
                const BrickNode* node = grid.nodeAt({x, y, z});
                if (!node) continue;
                forEachChild(node->mask, [&](int child) {
                    const glm::ivec3 brick = glm::ivec3(x, y, z) * kNodeBricks + childPosition(child);
                    if (glm::all(glm::greaterThanEqual(brick, from)) && glm::all(glm::lessThanEqual(brick, to)))
                        f(brick, *node->bricks[size_t(child)]);
                });
            }
}

/// The axes of the separating axis theorem for a box and a cube: three of the cube, three of the box, and the cross
/// products of one of each.
struct BoxAxes {
    std::array<glm::dvec3, 15> axes;
    std::array<double, 15> shapeRadius;  ///< half the length of the box's projection on the axis
    int count = 0;

    explicit BoxAxes(const CellShape& box) {
        const std::array<glm::dvec3, 3> edges = edgeDirections(box);
        for (int i = 0; i < 3; ++i) add(box, glm::dvec3(i == 0, i == 1, i == 2));
        for (const glm::dvec3& edge : edges) add(box, edge);
        for (int i = 0; i < 3; ++i)
            for (const glm::dvec3& edge : edges) add(box, glm::cross(glm::dvec3(i == 0, i == 1, i == 2), edge));
    }
    /// Unit vectors; of a flat box the third is its normal, and there is none of a segment or a point.
    static std::array<glm::dvec3, 3> edgeDirections(const CellShape& box) {
        std::array<glm::dvec3, 3> out{};
        size_t flat = 0, flatCount = 0;
        for (size_t i = 0; i < 3; ++i) {
            const double length = glm::length(box.halfAxes[i]);
            if (length > 0.0)
                out[i] = box.halfAxes[i] / length;
            else
                flat = i, ++flatCount;
        }
        if (flatCount == 1) out[flat] = glm::cross(out[(flat + 1) % 3], out[(flat + 2) % 3]);
        return out;
    }
    void add(const CellShape& box, glm::dvec3 axis) {
        const double length = glm::length(axis);
        if (!(length > 1e-9)) return;
        axis /= length;
        axes[size_t(count)] = axis;
        shapeRadius[size_t(count)] = 0.0;
        for (const glm::dvec3& half : box.halfAxes) shapeRadius[size_t(count)] += std::abs(glm::dot(axis, half));
        ++count;
    }
    /// Half the sum of the lengths of both projections: within that distance along the axis they overlap.
    double halfExtent(int i, double cubeHalf) const {
        const glm::dvec3& axis = axes[size_t(i)];
        return shapeRadius[size_t(i)] + cubeHalf * (std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z));
    }
    bool overlaps(glm::dvec3 fromCube, double cubeHalf) const {
        for (int i = 0; i < count; ++i)
            if (std::abs(glm::dot(axes[size_t(i)], fromCube)) > halfExtent(i, cubeHalf)) return false;
        return true;
    }
    /// When the box, which begins at `fromCube` from the middle of a unit cube, touches it. `normal`: the axis of first
    /// contact.
    Span touch(glm::dvec3 fromCube, glm::dvec3 direction, Span span, glm::dvec3& normal) const {
        for (int i = 0; i < count; ++i) {
            const double from = glm::dot(axes[size_t(i)], fromCube), speed = glm::dot(axes[size_t(i)], direction);
            const double limit = halfExtent(i, 0.5);
            if (std::abs(speed) < 1e-15) {
                if (std::abs(from) > limit) return {1.0, 0.0};
                continue;
            }
            const double first = (-limit - from) / speed, second = (limit - from) / speed;
            if (std::min(first, second) > span.enter) {
                span.enter = std::min(first, second);
                normal = speed < 0.0 ? axes[size_t(i)] : -axes[size_t(i)];
            }
            span.leave = std::min(span.leave, std::max(first, second));
            if (span.empty()) return span;
        }
        return span;
    }
};

/// One cast through one grid.
class ShapeCast {
public:
    ShapeCast(const VoxelGrid& grid, const CellShape& shape, glm::dvec3 direction, double tMax, EntryFilter accepted)
        : m_grid(grid),
          m_shape(shape),
          m_middle(shape.middle()),
          m_halfExtent(shape.halfExtent()),
          m_direction(direction),
          m_accepted(accepted) {
        m_best.t = tMax;
        const double size = std::max({m_halfExtent.x, m_halfExtent.y, m_halfExtent.z});
        m_tolerance = std::max(kContactTolerance, 4.0 * std::numeric_limits<double>::epsilon() * size);
        if (shape.isBox) m_axes.emplace(shape);
    }

    /// Visits the path in intervals as long as a directory node. A brick belongs to the interval in which the shape's
    /// bounding box first meets it.
    CellContact run() {
        const Span path =
            spanInBox(m_middle, m_direction, -m_halfExtent, glm::dvec3(m_grid.size()) + m_halfExtent, {0.0, m_best.t});
        if (path.empty()) return {};
        const double speed = glm::length(m_direction);
        const double interval = speed > 0.0 ? kNodeSize / speed : 1.0;
        for (double from = path.enter;; from += interval) {
            visitInterval({from, std::min(from + interval, path.leave)}, from == path.enter);
            if (!(from + interval < std::min(path.leave, m_best.t))) break;
        }
        if (!m_best.hit) return {};
        if (m_best.normal == glm::dvec3(0.0))
            m_best.normal = speed > 0.0 ? -m_direction / speed : glm::dvec3(0.0, 1.0, 0.0);
        return m_best;
    }

private:
    struct BrickCandidate {
        double enter, leave;
        glm::ivec3 position;
        const Brick* brick;
    };

    void visitInterval(Span interval, bool isFirst) {
        const glm::dvec3 from = m_middle + m_direction * interval.enter, to = m_middle + m_direction * interval.leave;
        m_candidates.clear();
        forEachBrickIn(
            m_grid, glm::min(from, to) - m_halfExtent, glm::max(from, to) + m_halfExtent,
            [&](glm::ivec3 position, const Brick& brick) {
                const glm::dvec3 low(position * kBrickSize);
                const Span span =
                    spanInBox(m_middle, m_direction, low - m_halfExtent, low + 8.0 + m_halfExtent, {0.0, m_best.t});
                if (span.empty() || span.enter > interval.leave || (span.enter <= interval.enter && !isFirst)) return;
                m_candidates.push_back({span.enter, span.leave, position, &brick});
            });
        std::stable_sort(m_candidates.begin(), m_candidates.end(),
                         [](const BrickCandidate& a, const BrickCandidate& b) { return a.enter < b.enter; });
        for (const BrickCandidate& each : m_candidates) {
            if (each.enter > m_best.t) break;
            visitBrick(each);
        }
    }

    void visitBrick(const BrickCandidate& each) {
        BrickBits bits = acceptedVoxels(*each.brick, m_accepted);
        if (each.enter > 0.0) bits = outerVoxels(bits);
        const glm::dvec3 from = m_middle + m_direction * each.enter,
                         to = m_middle + m_direction * std::min(each.leave, m_best.t);
        clip(bits, each.position, glm::min(from, to) - m_halfExtent - 1e-6, glm::max(from, to) + m_halfExtent + 1e-6);
        forEachVoxel(bits, [&](int i) { visitCell(each.position * kBrickSize + voxelInBrick(i)); });
    }

    void visitCell(glm::ivec3 cell) {
        const glm::dvec3 low(cell);
        const Span span =
            spanInBox(m_middle, m_direction, low - m_halfExtent, low + 1.0 + m_halfExtent, {0.0, m_best.t});
        if (span.empty() || (m_best.hit && span.enter >= m_best.t)) return;
        if (m_axes) {
            glm::dvec3 normal(0.0);
            const Span touch = m_axes->touch(m_middle - low - 0.5, m_direction, {0.0, m_best.t}, normal);
            if (!touch.empty() && (!m_best.hit || touch.enter < m_best.t))
                m_best = {true, cell, touch.enter, glm::clamp(m_middle + m_direction * touch.enter, low, low + 1.0),
                          normal};
            return;
        }
        castRound(cell, span.enter);
    }

    /// Newton's method for distance = radius, from t before the contact.
    void castRound(glm::ivec3 cell, double t) {
        const glm::dvec3 low(cell);
        for (int i = 0; i < kMaxNewtonSteps; ++i) {
            const glm::dvec3 displacement = m_direction * t;
            const SegmentToBox near = closestToBox(m_shape.a + displacement, m_shape.b + displacement, low, low + 1.0);
            const double gap = near.distance - m_shape.radius;
            const glm::dvec3 normal =
                near.distance > 0.0 ? (near.onSegment - near.onBox) / near.distance : glm::dvec3(0.0);
            const double approach = -glm::dot(normal, m_direction);
            if (gap <= m_tolerance) {
                if (gap >= -m_tolerance && near.distance > 0.0 && !(approach > 1e-12)) return;
                m_best = {true, cell, t, near.onBox, normal};
                return;
            }
            if (!(approach > 0.0)) return;
            t += gap / approach;
            if (t > m_best.t || (m_best.hit && t == m_best.t)) return;
        }
    }

    const VoxelGrid& m_grid;
    const CellShape& m_shape;
    glm::dvec3 m_middle, m_halfExtent, m_direction;
    EntryFilter m_accepted;
    double m_tolerance;  ///< cells: coordinates of a very large shape are not as exact
    std::optional<BoxAxes> m_axes;
    CellContact m_best;
    std::vector<BrickCandidate> m_candidates;
};

bool isNear(glm::dvec3 v, double limit = kMaxCoordinate) {
    return std::abs(v.x) < limit && std::abs(v.y) < limit && std::abs(v.z) < limit;
}

bool isNear(const CellShape& shape, double limit = kMaxCoordinate) {
    bool near = isNear(shape.a, limit) && isNear(shape.halfExtent(), limit);
    if (!shape.isBox) near = near && isNear(shape.b, limit) && shape.radius >= 0.0;
    return near;
}

/// The shape begins where its bounding box comes near the grid, so that what is solved has small coordinates.
CellContact castFromAfar(const VoxelGrid& grid, CellShape shape, glm::dvec3 direction, double tMax,
                         EntryFilter accepted) {
    const glm::dvec3 reach = shape.halfExtent() + kNearMargin;
    if (!isNear(reach, kMaxSize)) return {};
    const Span path = spanInBox(shape.middle(), direction, -reach, glm::dvec3(grid.size()) + reach, {0.0, tMax});
    if (path.empty()) return {};
    shape.a += direction * path.enter;
    shape.b += direction * path.enter;
    CellContact contact = ShapeCast(grid, shape, direction, tMax - path.enter, accepted).run();
    contact.t += path.enter;
    return contact;
}

}  // namespace

glm::dvec3 CellShape::halfExtent() const {
    if (!isBox) return glm::abs(b - a) * 0.5 + radius;
    return glm::abs(halfAxes[0]) + glm::abs(halfAxes[1]) + glm::abs(halfAxes[2]);
}

/// The squared distance from a point of the segment to the box is convex and piecewise quadratic in the point's
/// parameter; the pieces meet where the segment crosses a plane of a face. Its derivative is monotone, so the piece
/// with the minimum is found by the sign of the derivative at the planes, and the minimum by interpolation, as the
/// derivative is linear there.
SegmentToBox closestToBox(glm::dvec3 a, glm::dvec3 b, glm::dvec3 low, glm::dvec3 high) {
    const glm::dvec3 segment = b - a;
    const auto slope = [&](double s) {
        const glm::dvec3 p = a + segment * s;
        return glm::dot(p - glm::clamp(p, low, high), segment);
    };
    double first = 0.0, last = 1.0, firstSlope = slope(0.0), lastSlope = slope(1.0), at = 0.0;
    if (firstSlope >= 0.0) {
        at = 0.0;
    } else if (lastSlope <= 0.0) {
        at = 1.0;
    } else {
        for (int i = 0; i < 6; ++i) {
            const int axis = i >> 1;
            if (segment[axis] == 0.0) continue;
            const double s = ((i & 1 ? high[axis] : low[axis]) - a[axis]) / segment[axis];
            if (!(s > first && s < last)) continue;
            const double here = slope(s);
            if (here < 0.0)
                first = s, firstSlope = here;
            else
                last = s, lastSlope = here;
        }
        at = first + (last - first) * (firstSlope / (firstSlope - lastSlope));
    }
    const glm::dvec3 onSegment = a + segment * at;
    const glm::dvec3 onBox = glm::clamp(onSegment, low, high);
    return {onSegment, onBox, glm::length(onSegment - onBox)};
}

CellContact castShape(const VoxelGrid& grid, const CellShape& shape, glm::dvec3 direction, double tMax,
                      EntryFilter accepted) {
    if (!isNear(shape, kMaxOverlap) || !isNear(direction) || !(tMax >= 0.0) || grid.empty()) return {};
    if (isNear(shape)) return ShapeCast(grid, shape, direction, tMax, accepted).run();
    return castFromAfar(grid, shape, direction, tMax, accepted);
}

std::optional<glm::ivec3> findOverlap(const VoxelGrid& grid, const CellShape& shape, EntryFilter accepted) {
    if (!isNear(shape, kMaxOverlap) || grid.empty()) return {};
    const glm::dvec3 middle = shape.middle(), halfExtent = shape.halfExtent();
    std::optional<BoxAxes> axes;
    if (shape.isBox) axes.emplace(shape);
    const auto meets = [&](glm::dvec3 low, double size) {
        if (axes) return axes->overlaps(middle - low - 0.5 * size, 0.5 * size);
        return closestToBox(shape.a, shape.b, low, low + size).distance <= shape.radius;
    };
    std::optional<glm::ivec3> found;
    forEachBrickIn(grid, middle - halfExtent, middle + halfExtent, [&](glm::ivec3 position, const Brick& brick) {
        if (found || !meets(glm::dvec3(position * kBrickSize), kBrickSize)) return;
        BrickBits bits = acceptedVoxels(brick, accepted);
        clip(bits, position, middle - halfExtent - 1.0, middle + halfExtent);
        forEachVoxel(bits, [&](int i) {
            const glm::ivec3 cell = position * kBrickSize + voxelInBrick(i);
            if (!found && meets(glm::dvec3(cell), 1.0)) found = cell;
        });
    });
    return found;
}

CellContact findDeepest(const VoxelGrid& grid, const CellShape& round) {
    CellContact best;
    if (!isNear(round) || grid.empty()) return best;
    const glm::dvec3 middle = round.middle(), halfExtent = round.halfExtent();
    best.t = round.radius;
    forEachBrickIn(grid, middle - halfExtent, middle + halfExtent, [&](glm::ivec3 position, const Brick& brick) {
        const glm::dvec3 base(position * kBrickSize);
        if (closestToBox(round.a, round.b, base, base + 8.0).distance > best.t) return;
        BrickBits bits = brick.occupancy;
        clip(bits, position, middle - halfExtent - 1.0, middle + halfExtent);
        forEachVoxel(bits, [&](int i) {
            const glm::ivec3 cell = position * kBrickSize + voxelInBrick(i);
            const SegmentToBox near = closestToBox(round.a, round.b, glm::dvec3(cell), glm::dvec3(cell) + 1.0);
            if (near.distance > best.t || (best.hit && near.distance == best.t)) return;
            const glm::dvec3 normal =
                near.distance > 0.0 ? (near.onSegment - near.onBox) / near.distance : glm::dvec3(0.0);
            best = {true, cell, near.distance, near.onBox, normal};
        });
    });
    return best;
}

ClosestVoxel findClosest(const VoxelGrid& grid, glm::dvec3 a, glm::dvec3 b, double maxDistance, EntryFilter accepted) {
    ClosestVoxel best;
    if (!isNear(a) || !isNear(b) || !(maxDistance >= 0.0) || grid.empty()) return best;
    maxDistance = std::min(maxDistance, kMaxCoordinate);
    best.to.distance = maxDistance;
    struct BrickCandidate {
        double distance;
        glm::ivec3 position;
        const Brick* brick;
    };
    std::vector<BrickCandidate> candidates;
    const glm::dvec3 low = glm::min(a, b) - maxDistance, high = glm::max(a, b) + maxDistance;
    forEachBrickIn(grid, low, high, [&](glm::ivec3 position, const Brick& brick) {
        const glm::dvec3 base(position * kBrickSize);
        const double distance = closestToBox(a, b, base, base + double(kBrickSize)).distance;
        if (distance <= maxDistance) candidates.push_back({distance, position, &brick});
    });
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const BrickCandidate& one, const BrickCandidate& two) { return one.distance < two.distance; });
    for (const BrickCandidate& each : candidates) {
        if (each.distance > best.to.distance || (best.found && each.distance == best.to.distance)) break;
        forEachVoxel(acceptedVoxels(*each.brick, accepted), [&](int i) {
            const glm::ivec3 cell = each.position * kBrickSize + voxelInBrick(i);
            const SegmentToBox to = closestToBox(a, b, glm::dvec3(cell), glm::dvec3(cell) + 1.0);
            if (to.distance > best.to.distance || (best.found && to.distance == best.to.distance)) return;
            best = {true, cell, to};
        });
    }
    return best;
}

}  // namespace rubble
