#include "physics/collision/hull_separation.h"

#include <cmath>

namespace rubble {

/// The gap along an axis is -max over the points p of a and q of b of dot(q - p, axis); its gradient is the difference
/// p - q of the two support points. Each iteration turns the axis by atan(step) towards that gradient's part across the
/// axis, and halves the step when the gap does not widen.
HullGap refineSeparatingAxis(const TransformedHull& a, const TransformedHull& b, float enough, int maxIterations,
                             glm::vec3& axis) {
    HullGap gap(a, b, axis);
    float step = 1.0f;
    for (int i = 0; i < maxIterations && gap.distance() <= enough; ++i) {
        const glm::vec3 gradient = gap.a.pointOf(a) - gap.b.pointOf(b);
        const glm::vec3 across = gradient - axis * glm::dot(gradient, axis);
        const float length2 = glm::dot(across, across);
        if (length2 < 1e-8f) break;
        const glm::vec3 n = axis + across * (step / std::sqrt(length2));
        const glm::vec3 candidate = n / std::sqrt(glm::dot(n, n));
        const HullGap candidateGap(a, b, candidate);
        if (candidateGap.distance() > gap.distance())
            gap = candidateGap, axis = candidate;
        else
            step *= 0.5f;
    }
    return gap;
}

}  // namespace rubble
