#pragma once
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace rubble {

/// A vector or quaternion at length 1. One of that length, up to rounding, stays as it is to the last bit: who sets
/// what was read changes nothing. The length is not 0.
template <class T>
T unitLength(const T& v) {
    using Real = typename T::value_type;
    const Real squared = glm::dot(v, v);
    return std::abs(squared - Real(1)) <= Real(8) * std::numeric_limits<Real>::epsilon() ? v : v / std::sqrt(squared);
}

}  // namespace rubble
