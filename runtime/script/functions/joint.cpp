#include <cmath>
#include <set>

#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/vector_math.h"
#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {
namespace {

/// The points of a rope: x, y and z of each; empty of other joints.
std::vector<double> pointsOf(lua_State* L) {
    const rubble_joint joint = handleAt(L, 1, "joint");
    uint32_t count = 0;
    if (!isDone(L, apiOf(L).get_rope_points(worldOf(L), joint, nullptr, 0, &count))) return {};
    std::vector<double> points(count);
    isDone(L, apiOf(L).get_rope_points(worldOf(L), joint, points.data(), count, &count));
    return points;
}

int isBroken(lua_State* L) {
    const rubble_joint joint = handleAt(L, 1, "joint");
    uint64_t value = 0;
    const bool isThere = apiOf(L).get_user_value(worldOf(L), joint, &value) == RUBBLE_OK || isMadeInThisStep(L, joint);
    lua_pushboolean(L, !isThere);
    return 1;
}

/// All joints.
std::vector<rubble_joint_state> allJoints(lua_State* L) {
    uint32_t count = 0;
    isDone(L, apiOf(L).get_joint_states(worldOf(L), nullptr, 0, &count));
    Sandbox::of(L).charge(L, int64_t(count) * 10);
    std::vector<rubble_joint_state> joints(count);
    isDone(L, apiOf(L).get_joint_states(worldOf(L), joints.data(), count, &count));
    return joints;
}

int getShapes(lua_State* L) {
    const rubble_joint joint = handleAt(L, 1, "joint");
    std::vector<uint64_t> shapes;
    rubble_joint_state state = {};
    if (isDone(L, apiOf(L).get_joint_state(worldOf(L), joint, &state)))
        for (const rubble_shape shape : state.shapes)
            if (shape) shapes.push_back(shape);
    return pushHandles(L, shapes.data(), shapes.size());
}

int getOtherShape(lua_State* L) {
    const rubble_shape shape = handleAt(L, 2, "shape");
    rubble_joint_state state = {};
    const bool isThere = isDone(L, apiOf(L).get_joint_state(worldOf(L), handleAt(L, 1, "joint"), &state));
    const size_t end = state.shapes[0] == shape ? 0 : 1;
    pushHandle(L, isThere && state.shapes[end] == shape ? state.shapes[1 - end] : 0);
    return 1;
}

int getType(lua_State* L) {
    static constexpr std::pair<uint32_t, const char*> kTypes[] = {
        {RUBBLE_JOINT_BALL, "ball"},  {RUBBLE_JOINT_HINGE, "hinge"}, {RUBBLE_JOINT_PRISMATIC, "prismatic"},
        {RUBBLE_JOINT_CONE, "cone"},  {RUBBLE_JOINT_ROPE, "rope"},   {RUBBLE_JOINT_FIXED, "fixed"},
        {RUBBLE_JOINT_WHEEL, "wheel"}};
    rubble_joint_state state = {};
    const char* name = "";
    if (isDone(L, apiOf(L).get_joint_state(worldOf(L), handleAt(L, 1, "joint"), &state)))
        for (const auto& [kind, type] : kTypes)
            if (kind == state.kind) name = type;
    lua_pushstring(L, name);
    return 1;
}

/// The body of a shape, and whether it is static; 0, the world, is.
rubble_body bodyOf(lua_State* L, rubble_shape shape, bool& isStatic) {
    rubble_shape_state state = {};
    rubble_body_state body = {};
    isStatic = true;
    if (!shape || !isDone(L, apiOf(L).get_shape_state(worldOf(L), shape, &state))) return 0;
    if (!isDone(L, apiOf(L).get_body_state(worldOf(L), state.body, &body))) return 0;
    isStatic = body.flags & RUBBLE_BODY_STATIC;
    return state.body;
}

/// Whether a chain of joints leads from a body to a static one: grows the set of bodies that are known to be joined.
int isJointedToStatic(lua_State* L) {
    std::set<rubble_body> joined{handleAt(L, 1, "body")};
    const std::vector<rubble_joint_state> joints = allJoints(L);
    bool grows = true, isHeld = false;
    while (grows && !isHeld) {
        grows = false;
        for (const rubble_joint_state& joint : joints) {
            bool isStatic[2];
            const rubble_body ends[2] = {bodyOf(L, joint.shapes[0], isStatic[0]),
                                         bodyOf(L, joint.shapes[1], isStatic[1])};
            Sandbox::of(L).charge(L, 20);
            for (int i = 0; i < 2; ++i) {
                if (!joined.count(ends[i])) continue;
                isHeld = isHeld || isStatic[1 - i];
                grows = (ends[1 - i] && joined.insert(ends[1 - i]).second) || grows;
            }
        }
    }
    lua_pushboolean(L, isHeld);
    return 1;
}

rubble_joint_properties propertiesAt(lua_State* L) {
    auto properties = sized<rubble_joint_properties>();
    isDone(L, apiOf(L).get_joint_properties(worldOf(L), handleAt(L, 1, "joint"), &properties));
    return properties;
}

int getLimits(lua_State* L) {
    const rubble_joint_properties properties = propertiesAt(L);
    lua_pushnumber(L, properties.lower_limit);
    lua_pushnumber(L, properties.upper_limit);
    return 2;
}

int getMovement(lua_State* L) {
    lua_pushnumber(L, propertiesAt(L).movement);
    return 1;
}

int setMotorOf(lua_State* L, uint32_t kind, double target, int index, double otherwise) {
    const double strength = finiteOr(L, index, "strength", otherwise);
    if (strength < 0.0) refuseArgument(L, index, "strength", "0 or more");
    auto motor = sized<rubble_joint_motor>();
    motor.joint = handleAt(L, 1, "joint");
    motor.motor = kind;
    motor.motor_target = target;
    motor.motor_max_force = strength;
    isDone(L, apiOf(L).set_joint_motor(worldOf(L), &motor));
    return 0;
}

int setMotor(lua_State* L) {
    return setMotorOf(L, RUBBLE_MOTOR_SPEED, finiteAt(L, 2, "velocity"), 3, 1e5);
}

int setMotorTarget(lua_State* L) {
    return setMotorOf(L, RUBBLE_MOTOR_POSITION, finiteAt(L, 2, "target"), 4, 0.0);
}

int detach(lua_State* L) {
    const rubble_joint joint = handleAt(L, 1, "joint");
    isDone(L, apiOf(L).detach_joint(worldOf(L), joint, handleAt(L, 2, "shape")));
    return 0;
}

int getPointCount(lua_State* L) {
    lua_pushinteger(L, lua_Integer(pointsOf(L).size() / 3));
    return 1;
}

int getPoint(lua_State* L) {
    const std::vector<double> points = pointsOf(L);
    const double index = numberAt(L, 2, "index");
    if (points.empty()) {  // it is gone
        pushVector(L, Vector{}.data());
        return 1;
    }
    if (!(index >= 1.0 && index * 3.0 <= double(points.size())))
        refuseArgument(L, 2, "index", "a point of the rope, from 1 on");
    pushVector(L, points.data() + size_t(index - 1.0) * 3);
    return 1;
}

int breakRope(lua_State* L) {
    const std::vector<double> points = pointsOf(L);
    const Vector at = vectorAt(L, 2, "pos");
    if (!std::isfinite(dot(at, at))) refuseArgument(L, 2, "pos", "a vector of finite numbers");
    if (points.empty()) return 0;
    size_t nearest = 0;
    double least = -1.0;
    for (size_t i = 0; i + 2 < points.size(); i += 3) {
        double squared = 0.0;
        for (size_t axis = 0; axis < 3; ++axis)
            squared += (points[i + axis] - at[axis]) * (points[i + axis] - at[axis]);
        if (least < 0.0 || squared < least) least = squared, nearest = i;
    }
    auto cut = sized<rubble_carve>();  // small enough to meet no voxel beside the rope
    std::copy_n(points.data() + nearest, 3, cut.position);
    cut.radii[0] = 0.02;
    isDone(L, apiOf(L).carve(worldOf(L), &cut));
    return 0;
}

constexpr ScriptFunction kFunctions[] = {
    {"IsJointBroken(joint) -> boolean", "Whether it is gone.", isBroken},
    {"GetJointShapes(joint) -> list", "The shapes that it connects.", getShapes},
    {"GetJointOtherShape(joint, shape) -> shape", "The shape at its other end; 0: the world.", getOtherShape},
    {"GetJointType(joint) -> text", "\"ball\", \"hinge\", \"prismatic\", \"cone\", \"rope\", \"fixed\" or \"wheel\".",
     getType},
    {"IsBodyJointedToStatic(body) -> boolean", "Whether joints lead from a body to a static one, or to the world.",
     isJointedToStatic},
    {"SetJointMotor(joint, velocity, strength)",
     "Turns or slides at a speed, in rad/s or m/s, with at most strength N m or N.", setMotor, 30},
    {"SetJointMotorTarget(joint, target, maxVel, strength)",
     "Goes to an angle or a place, in radians or metres, as fast as strength allows: maxVel has no effect.",
     setMotorTarget, 30},
    {"GetJointLimits(joint) -> min, max", "The limits of its free motion, in radians or metres; 0, 0 without limits.",
     getLimits},
    {"GetJointMovement(joint) -> number",
     "Where its free motion is, in radians or metres from where it was made; of a rope the metres between its ends.",
     getMovement},
    {"DetachJointFromShape(joint, shape)", "Frees the end of a rope that is on a shape; other joints are removed.",
     detach, 200},
    {"GetRopeNumberOfPoints(joint) -> count", "How many points a rope has; 0 of other joints.", getPointCount},
    {"GetRopePointPosition(joint, index) -> v", "A point of a rope, from 1 on.", getPoint},
    {"BreakRope(joint, pos)", "Cuts a rope where it is the closest to a place.", breakRope, 200},
};

}  // namespace

std::span<const ScriptFunction> jointFunctions() {
    return kFunctions;
}

}  // namespace rubble::script
