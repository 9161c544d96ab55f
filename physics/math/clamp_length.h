#pragma once
#include <cmath>
#include <glm/geometric.hpp>

namespace rubble {

/// A vector shortened to maxLength where it is longer. Its length as glm::length() computes it is never above
/// maxLength.
inline glm::dvec3 clampedLength(const glm::dvec3& v, double maxLength) {
    constexpr double kRounding = 1.0 - 0x1p-50;  // more than the rounding of the products and of the root
    const double length2 = glm::dot(v, v);
    return length2 > maxLength * maxLength ? v * (maxLength / std::sqrt(length2) * kRounding) : v;
}

/// Shortens a vector that is longer than maxLength; false if it is not.
inline bool clampLength(glm::dvec3& v, double maxLength) {
    const glm::dvec3 before = v;
    v = clampedLength(v, maxLength);
    return v != before;
}

}  // namespace rubble
