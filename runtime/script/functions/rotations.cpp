#include <algorithm>
#include <numbers>

#include "runtime/script/binding/vector_math.h"
#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

int give(lua_State* L, const Rotation& rotation) {
    pushRotation(L, rotation.data());
    return 1;
}

Rotation unit(const Rotation& q) {
    const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (size == 0.0) return {0.0, 0.0, 0.0, 1.0};
    return {q[0] / size, q[1] / size, q[2] / size, q[3] / size};
}

int makeQuat(lua_State* L) {
    return give(
        L, {numberOr(L, 1, "x", 0.0), numberOr(L, 2, "y", 0.0), numberOr(L, 3, "z", 0.0), numberOr(L, 4, "w", 1.0)});
}

int quatCopy(lua_State* L) {
    return give(L, rotationAt(L, 1, "q"));
}

int quatAxisAngle(lua_State* L) {
    return give(L, aboutAxis(normalized(vectorAt(L, 1, "axis")), numberAt(L, 2, "angle") * kRadians));
}

int quatEuler(lua_State* L) {
    const Rotation x = aboutAxis({1, 0, 0}, numberAt(L, 1, "x") * kRadians);
    const Rotation y = aboutAxis({0, 1, 0}, numberAt(L, 2, "y") * kRadians);
    const Rotation z = aboutAxis({0, 0, 1}, numberAt(L, 3, "z") * kRadians);
    return give(L, y * z * x);
}

int getQuatEuler(lua_State* L) {
    const Rotation q = unit(rotationAt(L, 1, "q"));
    const Vector right = rotated(q, {1, 0, 0}), up = rotated(q, {0, 1, 0}), back = rotated(q, {0, 0, 1});
    const double sine = std::clamp(right[1], -1.0, 1.0);
    const bool isSteep = std::abs(sine) > 0.9999999;
    const double y = isSteep ? std::atan2(back[0], back[2]) : std::atan2(-right[2], right[0]);
    lua_pushnumber(L, isSteep ? 0.0 : std::atan2(-back[1], up[1]) / kRadians);
    lua_pushnumber(L, y / kRadians);
    lua_pushnumber(L, std::asin(sine) / kRadians);
    return 3;
}

/// The rotation of a frame whose axes are given.
Rotation fromAxes(const Vector& x, const Vector& y, const Vector& z) {
    const double trace = x[0] + y[1] + z[2];
    if (trace > 0.0) return unit({y[2] - z[1], z[0] - x[2], x[1] - y[0], 1.0 + trace});
    if (x[0] > y[1] && x[0] > z[2]) return unit({1.0 + x[0] - y[1] - z[2], y[0] + x[1], z[0] + x[2], y[2] - z[1]});
    if (y[1] > z[2]) return unit({y[0] + x[1], 1.0 - x[0] + y[1] - z[2], z[1] + y[2], z[0] - x[2]});
    return unit({z[0] + x[2], z[1] + y[2], 1.0 - x[0] - y[1] + z[2], x[1] - y[0]});
}

int quatLookAt(lua_State* L) {
    const Vector ahead = vectorAt(L, 2, "target") - vectorAt(L, 1, "eye");
    if (length(ahead) == 0.0) return give(L, {0.0, 0.0, 0.0, 1.0});
    const Vector z = normalized(ahead) * -1.0;
    const Vector side = cross({0, 1, 0}, z);
    const Vector x = length(side) > 1e-9 ? normalized(side) : Vector{1.0, 0.0, 0.0};
    return give(L, fromAxes(x, cross(z, x), z));
}

int quatSlerp(lua_State* L) {
    const Rotation a = unit(rotationAt(L, 1, "a"));
    Rotation b = unit(rotationAt(L, 2, "b"));
    const double t = numberAt(L, 3, "t");
    double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    if (cosine < 0.0) {
        cosine = -cosine;
        for (double& component : b) component = -component;
    }
    double atA = 1.0 - t, atB = t;
    if (cosine < 0.9999) {
        const double angle = std::acos(cosine);
        atA = std::sin(atA * angle) / std::sin(angle);
        atB = std::sin(atB * angle) / std::sin(angle);
    }
    return give(
        L, unit({a[0] * atA + b[0] * atB, a[1] * atA + b[1] * atB, a[2] * atA + b[2] * atB, a[3] * atA + b[3] * atB}));
}

int quatRotateQuat(lua_State* L) {
    return give(L, rotationAt(L, 1, "a") * rotationAt(L, 2, "b"));
}

int quatRotateVec(lua_State* L) {
    const Vector turned = rotated(rotationAt(L, 1, "q"), vectorAt(L, 2, "v"));
    pushVector(L, turned.data());
    return 1;
}

int quatStr(lua_State* L) {
    const Rotation q = rotationAt(L, 1, "q");
    lua_pushfstring(L, "(%f, %f, %f, %f)", q[0], q[1], q[2], q[3]);
    return 1;
}

/// A rotation times a vector turns it, times a rotation joins them.
int multiply(lua_State* L) {
    if (lua_type(L, 2) == LUA_TTABLE && lua_rawlen(L, 2) == 3) return quatRotateVec(L);
    return quatRotateQuat(L);
}

constexpr ScriptFunction kFunctions[] = {
    {"Quat(x, y, z, w) -> q",
     "A rotation; without arguments none. Any table {x, y, z, w} is one. q * v turns a vector, a * b joins two.",
     makeQuat},
    {"QuatCopy(q) -> q", "A copy.", quatCopy},
    {"QuatAxisAngle(axis, angle) -> q", "About an axis, by an angle in degrees.", quatAxisAngle},
    {"QuatEuler(x, y, z) -> q", "By angles in degrees: about x, then z, then y.", quatEuler},
    {"GetQuatEuler(q) -> x, y, z", "The angles of QuatEuler(), in degrees.", getQuatEuler},
    {"QuatLookAt(eye, target) -> q", "The rotation of a camera at eye, which looks along -z, towards target.",
     quatLookAt},
    {"QuatSlerp(a, b, t) -> q", "The rotation between a, at t = 0, and b, at t = 1, on the shortest arc.", quatSlerp},
    {"QuatRotateQuat(a, b) -> q", "First b, then a.", quatRotateQuat},
    {"QuatStr(q) -> text", "\"(x, y, z, w)\".", quatStr},
    {"QuatRotateVec(q, v) -> v", "The vector v, turned.", quatRotateVec},
};

constexpr ScriptFunction kOperators[] = {{"__mul(a, b)", "", multiply}};

}  // namespace

std::span<const ScriptFunction> rotationFunctions() {
    return kFunctions;
}

void openRotationOperators(lua_State* L) {
    openOperators(L, ValueKind::Quat, kOperators);
}

}  // namespace rubble::script
