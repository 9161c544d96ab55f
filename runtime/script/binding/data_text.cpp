#include "runtime/script/binding/data_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <optional>

#include "runtime/script/binding/arguments.h"

namespace rubble::script {
namespace {

constexpr size_t kMaxDepth = 32, kMaxBytes = 1 << 20, kMaxLosses = 10, kMaxPath = 200;

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
    DataWriter(lua_State* L, DataLosses& losses) : m_state(L), m_losses(losses) {}

    /// None: it cannot be kept. `path`: where it is.
    std::optional<std::string> write(int index, const std::string& path) {
        const int at = lua_absindex(m_state, index);
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
                return counted(quoted(bytes, length), path);
            }
            case LUA_TTABLE:
                return writeTable(at, path);
        }
        return lose(path, std::string("a ") + luaL_typename(m_state, at));
    }

private:
    std::optional<std::string> counted(std::string text, const std::string& path) {
        Sandbox::of(m_state).charge(m_state, int64_t(text.size()) / 8);
        if (text.size() > kMaxBytes) return lose(path, "more than " + std::to_string(kMaxBytes) + " bytes as a text");
        return text;
    }
    std::nullopt_t lose(const std::string& path, const std::string& found) {
        if (m_losses.size() < kMaxLosses) m_losses.push_back(path + ": " + found);
        return std::nullopt;
    }
    /// The path of a field, whose key is at `index` and written as `text`.
    std::string fieldPath(const std::string& path, int index, const std::string& text) const {
        const std::string plain = lua_type(m_state, index) == LUA_TSTRING ? lua_tostring(m_state, index) : "";
        const auto isLetter = [](unsigned char letter) { return std::isalnum(letter) || letter == '_'; };
        const bool isName = !plain.empty() && std::all_of(plain.begin(), plain.end(), isLetter);
        return (isName ? path + "." + plain : path + "[" + text + "]").substr(0, kMaxPath);
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

    std::string field(int at, int key, const char* name, const std::string& path) {
        if (name)
            lua_pushstring(m_state, name);
        else
            lua_pushinteger(m_state, key);
        lua_rawget(m_state, at);
        const std::optional<std::string> text = write(-1, path + "." + (name ? name : std::to_string(key)));
        lua_pop(m_state, 1);
        return text.value_or("nil");
    }

    /// What a table of a constructor has beside what that makes is lost.
    void loseOtherFields(int at, const std::string& constructor, const std::string& path) {
        const lua_Integer count = constructor == "Vec" ? 3 : constructor == "Quat" ? 4 : 0;
        for (lua_pushnil(m_state); lua_next(m_state, at); lua_pop(m_state, 1)) {
            const lua_Integer number = lua_isinteger(m_state, -2) ? lua_tointeger(m_state, -2) : 0;
            const std::string name = lua_type(m_state, -2) == LUA_TSTRING ? lua_tostring(m_state, -2) : "";
            if ((number >= 1 && number <= count) || (count == 0 && (name == "pos" || name == "rot"))) continue;
            const int kind = lua_type(m_state, -2);
            const bool isPlain = kind == LUA_TNUMBER || kind == LUA_TSTRING || kind == LUA_TBOOLEAN;
            const std::string key =
                isPlain ? write(-2, path).value_or("") : std::string("a ") + lua_typename(m_state, kind);
            lose(fieldPath(path, -2, key), "a field of a " + constructor);
        }
    }

    std::string writeVector(int at, const std::string& constructor, const std::string& path) {
        loseOtherFields(at, constructor, path);
        if (constructor == "Transform")
            return "Transform(" + field(at, 0, "pos", path) + "," + field(at, 0, "rot", path) + ")";
        std::string text = constructor + "(";
        for (int i = 1; i <= (constructor == "Vec" ? 3 : 4); ++i)
            text += (i > 1 ? "," : "") + field(at, i, nullptr, path);
        return text + ")";
    }

    std::optional<std::string> writeTable(int at, const std::string& path) {
        const void* table = lua_topointer(m_state, at);
        if (std::find(m_open.begin(), m_open.end(), table) != m_open.end())
            return lose(path, "a table that is in itself");
        if (m_open.size() >= kMaxDepth) return lose(path, "a table within " + std::to_string(kMaxDepth) + " others");
        luaL_checkstack(m_state, 8, nullptr);
        m_open.push_back(table);
        const std::string constructor = constructorOf(at);
        std::string text = constructor.empty() ? writeFields(at, path) : writeVector(at, constructor, path);
        m_open.pop_back();
        return counted(std::move(text), path);
    }

    std::string writeFields(int at, const std::string& path) {
        std::vector<std::pair<std::string, std::string>> rows;
        for (lua_pushnil(m_state); lua_next(m_state, at); lua_pop(m_state, 1)) {
            const int kind = lua_type(m_state, -2);
            if (kind != LUA_TNUMBER && kind != LUA_TSTRING && kind != LUA_TBOOLEAN) {
                lose(path, std::string("a key that is a ") + lua_typename(m_state, kind));
                continue;
            }
            const std::optional<std::string> key = write(-2, path);
            std::optional<std::string> value = key ? write(-1, fieldPath(path, -2, *key)) : std::nullopt;
            if (value) rows.emplace_back(*key, std::move(*value));
        }
        std::sort(rows.begin(), rows.end());
        std::string text = "{";
        for (const auto& [key, value] : rows) text += "[" + key + "]=" + value + ",";
        return text + "}";
    }

    lua_State* m_state;
    DataLosses& m_losses;
    std::vector<const void*> m_open;  ///< tables that are being written, each in the one before
};

}  // namespace

std::string dataText(lua_State* L, int index, DataLosses& losses) {
    return DataWriter(L, losses).write(index, "").value_or("nil");
}

}  // namespace rubble::script
