#include <algorithm>
#include <glm/glm.hpp>

#include "physics/bodies/solver_body.h"

// Free rotation of a rigid body by splitting.
//
// In principal axes, Euler's equations dL/dt = L x (L / I) have the energy H = Lx^2 / 2Ix + Ly^2 / 2Iy + Lz^2 / 2Iz.
// Each term alone moves L by a rotation about its axis, at the rate L_i / I_i, which has a closed form. Splitting H
// into such terms and composing their exact flows symmetrically gives an integrator that is symplectic and
// time-reversible, and keeps |L| exactly (Dullweber, Leimkuhler and McLachlan, "Symplectic splitting methods for rigid
// body molecular dynamics", J. Chem. Phys. 107, 1997). Here |L|^2 / 2Iz is split off first: its flow is the rotation
// about L itself, which commutes with the others and is applied once at the end. Two terms are left, with the rates Lx
// (1/Ix - 1/Iz) and Ly (1/Iy - 1/Iz). With x the axis of the most different moment, a symmetric top needs only the
// first, so its motion is exact for every step. Three Strang steps of the lengths kOuter, kInner and kOuter make the
// whole of fourth order (Yoshida, "Construction of higher order symplectic integrators", 1990).

namespace rubble {
namespace {

constexpr double kEqualMoments = 1.0 + 1e-6;  ///< ratio of two moments below which they count as equal

/// tan(h) / h for h2 = h^2, radians: the first terms of the Taylor series, the same bits on every machine. The relative
/// error is about 17/315 h^6: 2e-4 for a rotation by 2 h = 0.8 radians.
double tanOverHalf(double h2) {
    return 1.0 + h2 * (1.0 / 3.0 + h2 * (2.0 / 15.0));
}

/// The rotation by the rotation vector `angle`, radians: (1, tan(|angle| / 2) axis), which is not of length 1.
glm::dquat rotationOf(glm::dvec3 angle) {
    const glm::dvec3 half = angle * 0.5;
    const double tangent = tanOverHalf(glm::dot(half, half));
    return {1.0, half.x * tangent, half.y * tangent, half.z * tangent};
}

/// The principal axis whose moment differs the most from the other two.
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

/// A rotation, as a quaternion of any length, and the angular momentum in the rotated frame.
struct Spin {
    double w, x, y, z;
    glm::dvec3 momentum;
};

/// Rotates the frame about its axis i, and the momentum in it back by the same angle. j and k are the axes that follow
/// i.
void rotateAbout(double angle, double& w, double& i, double& j, double& k, double& momentumJ, double& momentumK) {
    const double half = 0.5 * angle, t = half * tanOverHalf(half * half);
    const double scale = 1.0 / (1.0 + t * t), cosine = (1.0 - t * t) * scale, sine = 2.0 * t * scale;
    const double w0 = w, j0 = j, along = momentumJ;
    w = w0 - i * t, i = i + w0 * t;
    j = j0 + k * t, k = k - j0 * t;
    momentumJ = cosine * along + sine * momentumK;
    momentumK = cosine * momentumK - sine * along;
}

/// The splitting of the file's opening comment; a, b and c are its axes x, y and z.
void rotateTorqueFree(SolverBody& body, double seconds) {
    constexpr double kOuter = 1.3512071919596578;  // 1 / (2 - 2^(1/3))
    constexpr double kInner = 1.0 - 2.0 * kOuter;
    const int a = uniqueAxis(body.inertia), b = (a + 1) % 3, c = (a + 2) % 3;
    const glm::dvec3 inverse = 1.0 / body.inertia,
                     momentum = body.inertia * (glm::conjugate(body.rotation) * body.angularVelocity);
    const glm::dvec3 axes(body.rotation.x, body.rotation.y, body.rotation.z);
    const double rateX = (inverse[a] - inverse[c]) * seconds, rateY = (inverse[b] - inverse[c]) * seconds;
    Spin s{body.rotation.w, axes[a], axes[b], axes[c], {momentum[a], momentum[b], momentum[c]}};
    const auto rotateX = [&](double share) {
        rotateAbout(rateX * share * s.momentum.x, s.w, s.x, s.y, s.z, s.momentum.y, s.momentum.z);
    };
    const auto rotateY = [&](double share) {
        rotateAbout(rateY * share * s.momentum.y, s.w, s.y, s.z, s.x, s.momentum.z, s.momentum.x);
    };
    rotateY(0.5 * kOuter);
    rotateX(kOuter);
    rotateY(0.5 * (kOuter + kInner));
    rotateX(kInner);
    rotateY(0.5 * (kInner + kOuter));
    rotateX(kOuter);
    rotateY(0.5 * kOuter);
    glm::dvec3 newMomentum, rotated;
    newMomentum[a] = s.momentum.x, newMomentum[b] = s.momentum.y, newMomentum[c] = s.momentum.z;
    rotated[a] = s.x, rotated[b] = s.y, rotated[c] = s.z;
    body.rotation = glm::normalize(glm::dquat(s.w, rotated.x, rotated.y, rotated.z) *
                                   rotationOf(newMomentum * (inverse[c] * seconds)));
    body.angularVelocity = body.rotation * (newMomentum * inverse);
}

}  // namespace

void rotateBody(SolverBody& body, double seconds) {
    if (body.conservesMomentum) return rotateTorqueFree(body, seconds);
    body.rotation = glm::normalize(rotationOf(body.angularVelocity * seconds) * body.rotation);
}

bool hasEqualMoments(const SolverBody& body) {
    const glm::dvec3& i = body.inertia;
    return std::max({i.x, i.y, i.z}) < kEqualMoments * std::min({i.x, i.y, i.z});
}

glm::dvec3 freeSpinChange(const SolverBody& body, double seconds) {
    SolverBody rotated = body;
    rotateTorqueFree(rotated, seconds);
    return rotated.angularVelocity - body.angularVelocity;
}

glm::dmat3 worldInverseInertia(const SolverBody& body) {
    const glm::dmat3 axes = glm::mat3_cast(body.rotation);
    glm::dmat3 scaled = axes;
    for (int i = 0; i < 3; ++i) scaled[i] /= body.inertia[i];
    return scaled * glm::transpose(axes);
}

glm::dvec3 angularMomentum(const SolverBody& body) {
    return body.rotation * (body.inertia * (glm::conjugate(body.rotation) * body.angularVelocity));
}

double kineticEnergy(const SolverBody& body) {
    const glm::dvec3 w = glm::conjugate(body.rotation) * body.angularVelocity;
    return 0.5 * (glm::dot(body.velocity, body.velocity) / body.inverseMass + glm::dot(w, body.inertia * w));
}

}  // namespace rubble
