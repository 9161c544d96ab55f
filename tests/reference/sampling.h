#pragma once
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "runtime/core/constants.h"
#include "runtime/core/random.h"

namespace rubble::reference {

/// Two uniform numbers in [0, 1), in a fixed order.
inline glm::dvec2 unitSquare(Random& random) {
    const double x = random.unit();
    const double y = random.unit();
    return {x, y};
}

/// A right-handed basis: two unit vectors and n itself, as columns.
inline glm::dmat3 orthonormalBasis(glm::dvec3 n) {
    const glm::dvec3 aside = std::abs(n.x) > 0.7 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 t = glm::normalize(glm::cross(aside, n));
    return {t, glm::cross(n, t), n};
}

/// A direction around n with density cos / pi.
inline glm::dvec3 cosineDirection(glm::dvec3 n, glm::dvec2 u) {
    const double angle = 2.0 * kPi * u.x, r = std::sqrt(u.y);
    return glm::normalize(orthonormalBasis(n) *
                          glm::dvec3(r * std::cos(angle), r * std::sin(angle), std::sqrt(1.0 - u.y)));
}

/// A direction uniform within an angle, given by its cosine, of the axis.
inline glm::dvec3 coneDirection(glm::dvec3 axis, double cosine, glm::dvec2 u) {
    const double angle = 2.0 * kPi * u.x, z = 1.0 - u.y * (1.0 - cosine), r = std::sqrt(std::max(0.0, 1.0 - z * z));
    return glm::normalize(orthonormalBasis(axis) * glm::dvec3(r * std::cos(angle), r * std::sin(angle), z));
}

/// A GGX normal with the density of those visible from v (Heitz 2018, "Sampling the GGX distribution of visible
/// normals"): unlike the shaders' spherical cap, so that the two check each other. Local frame, z up.
inline glm::dvec3 sampleVisibleNormal(glm::dvec3 v, double alpha, glm::dvec2 u) {
    const glm::dvec3 vh = glm::normalize(glm::dvec3(alpha * v.x, alpha * v.y, v.z));
    const glm::dmat3 frame = orthonormalBasis(vh);
    // Projected along vh, the hemisphere is a half disc and half an ellipse of height vh.z, with areas as 1 to vh.z.
    const double angle = 2.0 * kPi * u.x, r = std::sqrt(u.y);
    // The second axis must lie in the plane of vh and the pole.
    const glm::dvec3 t1 = vh.z < 0.999999 ? glm::normalize(glm::cross(glm::dvec3(0, 0, 1), vh)) : frame[0];
    const glm::dvec3 t2 = glm::cross(vh, t1);
    const double p1 = r * std::cos(angle), s = 0.5 * (1.0 + vh.z);
    const double p2 = (1.0 - s) * std::sqrt(std::max(0.0, 1.0 - p1 * p1)) + s * r * std::sin(angle);
    const glm::dvec3 h = p1 * t1 + p2 * t2 + std::sqrt(std::max(0.0, 1.0 - p1 * p1 - p2 * p2)) * vh;
    return glm::normalize(glm::dvec3(alpha * h.x, alpha * h.y, std::max(1e-6, h.z)));
}

}  // namespace rubble::reference
