#pragma once
#include <cmath>

// Vectors and matrices over any kind of real number: float, or Float8 (float8.h), which is eight of them at once.

namespace rubble {

/// `yes` where the condition holds, else `no`: the scalar form of what Float8 does in each lane.
inline float select(bool condition, float yes, float no) {
    return condition ? yes : no;
}
/// The larger one.
inline float larger(float a, float b) {
    return a > b ? a : b;
}
/// The smaller one.
inline float smaller(float a, float b) {
    return a < b ? a : b;
}
/// The square root.
inline float rootOf(float v) {
    return std::sqrt(v);
}

template <class Real>
struct Vec3 {
    Real x, y, z;
};
template <class Real>
Vec3<Real> operator+(const Vec3<Real>& a, const Vec3<Real>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
Vec3<Real> operator-(const Vec3<Real>& a, const Vec3<Real>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
Vec3<Real> operator*(const Vec3<Real>& a, const Real& b) {
    return {a.x * b, a.y * b, a.z * b};
}
/// The dot product, summed from x to z.
template <class Real>
Real dot(const Vec3<Real>& a, const Vec3<Real>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// The cross product.
template <class Real>
Vec3<Real> cross(const Vec3<Real>& a, const Vec3<Real>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Lane by lane.
template <class Real, class Condition>
Vec3<Real> select(const Condition& condition, const Vec3<Real>& yes, const Vec3<Real>& no) {
    return {select(condition, yes.x, no.x), select(condition, yes.y, no.y), select(condition, yes.z, no.z)};
}

/// A matrix as three columns.
template <class Real>
struct Mat3 {
    Vec3<Real> x, y, z;
    Vec3<Real> operator*(const Vec3<Real>& v) const { return x * v.x + y * v.y + z * v.z; }
};

/// A symmetric matrix.
template <class Real>
struct SymmetricMat3 {
    Real xx, xy, xz, yy, yz, zz;
    Vec3<Real> operator*(const Vec3<Real>& v) const {
        return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z};
    }
};

}  // namespace rubble
