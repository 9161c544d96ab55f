#include <algorithm>
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

/// The principal axis whose moment is the farthest from the other two.
int uniqueAxis(glm::dvec3 inertia) {
    int found = 0;
    double closest = 1e300;
    for (int i = 0; i < 3; ++i) {
        const double a = inertia[(i + 1) % 3], b = inertia[(i + 2) % 3], apart = std::max(a, b) / std::min(a, b);
        if (apart < closest) closest = apart, found = i;
    }
    return found;
}

}  // namespace

void rotateBody(SolverBody& body, double seconds) {
    if (!body.conserves) {
        body.rotation = glm::normalize(turnBy(body.angularVelocity * seconds) * body.rotation);
        return;
    }
    // A symmetric top turns about its momentum and about its own axis at constant rates, so those two turns are its exact
    // motion however long it is. What differs between the other two axes is a third turn, half before and half after.
    const int axis = uniqueAxis(body.inertia), middle = (axis + 1) % 3, last = (axis + 2) % 3;
    const glm::dvec3 inverse = 1.0 / body.inertia;
    glm::dvec3 momentum = body.inertia * (glm::conjugate(body.rotation) * body.angularVelocity);  // principal axes
    glm::dquat& rotation = body.rotation;
    const auto turnAbout = [&](int i, double time) {
        glm::dvec3 angle(0.0);
        angle[i] = (inverse[i] - inverse[last]) * momentum[i] * time;
        const glm::dquat turn = turnBy(angle);
        rotation = rotation * turn;
        momentum = glm::conjugate(turn) * momentum;
    };
    turnAbout(middle, 0.5 * seconds);
    turnAbout(axis, 0.5 * seconds);
    rotation = rotation * turnBy(momentum * (inverse[last] * seconds));
    turnAbout(axis, 0.5 * seconds);
    turnAbout(middle, 0.5 * seconds);
    rotation = glm::normalize(rotation);
    body.angularVelocity = rotation * (momentum * inverse);
}

glm::dmat3 worldInverseInertia(const SolverBody& body) {
    const glm::dmat3 axes = glm::mat3_cast(body.rotation);
    glm::dmat3 scaled = axes;
    for (int i = 0; i < 3; ++i) scaled[i] /= body.inertia[i];
    return scaled * glm::transpose(axes);
}

}  // namespace rubble
