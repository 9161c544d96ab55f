#include <gtest/gtest.h>

#include "tests/runtime/script/yard_fixture.h"

namespace rubble::script {
namespace {

using Words = std::vector<std::string>;

/// A script with some globals.
class Completion : public testing::Test {
protected:
    Words of(std::string_view line) { return m_script.completions(line); }
    bool run(const std::string& text) {
        std::string answer;
        return m_script.evaluate(text, answer);
    }

private:
    Yard m_yard;
    Script& m_script = m_yard.host().add("line", "");
};

TEST_F(Completion, NamesGlobals) {
    EXPECT_EQ(of("GetBodyMa"), (Words{"GetBodyMass("}));
    EXPECT_EQ(of("x = 1 + GetBodyMa"), (Words{"GetBodyMass("}));
    EXPECT_EQ(of("UiTextO"), (Words{"UiTextOutline("}));
    EXPECT_EQ(of("nothing_like_that"), Words{});
    EXPECT_GT(of("").size(), 200u);
    ASSERT_TRUE(run("wallCount = 5"));
    EXPECT_EQ(of("print(wallC"), (Words{"wallCount"}));
}

TEST_F(Completion, NamesKeywords) {
    EXPECT_EQ(of("retu"), (Words{"return"}));
    EXPECT_EQ(of("string.retu"), Words{});
}

TEST_F(Completion, NamesFields) {
    EXPECT_EQ(of("math.ma"), (Words{"math.max(", "math.maxinteger"}));
    ASSERT_TRUE(run("lift = {door = {left = 1, length = print, [3] = 4, ['not a name'] = 5}}"));
    EXPECT_EQ(of("lift.door.le"), (Words{"lift.door.left", "lift.door.length("}));
    EXPECT_EQ(of("lift.door."), (Words{"lift.door.left", "lift.door.length("}));
    EXPECT_EQ(of("lift.door:"), (Words{"lift.door:length("}));
    EXPECT_EQ(of("'a'..lift.do"), (Words{"..lift.door"}));
    EXPECT_EQ(of("name..lift.do"), (Words{"name..lift.door"}));
    EXPECT_EQ(of("lift.window."), Words{});
    EXPECT_EQ(of("lift.door.left."), Words{});
}

TEST_F(Completion, NamesWhatMetatablesGive) {
    ASSERT_TRUE(
        run("name = 'a' v = Vec() q = Quat() t = Transform() base = {open = print} "
            "door = setmetatable({}, {__index = base}) far = setmetatable({}, {__index = door})"));
    EXPECT_EQ(of("name:up"), (Words{"name:upper("}));
    EXPECT_EQ(of("v."), (Words{"v.x", "v.y", "v.z"}));
    EXPECT_EQ(of("q."), (Words{"q.w", "q.x", "q.y", "q.z"}));
    EXPECT_EQ(of("t."), (Words{"t.pos", "t.rot"}));
    EXPECT_EQ(of("t.pos."), (Words{"t.pos.x", "t.pos.y", "t.pos.z"}));
    EXPECT_EQ(of("far:o"), (Words{"far:open("}));
}

TEST_F(Completion, RunsNothingOfTheScript) {
    ASSERT_TRUE(
        run("local function loop() while true do end end "
            "trap = setmetatable({}, {__index = loop, __pairs = loop, __len = loop, __metatable = 1}) "
            "ring = {} setmetatable(ring, {__index = ring})"));
    EXPECT_EQ(of("trap.x"), Words{});
    EXPECT_EQ(of("trap.x.y"), Words{});
    EXPECT_EQ(of("ring.x.y"), Words{});
    EXPECT_TRUE(run("x = 1"));
}

TEST_F(Completion, OddLinesAreNoHarm) {
    for (const char* line : {".", ":", "..", "...", "a..", "1.", "1.5", "x.1", "f().x", "\"", "a.b.c.d.e:", "::", "é"})
        EXPECT_LT(of(line).size(), 1000u) << line;
    EXPECT_EQ(of(std::string("math.a\0math.ab", 14)), (Words{"math.abs("}));
    EXPECT_EQ(of(std::string(99'999, ':')), Words{});
    EXPECT_FALSE(run("while true do end"));
    EXPECT_EQ(of("math.ab"), Words{}) << "it was stopped";
}

}  // namespace
}  // namespace rubble::script
