#include <glm/glm.hpp>

#include "physics/contact_solver.h"

namespace rubble {
namespace {

/// The rotation by `angle` radians about its axis, by Cayley's map corrected to fifth order: no library's sine decides a bit.
glm::dquat turnBy(glm::dvec3 angle) {
    const glm::dvec3 half = angle * 0.5;
    const double x = glm::dot(half, half);
    const double tangent = 1.0 + x * (1.0 / 3.0 + x * (2.0 / 15.0));  // tan(h) / h
    return glm::normalize(glm::dquat(1.0, half.x * tangent, half.y * tangent, half.z * tangent));
}

/// Angular velocity of a body of this momentum, both in world axes.
glm::dvec3 spinOf(const glm::dquat& rotation, glm::dvec3 inertia, glm::dvec3 momentum) {
    return rotation * ((glm::conjugate(rotation) * momentum) / inertia);
}

}  // namespace

void rotateBody(SolverBody& body, double seconds) {
    if (!body.conserves) {
        body.rotation = glm::normalize(turnBy(body.angularVelocity * seconds) * body.rotation);
        return;
    }
    const glm::dquat before = body.rotation;
    const glm::dvec3 momentum = before * (body.inertia * (glm::conjugate(before) * body.angularVelocity));
    glm::dvec3 middle = body.angularVelocity;
    for (int i = 0; i < 4; ++i) {
        const glm::dquat halfway = glm::normalize(turnBy(middle * (0.5 * seconds)) * before);
        middle = spinOf(halfway, body.inertia, momentum);
    }
    body.rotation = glm::normalize(turnBy(middle * seconds) * before);
    body.angularVelocity = spinOf(body.rotation, body.inertia, momentum);
}

glm::dmat3 worldInverseInertia(const SolverBody& body) {
    const glm::dmat3 axes = glm::mat3_cast(body.rotation);
    glm::dmat3 scaled = axes;
    for (int i = 0; i < 3; ++i) scaled[i] /= body.inertia[i];
    return scaled * glm::transpose(axes);
}

}  // namespace rubble
