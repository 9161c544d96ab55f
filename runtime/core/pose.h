#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace rubble {

/// A rigid placement: where a frame's origin is in its parent, in metres, and how it is turned.
struct Pose {
    glm::dvec3 position{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};

    glm::dvec3 transformPoint(glm::dvec3 local) const { return position + rotation * local; }
    glm::dvec3 inversePoint(glm::dvec3 parent) const { return glm::conjugate(rotation) * (parent - position); }
    friend bool operator==(const Pose& a, const Pose& b) {
        return a.position == b.position && a.rotation == b.rotation;
    }
};

/// Applies the right pose first: child-in-parent = parent * child-in-it.
inline Pose operator*(const Pose& parent, const Pose& child) {
    return {parent.transformPoint(child.position), glm::normalize(parent.rotation * child.rotation)};
}

}  // namespace rubble
