#include "physics/separation.h"

#include <cmath>

namespace rubble {
float widenGap(const PlacedHull& a, const PlacedHull& b, float enough, int turns, glm::vec3& axis) {
    float gap = gapAlong(a, b, axis), step = 1.0f;
    for (int turn = 0; turn < turns && gap <= enough; ++turn) {
        const glm::vec3 way = a.farthest(-axis) - b.farthest(axis);
        const glm::vec3 across = way - axis * glm::dot(way, axis);
        const float length2 = glm::dot(across, across);
        if (length2 < 1e-8f) break;
        const glm::vec3 n = axis + across * (step / std::sqrt(length2));
        const glm::vec3 turned = n / std::sqrt(glm::dot(n, n));
        const float wider = gapAlong(a, b, turned);
        if (wider > gap)
            gap = wider, axis = turned;
        else
            step *= 0.5f;
    }
    return gap;
}

}  // namespace rubble
