#pragma once
#include "physics/shapes/hull_points.h"

// Early out of narrowphase: whether the convex hulls of two shapes are separated, by a local search for the axis of the
// widest gap. It is a simplification of Gilbert, Johnson and Keerthi's algorithm (GJK, 1988) that needs no simplex: the
// axis of the step before is an excellent start, and a gap that is too small costs time, never correctness.

namespace rubble {

/// The convex hull of a shape in world axes, in metres from an origin nearby.
struct TransformedHull {
    const HullPoints& points;
    glm::mat3 axes;    ///< of a cell
    glm::vec3 corner;  ///< of cell (0, 0, 0)
};

/// How far a hull extends in a direction.
class HullSupport {
public:
    /// direction: a unit vector.
    HullSupport(const TransformedHull& hull, const glm::vec3& direction)
        : m_direction(direction * hull.axes),
          m_far(hull.points.support(m_direction)),
          m_origin(glm::dot(hull.corner, direction)) {}
    /// The largest dot product of a point of the hull with the direction, metres.
    float distance() const { return m_origin + m_far; }
    /// A point at which it is reached. hull: the same.
    glm::vec3 pointOf(const TransformedHull& hull) const {
        return hull.corner + hull.axes * hull.points.supportPoint(m_direction, m_far);
    }

private:
    glm::vec3 m_direction;  ///< in cells
    float m_far, m_origin;  ///< the largest dot product from cell (0, 0, 0), and that of this cell
};

/// Two hulls along a unit vector that points from b to a.
struct HullGap {
    /// axis: the vector.
    HullGap(const TransformedHull& hullA, const TransformedHull& hullB, const glm::vec3& axis)
        : a(hullA, -axis), b(hullB, axis) {}
    /// The distance between the projections, metres; negative: they overlap.
    float distance() const { return -a.distance() - b.distance(); }
    HullSupport a, b;  ///< of a against the vector, of b along it
};

/// Turns `axis`, a unit vector from b to a, uphill towards the widest gap. Stops after maxIterations, or when the gap
/// exceeds `enough` (metres). Returns the gap along the axis that it found.
HullGap refineSeparatingAxis(const TransformedHull& a, const TransformedHull& b, float enough, int maxIterations,
                             glm::vec3& axis);

}  // namespace rubble
