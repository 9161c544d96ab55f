#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "runtime/script/sandbox/sandbox.h"

namespace rubble::script {

using Vector = std::array<double, 3>;
using Rotation = std::array<double, 4>;  ///< a quaternion x, y, z, w
struct Placement {
    Vector position{};
    Rotation rotation{0.0, 0.0, 0.0, 1.0};
};

/// The arguments of the running function. What is wrong is an error "MakeHole: r0: expected a number, found nil", with
/// the script and its line before it.
double numberAt(lua_State* L, int index, const char* name);
/// As numberAt(); what is left out or nil is `otherwise`.
double numberOr(lua_State* L, int index, const char* name, double otherwise);
/// As numberAt(); what is not finite is an error.
double finiteAt(lua_State* L, int index, const char* name);
/// As numberOr(); what is not finite is an error.
double finiteOr(lua_State* L, int index, const char* name, double otherwise);
/// A number, brought into a range; not a number is an error.
double clampedAt(lua_State* L, int index, const char* name, double low, double high);
/// The same; the log says once for each line that a number was brought into it.
double limitedAt(lua_State* L, int index, const char* name, double low, double high);
/// Any value counts as true but false; what is left out or nil is `otherwise`.
bool boolOr(lua_State* L, int index, bool otherwise);
/// A table {x, y, z}.
Vector vectorAt(lua_State* L, int index, const char* name);
/// The corners of a box, which are the arguments 1 and 2, `min` and `max`.
std::pair<Vector, Vector> cornersAt(lua_State* L);
/// A table {x, y, z, w}.
Rotation rotationAt(lua_State* L, int index, const char* name);
/// A table {pos =, rot =}.
Placement placementAt(lua_State* L, int index, const char* name);
/// The same where it becomes the pose of something: a rotation whose length is not quite 1, up to a tenth, is
/// normalised. The interface refuses what is farther off.
Placement poseAt(lua_State* L, int index, const char* name);
/// A text, not a number.
std::string textAt(lua_State* L, int index, const char* name);
/// As textAt(); what is left out or nil is `otherwise`.
std::string textOr(lua_State* L, int index, const char* name, const char* otherwise);
/// A handle; that of nothing is 0.
uint64_t handleAt(lua_State* L, int index, const char* name);
/// Raises that error. Where `name` is null it is that of the signature.
[[noreturn]] void refuseArgument(lua_State* L, int index, const char* name, const char* expected);

/// Results. Vectors, rotations and transforms are tables {x, y, z}, {x, y, z, w} and {pos =, rot =} that have
/// operators.
void pushVector(lua_State* L, const double* vector);
/// {x, y, z, w}.
void pushRotation(lua_State* L, const double* rotation);
/// {pos =, rot =}.
void pushPlacement(lua_State* L, const Placement& placement);
/// A handle is a whole number.
void pushHandle(lua_State* L, uint64_t handle);
/// A list of handles.
int pushHandles(lua_State* L, const uint64_t* handles, size_t count);

/// Which metatable a table of these has; their operators are in functions/vectors.cpp and its neighbours.
enum class ValueKind { Vec, Quat, Transform };
/// Pushes the metatable of a kind, which is empty at first.
void pushMetatable(lua_State* L, ValueKind kind);

}  // namespace rubble::script
