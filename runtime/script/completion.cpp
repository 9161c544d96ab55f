// What Script::completions() offers.
#include <array>
#include <set>

#include "runtime/script/binding/arguments.h"
#include "runtime/script/script.h"

namespace rubble::script {
namespace {

constexpr std::array kKeywords = {"and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
                                  "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
                                  "repeat",   "return", "then", "true", "until",  "while"};
constexpr int kMaxMetatables = 8;  ///< tables behind tables that are looked through

bool isNameByte(char byte) {
    return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || (byte >= '0' && byte <= '9') || byte == '_';
}

bool isName(std::string_view text) {
    bool isGood = !text.empty() && (text[0] < '0' || text[0] > '9');
    for (const char byte : text) isGood = isGood && isNameByte(byte);
    return isGood;
}

/// The end of a line: "x = a.b:c" is the names a and b, and the beginning c of a method.
struct Ending {
    std::string_view word;                ///< "a.b:c", from the last byte on that no name has
    std::vector<std::string_view> names;  ///< a, b
    std::string_view beginning;           ///< c
    bool isMethod = false, isGood = true;
};

Ending endingOf(std::string_view line) {
    Ending ending;
    size_t start = line.size();
    while (start > 0 && (isNameByte(line[start - 1]) || line[start - 1] == '.' || line[start - 1] == ':')) --start;
    ending.word = line.substr(start);
    const size_t operation = ending.word.rfind("..");  // that joins texts
    std::string_view rest = operation == line.npos ? ending.word : ending.word.substr(operation + 2);
    for (size_t end; (end = rest.find_first_of(".:")) != rest.npos; rest.remove_prefix(end + 1)) {
        ending.names.push_back(rest.substr(0, end));
        ending.isMethod = rest[end] == ':';
        ending.isGood = ending.isGood && isName(ending.names.back());
    }
    ending.beginning = rest;
    return ending;
}

/// Replaces the value on the stack by what its metatable says to look in, without calling anything; false: nothing.
bool lookBehind(lua_State* L) {
    if (!lua_getmetatable(L, -1)) return false;
    lua_pushstring(L, "__index");
    lua_rawget(L, -2);
    lua_replace(L, -3);
    lua_pop(L, 1);
    return lua_istable(L, -1);
}

/// Replaces the value on the stack by its field.
void getField(lua_State* L, std::string_view name) {
    for (int i = 0; i < kMaxMetatables; ++i) {
        if (lua_istable(L, -1)) {
            lua_pushlstring(L, name.data(), name.size());
            if (lua_rawget(L, -2) != LUA_TNIL) return lua_remove(L, -2);
            lua_pop(L, 1);
        }
        if (!lookBehind(L)) break;
    }
    lua_pop(L, 1);
    lua_pushnil(L);
}

/// The fields that operators give to the value on the stack.
std::string_view componentsOf(lua_State* L) {
    std::string_view components;
    if (!lua_getmetatable(L, -1)) return components;
    for (const auto& [kind, fields] : {std::pair{ValueKind::Vec, "xyz"}, std::pair{ValueKind::Quat, "xyzw"}}) {
        pushMetatable(L, kind);
        if (lua_rawequal(L, -1, -2)) components = fields;
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return components;
}

/// A question and its answer.
struct Search {
    Ending ending;
    std::set<std::string> names;
};

void addName(Search& search, std::string_view name, bool isFunction) {
    if (!isName(name) || !name.starts_with(search.ending.beginning) || (search.ending.isMethod && !isFunction)) return;
    search.names.insert(std::string(name) + (isFunction ? "(" : ""));
}

int find(lua_State* L) {
    auto& search = *static_cast<Search*>(lua_touserdata(L, 1));
    lua_rawgeti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
    for (const std::string_view name : search.ending.names) getField(L, name);
    if (search.ending.names.empty())
        for (const char* keyword : kKeywords) addName(search, keyword, false);
    for (const char& component : componentsOf(L)) addName(search, {&component, 1}, false);
    for (int i = 0; i < kMaxMetatables; ++i) {
        if (lua_istable(L, -1))
            for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1)) {
                size_t length = 0;
                if (lua_type(L, -2) != LUA_TSTRING) continue;
                const char* name = lua_tolstring(L, -2, &length);
                addName(search, {name, length}, lua_isfunction(L, -1));
            }
        if (!lookBehind(L)) break;
    }
    return 0;
}

}  // namespace

std::vector<std::string> Script::completions(std::string_view line) {
    Search search{endingOf(line), {}};
    if (isStopped() || !search.ending.isGood || !m_sandbox.prepare(find, &search)) return {};
    const std::string_view word = search.ending.word;
    const std::string before(word.substr(0, word.size() - search.ending.beginning.size()));
    std::vector<std::string> words;
    for (const std::string& name : search.names) words.push_back(before + name);
    return words;
}

}  // namespace rubble::script
