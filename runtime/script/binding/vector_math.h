#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/script/binding/arguments.h"

namespace rubble::script {

/// Arithmetic of vectors and unit quaternions.
inline Vector operator+(const Vector& a, const Vector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector operator-(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector operator*(const Vector& a, double s) {
    return {a[0] * s, a[1] * s, a[2] * s};
}
/// The dot product.
inline double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
/// The cross product.
inline Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// The length.
inline double length(const Vector& a) {
    return std::sqrt(dot(a, a));
}
/// Of a vector without a length (0, 0, 1), as in Teardown.
inline Vector normalized(const Vector& a) {
    const double size = length(a);
    if (size > 1e-140 && size < 1e150) return a * (1.0 / size);
    const double largest = std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});  // squares are no numbers
    if (!(largest > 0.0 && largest < std::numeric_limits<double>::infinity())) return {0.0, 0.0, 1.0};
    const Vector near{a[0] / largest, a[1] / largest, a[2] / largest};
    return near * (1.0 / length(near));
}
/// First b, then a.
inline Rotation operator*(const Rotation& a, const Rotation& b) {
    return {
        a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
        a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}
/// The rotation back.
inline Rotation inverse(const Rotation& a) {
    return {-a[0], -a[1], -a[2], a[3]};
}
/// The vector v, turned.
inline Vector rotated(const Rotation& by, const Vector& v) {
    const Vector axis{by[0], by[1], by[2]};
    const Vector twice = cross(axis, v) * 2.0;
    return v + twice * by[3] + cross(axis, twice);
}
/// About an axis of length 1, in radians.
inline Rotation aboutAxis(const Vector& axis, double angle) {
    const double half = std::sin(0.5 * angle);
    return {axis[0] * half, axis[1] * half, axis[2] * half, std::cos(0.5 * angle)};
}
/// From a frame to its parent, and back.
inline Vector toParent(const Placement& frame, const Vector& point) {
    return frame.position + rotated(frame.rotation, point);
}
/// A point of the parent, seen from within the frame.
inline Vector toLocal(const Placement& frame, const Vector& point) {
    return rotated(inverse(frame.rotation), point - frame.position);
}

}  // namespace rubble::script
