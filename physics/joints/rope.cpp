#include "physics/joints/rope.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "physics/bodies/dynamic_body.h"
#include "physics/shapes/cell_transform.h"

// Ropes by position-based dynamics (Mueller et al., "Position Based Dynamics", 2007).
//
// A rope is a chain of points of equal mass. A substep of h seconds moves each point x by h (v + h g), then projects
// the positions onto the constraints, and sets v to the change of position divided by h. A segment may not be longer
// than its rest length l: with d = x_j - x_i and the inverse masses w, its projection is
//     x_i += w_i (|d| - l) / (w_i + w_j) d / |d|,   x_j -= w_j (...) d / |d|
// and nothing if it is shorter, since a rope does not push. Points at the ends that something holds have w = 0. The
// last passes give the whole correction to the farther point ("follow the leader"), which makes a taut rope straight.
// Then places along the segments are pushed out of voxels, with Coulomb friction along the displacement by which they
// slid: an exit of depth d takes back up to friction * d of it.

namespace rubble {
namespace {

constexpr int kSubsteps = 4, kPasses = 6;
constexpr double kDrag = 0.4;           ///< fraction of a free point's speed that air takes in a second
constexpr double kSampling = 0.12;      ///< metres between the places that are kept out of voxels
constexpr double kNoContactEnds = 0.3;  ///< metres from a held end within which the rope touches nothing
constexpr double kFriction = 0.6;
constexpr int kMaxDepth = 3;             ///< cells from which a place is pushed out at most
constexpr double kTouchDistance = 0.02;  ///< metres from a rope at which something bends it
constexpr double kMaxSpeed = 200.0;      ///< m/s, above which a point is stopped

const std::array<glm::ivec3, 6> kSides = {{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};

/// The displacement, in cells, that takes a ball whose centre is in an empty cell out of the solid neighbours that it
/// reaches into.
glm::dvec3 exitFromNeighbours(const VoxelGrid& grid, glm::ivec3 cell, glm::dvec3 center, double radius) {
    glm::dvec3 out(0.0);
    for (const glm::ivec3& side : kSides) {
        const glm::ivec3 next = glm::ivec3(glm::floor(center + glm::dvec3(side) * radius));
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
    double shortest = 1e9;
    for (const glm::ivec3& side : kSides)
        for (int depth = 1; depth <= kMaxDepth; ++depth) {
            if (grid.at(cell + side * depth)) continue;
            double distance = 0.0;
            for (int a = 0; a < 3; ++a) {
                if (side[a] > 0) distance = double(cell[a] + depth) + radius - center[a];
                if (side[a] < 0) distance = center[a] - double(cell[a] - depth + 1) + radius;
            }
            if (distance < shortest) shortest = distance, out = glm::dvec3(side) * distance;
            break;
        }
    return out;
}

/// The displacement that takes a ball out of a grid, in its cells; zero: it touches nothing.
glm::dvec3 exitDisplacement(const VoxelGrid& grid, glm::dvec3 center, double radius) {
    const glm::dvec3 size(grid.size());
    for (int a = 0; a < 3; ++a)
        if (!(center[a] > -radius && center[a] < size[a] + radius)) return glm::dvec3(0.0);
    const glm::ivec3 cell = glm::ivec3(glm::floor(center));
    return grid.at(cell) ? exitFromInside(grid, cell, center, radius) : exitFromNeighbours(grid, cell, center, radius);
}

/// The same for all parts of an object, metres, world axes.
glm::dvec3 exitDisplacement(const CollisionObject& object, glm::dvec3 center, double radius) {
    glm::dvec3 out(0.0);
    const std::span<const CellTransform> cellTransforms = object.cellTransforms();
    for (size_t i = 0; i < cellTransforms.size(); ++i) {
        const ColliderPart& part = *object.collider.parts[i];
        const double size = part.voxelSize();
        const glm::dvec3 local = center + out - object.pose.position - cellTransforms[i].corner;
        const glm::dmat3& axes = cellTransforms[i].axes;
        const glm::dvec3 cells =
            glm::dvec3(glm::dot(axes[0], local), glm::dot(axes[1], local), glm::dot(axes[2], local)) / (size * size);
        const glm::dvec3 exit = exitDisplacement(part.grid(), cells, radius / size);
        if (exit != glm::dvec3(0.0)) out += axes * exit;
    }
    return out;
}

class RopeSolver {
public:
    RopeSolver(std::span<RopePoint> points, const RopeStep& step, std::vector<RopeBend>& bends)
        : m_points(points),
          m_step(step),
          m_bends(bends),
          m_last(points.size() - 1),
          m_spacing(step.length / double(m_last)) {
        for (const RopePoint& point : points) m_before.push_back(point.position);
    }

    /// Returns the largest speed of a point, m/s.
    double run() {
        const double h = m_step.seconds / kSubsteps;
        const std::array<glm::dvec3, 2> from = {m_points.front().position, m_points.back().position};
        for (int substep = 1; substep <= kSubsteps; ++substep) {
            predict(h);
            const double share = double(substep) / kSubsteps;
            for (size_t end = 0; end < 2; ++end)
                if (m_step.ends[end])
                    m_points[end ? m_last : 0].position = from[end] + (*m_step.ends[end] - from[end]) * share;
            for (int pass = 0; pass < kPasses; ++pass) limitLengths(pass % 2 == 0, pass + 2 >= kPasses);
            collide();
            updateVelocities(h);
        }
        double fastest = 0.0;
        for (const RopePoint& point : m_points) fastest = std::max(fastest, glm::length(point.velocity));
        return fastest;
    }

    /// Pushes the points out of what is nearby, and notes where.
    void collide() {
        m_bends.clear();
        if (m_step.nearby.empty()) return;
        for (size_t i = 0; i < m_last; ++i) {
            const int samples = int(std::clamp(std::ceil(m_spacing / kSampling), 1.0, 16.0));
            for (int k = i == 0 ? 0 : 1; k <= samples; ++k) collideAt(i, double(k) / samples);
        }
    }

private:
    /// Inverse mass, in units of a point's.
    double weight(size_t i) const { return (i == 0 && m_step.ends[0]) || (i == m_last && m_step.ends[1]) ? 0.0 : 1.0; }

    void predict(double h) {
        for (size_t i = 0; i <= m_last; ++i) {
            RopePoint& point = m_points[i];
            m_before[i] = point.position;
            point.velocity = (point.velocity + m_step.gravity * h) * (1.0 - kDrag * h);
            point.position += point.velocity * h;
        }
    }

    void updateVelocities(double h) {
        for (size_t i = 0; i <= m_last; ++i) {
            glm::dvec3 velocity = (m_points[i].position - m_before[i]) / h;
            const double speed = glm::length(velocity);
            if (!(speed < kMaxSpeed)) velocity = glm::dvec3(0.0);
            m_points[i].velocity = velocity;
        }
    }

    /// One pass over the segments. follow: the farther point of each takes the whole correction.
    void limitLengths(bool forward, bool follow) {
        for (size_t k = 0; k < m_last; ++k) {
            const size_t i = forward ? k : m_last - k, j = forward ? k + 1 : m_last - k - 1;
            const glm::dvec3 segment = m_points[j].position - m_points[i].position;
            const double length = glm::length(segment);
            if (length <= m_spacing) continue;
            double wi = weight(i), wj = weight(j);
            if (follow && wj > 0.0) wi = 0.0;
            if (wi + wj == 0.0) continue;
            const glm::dvec3 change = segment * ((length - m_spacing) / (length * (wi + wj)));
            m_points[i].position += change * wi;
            m_points[j].position -= change * wj;
        }
    }

    /// Pushes the place at a fraction of segment i out of what is nearby, by moving the segment's two points.
    void collideAt(size_t i, double fraction) {
        const double along = (double(i) + fraction) * m_spacing;
        if ((m_step.ends[0] && along < kNoContactEnds) || (m_step.ends[1] && m_step.length - along < kNoContactEnds))
            return;
        RopePoint &a = m_points[i], &b = m_points[i + 1];
        const glm::dvec3 place = a.position + (b.position - a.position) * fraction;
        const glm::dvec3 before = m_before[i] + (m_before[i + 1] - m_before[i]) * fraction;
        glm::dvec3 out(0.0);
        const CollisionObject* touched = nullptr;
        for (const CollisionObject* object : m_step.nearby) {
            const glm::dvec3 radius(m_step.radius + kTouchDistance);
            const glm::dvec3 now = place + out;
            if (glm::any(glm::lessThan(now, object->low - radius)) ||
                glm::any(glm::greaterThan(now, object->high + radius)))
                continue;
            const glm::dvec3 exit = exitDisplacement(*object, now, m_step.radius + kTouchDistance);
            if (exit != glm::dvec3(0.0)) out += exit, touched = object;
        }
        const double depth = glm::length(out) - kTouchDistance;
        if (!touched) return;
        if (!(depth > 0.0)) return m_bends.push_back(bendOn(*touched, place));
        out *= depth / (depth + kTouchDistance);
        const glm::dvec3 normal = glm::normalize(out);
        const glm::dvec3 slid = place - before - normal * glm::dot(place - before, normal);
        const double slide = glm::length(slid);
        if (slide > 0.0) out -= slid * std::min(1.0, kFriction * depth / slide);
        const double wa = weight(i) * (1.0 - fraction), wb = weight(i + 1) * fraction,
                     sum = wa * (1.0 - fraction) + wb * fraction;
        if (sum < 1e-6) return m_bends.push_back(bendOn(*touched, place));
        a.position += out * (wa / sum);
        b.position += out * (wb / sum);
        m_bends.push_back(bendOn(*touched, a.position + (b.position - a.position) * fraction));
    }
    static RopeBend bendOn(const CollisionObject& object, glm::dvec3 place) {
        if (!object.dynamic) return {place, {}, {}};
        return {place, object.dynamic->handle(), object.dynamic->pose().inversePoint(place)};
    }

    std::span<RopePoint> m_points;
    const RopeStep& m_step;
    std::vector<RopeBend>& m_bends;
    size_t m_last;                     ///< index of the last point
    double m_spacing;                  ///< rest length of a segment, metres
    std::vector<glm::dvec3> m_before;  ///< positions before the substep
};

}  // namespace

double moveRope(std::span<RopePoint> points, const RopeStep& step, std::vector<RopeBend>& bends) {
    return RopeSolver(points, step, bends).run();
}

void findBends(std::span<const RopePoint> points, const RopeStep& step, std::vector<RopeBend>& bends) {
    std::vector<RopePoint> copy(points.begin(), points.end());
    RopeSolver(copy, step, bends).collide();
}

}  // namespace rubble
