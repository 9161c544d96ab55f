#include <algorithm>
#include <bit>
#include <vector>

#include "runtime/script/sandbox/libraries.h"
#include "runtime/script/sandbox/sandbox.h"

namespace rubble::script {
namespace {

/// The length of the list at index 1; of what is none an error.
lua_Integer lengthOf(lua_State* L) {
    if (!lua_istable(L, 1)) luaL_checktype(L, 1, LUA_TTABLE);
    return luaL_len(L, 1);
}

void chargeRange(lua_State* L, lua_Integer first, lua_Integer last) {
    if (last < first) return;
    const lua_Unsigned count = lua_Unsigned(last) - lua_Unsigned(first);
    Sandbox::of(L).charge(L, count < lua_Unsigned(1) << 40 ? int64_t(count) + 1 : int64_t(1) << 40);
}

int insert(lua_State* L) {
    const lua_Integer end = lua_Integer(lua_Unsigned(lengthOf(L)) + 1);
    const int count = lua_gettop(L);
    if (count != 2 && count != 3)
        return luaL_error(L, "wrong number of arguments to 'insert': expected 2 or 3, found %d", count);
    lua_Integer position = end;
    if (count == 3) {
        position = luaL_checkinteger(L, 2);
        luaL_argcheck(L, lua_Unsigned(position) - 1u < lua_Unsigned(end), 2, "position out of bounds");
        chargeRange(L, position, end);
        for (lua_Integer i = end; i > position; --i) {
            lua_geti(L, 1, i - 1);
            lua_seti(L, 1, i);
        }
    }
    lua_seti(L, 1, position);
    return 0;
}

int remove(lua_State* L) {
    const lua_Integer length = lengthOf(L);
    lua_Integer position = luaL_optinteger(L, 2, length);
    const bool isInside = lua_Unsigned(position) - 1u <= lua_Unsigned(length);
    luaL_argcheck(L, isInside || position == length, 2, "position out of bounds");
    chargeRange(L, position, length);
    lua_geti(L, 1, position);
    for (; position < length; ++position) {
        lua_geti(L, 1, position + 1);
        lua_seti(L, 1, position);
    }
    lua_pushnil(L);
    lua_seti(L, 1, position);
    return 1;
}

/// table.concat: charges the range and says it, so that a length that changes has no effect.
int concat(lua_State* L) {
    lua_settop(L, 4);
    const lua_Integer first = luaL_optinteger(L, 3, 1);
    const lua_Integer last = lua_isnil(L, 4) ? luaL_len(L, 1) : luaL_checkinteger(L, 4);
    chargeRange(L, first, last);
    lua_pushinteger(L, first);
    lua_replace(L, 3);
    lua_pushinteger(L, last);
    lua_replace(L, 4);
    Sandbox::of(L).makeRoom(L);
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

int unpack(lua_State* L) {
    const lua_Integer first = luaL_optinteger(L, 2, 1);
    const lua_Integer last = lua_isnoneornil(L, 3) ? luaL_len(L, 1) : luaL_checkinteger(L, 3);
    if (first <= last && lua_Unsigned(last) - lua_Unsigned(first) >= lua_Unsigned(kMaxResults))
        return luaL_error(L, "table.unpack: expected at most %d values at once", int(kMaxResults));
    lua_settop(L, 1);
    lua_pushinteger(L, first);
    lua_pushinteger(L, last);
    chargeRange(L, first, last);
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

int move(lua_State* L) {
    chargeRange(L, luaL_checkinteger(L, 2), luaL_checkinteger(L, 3));
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

/// Whether the value at the top is less than the one below it; takes both away. Index 2: the comparison, or nil.
bool takeLess(lua_State* L) {
    int64_t work = 2;
    bool isLess;
    if (lua_isnil(L, 2)) {
        if (lua_type(L, -1) == LUA_TSTRING) work += int64_t(lua_rawlen(L, -1) >> 4);
        Sandbox::of(L).charge(L, work);
        isLess = lua_compare(L, -1, -2, LUA_OPLT);
    } else {
        Sandbox::of(L).charge(L, work);
        lua_pushvalue(L, 2);
        lua_pushvalue(L, -2);
        lua_pushvalue(L, -4);
        lua_call(L, 2, 1);
        isLess = lua_toboolean(L, -1);
        lua_pop(L, 1);
    }
    lua_pop(L, 2);
    return isLess;
}

/// Merges the sorted runs [low, middle) and [middle, high) of positions in the list at index 3. Equal values keep their
/// order; each value is compared once a merge, whatever the comparison says.
void mergeRuns(lua_State* L, std::vector<int>& order, std::vector<int>& merged, size_t low, size_t middle,
               size_t high) {
    size_t left = low, right = middle;
    for (size_t to = low; to < high; ++to) {
        bool takesRight = left == middle;
        if (left < middle && right < high) {
            lua_rawgeti(L, 3, order[left]);
            lua_rawgeti(L, 3, order[right]);
            takesRight = takeLess(L);
        }
        merged[to] = takesRight ? order[right++] : order[left++];
    }
}

/// table.sort: a stable merge sort.
int sort(lua_State* L) {
    const lua_Integer length = lengthOf(L);
    lua_settop(L, 2);
    if (length < 2) return 0;
    if (!lua_isnil(L, 2)) luaL_checktype(L, 2, LUA_TFUNCTION);
    luaL_argcheck(L, length < (1 << 24), 1, "list too long");
    chargeRange(L, 1, length);
    lua_createtable(L, int(std::bit_ceil(size_t(length))), 0);
    for (lua_Integer i = 1; i <= length; ++i) {
        lua_geti(L, 1, i);
        lua_rawseti(L, 3, i);
    }
    std::vector<int> order(static_cast<size_t>(length)), merged(order.size());
    for (size_t i = 0; i < order.size(); ++i) order[i] = int(i) + 1;
    for (size_t run = 1; run < order.size(); run *= 2) {
        for (size_t low = 0; low < order.size(); low += 2 * run)
            mergeRuns(L, order, merged, low, std::min(low + run, order.size()), std::min(low + 2 * run, order.size()));
        order.swap(merged);
    }
    for (lua_Integer i = 1; i <= length; ++i) {
        lua_rawgeti(L, 3, order[size_t(i - 1)]);
        lua_seti(L, 1, i);
    }
    return 0;
}

/// table.getn of Lua 5.1.
int getn(lua_State* L) {
    lua_pushinteger(L, lengthOf(L));
    return 1;
}

}  // namespace

void openTable(lua_State* L) {
    lua_getglobal(L, LUA_TABLIBNAME);
    wrapField(L, "concat", concat);
    wrapField(L, "unpack", unpack);
    wrapField(L, "move", move);
    static constexpr luaL_Reg kFunctions[] = {
        {"insert", insert}, {"remove", remove}, {"sort", sort}, {"getn", getn}, {nullptr, nullptr}};
    luaL_setfuncs(L, kFunctions, 0);
    lua_getfield(L, -1, "unpack");
    lua_setglobal(L, "unpack");  // its name in Lua 5.1
    lua_pop(L, 1);
}

}  // namespace rubble::script
