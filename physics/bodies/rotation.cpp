#include <glm/glm.hpp>

#include "physics/solver/contact_solver.h"

namespace rubble {
namespace {

/// tan(h) / h of half an angle h, x = h^2, to fifth order: no library's tangent decides a bit.
double tanOverX(double x) {
    return 1.0 + x * (1.0 / 3.0 + x * (2.0 / 15.0));
}

/// The rotation by `angle` radians about its axis, by Cayley's map corrected to fifth order; not of length 1.
glm::dquat rotationVector(glm::dvec3 angle) {
    const glm::dvec3 half = angle * 0.5;
    const double tangent = tanOverX(glm::dot(half, half));
    return {1.0, half.x * tangent, half.y * tangent, half.z * tangent};
}

/// The principal axis whose moment is the farthest from the other two.
int uniqueAxis(glm::dvec3 inertia) {
    int least = 0, most = 2;
    for (int i = 0; i < 3; ++i) {
        if (inertia[i] < inertia[least]) least = i;
        if (inertia[i] > inertia[most]) most = i;
    }
    if (least == most) return 0;
    const double middle = inertia[3 - least - most];
    return inertia[least] * inertia[most] < middle * middle ? least : most;
}

/// A rotation, as a quaternion of any length, and the angular momentum in the frame that it turns.
struct Spin {
    double w, x, y, z;
    glm::dvec3 momentum;
};

/// Turns about the frame's axis i, and the momentum back by the same angle: its parts along j and k, the axes that
/// updateCachedContacts.
void turnAbout(double angle, double& w, double& i, double& j, double& k, double& momentumJ, double& momentumK) {
    const double half = 0.5 * angle, t = half * tanOverX(half * half);
    const double scale = 1.0 / (1.0 + t * t), cosine = (1.0 - t * t) * scale, sine = 2.0 * t * scale;
    const double w0 = w, j0 = j, along = momentumJ;
    w = w0 - i * t, i = i + w0 * t;
    j = j0 + k * t, k = k - j0 * t;
    momentumJ = cosine * along + sine * momentumK;
    momentumK = cosine * momentumK - sine * along;
}

/// A symmetric top turns about its momentum and about its own axis at constant rates, so those two turns are its exact
/// motion however long it is. What differs between the other two axes is a turn about one of them. All three commute
/// with the turn about the momentum, which is one turn at the end; the other two alternate, in three times half before
/// and half after, so weighted that it is of fourth order (Yoshida 1990).
void rotateTorqueFree(SolverBody& body, double seconds) {
    constexpr double kOuter = 1.3512071919596578, kInner = 1.0 - 2.0 * kOuter;  // 1 / (2 - 2^(1/3))
    const int a = uniqueAxis(body.inertia), b = (a + 1) % 3, c = (a + 2) % 3;   // x, y and z in the following
    const glm::dvec3 inverse = 1.0 / body.inertia,
                     momentum = body.inertia * (glm::conjugate(body.rotation) * body.angularVelocity);
    const glm::dvec3 axes(body.rotation.x, body.rotation.y, body.rotation.z);
    const double rateX = (inverse[a] - inverse[c]) * seconds, rateY = (inverse[b] - inverse[c]) * seconds;
    Spin s{body.rotation.w, axes[a], axes[b], axes[c], {momentum[a], momentum[b], momentum[c]}};
    const auto turnX = [&](double share) {
        turnAbout(rateX * share * s.momentum.x, s.w, s.x, s.y, s.z, s.momentum.y, s.momentum.z);
    };
    const auto turnY = [&](double share) {
        turnAbout(rateY * share * s.momentum.y, s.w, s.y, s.z, s.x, s.momentum.z, s.momentum.x);
    };
    turnY(0.5 * kOuter);
    turnX(kOuter);
    turnY(0.5 * (kOuter + kInner));
    turnX(kInner);
    turnY(0.5 * (kInner + kOuter));
    turnX(kOuter);
    turnY(0.5 * kOuter);
    glm::dvec3 left, turned;
    left[a] = s.momentum.x, left[b] = s.momentum.y, left[c] = s.momentum.z;
    turned[a] = s.x, turned[b] = s.y, turned[c] = s.z;
    body.rotation =
        glm::normalize(glm::dquat(s.w, turned.x, turned.y, turned.z) * rotationVector(left * (inverse[c] * seconds)));
    body.angularVelocity = body.rotation * (left * inverse);
}

}  // namespace

void rotateBody(SolverBody& body, double seconds) {
    if (body.conservesMomentum) return rotateTorqueFree(body, seconds);
    body.rotation = glm::normalize(rotationVector(body.angularVelocity * seconds) * body.rotation);
}

glm::dmat3 worldInverseInertia(const SolverBody& body) {
    const glm::dmat3 axes = glm::mat3_cast(body.rotation);
    glm::dmat3 scaled = axes;
    for (int i = 0; i < 3; ++i) scaled[i] /= body.inertia[i];
    return scaled * glm::transpose(axes);
}

}  // namespace rubble
