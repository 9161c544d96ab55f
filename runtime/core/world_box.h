#pragma once
#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "runtime/core/rotated_box.h"

namespace rubble {

/// An axis-aligned box in world space, metres.
struct WorldBox {
    glm::dvec3 low{0.0}, high{0.0};

    /// Whether the boxes have a point in common; touching faces count. False with a NaN.
    bool overlaps(const WorldBox& o) const {
        return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y && low.z <= o.high.z &&
               o.low.z <= high.z;
    }
    /// Whether all of `o` is inside; touching faces count as inside.
    bool contains(const WorldBox& o) const {
        return low.x <= o.low.x && low.y <= o.low.y && low.z <= o.low.z && o.high.x <= high.x && o.high.y <= high.y &&
               o.high.z <= high.z;
    }
    /// The smallest box around both.
    WorldBox merged(const WorldBox& o) const { return {glm::min(low, o.low), glm::max(high, o.high)}; }
    /// Half the surface area, m2: the cost measure of a bounds tree.
    double area() const {
        const glm::dvec3 d = high - low;
        return d.x * d.y + d.y * d.z + d.z * d.x;
    }
};

/// The smallest world box around a rotated box.
inline WorldBox boundsOfBox(glm::dvec3 center, glm::dvec3 halfSize, const glm::dquat& rotation) {
    const glm::dvec3 extent = rotatedHalfExtent(glm::mat3_cast(rotation), halfSize);
    return {center - extent, center + extent};
}

}  // namespace rubble
