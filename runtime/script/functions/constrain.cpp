// What holds bodies in the next step alone.
#include <algorithm>
#include <cmath>

#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/messages.h"
#include "runtime/script/binding/vector_math.h"
#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {
namespace {

constexpr double kStepsPerSecond = 60.0;  ///< an impulse in a step is a force times 1/60 s
constexpr double kMaxForce = 1e9;

double forceOf(double impulse) {
    return std::clamp(impulse * kStepsPerSecond, -kMaxForce, kMaxForce);
}

/// A constraint between the bodies of arguments 1 and 2.
rubble_body_constraint constraintAt(lua_State* L, uint32_t kind) {
    auto constraint = sized<rubble_body_constraint>();
    constraint.kind = kind;
    constraint.body = handleAt(L, 1, "bodyA");
    constraint.other = handleAt(L, 2, "bodyB");
    return constraint;
}

/// A limit; 0: none.
double limitAt(lua_State* L, int index) {
    const std::string name = parameterAt(L, index);
    const double limit = finiteOr(L, index, name.c_str(), 0.0);
    if (limit < 0.0) refuseArgument(L, index, name.c_str(), "0 (no limit) or more");
    return limit;
}

/// Holds all three components of a velocity: at most `fastest` of it, by an impulse of at most `strongest`; 0: no
/// limit.
void holdAll(lua_State* L, rubble_body_constraint constraint, Vector velocity, double fastest, double strongest) {
    const double speed = length(velocity);
    if (fastest > 0.0 && speed > fastest) velocity = velocity * (fastest / speed);
    constraint.max_force = forceOf(strongest), constraint.min_force = -constraint.max_force;
    for (size_t axis = 0; axis < 3; ++axis) {
        Vector direction{};
        direction[axis] = 1.0;
        copy(constraint.direction, direction);
        constraint.speed = velocity[axis];
        isDone(L, apiOf(L).constrain_bodies(worldOf(L), &constraint));
    }
}

int position(lua_State* L) {
    rubble_body_constraint constraint = constraintAt(L, RUBBLE_CONSTRAINT_VELOCITY);
    const Vector from = vectorAt(L, 3, "pointA"), to = vectorAt(L, 4, "pointB");
    copy(constraint.position, from);
    holdAll(L, constraint, (to - from) * kStepsPerSecond, limitAt(L, 5), limitAt(L, 6));
    return 0;
}

int orientation(lua_State* L) {
    const rubble_body_constraint constraint = constraintAt(L, RUBBLE_CONSTRAINT_ANGULAR_VELOCITY);
    Rotation turn = rotationAt(L, 4, "quatB") * inverse(rotationAt(L, 3, "quatA"));
    if (turn[3] < 0.0)
        for (double& each : turn) each = -each;  // the shorter way
    const Vector axis{turn[0], turn[1], turn[2]};
    const double sine = length(axis), angle = 2.0 * std::atan2(sine, turn[3]);
    holdAll(L, constraint, axis * (sine > 1e-12 ? angle * kStepsPerSecond / sine : 0.0), limitAt(L, 5), limitAt(L, 6));
    return 0;
}

/// One component of a velocity; `first`: the argument of the direction, before speed, least and most impulse.
int holdOne(lua_State* L, rubble_body_constraint constraint, int first) {
    copy(constraint.direction, vectorAt(L, first, "dir"));
    const auto numberOf = [&](int index) { return finiteOr(L, index, parameterAt(L, index).c_str(), 0.0); };
    constraint.speed = finiteAt(L, first + 1, parameterAt(L, first + 1).c_str());
    const double low = numberOf(first + 2), high = numberOf(first + 3);
    if (low > high) refuseArgument(L, first + 2, parameterAt(L, first + 2).c_str(), "at most the largest impulse");
    constraint.min_force = forceOf(low), constraint.max_force = forceOf(high);
    isDone(L, apiOf(L).constrain_bodies(worldOf(L), &constraint));
    return 0;
}

int velocity(lua_State* L) {
    rubble_body_constraint constraint = constraintAt(L, RUBBLE_CONSTRAINT_VELOCITY);
    copy(constraint.position, vectorAt(L, 3, "point"));
    return holdOne(L, constraint, 4);
}

int angularVelocity(lua_State* L) {
    return holdOne(L, constraintAt(L, RUBBLE_CONSTRAINT_ANGULAR_VELOCITY), 3);
}

constexpr ScriptFunction kFunctions[] = {
    {"ConstrainPosition(bodyA, bodyB, pointA, pointB, maxVel, maxImpulse)",
     "Pulls a point of body A to a place that body B bears, 0: the world, in the next step; call it in update(). "
     "Without maxVel in m/s and maxImpulse in N s nothing limits it.",
     position, 200},
    {"ConstrainOrientation(bodyA, bodyB, quatA, quatB, maxAngVel, maxAngImpulse)",
     "Turns body A so that quatA becomes quatB, likewise.", orientation, 200},
    {"ConstrainVelocity(bodyA, bodyB, point, dir, relVel, minImpulse, maxImpulse)",
     "Holds the speed of a point of body A along a direction, against body B, in the next step. Both impulses 0: no "
     "limit.",
     velocity, 100},
    {"ConstrainAngularVelocity(bodyA, bodyB, dir, relAngVel, minAngImpulse, maxAngImpulse)",
     "Holds how fast body A turns about a direction, in rad/s, likewise.", angularVelocity, 100},
};

}  // namespace

std::span<const ScriptFunction> constrainFunctions() {
    return kFunctions;
}

}  // namespace rubble::script
