#pragma once
#include <glm/vec3.hpp>

namespace rubble {

/// Whether low <= value <= high; false for a NaN.
inline bool isWithin(double value, double low, double high) {
    return value >= low && value <= high;
}
/// Whether each component is in [low, high]; false for a NaN.
inline bool isWithin(const glm::dvec3& v, double low, double high) {
    return isWithin(v.x, low, high) && isWithin(v.y, low, high) && isWithin(v.z, low, high);
}
/// Whether each component is in [-limit, limit]; false for a NaN.
inline bool isWithin(const glm::dvec3& v, double limit) {
    return isWithin(v, -limit, limit);
}

}  // namespace rubble
