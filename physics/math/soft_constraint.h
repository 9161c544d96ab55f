#pragma once

// Soft constraints, with which contacts and joints correct errors of position.
//
// Derivation (Catto, "Soft Constraints", GDC 2011; "Solver2D", 2024). Let a constraint of effective mass m have the
// error C and the velocity v = dC/dt. A spring of natural frequency w = 2 pi hertz and damping ratio z gives it the
// force
//     f = -m w^2 C - 2 m z w v.
// Implicit Euler over h seconds takes C and v at the end of the step, with C' = C + h v'. The velocity changes by
// h f / m, so
//     v' (1 + 2 z h w + h^2 w^2) = v - h w^2 C.
// With a1 = 2 z + h w, a2 = h w a1 and a3 = 1 / (1 + a2) a solver reaches the same v' by iterating the impulse
//     lambda = -m massScale (v + biasRate C) - impulseScale (sum of lambda so far)
// with biasRate = w / a1, massScale = a2 a3 and impulseScale = a3. An infinite frequency is the rigid constraint:
// biasRate is 1 / h, massScale 1, impulseScale 0. The result is stable for every frequency.

namespace rubble {

/// 2 pi to 15 digits. Recordings depend on these bits: do not replace it by 2 * kPi.
inline constexpr double kSoftTwoPi = 6.28318530717958;

/// How a soft constraint answers to an error; the defaults are those of a rigid one without bias.
template <class T>
struct Softness {
    T biasRate = 0;      ///< 1/s: velocity asked for per metre (or radian) of error
    T massScale = 1;     ///< of the effective mass
    T impulseScale = 0;  ///< of the impulse so far, which is given back
};

/// The softness of a damped spring in a substep of this length. hertz: natural frequency, above 0. dampingRatio: 1 is
/// critical.
template <class T>
Softness<T> makeSoft(double hertz, double dampingRatio, double seconds) {
    const double omega = kSoftTwoPi * hertz;
    const double a1 = 2.0 * dampingRatio + seconds * omega, a2 = seconds * omega * a1, a3 = 1.0 / (1.0 + a2);
    return {T(omega / a1), T(a2 * a3), T(a3)};
}

}  // namespace rubble
