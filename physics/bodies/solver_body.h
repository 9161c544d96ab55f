#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

namespace rubble {

/// A body as the solver moves it. Its frame is its principal axes about the centre of mass.
struct SolverBody {
    glm::dvec3 position{0.0};  ///< world, metres
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 velocity{0.0}, angularVelocity{0.0};
    glm::dvec3 inertia{1.0};  ///< kg m2
    double inverseMass = 0.0;
    double minHalfExtent = 0.0;      ///< metres: half its smallest side
    bool conservesMomentum = false;  ///< its rotation keeps angular momentum: for uneven bodies that spin fast
};

/// A body within the step.
struct SolverState {
    glm::vec3 v{0.0f}, w{0.0f};
    float inverseMass = 0.0f, minHalfExtent = 0.0f;
    glm::vec3 deltaPosition{0.0f};   ///< since the step began
    glm::mat3 deltaRotation{0.0f};   ///< rotation since the step began, less the identity
    glm::mat3 inverseInertia{0.0f};  ///< world
    bool isConstrained = false, isLoadBearing = false;
    bool inertiaRotates = false;  ///< within the step
    bool isJointed = false;
    bool isHitByFast = false;  ///< so fast that its core counts
};

/// One substep of a body's rotation. Bodies that conserve hold their angular momentum (see rotation.cpp for how); the
/// others keep their angular velocity.
void rotateBody(SolverBody& body, double seconds);
/// World tensor of a body's inverse inertia.
glm::dmat3 worldInverseInertia(const SolverBody& body);

}  // namespace rubble
