#pragma once
#include <cmath>

#include "samples/hosts/godot/variant.h"

namespace rubble_godot {

/// Godot's transform of a place of Rubble: metres, and a unit quaternion x, y, z, w. Both worlds are right-handed with
/// y up.
inline Transform toTransform(const double position[3], const double q[4]) {
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    Transform out;
    out.rows = {{{float(1 - 2 * (y * y + z * z)), float(2 * (x * y - w * z)), float(2 * (x * z + w * y))},
                 {float(2 * (x * y + w * z)), float(1 - 2 * (x * x + z * z)), float(2 * (y * z - w * x))},
                 {float(2 * (x * z - w * y)), float(2 * (y * z + w * x)), float(1 - 2 * (x * x + y * y))}}};
    for (size_t i = 0; i < 3; ++i) out.origin[i] = float(position[i]);
    return out;
}

/// The unit quaternion x, y, z, w of a basis without scale.
inline void toQuaternion(const Transform& t, double q[4]) {
    const auto& m = t.rows;
    const double squares[4] = {1.0 + m[0][0] - m[1][1] - m[2][2], 1.0 - m[0][0] + m[1][1] - m[2][2],
                               1.0 - m[0][0] - m[1][1] + m[2][2], 1.0 + m[0][0] + m[1][1] + m[2][2]};
    size_t largest = 0;
    for (size_t i = 1; i < 4; ++i)
        if (squares[i] > squares[largest]) largest = i;
    const double scale = 0.5 / std::sqrt(squares[largest]);
    const double x = m[2][1] - m[1][2], y = m[0][2] - m[2][0], z = m[1][0] - m[0][1];
    const double xy = m[0][1] + m[1][0], xz = m[0][2] + m[2][0], yz = m[1][2] + m[2][1];
    const double rows[4][4] = {
        {squares[0], xy, xz, x}, {xy, squares[1], yz, y}, {xz, yz, squares[2], z}, {x, y, z, squares[3]}};
    for (size_t i = 0; i < 4; ++i) q[i] = rows[largest][i] * scale;
}

/// A point of the transform's space, in the space around it.
inline Vec3 transformPoint(const Transform& t, const Vec3& point) {
    Vec3 out = t.origin;
    for (size_t row = 0; row < 3; ++row)
        for (size_t i = 0; i < 3; ++i) out[row] += t.rows[row][i] * point[i];
    return out;
}

/// A vector of Godot.
inline Vec3 toVec3(const double v[3]) {
    return {float(v[0]), float(v[1]), float(v[2])};
}

/// A vector of Rubble.
inline void copy(const Vec3& from, double to[3]) {
    for (size_t i = 0; i < 3; ++i) to[i] = from[i];
}

}  // namespace rubble_godot
