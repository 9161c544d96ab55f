#include "runtime/script/binding/vector_math.h"
#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {
namespace {

int give(lua_State* L, const Vector& vector) {
    pushVector(L, vector.data());
    return 1;
}

int makeTransform(lua_State* L) {
    Placement placement;
    if (!lua_isnoneornil(L, 1)) placement.position = vectorAt(L, 1, "pos");
    if (!lua_isnoneornil(L, 2)) placement.rotation = rotationAt(L, 2, "rot");
    pushPlacement(L, placement);
    return 1;
}

int transformCopy(lua_State* L) {
    pushPlacement(L, placementAt(L, 1, "t"));
    return 1;
}

int toParentTransform(lua_State* L) {
    const Placement parent = placementAt(L, 1, "parent"), child = placementAt(L, 2, "child");
    pushPlacement(L, {toParent(parent, child.position), parent.rotation * child.rotation});
    return 1;
}

int toLocalTransform(lua_State* L) {
    const Placement parent = placementAt(L, 1, "parent"), child = placementAt(L, 2, "child");
    pushPlacement(L, {toLocal(parent, child.position), inverse(parent.rotation) * child.rotation});
    return 1;
}

int toParentVec(lua_State* L) {
    return give(L, rotated(placementAt(L, 1, "t").rotation, vectorAt(L, 2, "v")));
}

int toLocalVec(lua_State* L) {
    return give(L, rotated(inverse(placementAt(L, 1, "t").rotation), vectorAt(L, 2, "v")));
}

int toParentPoint(lua_State* L) {
    return give(L, toParent(placementAt(L, 1, "t"), vectorAt(L, 2, "p")));
}

int toLocalPoint(lua_State* L) {
    return give(L, toLocal(placementAt(L, 1, "t"), vectorAt(L, 2, "p")));
}

/// A transform times a point brings it to the parent, times a transform joins them.
int multiply(lua_State* L) {
    if (lua_type(L, 2) == LUA_TTABLE && lua_rawlen(L, 2) == 3) return toParentPoint(L);
    return toParentTransform(L);
}

int transformStr(lua_State* L) {
    const auto [p, q] = placementAt(L, 1, "t");
    lua_pushfstring(L, "(%f, %f, %f) (%f, %f, %f, %f)", p[0], p[1], p[2], q[0], q[1], q[2], q[3]);
    return 1;
}

constexpr ScriptFunction kFunctions[] = {
    {"Transform(pos, rot) -> t", "A frame {pos =, rot =}. t * p brings a point to its parent, a * b joins two frames.",
     makeTransform},
    {"TransformCopy(t) -> t", "A copy.", transformCopy},
    {"TransformStr(t) -> text", "Its place and its rotation, as VecStr() and QuatStr() write them.", transformStr},
    {"TransformToParentTransform(parent, child) -> t", "A frame within parent, seen from outside.", toParentTransform},
    {"TransformToLocalTransform(parent, child) -> t", "A frame, seen from within parent.", toLocalTransform},
    {"TransformToParentVec(t, v) -> v", "A direction of the frame, seen from outside.", toParentVec},
    {"TransformToLocalVec(t, v) -> v", "A direction, seen from within the frame.", toLocalVec},
    {"TransformToParentPoint(t, p) -> p", "A point of the frame, seen from outside.", toParentPoint},
    {"TransformToLocalPoint(t, p) -> p", "A point, seen from within the frame.", toLocalPoint},
};

constexpr ScriptFunction kOperators[] = {{"__mul(a, b)", "", multiply}};

}  // namespace

std::span<const ScriptFunction> transformFunctions() {
    return kFunctions;
}

void openTransformOperators(lua_State* L) {
    openOperators(L, ValueKind::Transform, kOperators);
}

}  // namespace rubble::script
