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

    /// The support function: the largest dot product of a point of the hull with the direction, metres for a unit
    /// vector.
    float support(const glm::vec3& direction) const {
        return glm::dot(corner, direction) + points.support(direction * axes);
    }
    /// A point at which the support function takes its value.
    glm::vec3 supportPoint(const glm::vec3& direction) const {
        return corner + axes * points.supportPoint(direction * axes);
    }
};

/// The distance between the projections of two hulls on a unit vector that points from b to a, metres. Negative: the
/// projections overlap.
inline float gapAlongAxis(const TransformedHull& a, const TransformedHull& b, const glm::vec3& axis) {
    return -a.support(-axis) - b.support(axis);
}

/// Turns `axis`, a unit vector from b to a, uphill towards the widest gap. Stops after maxIterations, or when the gap
/// exceeds `enough` (metres). Returns the gap along the axis that it found.
float refineSeparatingAxis(const TransformedHull& a, const TransformedHull& b, float enough, int maxIterations,
                           glm::vec3& axis);

}  // namespace rubble
