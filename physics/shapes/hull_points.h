#pragma once
#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "physics/shapes/solid_rows.h"

namespace rubble {

/// Corners of cells whose convex hull holds all of a shape: those of its own hull and few more, or those of its bounds.
/// They say how far the shape reaches in any direction.
class HullPoints {
public:
    /// Of the solid cells in the box.
    explicit HullPoints(const SolidRows& rows);
    explicit HullPoints(const CellBox& bounds);

    size_t size() const { return m_count; }
    /// The support dot product of a point with a direction.
    float support(const glm::vec3& direction) const;
    /// The point that has it.
    glm::vec3 supportPoint(const glm::vec3& direction) const;
    /// Bounds of the points after axes * point.
    void bounds(const glm::mat3& axes, glm::vec3& low, glm::vec3& high) const;

private:
    struct Points {
        std::array<float, 4> x, y, z;
    };
    void add(glm::ivec3 corner);

    std::vector<Points> m_points;  ///< float4 at a time, filled up with the last
    size_t m_count = 0;
};

}  // namespace rubble
