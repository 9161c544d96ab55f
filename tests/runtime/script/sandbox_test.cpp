#include "runtime/script/sandbox/sandbox.h"

#include <gtest/gtest.h>

#include "tests/runtime/script/lua_run.h"

namespace rubble::script {
namespace {

class SandboxTest : public testing::Test {
protected:
    std::string run(const std::string& text) { return runText(m_box, text); }
    Sandbox m_box{SandboxLimits{}};
};

TEST_F(SandboxTest, RunsLua) {
    EXPECT_EQ(run("local t = {} for i = 1, 10 do t[i] = i * i end return #t, t[10], _VERSION"), "10 100 Lua 5.4");
}

TEST_F(SandboxTest, AnErrorNamesScriptLineAndValue) {
    EXPECT_EQ(run("local t = {}\nreturn t.wheel.speed"), "error: test:2: attempt to index a nil value (field 'wheel')");
    EXPECT_EQ(run("error({})"), "error: test:1: table: 1") << "a value without a text has at least its kind";
    EXPECT_EQ(run("error(setmetatable({}, {__tostring = function() return 'mine' end}))"), "error: test:1: mine");
    EXPECT_EQ(run("error(nil)"), "error: test:1: nil");
    EXPECT_EQ(run("error(setmetatable({}, {__tostring = error}))"), "error: test:1: an error whose value has no text");
    EXPECT_FALSE(m_box.isStopped());
}

TEST_F(SandboxTest, NothingReachesOutside) {
    for (const char* name : {"io", "os", "debug", "package", "require", "dofile", "loadfile", "warn", "string.dump"})
        EXPECT_EQ(run("return " + std::string(name)), "nil") << name;
}

TEST_F(SandboxTest, BytecodeIsRefused) {
    EXPECT_EQ(run("return load('\\27Lua')"), "nil attempt to load a binary chunk (mode is 't')");
    EXPECT_EQ(run("return load('return 6 * 7')()"), "42");
    EXPECT_EQ(run("return load('return a', 'chunk', 'bt', {a = 5})()"), "5");
    EXPECT_EQ(run("return load('x =')"), "nil (load):1: unexpected symbol near <eof>");
    EXPECT_EQ(run("local n = 0 return load(function() n = n + 1 return n == 1 and '\\27Lua' or nil end)"),
              "nil attempt to load a binary chunk (mode is 't')");
    EXPECT_EQ(run("return load(5)"),
              "error: test:1: load: expected the text of a chunk or a function that gives it, found a number");
}

TEST_F(SandboxTest, CallsOfAFrameShareItsWork) {
    const std::string text = "for i = 1, 400000 do end return 1";
    int calls = 0;
    while (calls < 30 && run(text) == "1") ++calls;
    EXPECT_GE(calls, 8);
    EXPECT_LE(calls, 10);
    EXPECT_NE(m_box.stopReason().find("its 4000000 instructions in one frame"), std::string::npos);
    Sandbox other{SandboxLimits{}};
    for (int i = 0; i < 30; ++i) {
        other.beginFrame();
        ASSERT_EQ(runText(other, text), "1");
    }
}

TEST_F(SandboxTest, PairsGoesThroughObjectsAsTheyWereMade) {
    const std::string text =
        "local all, order, told = {}, {}, '' for i = 1, 60 do local kind = i % 3 "
        "local made = kind == 0 and {} or kind == 1 and function() return i end or coroutine.create(print) "
        "order[i % 7 * 10 + i // 7] = {made, i} end "
        "for _, row in pairs(order) do all[row[1]] = row[2] end all[print] = 61 all.name = 0 "
        "local last = -1 for _, i in pairs(all) do assert(i == last + 1) last = i end return last";
    EXPECT_EQ(run(text), "61");
    EXPECT_EQ(runText(m_box, text), "61");
}

TEST_F(SandboxTest, LongListsAreSorted) {
    EXPECT_EQ(run("local t = {} for i = 1, 30000 do t[i] = 30001 - i end table.sort(t) return t[1], t[30000]"),
              "1 30000");
}

TEST_F(SandboxTest, ALoopIsStopped) {
    EXPECT_EQ(run("local i = 0\nwhile true do i = i + 1 end"),
              "error: test:2: the script wanted more than its 2000000 instructions in one call and was stopped");
    EXPECT_TRUE(m_box.isStopped());
    EXPECT_EQ(run("return 1"), "error: " + m_box.stopReason()) << "a stopped script runs no more";
}

TEST_F(SandboxTest, EachCallHasABudgetOfItsOwn) {
    for (int i = 0; i < 5; ++i) {
        m_box.beginFrame();
        EXPECT_EQ(run("for i = 1, 1000000 do end return 'done'"), "done");
    }
    EXPECT_GT(m_box.workUsed(), 900'000);
    EXPECT_LT(m_box.workUsed(), 1'200'000);
}

TEST_F(SandboxTest, MemoryIsBounded) {
    SandboxLimits limits;
    limits.memory = 1 << 20;
    Sandbox box(limits);
    EXPECT_EQ(runText(box, "local t = {} for i = 1, 1e9 do t[i] = ('x'):rep(1000) .. i end"),
              "error: test:1: the script wanted more than its 1048576 bytes of memory and was stopped");
    EXPECT_LE(box.peakMemory(), limits.memory + (64 << 10));
}

TEST_F(SandboxTest, ARefusedStringIsAnErrorThatAScriptMayCatch) {
    EXPECT_EQ(run("local s = ('x'):rep(200000) return pcall(function() return s .. s end)"),
              "false the script wanted a string of 400000 bytes, of at most 262144 bytes");
    EXPECT_EQ(run("return pcall(string.rep, 'x', 1 << 62)"),
              "false string.rep: the result is too long: expected at most 262144 bytes");
    EXPECT_EQ(run("return #string.rep('', 1 << 62)"), "0");
    EXPECT_FALSE(m_box.isStopped());
}

TEST_F(SandboxTest, NoFinalisers) {
    EXPECT_EQ(run("setmetatable({}, {__gc = function() end})"),
              "error: test:1: setmetatable: scripts have no finalisers: expected no field __gc, found one");
    EXPECT_EQ(run("local m = {} setmetatable({}, m) m.__gc = error collectgarbage() return 1"), "1");
}

TEST_F(SandboxTest, ProtectedCallsPassValuesOn) {
    EXPECT_EQ(run("return pcall(function(a, b) return a + b, a end, 2, 3)"), "true 5 2");
    EXPECT_EQ(run("return pcall(error, 'why')"), "false why");
    EXPECT_EQ(run("return xpcall(function(a) error('x' .. a, 0) end, function(e) return e .. '!' end, 1)"),
              "false x1!");
    EXPECT_EQ(run("return xpcall(function(a, b) return b, a end, print, 1, 2)"), "true 2 1");
    EXPECT_EQ(run("local c = coroutine.wrap(function() return pcall(function() coroutine.yield(1) error('e', 0) end) "
                  "end) local a = c() return a, c()"),
              "1 false e");
}

TEST_F(SandboxTest, Coroutines) {
    EXPECT_EQ(run("local c = coroutine.create(function(a) local b = coroutine.yield(a + 1) return b * 2 end) "
                  "local _, x = coroutine.resume(c, 1) local _, y = coroutine.resume(c, 10) "
                  "return x, y, coroutine.status(c), coroutine.resume(c)"),
              "2 20 dead false cannot resume dead coroutine");
    EXPECT_EQ(run("local w = coroutine.wrap(function() error('inside', 0) end) w()"), "error: test:1: inside")
        << "what has no place gets that of the call";
    EXPECT_EQ(run("local w = coroutine.wrap(function() error(function() return 'called' end) end) pcall(w) "
                  "return pcall(w)"),
              "false cannot resume dead coroutine");
    EXPECT_EQ(run("local c = coroutine.create(function() local x <close> = setmetatable({}, {__close = function() "
                  "closed = true end}) coroutine.yield() end) coroutine.resume(c) coroutine.close(c) return closed"),
              "true");
}

TEST_F(SandboxTest, PairsHasAFixedOrder) {
    const std::string all =
        "local t = {b = 1, a = 2, [3] = 1, [1] = 1, [2.5] = 1, [true] = 1, c = 3, [false] = 1, [-1] = 1} "
        "local s = '' for k in pairs(t) do s = s .. tostring(k) .. ' ' end return s";
    for (int i = 0; i < 3; ++i) {
        Sandbox other{SandboxLimits{}};
        EXPECT_EQ(runText(other, all), "-1 1 2.5 3 a b c false true ");
    }
    EXPECT_EQ(run("local s = 0 for i, v in pairs({5, 6, 7}) do s = s * 100 + i * 10 + v end return s"), "152637");
    EXPECT_EQ(
        run("local t = {a = 1, b = 2, c = 3} local s = '' for k in pairs(t) do t.c = nil s = s .. k end return s"),
        "ab");
    EXPECT_EQ(run("for k, v in pairs(setmetatable({}, {__pairs = function() return next, {x = 9} end})) do return k, v "
                  "end"),
              "x 9");
    EXPECT_EQ(run("pairs(nil)"), "error: test:1: bad argument #1 to 'pairs' (table expected, got nil)");
}

TEST_F(SandboxTest, NothingDependsOnTheTimeOrOnAddresses) {
    const std::string text =
        "local t, f = {}, function() end "
        "return tostring(t), tostring(f), tostring(t), string.format('%s %5.1f', {}, 2), math.random(1000), "
        "math.random(1000)";
    const std::string first = run(text);
    EXPECT_EQ(first.substr(0, 38), "table: 1 function: 2 table: 1 table: 3");
    Sandbox other{SandboxLimits{}};
    EXPECT_EQ(runText(other, text), first);
    EXPECT_EQ(run("return string.format('%5p', {})"),
              "error: test:1: string.format: expected no %p: addresses are not in reach");
}

TEST_F(SandboxTest, SortIsStableAndEndsWhateverItsComparisonSays) {
    EXPECT_EQ(run("local t = {5, 3, 9, 1} table.sort(t) return table.concat(t, ' ')"), "1 3 5 9");
    EXPECT_EQ(run("local t = {'a2', 'b1', 'c2', 'd1'} table.sort(t, function(x, y) return x:sub(2) < y:sub(2) end) "
                  "return table.concat(t, ' ')"),
              "b1 d1 a2 c2");
    EXPECT_EQ(run("local t = {} for i = 1, 1000 do t[i] = i end table.sort(t, function() return true end) return #t"),
              "1000");
    EXPECT_EQ(run("table.sort({1, 'x'})"), "error: test:1: attempt to compare string with number");
    EXPECT_EQ(run("local t = {} for i = 1, 1000 do t[i] = (i * 7919) % 1009 end table.sort(t) "
                  "for i = 2, 1000 do assert(t[i - 1] < t[i]) end return 'sorted'"),
              "sorted");
}

TEST_F(SandboxTest, Tables) {
    EXPECT_EQ(run("local t = {1, 2, 3} table.insert(t, 2, 9) table.insert(t, 8) return table.concat(t, ',')"),
              "1,9,2,3,8");
    EXPECT_EQ(run("local t = {1, 2, 3} local a = table.remove(t, 1) local b = table.remove(t) return a, b, #t"),
              "1 3 1");
    EXPECT_EQ(run("local t = {} return table.remove(t), table.remove(t, 0), #t"), "nil nil 0");
    EXPECT_EQ(run("table.insert({1}, 5, 1)"), "error: test:1: bad argument #2 to 'insert' (position out of bounds)");
    EXPECT_EQ(run("return table.unpack({1, 2, 3}, 2)"), "2 3");
    EXPECT_EQ(run("return table.concat({1, 2, 3}, '-', 2, 3)"), "2-3");
    EXPECT_EQ(run("return table.concat(table.move({1, 2, 3}, 2, 3, 1), ' ')"), "2 3 3");
}

TEST_F(SandboxTest, PrintGoesToItsOutput) {
    std::string printed;
    m_box.output = [&](std::string_view line) { printed += std::string(line) + "\n"; };
    run("print(1, 'two', nil) print()");
    EXPECT_EQ(printed, "1\ttwo\tnil\n\n");
}

TEST_F(SandboxTest, AWaitingThreadGoesOn) {
    lua_State* thread = lua_newthread(m_box.state());
    ASSERT_EQ(luaL_loadstring(thread, "local a = coroutine.yield(1) return a + 1"), LUA_OK);
    RunResult result = m_box.run(thread, 0);
    EXPECT_EQ(result.state, RunResult::Waits);
    EXPECT_EQ(result.results, 1);
    lua_pop(thread, 1);
    lua_pushinteger(thread, 41);
    result = m_box.run(thread, 1);
    EXPECT_EQ(result.state, RunResult::Done);
    EXPECT_EQ(lua_tointeger(thread, -1), 42);
}

TEST(Sandbox, GarbageMakesRoomForLongTexts) {
    SandboxLimits limits;
    limits.processorSeconds = 10.0, limits.work = limits.workPerFrame = 20'000'000;  // it ends for its memory
    Sandbox box(limits);
    EXPECT_EQ(runText(box, "local x = {} for i = 1, 70 do x[i] = ('x'):rep(200000) .. i end return #x"), "70");
    const char* const tooMuch =
        "return select(2, pcall(function() local x = {} for i = 1, 200 do "
        "x[i] = ('x'):rep(200000) .. i end end))";
    EXPECT_NE(runText(box, tooMuch).find("bytes of memory"), std::string::npos);
    EXPECT_FALSE(box.isStopped());
    box.beginFrame();
    EXPECT_LT(box.memoryUsed(), size_t(1) << 20) << "what was wanted and did not fit is gone";
}

}  // namespace
}  // namespace rubble::script
