#pragma once
#include "physics/hull_points.h"

namespace rubble {

/// The convex hull of a shape at its place, about some origin near by, in metres.
struct PlacedHull {
    const HullPoints& points;
    glm::mat3 axes;    ///< of a cell
    glm::vec3 corner;  ///< of the grid

    float highest(const glm::vec3& direction) const { return glm::dot(corner, direction) + points.highest(direction * axes); }
    glm::vec3 farthest(const glm::vec3& direction) const { return corner + axes * points.farthest(direction * axes); }
};

/// How far `a` is from `b` along a unit vector that points from b to a; < 0: they overlap by that much, seen from there.
inline float gapAlong(const PlacedHull& a, const PlacedHull& b, const glm::vec3& axis) {
    return -a.highest(-axis) - b.highest(axis);
}

/// Turns a unit vector at most `turns` times towards where the gap is widest, until that is `enough`; returns the gap.
float widenGap(const PlacedHull& a, const PlacedHull& b, float enough, int turns, glm::vec3& axis);

}  // namespace rubble
