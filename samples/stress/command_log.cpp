#include "samples/stress/command_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <utility>

#include "samples/stress/checks/check.h"
#include "samples/stress/scene_functions.h"

namespace stress {
namespace {

constexpr lua_Integer kSmallestHandle = 1 << 20;

/// How functions of the vocabulary without an effect on the world begin. All others are written down.
constexpr std::array kQuestions = {"Get", "Is",    "Has",      "List",  "Find", "Query", "Vec",     "Quat", "Transform",
                                   "Ui",  "Debug", "DrawLine", "Input", "wait", "start", "require", "saved"};
/// Functions that give handles of things that were not made by a command.
constexpr std::array kFinders = {"Find",          "GetShapeBody",   "GetShapeJoints",     "GetShapeLights",
                                 "GetBodyShapes", "GetJointShapes", "GetJointOtherShape", "GetLightShape"};
/// Lists of all objects of a kind.
constexpr struct {
    uint32_t kind;
    const char* list;
} kLists[] = {{RUBBLE_KIND_BODY, "FindBodies()"},
              {RUBBLE_KIND_SHAPE, "FindShapes()"},
              {RUBBLE_KIND_JOINT, "FindJoints()"},
              {RUBBLE_KIND_LIGHT, "FindLights()"},
              {RUBBLE_KIND_TRIGGER, "FindTriggers()"}};

bool beginsWithOneOf(const std::string& name, const auto& prefixes) {
    return std::any_of(prefixes.begin(), prefixes.end(), [&](const char* each) { return name.starts_with(each); });
}

/// Scene functions all have an effect, but those that wait or compare.
bool isCommand(const rubble::script::ScriptFunction& function, const std::string& name) {
    const auto scene = sceneFunctions();
    const bool isOfScene =
        std::any_of(scene.begin(), scene.end(), [&](const auto& each) { return &each == &function; });
    return isOfScene ? name != "WaitForStep" && name != "Expect" : !beginsWithOneOf(name, kQuestions);
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

/// The commands that a text needs: what they give stands in it as "@number@".
std::vector<size_t> neededBy(const std::string& text) {
    std::vector<size_t> numbers;
    for (size_t at = 0; (at = text.find('@', at)) != text.npos; at = text.find('@', at + 1) + 1)
        numbers.push_back(size_t(std::stoul(text.substr(at + 1))));
    return numbers;
}

/// A call whose error the script has caught.
std::string caught(const std::string& call) {
    const size_t open = call.find('(');
    const std::string arguments = call.substr(open + 1);
    return "pcall(" + call.substr(0, open) + (arguments == ")" ? "" : ", ") + arguments;
}

/// A command whose needed ones have these numbers now.
Command renumbered(Command command, const std::vector<size_t>& numbers) {
    std::string text;
    const std::string& old = command.text;
    for (size_t at = 0; at < old.size();) {
        const size_t begin = old.find('@', at);
        text += old.substr(at, begin == std::string::npos ? begin : begin - at);
        if (begin == std::string::npos) break;
        const size_t end = old.find('@', begin + 1);
        text += fmt::format("@{}@", numbers[size_t(std::stoul(old.substr(begin + 1, end - begin - 1)))]);
        at = end + 1;
    }
    command.text = std::move(text);
    for (size_t& needed : command.needed) needed = numbers[needed];
    return command;
}

}  // namespace

std::string CommandLog::valueText(lua_State* L, int index, int depth) {
    switch (lua_type(L, index)) {
        case LUA_TBOOLEAN:
            return lua_toboolean(L, index) ? "true" : "false";
        case LUA_TSTRING:
            return quoted(textOf(L, index));
        case LUA_TNUMBER: {
            if (!lua_isinteger(L, index)) return numberText(lua_tonumber(L, index));
            const lua_Integer value = lua_tointeger(L, index);
            const std::string expression = value < kSmallestHandle ? "" : expressionOf(L, uint64_t(value));
            return expression.empty() ? std::to_string(value) : expression;
        }
        case LUA_TTABLE:
            return depth == 0 ? "{}" : tableText(L, index, depth);
        default:
            return "nil";
    }
}

/// First its list, then its other keys, sorted, as the order in a table is not.
std::string CommandLog::tableText(lua_State* L, int index, int depth) {
    std::string text;
    const lua_Integer length = lua_Integer(lua_rawlen(L, index));
    for (lua_Integer i = 1; i <= length; ++i) {
        lua_rawgeti(L, index, i);
        text += (text.empty() ? "" : ", ") + valueText(L, lua_gettop(L), depth - 1);
        lua_pop(L, 1);
    }
    std::map<std::string, std::string> fields;
    for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
        const bool isListed = lua_isinteger(L, -2) && lua_tointeger(L, -2) >= 1 && lua_tointeger(L, -2) <= length;
        const int type = lua_type(L, -2);
        if (isListed || (type != LUA_TSTRING && type != LUA_TNUMBER && type != LUA_TBOOLEAN)) continue;
        const std::string key = type == LUA_TSTRING ? keyText(textOf(L, -2)) : keyText(L, -2);
        fields[key] = valueText(L, lua_gettop(L), depth - 1);
    }
    for (const auto& [key, value] : fields) text += (text.empty() ? "" : ", ") + key + " = " + value;
    return "{" + text + "}";
}

size_t CommandLog::add(lua_State* L, const std::string& text, bool hasEffect) {
    const size_t at = m_bytes.size();
    m_bytes.resize(at + sizeof(Head));
    setHead(at, {int32_t(rubble::script::ScriptContext::of(L).shared.step), uint32_t(text.size()), hasEffect});
    m_bytes += text;
    ++m_count;
    return at;
}

CommandLog::Head CommandLog::headAt(size_t at) const {
    Head head;
    std::memcpy(&head, m_bytes.data() + at, sizeof head);
    return head;
}

void CommandLog::setHead(size_t at, const Head& head) {
    std::memcpy(m_bytes.data() + at, &head, sizeof head);
}

std::string CommandLog::expressionOf(lua_State* L, uint64_t handle) {
    if (const auto found = m_origins.find(handle); found != m_origins.end()) {
        const auto [command, place] = found->second;
        if (place == Origin::BodyOfIt) return fmt::format("GetShapeBody(@{}@)", command);
        return place ? fmt::format("@{}@[{}]", command, place) : fmt::format("@{}@", command);
    }
    const rubble::script::ScriptWorld& shared = rubble::script::ScriptContext::of(L).shared;
    for (const auto& row : kLists) {
        const auto read = [&](uint64_t* out, uint32_t capacity, uint32_t* count) {
            return shared.api->get_objects(shared.world, row.kind, out, capacity, count);
        };
        const std::vector<uint64_t> objects = readRows<uint64_t>(read);
        if (std::find(objects.begin(), objects.end(), handle) == objects.end()) continue;
        for (size_t i = 0; i < objects.size(); ++i) m_origins.emplace(objects[i], Origin{m_count, int32_t(i + 1)});
        add(L, row.list, false);
        return expressionOf(L, handle);
    }
    return {};
}

void CommandLog::begin(lua_State* L, const rubble::script::ScriptFunction& function) {
    if (m_isClosed) return;
    catchOpenCall();
    m_waiting.erase(L);
    m_call = {};
    const std::string called = function.name();
    const bool hasEffect = isCommand(function, called);
    if (!hasEffect && !beginsWithOneOf(called, kFinders)) return;
    std::string arguments;
    luaL_checkstack(L, 20, nullptr);
    const int count = lua_gettop(L);
    for (int i = 1; i <= count; ++i) arguments += (i > 1 ? ", " : "") + valueText(L, i, 3);
    m_call = {&function, called + "(" + arguments + ")"};
    if (!hasEffect) return;
    m_call.command = m_count;
    m_call.at = add(L, m_call.text, true);
    m_isOpen = true;
}

void CommandLog::wait(lua_State* L, const rubble::script::ScriptFunction&) {
    if (m_isClosed || !std::exchange(m_isOpen, false)) return;
    m_waiting[L] = m_call;
    Head head = headAt(m_call.at);
    head.waits = true;
    setHead(m_call.at, head);
}

void CommandLog::catchOpenCall() {
    if (!std::exchange(m_isOpen, false)) return;
    Head head = headAt(m_call.at);
    head.isCaught = true;
    setHead(m_call.at, head);
}

void CommandLog::close(const std::string& message) {
    m_isClosed = true;
    if (!m_isOpen) return;
    const std::string& text = m_call.text;
    if (message.find(": " + text.substr(0, text.find('(')) + ": ") == std::string::npos) catchOpenCall();
}

bool CommandLog::name(lua_State* L, int index, uint32_t command) {
    if (lua_isinteger(L, index)) {
        const lua_Integer value = lua_tointeger(L, index);
        return value >= kSmallestHandle && m_origins.emplace(uint64_t(value), Origin{command, Origin::Itself}).second;
    }
    bool isNew = false;
    for (lua_Integer i = 1; lua_istable(L, index) && i <= lua_Integer(lua_rawlen(L, index)); ++i) {
        lua_rawgeti(L, index, i);
        const lua_Integer value = lua_isinteger(L, -1) ? lua_tointeger(L, -1) : 0;
        if (value >= kSmallestHandle) isNew |= m_origins.emplace(uint64_t(value), Origin{command, int32_t(i)}).second;
        lua_pop(L, 1);
    }
    return isNew;
}

void CommandLog::end(lua_State* L, const rubble::script::ScriptFunction& function, int results) {
    if (m_isClosed) return;
    Call call;
    if (const auto waiting = m_waiting.find(L); waiting != m_waiting.end()) {
        call = std::move(waiting->second);
        m_waiting.erase(waiting);
    } else if (m_call.function == &function) {
        call = std::exchange(m_call, {});
        m_isOpen = false;
    }
    if (!call.function || results == 0) return;
    const int first = lua_gettop(L) - results + 1;
    if (call.command == kNone) {
        if (name(L, first, m_count)) add(L, call.text, false);
        return;
    }
    name(L, first, call.command);
    if (results > 1 && lua_isinteger(L, first + 1) && lua_tointeger(L, first + 1) >= kSmallestHandle)
        m_origins.emplace(uint64_t(lua_tointeger(L, first + 1)), Origin{call.command, Origin::BodyOfIt});
}

uint64_t CommandLog::bytes() const {
    constexpr uint64_t kNode = 4 * sizeof(void*);  // of malloc, with a pointer to the next and a row
    return m_bytes.capacity() + m_origins.size() * kNode + m_origins.bucket_count() * sizeof(void*);
}

std::vector<Command> CommandLog::take() {
    std::vector<Command> commands;
    commands.reserve(m_count);
    for (size_t at = 0; at < m_bytes.size();) {
        const Head head = headAt(at);
        std::string text = m_bytes.substr(at + sizeof head, head.length);
        std::vector<size_t> needed = neededBy(text);
        if (head.isCaught) text = caught(text);
        commands.push_back({head.step, std::move(text), std::move(needed), head.hasEffect, head.waits});
        at += sizeof head + head.length;
    }
    *this = {};
    m_bytes.shrink_to_fit();  // a text keeps its memory
    return keep(commands, {});
}

std::vector<Command> keep(const std::vector<Command>& commands, std::vector<bool> isKept) {
    isKept.resize(commands.size(), true);
    std::vector<bool> isNeeded(commands.size());
    for (size_t i = 0; i < commands.size(); ++i)
        for (const size_t needed : commands[i].needed) isKept[i] = isKept[i] && isKept[needed];
    for (size_t i = commands.size(); i-- > 0;) {
        isKept[i] = isKept[i] && (commands[i].hasEffect || isNeeded[i]);
        for (const size_t needed : commands[i].needed) isNeeded[needed] = isNeeded[needed] || isKept[i];
    }
    std::vector<Command> kept;
    std::vector<size_t> numbers(commands.size());
    for (size_t i = 0; i < commands.size(); ++i) {
        numbers[i] = kept.size();
        if (isKept[i]) kept.push_back(renumbered(commands[i], numbers));
    }
    return kept;
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
        step += commands[i].waits;
    }
    return text + "end\n";
}

}  // namespace stress
