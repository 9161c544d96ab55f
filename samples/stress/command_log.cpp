#include "samples/stress/command_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "samples/stress/scene_functions.h"

namespace stress {
namespace {

constexpr lua_Integer kSmallestHandle = 1 << 20;

/// How functions of the vocabulary with an effect begin.
constexpr std::array kEffects = {"Set",    "Draw",    "Create",    "Clear",     "Resize", "Trim",      "Split",
                                 "Merge",  "Copy",    "Extrude",   "Remove",    "Paint",  "Constrain", "Apply",
                                 "Spawn",  "AddHeat", "Explosion", "Shoot",     "Delete", "MakeHole",  "PointLight",
                                 "Detach", "Break",   "Crack",     "Extinguish"};
/// Functions that give handles of things that were not made by a command.
constexpr std::array kFinders = {"Find", "GetShapeBody", "GetBodyShapes", "GetJointShapes", "GetShapeJoints"};

bool beginsWithOneOf(const std::string& name, const auto& prefixes) {
    return std::any_of(prefixes.begin(), prefixes.end(), [&](const char* each) { return name.starts_with(each); });
}

/// Scene functions all have an effect, but those that wait or compare.
bool isCommand(const rubble::script::ScriptFunction& function, const std::string& name) {
    const auto scene = sceneFunctions();
    const bool isOfScene =
        std::any_of(scene.begin(), scene.end(), [&](const auto& each) { return &each == &function; });
    return isOfScene ? name != "WaitForStep" && name != "Expect" : beginsWithOneOf(name, kEffects);
}

/// A text in quotes, in one line, that Lua reads as the same bytes. "@" is escaped, as commands stand between two of
/// it.
std::string quoted(const std::string& bytes) {
    std::string text = "\"";
    for (size_t i = 0; i < bytes.size(); ++i) {
        const auto byte = static_cast<unsigned char>(bytes[i]);
        if (byte == '"' || byte == '\\')
            text += {'\\', bytes[i]};
        else if (byte == '\n')
            text += "\\n";
        else if (byte < 32 || byte > 126 || byte == '@')
            text += fmt::format("\\{:03}", byte);
        else
            text += bytes[i];
    }
    return text + "\"";
}

/// The shortest text of a number with a point that gives its bits again.
std::string numberText(double value) {
    if (std::isnan(value)) return "0/0";
    if (std::isinf(value)) return value > 0.0 ? "1/0" : "-1/0";
    const std::string text = fmt::format("{}", value);
    return text + (text.find_first_of(".e") == std::string::npos ? ".0" : "");
}

/// A key of a table as its constructor has it.
std::string keyText(const std::string& key) {
    static constexpr std::array kKeywords = {"and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
                                             "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
                                             "repeat",   "return", "then", "true", "until",  "while"};
    const auto isWord = [](char each) { return each == '_' || std::isalnum(static_cast<unsigned char>(each)); };
    const bool isName = !key.empty() && !std::isdigit(static_cast<unsigned char>(key[0])) &&
                        std::all_of(key.begin(), key.end(), isWord) &&
                        std::find(kKeywords.begin(), kKeywords.end(), key) == kKeywords.end();
    return isName ? key : "[" + quoted(key) + "]";
}

/// The same of a number or a boolean.
std::string keyText(lua_State* L, int index) {
    if (lua_isboolean(L, index)) return lua_toboolean(L, index) ? "[true]" : "[false]";
    return "[" +
           (lua_isinteger(L, index) ? std::to_string(lua_tointeger(L, index)) : numberText(lua_tonumber(L, index))) +
           "]";
}

/// The bytes of a text on the stack.
std::string textOf(lua_State* L, int index) {
    size_t length = 0;
    const char* bytes = lua_tolstring(L, index, &length);
    return {bytes, length};
}

}  // namespace

std::string CommandLog::valueText(lua_State* L, int index, int depth, std::vector<size_t>& needed) const {
    switch (lua_type(L, index)) {
        case LUA_TBOOLEAN:
            return lua_toboolean(L, index) ? "true" : "false";
        case LUA_TSTRING:
            return quoted(textOf(L, index));
        case LUA_TNUMBER: {
            if (!lua_isinteger(L, index)) return numberText(lua_tonumber(L, index));
            const lua_Integer value = lua_tointeger(L, index);
            const auto found = m_expressions.find(uint64_t(value));
            if (value < kSmallestHandle || found == m_expressions.end()) return std::to_string(value);
            for (size_t at = 0; (at = found->second.find('@', at)) != std::string::npos;) {
                needed.push_back(size_t(std::stoul(found->second.substr(at + 1))));
                at = found->second.find('@', at + 1) + 1;
            }
            return found->second;
        }
        case LUA_TTABLE:
            return depth == 0 ? "{}" : tableText(L, index, depth, needed);
        default:
            return "nil";
    }
}

/// First its list, then its other keys, sorted, as the order in a table is not.
std::string CommandLog::tableText(lua_State* L, int index, int depth, std::vector<size_t>& needed) const {
    std::string text;
    const lua_Integer length = lua_Integer(lua_rawlen(L, index));
    for (lua_Integer i = 1; i <= length; ++i) {
        lua_rawgeti(L, index, i);
        text += (text.empty() ? "" : ", ") + valueText(L, lua_gettop(L), depth - 1, needed);
        lua_pop(L, 1);
    }
    std::map<std::string, std::string> fields;
    for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
        const bool isListed = lua_isinteger(L, -2) && lua_tointeger(L, -2) >= 1 && lua_tointeger(L, -2) <= length;
        const int type = lua_type(L, -2);
        if (isListed || (type != LUA_TSTRING && type != LUA_TNUMBER && type != LUA_TBOOLEAN)) continue;
        const std::string key = type == LUA_TSTRING ? keyText(textOf(L, -2)) : keyText(L, -2);
        fields[key] = valueText(L, lua_gettop(L), depth - 1, needed);
    }
    for (const auto& [key, value] : fields) text += (text.empty() ? "" : ", ") + key + " = " + value;
    return "{" + text + "}";
}

void CommandLog::begin(lua_State* L, const rubble::script::ScriptFunction& function) {
    if (m_isClosed) return;
    catchOpenCall();
    const std::string called = function.name();
    m_isCommand = isCommand(function, called);
    if (!m_isCommand && !beginsWithOneOf(called, kFinders)) return m_call.clear();
    std::vector<size_t> needed;
    std::string arguments;
    luaL_checkstack(L, 20, nullptr);
    const int count = lua_gettop(L);
    for (int i = 1; i <= count; ++i) arguments += (i > 1 ? ", " : "") + valueText(L, i, 3, needed);
    m_call = called + "(" + arguments + ")";
    const int step = int(rubble::script::ScriptContext::of(L).shared.step);
    if (!m_isCommand) return;
    m_commands.push_back({step, m_call, std::move(needed)});
    m_isOpen = true;
}

void CommandLog::catchOpenCall() {
    if (!std::exchange(m_isOpen, false)) return;
    std::string& text = m_commands.back().text;
    const size_t open = text.find('(');
    const std::string arguments = text.substr(open + 1);
    text = "pcall(" + text.substr(0, open) + (arguments == ")" ? "" : ", ") + arguments;
}

void CommandLog::close(const std::string& message) {
    m_isClosed = true;
    if (!m_isOpen) return;
    const std::string& text = m_commands.back().text;
    if (message.find(": " + text.substr(0, text.find('(')) + ": ") == std::string::npos) catchOpenCall();
}

void CommandLog::name(lua_State* L, int index, const std::string& expression) {
    if (!lua_isinteger(L, index)) return;
    const lua_Integer value = lua_tointeger(L, index);
    if (value >= kSmallestHandle) m_expressions.emplace(uint64_t(value), expression);
}

void CommandLog::end(lua_State* L, const rubble::script::ScriptFunction&, int results) {
    if (m_isClosed) return;
    m_isOpen = false;
    if (m_call.empty() || results == 0) return;
    const int first = lua_gettop(L) - results + 1;
    const std::string made = m_isCommand ? fmt::format("@{}@", m_commands.size() - 1) : m_call;
    if (lua_istable(L, first)) {
        for (lua_Integer i = 1; i <= lua_Integer(lua_rawlen(L, first)); ++i) {
            lua_rawgeti(L, first, i);
            name(L, lua_gettop(L), fmt::format("{}[{}]", made, i));
            lua_pop(L, 1);
        }
        return;
    }
    name(L, first, made);
    if (results > 1 && m_isCommand) name(L, first + 1, "GetShapeBody(" + made + ")");
}

std::vector<Command> CommandLog::take() {
    m_expressions.clear();
    m_isOpen = m_isClosed = false;
    return std::exchange(m_commands, {});
}

std::string scriptOf(const std::vector<Command>& commands) {
    std::string text = "local made = {}\nfunction init()\n";
    int step = 0;
    for (size_t i = 0; i < commands.size(); ++i) {
        if (commands[i].step > step) text += fmt::format("    WaitForStep({})\n", step = commands[i].step);
        const std::string mark = fmt::format("@{}@", i);
        const bool isNeeded = std::any_of(commands.begin(), commands.end(), [&](const Command& each) {
            return each.text.find(mark) != std::string::npos;
        });
        std::string line = commands[i].text;
        for (size_t at = 0; (at = line.find('@', at)) != std::string::npos;) {
            const size_t end = line.find('@', at + 1);
            line = line.substr(0, at) + "made[" + line.substr(at + 1, end - at - 1) + "]" + line.substr(end + 1);
        }
        text += "    " + (isNeeded ? fmt::format("made[{}] = ", i) : std::string()) + line + "\n";
    }
    return text + "end\n";
}

}  // namespace stress
