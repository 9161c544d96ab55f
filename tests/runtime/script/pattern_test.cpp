// Patterns of the sandbox against those of Lua itself.
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "tests/runtime/script/lua_run.h"

namespace rubble::script {
namespace {

/// Runs a text in a state of Lua with its own libraries.
class PlainLua {
public:
    PlainLua() : m_state(luaL_newstate(), lua_close) { luaL_openlibs(m_state.get()); }
    std::string run(const std::string& text) {
        lua_State* L = m_state.get();
        lua_settop(L, 0);
        std::string answer;
        if (luaL_loadbufferx(L, text.data(), text.size(), "=test", "t") || lua_pcall(L, 0, LUA_MULTRET, 0))
            return "error: " + std::string(lua_tostring(L, -1));
        for (int i = 1, count = lua_gettop(L); i <= count; ++i) {
            size_t length = 0;
            const char* bytes = luaL_tolstring(L, i, &length);
            answer += (i > 1 ? " " : "") + std::string(bytes, length);
            lua_pop(L, 1);
        }
        return answer;
    }

private:
    std::unique_ptr<lua_State, void (*)(lua_State*)> m_state;
};

template <class T, size_t N>
const T& oneOf(std::mt19937& random, const T (&values)[N]) {
    return values[random() % N];
}

std::string randomPattern(std::mt19937& random) {
    static const std::string kItems[] = {"a",  "b",    "%a",    "%d",    ".",  "[ab]",  "[^a]", "(",      ")",
                                         "()", "%b()", "%f[a]", "%1",    "%s", "[%a-]", "[]x]", "[0-9a]", "%W",
                                         "$",  "^",    "%(",    "[^%s]", "[",  "%",     "-",    "]"};
    static const std::string kRepeats[] = {"", "", "", "*", "+", "-", "?"};
    std::string pattern = random() % 6 ? "" : "^";
    for (size_t i = 1 + random() % 5; i > 0; --i) {
        pattern += oneOf(random, kItems);
        pattern += oneOf(random, kRepeats);
    }
    return pattern + (random() % 6 ? "" : "$");
}

std::string randomSubject(std::mt19937& random) {
    static const char kBytes[] = {'a', 'b', 'a', '0', ' ', '(', ')', '-', 'x', ']'};
    std::string subject;
    for (size_t i = random() % 12; i > 0; --i) subject += oneOf(random, kBytes);
    return subject;
}

TEST(Pattern, RandomPatternsMatchAsInLuaItself) {
    static const std::string kCalls[] = {
        "return string.find(s, p)",
        "return string.find(s, p, 3)",
        "return string.find(s, p, -2)",
        "return string.find(s, p, 1, true)",
        "return string.match(s, p)",
        "local t = {} for a, b in string.gmatch(s, p) do t[#t + 1] = tostring(a) .. tostring(b) end return #t, "
        "table.concat(t, ',')",
        "return string.gsub(s, p, '<%0>')",
        "return string.gsub(s, p, '%1%1', 2)",
        "return string.gsub(s, p, {a = 'A', ab = false, b = 7})",
        "return string.gsub(s, p, function(a, b) return b end)",
    };
    std::mt19937 random(7);
    PlainLua plain;
    int matches = 0, errors = 0;
    for (int i = 0; i < 4000; ++i) {
        const std::string text = "local s, p = [==[" + randomSubject(random) + "]==], [==[" + randomPattern(random) +
                                 "]==] " + oneOf(random, kCalls);
        Sandbox box{SandboxLimits{}};
        const std::string expected = plain.run(text);
        ASSERT_EQ(runText(box, text), expected) << text;
        errors += expected.starts_with("error");
        matches += !expected.starts_with("error") && !expected.starts_with("nil");
    }
    EXPECT_GT(matches, 1000);
    EXPECT_GT(errors, 200) << "wrong patterns are compared too";
}

TEST(Pattern, StringFunctionsAnswerAsInLuaItself) {
    PlainLua plain;
    Sandbox box{SandboxLimits{}};
    for (const char* text : {"return ('x'):rep(3, '-'), ('x'):rep(0), ('x'):rep(-1)",
                             "return string.find('', '')",
                             "return string.find('abc', '', 10)",
                             "return string.find('abc', 'b', -10)",
                             "return string.gsub('abc', '', '-')",
                             "return string.gsub('hello world', 'o', '0', 1)",
                             "return string.gsub('abc', '%w', '%%%0')",
                             "return string.gsub('abc', 'b', '%9')",
                             "return string.gsub('abc', 'b', '%x')",
                             "return string.gsub('abc', 'b', true)",
                             "return string.gsub('abc', 'b', function() return {} end)",
                             "return string.format('%5.2f|%-5d|%q|%s|%x', 2.71828, 42, 'a\\nb', true, 255)",
                             "return string.format('%d', 'x')",
                             "return ('%s'):format(nil)",
                             "return ('x'):len()",
                             "return string.byte('abc', 1, -1)",
                             "return ('a,b,,c'):find(',', 1, true)",
                             "return string.match('key = value', '^(%w+)%s*=%s*(%w+)$')",
                             "return string.match('2024-01-02', '(%d+)-(%d+)-(%d+)')",
                             "return string.find('a\\0b', '\\0')",
                             "return string.rep()",
                             "return ('x'):bad()"})
        EXPECT_EQ(runText(box, text), plain.run(text)) << text;
}

TEST(Pattern, BacktrackingIsCharged) {
    Sandbox box{SandboxLimits{}};
    const std::string answer = runText(box, "return string.find(('a'):rep(10000), '.-.-.-.-.-b')");
    EXPECT_EQ(answer,
              "error: test:1: the script wanted more than its 2000000 instructions in one call and was stopped");
}

}  // namespace
}  // namespace rubble::script
