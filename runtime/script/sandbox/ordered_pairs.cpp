#include <algorithm>
#include <string_view>
#include <vector>

#include "runtime/script/sandbox/libraries.h"
#include "runtime/script/sandbox/sandbox.h"

namespace rubble::script {
namespace {

/// A key of a table, as it is sorted: numbers by size, then strings by their bytes, booleans, objects as they were
/// made, and the libraries' functions in the order that the table has.
struct Key {
    enum Kind { Number, String, Boolean, Other } kind = Other;
    double number = 0.0;
    lua_Integer integer = 0;
    std::string_view text;
    int position = 0;  ///< among the keys of the table

    bool operator<(const Key& other) const {
        if (kind != other.kind) return kind < other.kind;
        if (number != other.number) return number < other.number;
        if (integer != other.integer) return integer < other.integer;
        if (text != other.text) return text < other.text;
        return position < other.position;
    }
};

/// Of an object the number of its block, or a last one if it has none of its own.
lua_Integer creationAt(lua_State* L, int index) {
    const auto* block = static_cast<const char*>(lua_topointer(L, index));
    switch (lua_type(L, index)) {
        case LUA_TTABLE:
            return lua_Integer(creationOf(block));
        case LUA_TTHREAD:
            return lua_Integer(creationOf(block - LUA_EXTRASPACE));
        case LUA_TFUNCTION:
            if (lua_iscfunction(L, index) && !lua_getupvalue(L, index, 1)) return LUA_MAXINTEGER;
            if (lua_iscfunction(L, index)) lua_pop(L, 1);
            return lua_Integer(creationOf(block));
        default:
            return LUA_MAXINTEGER;
    }
}

Key keyAt(lua_State* L, int index, int position) {
    Key key;
    key.position = position;
    switch (lua_type(L, index)) {
        case LUA_TNUMBER:
            key.kind = Key::Number;
            key.number = lua_tonumber(L, index);
            if (lua_isinteger(L, index)) key.integer = lua_tointeger(L, index);
            break;
        case LUA_TSTRING: {
            size_t length = 0;
            const char* bytes = lua_tolstring(L, index, &length);
            key.kind = Key::String;
            key.text = {bytes, length};
            break;
        }
        case LUA_TBOOLEAN:
            key.kind = Key::Boolean;
            key.integer = lua_toboolean(L, index);
            break;
        default:
            key.integer = creationAt(L, lua_absindex(L, index));
    }
    return key;
}

/// next() over keys in their order: upvalue 1 the sorted keys, upvalue 2 how many are done. Keys that are gone by now
/// are passed over.
int nextOfSorted(lua_State* L) {
    lua_Integer at = lua_tointeger(L, lua_upvalueindex(2));
    for (;;) {
        Sandbox::of(L).charge(L, 1);
        if (lua_rawgeti(L, lua_upvalueindex(1), ++at) == LUA_TNIL) return 1;
        lua_pushvalue(L, -1);
        if (lua_rawget(L, 1) != LUA_TNIL) break;
        lua_pop(L, 2);
    }
    lua_pushinteger(L, at);
    lua_replace(L, lua_upvalueindex(2));
    return 2;
}

/// Whether next() goes through the table at index 1 in that order already, as it does through lists.
bool isInOrder(lua_State* L) {
    Key before;
    int count = 0;
    for (lua_pushnil(L); lua_next(L, 1); ++count) {
        lua_pop(L, 1);
        Sandbox::of(L).charge(L, 1);
        const Key key = keyAt(L, -1, count);
        if (count > 0 && !(before < key)) {
            lua_pop(L, 1);
            return false;
        }
        before = key;
    }
    return true;
}

/// All keys of the table at index 1, in their order; index 2 is then a list of them, in the order of next().
std::vector<Key> sortedKeys(lua_State* L) {
    std::vector<Key> keys;
    lua_newtable(L);
    for (lua_pushnil(L); lua_next(L, 1);) {
        lua_pop(L, 1);
        keys.push_back(keyAt(L, -1, int(keys.size())));
        Sandbox::of(L).charge(L, 16 + int64_t(keys.back().text.size() >> 2));
        lua_pushvalue(L, -1);
        lua_rawseti(L, 2, lua_Integer(keys.size()));
    }
    std::sort(keys.begin(), keys.end());
    return keys;
}

int orderedPairs(lua_State* L) {
    luaL_checkany(L, 1);
    lua_settop(L, 1);
    if (luaL_getmetafield(L, 1, "__pairs") != LUA_TNIL) {
        lua_pushvalue(L, 1);
        lua_call(L, 1, 3);
        return 3;
    }
    luaL_checktype(L, 1, LUA_TTABLE);
    if (isInOrder(L)) {
        lua_pushvalue(L, lua_upvalueindex(1));  // next
    } else {
        const std::vector<Key> keys = sortedKeys(L);
        lua_createtable(L, int(keys.size()), 0);
        for (size_t i = 0; i < keys.size(); ++i) {
            lua_rawgeti(L, 2, keys[i].position + 1);
            lua_rawseti(L, 3, lua_Integer(i) + 1);
        }
        lua_pushinteger(L, 0);
        lua_pushcclosure(L, nextOfSorted, 2);
    }
    lua_pushvalue(L, 1);
    lua_pushnil(L);
    return 3;
}

}  // namespace

void openPairs(lua_State* L) {
    lua_getfield(L, -1, "next");
    lua_pushcclosure(L, orderedPairs, 1);
    lua_setfield(L, -2, "pairs");
}

}  // namespace rubble::script
