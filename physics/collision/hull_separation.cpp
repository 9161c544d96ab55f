#include "physics/collision/hull_separation.h"

#include <cmath>

namespace rubble {
float refineSeparatingAxis(const TransformedHull& a, const TransformedHull& b, float enough, int turns,
                           glm::vec3& axis) {
    float gap = gapAlongAxis(a, b, axis), step = 1.0f;
    for (int turn = 0; turn < turns && gap <= enough; ++turn) {
        const glm::vec3 displacement = a.supportPoint(-axis) - b.supportPoint(axis);
        const glm::vec3 across = displacement - axis * glm::dot(displacement, axis);
        const float length2 = glm::dot(across, across);
        if (length2 < 1e-8f) break;
        const glm::vec3 n = axis + across * (step / std::sqrt(length2));
        const glm::vec3 turned = n / std::sqrt(glm::dot(n, n));
        const float wider = gapAlongAxis(a, b, turned);
        if (wider > gap)
            gap = wider, axis = turned;
        else
            step *= 0.5f;
    }
    return gap;
}

}  // namespace rubble
