#pragma once
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>

namespace rubble {

/// Half the size, along the axes of the outer frame, of the box that bounds a box of half size `half` whose axes are
/// the columns of a matrix: |M| half.
template <class T, glm::qualifier Q>
glm::vec<3, T, Q> rotatedHalfExtent(const glm::mat<3, 3, T, Q>& axes, const glm::vec<3, T, Q>& half) {
    return glm::abs(axes[0]) * half.x + glm::abs(axes[1]) * half.y + glm::abs(axes[2]) * half.z;
}

}  // namespace rubble
