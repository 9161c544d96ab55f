#include <cctype>
#include <cmath>
#include <cstdlib>
#include <set>

#include "runtime/script/binding/calls.h"
#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {
namespace {

constexpr size_t kMaxKeys = 10'000, kMaxText = 4096;

std::map<std::string, std::string>& keysOf(lua_State* L) {
    return ScriptContext::of(L).shared.registry;
}

/// The value of the key of argument 1, or null.
const std::string* valueAt(lua_State* L) {
    const auto found = keysOf(L).find(textAt(L, 1, "key"));
    return found == keysOf(L).end() ? nullptr : &found->second;
}

/// Whether a text is UTF-8 without zero bytes.
bool isPlainText(const std::string& text) {
    for (size_t at = 0; at < text.size();) {
        const auto first = static_cast<unsigned char>(text[at]);
        const size_t more = first < 0x80 ? 0 : first >> 5 == 6 ? 1 : first >> 4 == 14 ? 2 : first >> 3 == 30 ? 3 : 4;
        if (!first || more > 3 || at + more >= text.size()) return false;
        uint32_t point = more ? first & (0x3fu >> more) : first;
        for (size_t i = 1; i <= more; ++i) {
            const auto next = static_cast<unsigned char>(text[at + i]);
            if (next >> 6 != 2) return false;
            point = point << 6 | (next & 0x3fu);
        }
        constexpr uint32_t kLeast[] = {0, 0x80, 0x800, 0x10000};
        if (point < kLeast[more] || point > 0x10ffff || (point >= 0xd800 && point < 0xe000)) return false;
        at += more + 1;
    }
    return true;
}

int set(lua_State* L, const std::string& value) {
    const std::string key = textAt(L, 1, "key");
    if (key.empty() || key.size() > kMaxText) refuseArgument(L, 1, "key", "1 to 4096 bytes");
    if (!isPlainText(key)) refuseArgument(L, 1, "key", "UTF-8 without zero bytes");
    if (!isPlainText(value)) refuseArgument(L, 2, "value", "UTF-8 without zero bytes");
    if (value.size() > kMaxText) refuseArgument(L, 2, "value", "at most 4096 bytes");
    auto& keys = keysOf(L);
    if (keys.size() >= kMaxKeys && !keys.count(key))
        return luaL_error(L, "%s: the registry has %d keys already", runningFunction(L).name().c_str(), int(kMaxKeys));
    keys[key] = value;
    return 0;
}

std::string textOf(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", number);
    return text;
}

/// A number without its fraction, within the range of whole numbers; nothing of what is none.
int64_t wholeOf(double number) {
    constexpr double kLimit = 9223372036854775808.0;  // 2^63
    if (std::isnan(number)) return 0;
    if (number >= kLimit) return INT64_MAX;
    return number < -kLimit ? INT64_MIN : int64_t(number);
}

int setInt(lua_State* L) {
    if (lua_isinteger(L, 2)) return set(L, std::to_string(lua_tointeger(L, 2)));
    const double value = numberAt(L, 2, "value");
    if (std::isnan(value)) refuseArgument(L, 2, "value", "a number");
    return set(L, std::to_string(wholeOf(value)));
}

int setFloat(lua_State* L) {
    return set(L, textOf(numberAt(L, 2, "value")));
}

int setBool(lua_State* L) {
    return set(L, lua_toboolean(L, 2) ? "1" : "0");
}

int setString(lua_State* L) {
    if (!lua_isstring(L, 2)) refuseArgument(L, 2, "value", "a text");
    size_t length = 0;
    const char* bytes = lua_tolstring(L, 2, &length);
    return set(L, std::string(bytes, length));
}

/// Digits are exact; what goes on with a fraction or an exponent, or begins with 0x, is read as a number.
int64_t wholeOf(const std::string& text) {
    char* end = nullptr;
    const int64_t digits = std::strtoll(text.c_str(), &end, 10);
    return *end == '.' || *end == 'e' || *end == 'E' || *end == 'x' || *end == 'X' || end == text.c_str()
               ? wholeOf(std::strtod(text.c_str(), nullptr))
               : digits;
}

int pushInt(lua_State* L, const std::string* value) {
    lua_pushinteger(L, value ? wholeOf(*value) : 0);
    return 1;
}

int pushFloat(lua_State* L, const std::string* value) {
    lua_pushnumber(L, value ? std::strtod(value->c_str(), nullptr) : 0.0);
    return 1;
}

/// False are "", "0" and all zeros, "false", "no" and "off", in any case and with spaces around.
bool boolOf(const std::string& value) {
    std::string word;
    for (const unsigned char letter : value)
        if (!std::isspace(letter)) word += char(std::tolower(letter));
    char* end = nullptr;
    const bool isZero = std::strtod(word.c_str(), &end) == 0.0 && *end == '\0';  // as is ""
    return !isZero && word != "false" && word != "no" && word != "off";
}

int pushBool(lua_State* L, const std::string* value) {
    lua_pushboolean(L, value && boolOf(*value));
    return 1;
}

int pushString(lua_State* L, const std::string* value) {
    lua_pushstring(L, value ? value->c_str() : "");
    return 1;
}

template <int (*Push)(lua_State*, const std::string*)>
int getKey(lua_State* L) {
    return Push(L, valueAt(L));
}

/// A parameter of the script, or argument 2 where it has none.
template <int (*Push)(lua_State*, const std::string*)>
int getParam(lua_State* L) {
    const auto& parameters = ScriptContext::of(L).parameters;
    const auto found = parameters.find(textAt(L, 1, "name"));
    if (found != parameters.end()) return Push(L, &found->second);
    lua_settop(L, 2);
    return 1;
}

int hasKey(lua_State* L) {
    const std::string key = textAt(L, 1, "key");
    const auto next = keysOf(L).lower_bound(key);
    const bool isThere = next != keysOf(L).end() && (next->first == key || next->first.starts_with(key + "."));
    lua_pushboolean(L, isThere);
    return 1;
}

int clearKey(lua_State* L) {
    const std::string key = textAt(L, 1, "key");
    std::erase_if(keysOf(L),
                  [&](const auto& row) { return key.empty() || row.first == key || row.first.starts_with(key + "."); });
    return 0;
}

int listKeys(lua_State* L) {
    const std::string key = textAt(L, 1, "parent"), parent = key.empty() ? "" : key + ".";
    std::set<std::string> children;  // those of one child need not stand together: "a", "a-b", "a.c"
    for (auto row = keysOf(L).lower_bound(parent); row != keysOf(L).end() && row->first.starts_with(parent); ++row) {
        Sandbox::of(L).charge(L, 10);
        children.insert(row->first.substr(parent.size(), row->first.find('.', parent.size()) - parent.size()));
    }
    lua_newtable(L);
    lua_Integer count = 0;
    for (const std::string& child : children) {
        lua_pushstring(L, child.c_str());
        lua_rawseti(L, -2, ++count);
    }
    return 1;
}

constexpr ScriptFunction kFunctions[] = {
    {"SetInt(key, value)", "Writes a key of the registry, \"a.b.c\", which all scripts of the world share.", setInt},
    {"GetInt(key) -> number", "A key as a whole number; 0 if it is not there.", getKey<pushInt>},
    {"SetFloat(key, value)", "Writes a number.", setFloat},
    {"GetFloat(key) -> number", "A key as a number; 0 if it is not there.", getKey<pushFloat>},
    {"SetBool(key, value)", "Writes true or false.", setBool},
    {"GetBool(key) -> boolean", "A key as true or false; false if it is not there.", getKey<pushBool>},
    {"SetString(key, value)", "Writes a text.", setString},
    {"GetString(key) -> text", "A key as a text; \"\" if it is not there.", getKey<pushString>},
    {"HasKey(key) -> boolean", "Whether a key is there, or keys under it.", hasKey},
    {"ClearKey(key)", "Removes a key and all under it; \"\": all keys.", clearKey},
    {"ListKeys(parent) -> list", "The names of the keys right under a key, sorted; \"\": the first names of all.",
     listKeys},
    {"GetIntParam(name, default) -> number", "A parameter of the script.", getParam<pushInt>},
    {"GetFloatParam(name, default) -> number", "A parameter of the script.", getParam<pushFloat>},
    {"GetBoolParam(name, default) -> boolean", "A parameter of the script.", getParam<pushBool>},
    {"GetStringParam(name, default) -> text", "A parameter of the script.", getParam<pushString>},
};

}  // namespace

std::span<const ScriptFunction> registryFunctions() {
    return kFunctions;
}

}  // namespace rubble::script
