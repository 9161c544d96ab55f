#include "runtime/script/binding/vector_math.h"
#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {
namespace {

int give(lua_State* L, const Vector& vector) {
    pushVector(L, vector.data());
    return 1;
}

int makeVec(lua_State* L) {
    return give(L, {numberOr(L, 1, "x", 0.0), numberOr(L, 2, "y", 0.0), numberOr(L, 3, "z", 0.0)});
}

int vecCopy(lua_State* L) {
    return give(L, vectorAt(L, 1, "v"));
}

int vecLength(lua_State* L) {
    lua_pushnumber(L, length(vectorAt(L, 1, "v")));
    return 1;
}

int vecNormalize(lua_State* L) {
    return give(L, normalized(vectorAt(L, 1, "v")));
}

int vecScale(lua_State* L) {
    return give(L, vectorAt(L, 1, "v") * numberAt(L, 2, "s"));
}

int vecAdd(lua_State* L) {
    return give(L, vectorAt(L, 1, "a") + vectorAt(L, 2, "b"));
}

int vecSub(lua_State* L) {
    return give(L, vectorAt(L, 1, "a") - vectorAt(L, 2, "b"));
}

int vecDot(lua_State* L) {
    lua_pushnumber(L, dot(vectorAt(L, 1, "a"), vectorAt(L, 2, "b")));
    return 1;
}

int vecCross(lua_State* L) {
    return give(L, cross(vectorAt(L, 1, "a"), vectorAt(L, 2, "b")));
}

int vecLerp(lua_State* L) {
    const Vector a = vectorAt(L, 1, "a"), b = vectorAt(L, 2, "b");
    return give(L, a + (b - a) * numberAt(L, 3, "t"));
}

int multiply(lua_State* L) {
    if (lua_type(L, 1) == LUA_TNUMBER) return give(L, vectorAt(L, 2, "b") * numberAt(L, 1, "a"));
    return vecScale(L);
}

int divide(lua_State* L) {
    return give(L, vectorAt(L, 1, "a") * (1.0 / numberAt(L, 2, "b")));
}

int negate(lua_State* L) {
    return give(L, vectorAt(L, 1, "v") * -1.0);
}

int equals(lua_State* L) {
    lua_pushboolean(L, vectorAt(L, 1, "a") == vectorAt(L, 2, "b"));
    return 1;
}

int toText(lua_State* L) {
    const Vector v = vectorAt(L, 1, "v");
    lua_pushfstring(L, "(%f, %f, %f)", v[0], v[1], v[2]);
    return 1;
}

/// The place of x, y and z in the table; 0: of another key.
int placeOfField(lua_State* L) {
    if (lua_type(L, 2) != LUA_TSTRING || lua_rawlen(L, 2) != 1) return 0;
    const char field = *lua_tostring(L, 2);
    return field >= 'x' && field <= 'z' ? field - 'x' + 1 : 0;
}

int getField(lua_State* L) {
    const int place = placeOfField(L);
    if (place)
        lua_rawgeti(L, 1, place);
    else
        lua_pushnil(L);
    return 1;
}

int setField(lua_State* L) {
    const int place = placeOfField(L);
    if (place && lua_type(L, 3) != LUA_TNUMBER)
        return luaL_error(L, "%s of a vector: expected a number, found a value of type %s", lua_tostring(L, 2),
                          luaL_typename(L, 3));
    if (place)
        lua_rawseti(L, 1, place);
    else
        lua_rawset(L, 1);
    return 0;
}

constexpr ScriptFunction kFunctions[] = {
    {"Vec(x, y, z) -> v",
     "A vector; what is left out is 0. Any table {x, y, z} is one. Vectors have the operators + - * / == and the "
     "fields x, y, z.",
     makeVec},
    {"VecCopy(v) -> v", "A copy.", vecCopy},
    {"VecLength(v) -> number", "The length.", vecLength},
    {"VecNormalize(v) -> v", "The same direction with length 1; (0, 0, 1) of a vector without a length.", vecNormalize},
    {"VecScale(v, s) -> v", "All components times s.", vecScale},
    {"VecAdd(a, b) -> v", "The sum.", vecAdd},
    {"VecSub(a, b) -> v", "a minus b.", vecSub},
    {"VecDot(a, b) -> number", "The dot product.", vecDot},
    {"VecCross(a, b) -> v", "The cross product.", vecCross},
    {"VecStr(v) -> text", "\"(x, y, z)\".", toText},
    {"VecLerp(a, b, t) -> v", "The point between a, at t = 0, and b, at t = 1.", vecLerp},
};

constexpr ScriptFunction kOperators[] = {
    {"__add(a, b)", "", vecAdd},   {"__sub(a, b)", "", vecSub},       {"__mul(a, b)", "", multiply},
    {"__div(a, b)", "", divide},   {"__unm(v)", "", negate},          {"__eq(a, b)", "", equals},
    {"__tostring(v)", "", toText}, {"__index(v, key)", "", getField}, {"__newindex(v, key, value)", "", setField},
};

}  // namespace

std::span<const ScriptFunction> vectorFunctions() {
    return kFunctions;
}

void openVectorOperators(lua_State* L) {
    openOperators(L, ValueKind::Vec, kOperators);
}

}  // namespace rubble::script
