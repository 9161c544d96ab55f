#pragma once
#include "physics/shapes/hull_points.h"

namespace rubble {

/// The convex hull of a shape at its place, about some origin near by, in metres.
struct TransformedHull {
    const HullPoints& points;
    glm::mat3 axes;    ///< of a cell
    glm::vec3 corner;  ///< of the grid

    float support(const glm::vec3& direction) const {
        return glm::dot(corner, direction) + points.support(direction * axes);
    }
    glm::vec3 supportPoint(const glm::vec3& direction) const {
        return corner + axes * points.supportPoint(direction * axes);
    }
};

/// How far `a` is from `b` along a unit vector that points from b to a; < 0: they overlap by that much, seen from
/// there.
inline float gapAlongAxis(const TransformedHull& a, const TransformedHull& b, const glm::vec3& axis) {
    return -a.support(-axis) - b.support(axis);
}

/// Turns a unit vector at most `turns` times towards where the gap is widest, until that is `enough`; returns the gap.
float refineSeparatingAxis(const TransformedHull& a, const TransformedHull& b, float enough, int turns,
                           glm::vec3& axis);

}  // namespace rubble
