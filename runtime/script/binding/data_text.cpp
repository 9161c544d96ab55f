#include "runtime/script/binding/data_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "runtime/script/binding/arguments.h"

namespace rubble::script {
namespace {

constexpr int kMaxDepth = 32;
constexpr size_t kMaxBytes = 1 << 20;

std::string numberText(lua_State* L, int index) {
    char text[40];
    if (lua_isinteger(L, index)) {
        const lua_Integer value = lua_tointeger(L, index);
        return value == LUA_MININTEGER ? "math.mininteger" : std::to_string(value);
    }
    const double value = lua_tonumber(L, index);
    if (std::isnan(value)) return "(0/0)";
    if (std::isinf(value)) return value > 0 ? "(1/0)" : "(-1/0)";
    std::snprintf(text, sizeof text, "%.17g", value);
    const std::string plain = text;
    return plain.find_first_of(".e") == plain.npos ? plain + ".0" : plain;
}

std::string quoted(const char* bytes, size_t length) {
    std::string text = "\"";
    for (size_t i = 0; i < length; ++i) {
        const auto byte = static_cast<unsigned char>(bytes[i]);
        char escaped[8];
        std::snprintf(escaped, sizeof escaped, "\\%03d", byte);
        if (byte < 32 || byte == 127 || byte == '"' || byte == '\\')
            text += escaped;
        else
            text += char(byte);
    }
    return text + "\"";
}

/// Writes one value.
class DataWriter {
public:
    DataWriter(lua_State* L, const std::string& what) : m_state(L), m_what(what) {}

    std::string write(int index, int depth) {
        const int at = lua_absindex(m_state, index);
        std::string text;
        switch (lua_type(m_state, at)) {
            case LUA_TNIL:
                return "nil";
            case LUA_TBOOLEAN:
                return lua_toboolean(m_state, at) ? "true" : "false";
            case LUA_TNUMBER:
                return numberText(m_state, at);
            case LUA_TSTRING: {
                size_t length = 0;
                const char* bytes = lua_tolstring(m_state, at, &length);
                return counted(quoted(bytes, length));
            }
            case LUA_TTABLE:
                return counted(writeTable(at, depth));
        }
        luaL_error(m_state, "%s: expected data, found a %s in it", m_what.c_str(), luaL_typename(m_state, at));
        return text;
    }

private:
    std::string counted(std::string text) {
        Sandbox::of(m_state).charge(m_state, int64_t(text.size()) / 8);
        if (text.size() > kMaxBytes)
            luaL_error(m_state, "%s: expected at most %d bytes", m_what.c_str(), int(kMaxBytes));
        return text;
    }

    /// "Vec", "Quat" or "Transform" of a table that one of these has made, else "".
    std::string constructorOf(int at) {
        static constexpr std::pair<ValueKind, const char*> kKinds[] = {
            {ValueKind::Vec, "Vec"}, {ValueKind::Quat, "Quat"}, {ValueKind::Transform, "Transform"}};
        std::string name;
        if (!lua_getmetatable(m_state, at)) return name;
        for (const auto& [kind, constructor] : kKinds) {
            pushMetatable(m_state, kind);
            if (lua_rawequal(m_state, -1, -2)) name = constructor;
            lua_pop(m_state, 1);
        }
        lua_pop(m_state, 1);
        return name;
    }

    std::string field(int at, int key, const char* name, int depth) {
        if (name)
            lua_pushstring(m_state, name);
        else
            lua_pushinteger(m_state, key);
        lua_rawget(m_state, at);
        const std::string text = write(-1, depth + 1);
        lua_pop(m_state, 1);
        return text;
    }

    std::string writeTable(int at, int depth) {
        if (depth >= kMaxDepth)
            luaL_error(m_state, "%s: expected at most %d tables in each other", m_what.c_str(), kMaxDepth);
        luaL_checkstack(m_state, 8, nullptr);
        if (const std::string constructor = constructorOf(at); !constructor.empty()) {
            if (constructor == "Transform")
                return "Transform(" + field(at, 0, "pos", depth) + "," + field(at, 0, "rot", depth) + ")";
            std::string text = constructor + "(";
            for (int i = 1; i <= (constructor == "Vec" ? 3 : 4); ++i)
                text += (i > 1 ? "," : "") + field(at, i, nullptr, depth);
            return text + ")";
        }
        std::vector<std::pair<std::string, std::string>> rows;
        lua_pushnil(m_state);
        while (lua_next(m_state, at)) {
            if (lua_type(m_state, -2) == LUA_TTABLE)
                luaL_error(m_state, "%s: expected data, found a table as a key", m_what.c_str());
            rows.emplace_back(write(-2, depth + 1), write(-1, depth + 1));
            lua_pop(m_state, 1);
        }
        std::sort(rows.begin(), rows.end());
        std::string text = "{";
        for (const auto& [key, value] : rows) text += "[" + key + "]=" + value + ",";
        return text + "}";
    }

    lua_State* m_state;
    const std::string& m_what;
};

}  // namespace

std::string dataText(lua_State* L, int index, const std::string& what) {
    return DataWriter(L, what).write(index, 0);
}

}  // namespace rubble::script
