#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace rubble {

/// A rigid transform from a local frame to its parent: position of the origin in metres, and rotation.
struct Pose {
    glm::dvec3 position{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};

    /// A point of the local frame in the parent frame. Metres.
    glm::dvec3 transformPoint(glm::dvec3 local) const { return position + rotation * local; }
    /// A point of the parent frame in the local frame. Metres.
    glm::dvec3 inversePoint(glm::dvec3 parent) const { return glm::conjugate(rotation) * (parent - position); }
    friend bool operator==(const Pose& a, const Pose& b) {
        return a.position == b.position && a.rotation == b.rotation;
    }
};

/// The composition: `child` is applied first. `child` maps to the frame that `parent` maps from.
inline Pose operator*(const Pose& parent, const Pose& child) {
    return {parent.transformPoint(child.position), glm::normalize(parent.rotation * child.rotation)};
}

}  // namespace rubble
