#pragma once
#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "physics/shapes/solid_rows.h"

namespace rubble {

/// A set of points, in cells of the grid, with the same convex hull as the solid cells (or as their bounds). It answers
/// support queries: how far the shape extends in a direction.
class HullPoints {
public:
    /// The hull of the solid cells of the rows' box, and few points more.
    explicit HullPoints(const SolidRows& rows);
    /// The eight corners of a box.
    explicit HullPoints(const CellBox& bounds);

    /// The number of points.
    size_t size() const { return m_count; }
    /// The support function: the largest dot product of a point with the direction, which need not have length 1.
    float support(const glm::vec3& direction) const;
    /// The first point at which the support function takes its value. far: support(direction).
    glm::vec3 supportPoint(const glm::vec3& direction, float far) const;
    /// The bounding box of axes * point over all points.
    void bounds(const glm::mat3& axes, glm::vec3& low, glm::vec3& high) const;

private:
    struct Points {
        std::array<float, 4> x, y, z;
    };
    void add(glm::ivec3 corner);

    std::vector<Points> m_points;  ///< the last four are filled up by repeating the last point
    size_t m_count = 0;
};

}  // namespace rubble
