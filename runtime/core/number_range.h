#pragma once
#include <glm/vec3.hpp>

namespace rubble {

/// The numbers from `low` to `high`, both included. Not a number is in none.
struct NumberRange {
    double low = 0.0, high = 0.0;
};

/// Whether low <= value <= high; false for a NaN.
inline bool isWithin(double value, double low, double high) {
    return value >= low && value <= high;
}
/// Whether a value is in a range; false for a NaN.
inline bool isWithin(double value, NumberRange range) {
    return isWithin(value, range.low, range.high);
}
/// Whether each component is in a range; false for a NaN.
inline bool isWithin(const glm::dvec3& v, NumberRange range) {
    return isWithin(v.x, range) && isWithin(v.y, range) && isWithin(v.z, range);
}

}  // namespace rubble
