#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

namespace rubble {

/// A body as the solver moves it, in double. Its frame is the centre of mass in principal axes.
struct SolverBody {
    glm::dvec3 position{0.0};  ///< world, metres
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 velocity{0.0}, angularVelocity{0.0};  ///< world, m/s and rad/s
    glm::dvec3 inertia{1.0};                         ///< principal moments, kg m2
    double inverseMass = 0.0;                        ///< 1/kg; 0: it does not move
    float gravityScale = 1.0f;                       ///< with buoyancy: less than 1, or below 0
    bool conservesMomentum = false;                  ///< free rotation keeps angular momentum: see rotateBody()
    double regainable = 0.0;                         ///< joules lost lately, to regain; below 0: to lose
};

/// A body within the step, in float: movements since the step began are small. The order is that in which
/// contact_kernels.cpp loads it.
struct alignas(64) SolverState {
    glm::vec3 v{0.0f};  ///< linear velocity, world
    float inverseMass = 0.0f;
    glm::vec3 w{0.0f};  ///< angular velocity, world
    float unused = 0.0f;
    glm::mat3 inverseInertia{0.0f};  ///< world
    glm::mat3 deltaRotation{0.0f};   ///< rotation since the step began, less the identity
    glm::vec3 deltaPosition{0.0f};   ///< since the step began
    bool isConstrained = false;      ///< by a contact or joint; if not, it stays in double
    bool isLoadBearing = false;      ///< something much heavier lies on it
    bool isJointed = false;
    bool keepsPath = false;  ///< it is hit by something that closes fast, or rotates far
    bool isSteady = false;   ///< its contacts act as in the substep before: see SteadyBodies
    float gravityScale = 1.0f;
};

/// Rotates a body through one substep without torque. With conservesMomentum its angular momentum is constant, else its
/// angular velocity: cheaper, and accurate for slow bodies and for those with nearly equal principal moments.
void rotateBody(SolverBody& body, double seconds);
/// Whether all principal moments are equal: then neither the angular velocity nor effective masses change as it
/// rotates.
bool hasEqualMoments(const SolverBody& body);
/// About its centre of mass, world axes, kg m2/s.
glm::dvec3 angularMomentum(const SolverBody& body);
/// By how much free rotation through a time changes the angular velocity, rad/s, world.
glm::dvec3 freeSpinChange(const SolverBody& body, double seconds);
/// Joules of its motion.
double kineticEnergy(const SolverBody& body);
/// The inverse of the inertia tensor in world axes, 1/(kg m2).
glm::dmat3 worldInverseInertia(const SolverBody& body);

}  // namespace rubble
