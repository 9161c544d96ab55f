#pragma once
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace rubble {

/// The axes of a map seen from the sun: unit vectors at right angles to its rays and to each other.
struct SunBasis {
    glm::vec3 right, up;
};
/// sun: unit vector towards the sun. The axes turn steadily with it, except close to the zenith.
inline SunBasis sunBasis(glm::vec3 sun) {
    const glm::vec3 right =
        glm::normalize(glm::cross(std::abs(sun.y) < 0.99f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0), sun));
    return {right, glm::cross(sun, right)};
}

}  // namespace rubble
