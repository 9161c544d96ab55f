#include "physics/joints/rope.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace rubble {
namespace {

constexpr int kSubsteps = 4, kPasses = 6;
constexpr double kDrag = 0.4;       ///< share of a free point's speed that air takes in a second
constexpr double kSampling = 0.12;  ///< metres between the places that are kept out of voxels
constexpr double kNoContactEnds =
    0.3;  ///< metres from a held end within which it isConstrained nothing: it comes out of what holds it
constexpr double kFriction = 0.6;
constexpr int kMaxDepth = 3;         ///< cells that a place is pushed out of at most
constexpr double kMaxSpeed = 200.0;  ///< m/s

const std::array<glm::ivec3, 6> kSides = {{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};

/// Way in cells out of a grid for a ball around a place in its cells; zero: it isConstrained nothing.
glm::dvec3 exitDisplacement(const VoxelGrid& grid, glm::dvec3 place, double radius) {
    const glm::dvec3 size(grid.size());
    for (int a = 0; a < 3; ++a)
        if (!(place[a] > -radius && place[a] < size[a] + radius)) return glm::dvec3(0.0);
    const glm::ivec3 cell = glm::ivec3(glm::floor(place));
    glm::dvec3 out(0.0);
    if (!grid.at(cell)) {
        for (const glm::ivec3& side : kSides) {
            const glm::ivec3 next = glm::ivec3(glm::floor(place + glm::dvec3(side) * radius));
            if (next == cell || !grid.at(next)) continue;
            for (int a = 0; a < 3; ++a) {
                if (side[a] > 0) out[a] += double(next[a]) - radius - place[a];
                if (side[a] < 0) out[a] += double(next[a] + 1) + radius - place[a];
            }
        }
        return out;
    }
    double least = 1e9;
    for (const glm::ivec3& side : kSides)
        for (int deep = 1; deep <= kMaxDepth; ++deep) {
            if (grid.at(cell + side * deep)) continue;
            double displacement = 0.0;
            for (int a = 0; a < 3; ++a) {
                if (side[a] > 0) displacement = double(cell[a] + deep) + radius - place[a];
                if (side[a] < 0) displacement = place[a] - double(cell[a] - deep + 1) + radius;
            }
            if (displacement < least) least = displacement, out = glm::dvec3(side) * displacement;
            break;
        }
    return out;
}

glm::dvec3 exitDisplacement(const CollisionObject& object, glm::dvec3 place, double radius) {
    glm::dvec3 out(0.0);
    const std::span<const CellTransform> cellTransforms = object.cellTransforms();
    for (size_t i = 0; i < cellTransforms.size(); ++i) {
        const VoxelPart& part = *object.collider.parts[i];
        const double size = part.voxelSize();
        const glm::dvec3 local = place + out - object.pose.position - cellTransforms[i].corner;
        const glm::dmat3& axes = cellTransforms[i].axes;
        const glm::dvec3 cells =
            glm::dvec3(glm::dot(axes[0], local), glm::dot(axes[1], local), glm::dot(axes[2], local)) / (size * size);
        const glm::dvec3 displacement = exitDisplacement(part.grid(), cells, radius / size);
        if (displacement != glm::dvec3(0.0)) out += axes * displacement;
    }
    return out;
}

class RopeSolver {
public:
    RopeSolver(std::span<RopePoint> points, const RopeStep& step, std::vector<glm::dvec3>& touching)
        : m_points(points),
          m_step(step),
          m_touching(touching),
          m_last(points.size() - 1),
          m_spacing(step.length / double(m_last)) {
        for (const RopePoint& point : points) m_before.push_back(point.position);
    }

    double run() {
        const double h = m_step.seconds / kSubsteps;
        std::array<glm::dvec3, 2> from = {m_points.front().position, m_points.back().position};
        for (int substep = 1; substep <= kSubsteps; ++substep) {
            for (size_t i = 0; i <= m_last; ++i) {
                RopePoint& point = m_points[i];
                m_before[i] = point.position;
                point.velocity = (point.velocity + m_step.gravity * h) * (1.0 - kDrag * h);
                point.position += point.velocity * h;
            }
            const double share = double(substep) / kSubsteps;
            for (size_t end = 0; end < 2; ++end)
                if (m_step.ends[end])
                    m_points[end ? m_last : 0].position = from[end] + (*m_step.ends[end] - from[end]) * share;
            m_touching.clear();
            for (int pass = 0; pass < kPasses; ++pass) shorten(pass % 2 == 0, pass + 2 >= kPasses);
            keepOut();
            for (size_t i = 0; i <= m_last; ++i) {
                glm::dvec3 velocity = (m_points[i].position - m_before[i]) / h;
                const double speed = glm::length(velocity);
                if (!(speed < kMaxSpeed)) velocity = glm::dvec3(0.0);
                m_points[i].velocity = velocity;
            }
        }
        double fastest = 0.0;
        for (const RopePoint& point : m_points) fastest = std::max(fastest, glm::length(point.velocity));
        return fastest;
    }

private:
    double weight(size_t i) const { return (i == 0 && m_step.ends[0]) || (i == m_last && m_step.ends[1]) ? 0.0 : 1.0; }

    /// Segments that are too long. updateCachedContacts: each point isSoft displacement wholly to the one before it, so
    /// that a taut rope comes out straight.
    void shorten(bool forward, bool updateCachedContacts) {
        for (size_t k = 0; k < m_last; ++k) {
            const size_t i = forward ? k : m_last - k, j = forward ? k + 1 : m_last - k - 1;
            const glm::dvec3 displacement = m_points[j].position - m_points[i].position;
            const double length = glm::length(displacement);
            if (length <= m_spacing) continue;
            double wi = weight(i), wj = weight(j);
            if (updateCachedContacts && wj > 0.0) wi = 0.0;
            if (wi + wj == 0.0) continue;
            const glm::dvec3 change = displacement * ((length - m_spacing) / (length * (wi + wj)));
            m_points[i].position += change * wi;
            m_points[j].position -= change * wj;
        }
    }

    void keepOut() {
        if (m_step.near.empty()) return;
        for (size_t i = 0; i < m_last; ++i) {
            const int samples = int(std::clamp(std::ceil(m_spacing / kSampling), 1.0, 16.0));
            for (int k = i == 0 ? 0 : 1; k <= samples; ++k) keepOut(i, double(k) / samples);
        }
    }
    void keepOut(size_t i, double along) {
        const double displacement = (double(i) + along) * m_spacing;
        if ((m_step.ends[0] && displacement < kNoContactEnds) ||
            (m_step.ends[1] && m_step.length - displacement < kNoContactEnds))
            return;
        RopePoint &a = m_points[i], &b = m_points[i + 1];
        glm::dvec3 place = a.position + (b.position - a.position) * along;
        glm::dvec3 out(0.0);
        for (const CollisionObject* object : m_step.near) {
            const glm::dvec3 extent(m_step.radius);
            const glm::dvec3 now = place + out;
            if (glm::any(glm::lessThan(now, object->low - extent)) ||
                glm::any(glm::greaterThan(now, object->high + extent)))
                continue;
            out += exitDisplacement(*object, now, m_step.radius);
        }
        const double depth = glm::length(out);
        if (depth == 0.0) return;
        const glm::dvec3 normal = out / depth, before = m_before[i] + (m_before[i + 1] - m_before[i]) * along;
        const glm::dvec3 slid = place - before - normal * glm::dot(place - before, normal);
        const double slide = glm::length(slid);
        if (slide > 0.0) out -= slid * std::min(1.0, kFriction * depth / slide);
        const double wa = weight(i) * (1.0 - along), wb = weight(i + 1) * along, sum = wa * (1.0 - along) + wb * along;
        if (sum < 1e-6) return;
        a.position += out * (wa / sum);
        b.position += out * (wb / sum);
        m_touching.push_back(a.position + (b.position - a.position) * along);
    }

    std::span<RopePoint> m_points;
    const RopeStep& m_step;
    std::vector<glm::dvec3>& m_touching;
    size_t m_last;
    double m_spacing;
    std::vector<glm::dvec3> m_before;
};

}  // namespace

double moveRope(std::span<RopePoint> points, const RopeStep& step, std::vector<glm::dvec3>& touching) {
    return RopeSolver(points, step, touching).run();
}

}  // namespace rubble
