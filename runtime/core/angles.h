#pragma once
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "runtime/core/constants.h"

// Trigonometry whose results are the same bits on every machine. It uses only + - * / and sqrt, which IEEE 754 rounds
// exactly; the functions of the C library differ between versions.

namespace rubble {

/// atan(z) for 0 <= z <= 1, radians, with an error below 1e-14. The argument is halved three times by
/// atan z = 2 atan(z / (1 + sqrt(1 + z^2))); Gregory's series does the rest.
inline double atanOfUnit(double z) {
    for (int i = 0; i < 3; ++i) z = z / (1.0 + std::sqrt(1.0 + z * z));
    const double s = z * z;
    return 8.0 * z *
           (1.0 - s * (1.0 / 3.0 - s * (1.0 / 5.0 - s * (1.0 / 7.0 - s * (1.0 / 9.0 - s * (1.0 / 11.0 - s / 13.0))))));
}

/// std::atan2 in radians, -pi to pi. It is 0 if both arguments are 0.
inline double deterministicAtan2(double y, double x) {
    const double ay = std::abs(y), ax = std::abs(x);
    if (!(ax > 0.0) && !(ay > 0.0)) return 0.0;
    double angle = ay <= ax ? atanOfUnit(ay / ax) : 0.5 * kPi - atanOfUnit(ax / ay);
    if (x < 0.0) angle = kPi - angle;
    return y < 0.0 ? -angle : angle;
}

/// The angle of a rotation about the x axis (its twist), radians, -pi to pi.
inline double twistAboutX(const glm::dquat& q) {
    return q.w < 0.0 ? 2.0 * deterministicAtan2(-q.x, -q.w) : 2.0 * deterministicAtan2(q.x, q.w);
}

/// Cosine and sine of |angle| <= pi, radians: Taylor series of a quarter of the angle, then the double-angle formulas
/// twice.
inline void deterministicCosSin(double angle, double& cosine, double& sine) {
    const double q = 0.25 * angle, s = q * q;
    const double sq =
        q * (1.0 -
             s / 6.0 * (1.0 - s / 20.0 * (1.0 - s / 42.0 * (1.0 - s / 72.0 * (1.0 - s / 110.0 * (1.0 - s / 156.0))))));
    const double cq =
        1.0 - s / 2.0 * (1.0 - s / 12.0 * (1.0 - s / 30.0 * (1.0 - s / 56.0 * (1.0 - s / 90.0 * (1.0 - s / 132.0)))));
    const double sh = 2.0 * sq * cq, ch = cq * cq - sq * sq;
    sine = 2.0 * sh * ch;
    cosine = ch * ch - sh * sh;
}

}  // namespace rubble
