// What scripts may be like and ask for, and what they are told where that is wrong.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "runtime/script/binding/directives.h"
#include "tests/runtime/script/yard_fixture.h"

namespace rubble::script {
namespace {

TEST(ScriptText, MayBeginWithAMarkOrAProgram) {
    EXPECT_EQ(withoutDirectives("\xef\xbb\xbfx = 1"), "x = 1");
    EXPECT_EQ(withoutDirectives("#!/usr/bin/lua\nx = 1"), "--#!/usr/bin/lua\nx = 1");
    EXPECT_EQ(withoutDirectives("\xef\xbb\xbf#version 2\n#include \"a.lua\""), "--#version 2\nrequire(\"a.lua\")");
}

TEST(ScriptText, DirectivesInStringsAndCommentsStay) {
    for (const std::string text : {"x = [[\n#version 2\n#include \"a.lua\"\n]]", "--[==[ ]]\n#version 2\n]==]",
                                   "x = 'a\\z\n#version 2'", "x = [=[\n#version 2", "x = \"[[\"\ny = '\\'[['"})
        EXPECT_EQ(withoutDirectives(text), text);
    EXPECT_EQ(withoutDirectives("-- [[ x\n#version 2"), "-- [[ x\n--#version 2");
    EXPECT_EQ(withoutDirectives("x = '[['\n#version 2"), "x = '[['\n--#version 2");
    EXPECT_EQ(withoutDirectives("x = t[1]\n#version 2"), "x = t[1]\n--#version 2");
}

TEST(ScriptText, MayWait) {
    Yard yard;
    Script& script = yard.host().add("late.lua",
                                     "print('text') wait(0.05) function init() print('init') end\n"
                                     "function update() print('update') end print('end')");
    for (int i = 0; i < 5; ++i) yard.host().step();
    EXPECT_EQ(script.error(), "");
    const std::string log = yard.logged(0), begin = "late.lua: text\nlate.lua: end\nlate.lua: init\nlate.lua: update\n";
    EXPECT_EQ(log.substr(0, begin.size()), begin);
    yard.host().add("wrong.lua", "wait(0)\nerror('late') function init() print('never') end");
    for (int i = 0; i < 5; ++i) yard.host().step();
    EXPECT_EQ(yard.logged(RUBBLE_LOG_ERROR), "wrong.lua:2: late\n");
    EXPECT_EQ(yard.logged(0).find("never"), std::string::npos);
}

TEST(ScriptText, MayBeOfLua51) {
    Yard yard;
    EXPECT_EQ(
        yard.run("assert(select('#', unpack({1, 2, 3})) == 3 and table.getn({5, 6}) == 2 and math.pow(2, 10) == 1024)"),
        "");
    EXPECT_EQ(
        yard.run(
            "assert(require('MOD/tools').double(4) == 8) assert(#Spawn('MOD/post.vox', Transform({0, 9, 0})) > 0)"),
        "");
    EXPECT_NE(yard.run("Spawn('MOD/../post.vox', Transform())").find("found \"MOD/../post.vox\""), std::string::npos);
    EXPECT_NE(yard.run("Spawn('MOD//etc/passwd', Transform())").find("expected a file inside"), std::string::npos);
}

TEST(ScriptText, ThatIsTooLongIsToldByItsSize) {
    Yard yard;
    const Script& script = yard.host().add("big.lua", std::string(3'000'000, ' '));
    EXPECT_EQ(script.error(), "big.lua: expected a text of at most 500000 bytes, found one of 3000000");
    EXPECT_FALSE(script.isStopped());
    EXPECT_EQ(yard.host().add("fits.lua", std::string(300'000, ' ')).error(), "");
}

TEST(ScriptPoses, WhoseRotationIsNotQuiteOneLongAreNormalised) {
    Yard yard;
    EXPECT_EQ(yard.run("local b, q = FindBody('crate'), Quat(0, 0.7, 0, 0.7) "
                       "SetBodyTransform(b, Transform(Vec(0, 5, 0), q)) Spawn('post.vox', Transform(Vec(0, 9, 0), q)) "
                       "DrawShapeBox(CreateShape(b, Transform(Vec(1, 0, 0), q)), 0, 0, 0, 1, 1, 1) wait(0) "
                       "local r = GetBodyTransform(b).rot local sum = 0 for i = 1, 4 do sum = sum + r[i] ^ 2 end "
                       "assert(math.abs(sum - 1) < 1e-6, sum)"),
              "");
    for (const char* far : {"0, 0.6, 0, 0.6", "0, 0, 0, 1.2", "0/0, 0, 0, 1"})
        EXPECT_NE(yard.run("SetBodyTransform(FindBody('crate'), Transform(Vec(), Quat(" + std::string(far) + ")))"), "")
            << far;
}

TEST(ScriptRegistry, TextsAreUtf8WithoutZeroBytes) {
    Yard yard;
    for (const char* text : {"a\\0b", "\\xff", "\\xc3", "\\xed\\xa0\\x80", "\\xc0\\x80", "\\xf5\\x80\\x80\\x80"}) {
        EXPECT_NE(yard.run("SetString('k', '" + std::string(text) + "')").find("SetString: value: expected UTF-8"),
                  std::string::npos)
            << text;
        EXPECT_NE(yard.run("SetInt('k" + std::string(text) + "', 1)").find("SetInt: key: expected UTF-8"),
                  std::string::npos)
            << text;
    }
    EXPECT_EQ(
        yard.run(
            "SetString('k', 'h\\u{e9}\\u{20ac}\\u{1f600}') assert(GetString('k') == 'h\\u{e9}\\u{20ac}\\u{1f600}')"),
        "");
}

TEST(ScriptRegistry, TheEmptyKeyIsAboveAll) {
    Yard yard;
    EXPECT_EQ(yard.run("SetInt('b.c', 1) SetInt('a', 1) SetInt('b.d', 1) "
                       "assert(table.concat(ListKeys(''), ' ') == 'a b') ClearKey('') assert(#ListKeys('') == 0)"),
              "");
}

TEST(ScriptTags, OfAnObjectAreBounded) {
    Yard yard;
    const std::string error = yard.run(
        "local w = FindShape('wall') local n = 0 while n < 1e5 do for i = 1, 1000 do n = n + 1 SetTag(w, 't' .. n, "
        "'x') "
        "end wait(0) end");
    EXPECT_NE(error.find("SetTag: expected an object whose tags have at most 16384 bytes"), std::string::npos) << error;
    EXPECT_EQ(yard.run("SetTag(FindShape('floor'), 'a', 'b')"), "");
}

TEST(ScriptRandom, IsAnotherOneInEachScript) {
    Yard yard;
    for (int i = 0; i < 3; ++i) yard.host().add("torch.lua", "print(math.random(1, 1000000))");
    const std::string first = yard.logged(0);
    EXPECT_NE(first.substr(0, first.find('\n')), first.substr(first.find('\n') + 1, first.find('\n')));
    Yard other;
    for (int i = 0; i < 3; ++i) other.host().add("torch.lua", "print(math.random(1, 1000000))");
    EXPECT_EQ(other.logged(0), first);
    other.host().load();  // all begin again, and draw the same
    EXPECT_EQ(other.logged(0), first + first);
}

TEST(ScriptText, ReadsWholeNumbersOfAnyForm) {
    Yard yard;
    EXPECT_EQ(yard.run("local function whole(set, value) set('n', value) return GetInt('n') end "
                       "assert(whole(SetFloat, 1e15) == 1000000000000000 and whole(SetFloat, 1e-300) == 0) "
                       "assert(whole(SetString, '1e3') == 1000 and whole(SetString, '0x10') == 16) "
                       "assert(whole(SetString, '12.9') == 12 and whole(SetString, 'many') == 0) "
                       "assert(whole(SetInt, 2^63) == math.maxinteger and whole(SetInt, -1/0) == math.mininteger) "
                       "assert(whole(SetInt, math.maxinteger - 1) == math.maxinteger - 1)"),
              "");
    EXPECT_NE(yard.run("SetInt('n', 0 / 0)").find("SetInt: value: expected a number"), std::string::npos);
}

TEST(ScriptErrors, WordsThatNoFilterHasAreTold) {
    Yard yard;
    EXPECT_NE(yard.run("QueryRequire('dynamc')").find("QueryRequire: layers: expected words of"), std::string::npos);
    EXPECT_NE(yard.run("QueryInclude(2.5)").find("QueryInclude: layers: expected"), std::string::npos);
    EXPECT_EQ(yard.run("QueryRequire('  physical large  static ') QueryRequire('')"), "");
}

TEST(ScriptBudget, WhatGoesOnInAStepSharesOne) {
    Yard yard;
    const Script& starts = yard.host().add("starts",
                                           "function init() for i = 1, 200 do start(function() while true do "
                                           "for j = 1, 300000 do end wait(0) end end) end end");
    const Script& hears = yard.host().add("hears", "function onBreak() for j = 1, 300000 do end end");
    yard.host().add("breaks", "function update() MakeHole({0, 1, 0}, 0.2, 0.2) Explosion({0, 0.4, -2}, 2) end");
    for (int i = 0; i < 10; ++i) ASSERT_EQ(yard.host().step(), RUBBLE_OK);
    EXPECT_NE(starts.error().find("instructions in one frame"), std::string::npos) << starts.error();
    EXPECT_LT(starts.profile(Callback::Resume).work, 5'000'000);
    EXPECT_GT(hears.profile(Callback::Break).calls, 0u);
    EXPECT_LT(hears.profile(Callback::Break).work, 10 * 5'000'000);
    EXPECT_FALSE(yard.host().scripts().back().isStopped());
}

TEST(ScriptText, MayTakeACallbackAway) {
    Yard yard;
    yard.host().add("once", "function update() print('once') update = nil end function tick() tick = 5 end");
    for (int i = 0; i < 4; ++i) {
        yard.host().tick(1.0 / 60.0);
        ASSERT_EQ(yard.host().step(), RUBBLE_OK);
    }
    EXPECT_EQ(yard.logged(0), "once: once\nonce: tick: expected a function, which is called, found a number\n");
    EXPECT_EQ(yard.host().scripts().back().error(), "");
    EXPECT_FALSE(yard.host().scripts().back().has(Callback::Update));
}

TEST(ScriptErrors, NameTheLineOfAnyValue) {
    Yard yard;
    EXPECT_EQ(yard.run("\nerror(nil)"), "test:3: nil");
    EXPECT_EQ(yard.run("\nerror({})").substr(0, 14), "test:3: table:");
    EXPECT_EQ(yard.run("table.sort({1, 2, 3},\nfunction(a, b) wait(0) return a < b end)").substr(0, 28),
              "test:3: wait: expected a cal");
    EXPECT_EQ(yard.run("('abc'):gsub('.',\nfunction() coroutine.yield() end)").substr(0, 27),
              "test:3: coroutine.yield: ex");
    EXPECT_EQ(yard.run("\ncoroutine.yield()"),
              "test:3: coroutine.yield: expected a coroutine, found a callback: use wait()");
}

TEST(ScriptErrors, ValuesThatAreNoNumbersAreTold) {
    for (const char* call : {"ParticleRadius(0 / 0)", "ParticleColor(1, 1, 0 / 0)",
                             "SpawnParticle({0, 0 / 0, 0}, {0, 0, 0}, 1)", "SpawnParticle({0, 0, 0}, {0, 0, 0}, 0 / 0)",
                             "SetTimeScale(0 / 0)", "DrawShapeBox(FindShape('crate'), 0 / 0, 0, 0, 1, 1, 1)",
                             "GetShapeMaterialAtIndex(FindShape('crate'), 0, 0 / 0, 0)"}) {
        Yard yard;
        EXPECT_NE(yard.run(call).find(": expected a "), std::string::npos) << call;
    }
    Yard yard;
    EXPECT_EQ(yard.run("QueryAabbBodies({1, 0, 0}, {0, 1, 1})"),
              "test:2: QueryAabbBodies: max: expected no less than min, found a table of 3 values");
}

TEST(ScriptQueries, BoxesMayBeAsLargeAsAWorld) {
    Yard yard;
    EXPECT_EQ(yard.run("for _, size in ipairs{1e3, 1e5, 1e7, 5e8} do local far = {size, size, size} "
                       "assert(#QueryAabbBodies({-size, -size, -size}, far) == #FindBodies(), size) "
                       "assert(#QueryAabbShapes({0, -size, -size}, far) < #FindShapes(), size) end"),
              "");
}

TEST(ScriptFinds, WhatHasANameWhereNothingHasTheTag) {
    Yard yard;
    uint64_t gate = 0, bulb = 0;
    uint32_t count = 0;
    ASSERT_EQ(yard.api().find_by_tag(yard.world(), RUBBLE_KIND_TRIGGER, "gate", nullptr, &gate, 1, &count), RUBBLE_OK);
    ASSERT_EQ(yard.api().find_by_tag(yard.world(), RUBBLE_KIND_LIGHT, "bulb", nullptr, &bulb, 1, &count), RUBBLE_OK);
    yard.api().set_name(yard.world(), gate, "way in");
    yard.api().set_name(yard.world(), bulb, "spot");
    yard.host().step();
    EXPECT_EQ(yard.run("local gate = FindTrigger('gate') assert(gate ~= 0 and FindTrigger('way in') == gate) "
                       "assert(FindLight('spot') == FindLight('bulb') and #FindLights('spot') == 1) "
                       "SetTag(FindBody('crate'), 'spot') assert(FindLight('spot') == FindLight('bulb'))"),
              "");
}

TEST(ScriptFiles, LinksDoNotLeadOutOfTheFolder) {
    Yard yard;
    const TempFolder other;
    std::ofstream(other.path() / "secret.lua") << "return 7";
    std::filesystem::create_directory_symlink(other.path(), yard.folder() / "out");
    std::filesystem::create_symlink(yard.folder() / "tools.lua", yard.folder() / "same.lua");
    EXPECT_NE(yard.run("require('out/secret')").find("inside of the folder"), std::string::npos);
    EXPECT_EQ(yard.run("assert(require('same').double(2) == 4)"), "") << "a link within the folder";
}

TEST(ScriptFiles, AreNoPipes) {
    Yard yard;
    ASSERT_EQ(mkfifo((yard.folder() / "pipe.lua").c_str(), 0600), 0);
    for (const char* call : {"require('pipe')", "UiGetImageSize('pipe.lua')", "Spawn('pipe.lua')"})
        EXPECT_NE(yard.run(call).find(": expected a file, found something else under \"pipe"), std::string::npos)
            << call;
    const rubble_level_script script = {"pipe.lua", nullptr};
    yard.host().addLevelScripts();
    ASSERT_EQ(yard.api().set_level_scripts(yard.world(), &script, 1), RUBBLE_OK);
    yard.host().step();
    EXPECT_NE(yard.logged(RUBBLE_LOG_ERROR).find("the level names the script \"pipe.lua\""), std::string::npos);
}

TEST(ScriptCamera, IsKnownBeforeTheFirstFrame) {
    Yard yard;
    rubble_view view = viewOf(960, 540);
    view.position[1] = 3.0;
    yard.host().setView(view);
    EXPECT_EQ(yard.run("assert(GetCameraTransform().pos.y == 3 and GetPlayerCameraTransform().pos.y == 3)"), "");
}

TEST(ScriptErrors, NameTheFunctionOfTheScript) {
    Yard yard;
    EXPECT_EQ(yard.run("MakeHole({0, 1, 0}, -1)"), "test:2: MakeHole: r0: expected a radius of 0 or more, found -1");
    EXPECT_EQ(yard.run("QueryRaycast({0, 1, 0}, {0, 0, 1}, math.huge)"),
              "test:2: QueryRaycast: maxDist: expected 0 to 1e6 m, found inf");
    EXPECT_EQ(yard.run("QueryRaycasts({0, 1, 0, 0, 0, 1}, -1)"),
              "test:2: QueryRaycasts: maxDist: expected 0 to 1e6 m, found -1");
    EXPECT_EQ(yard.run("local d, s = QueryRaycasts({}, 10) assert(#d == 0 and #s == 0)"), "");
    EXPECT_EQ(yard.run("SetJointMotor(FindJoint('hinge'), 1, -1)"),
              "test:2: SetJointMotor: strength: expected 0 or more, found -1");
    EXPECT_EQ(yard.run("SetJointMotorTarget(FindJoint('hinge'), 0/0)"),
              "test:2: SetJointMotorTarget: target: expected a finite number, found -nan");
    EXPECT_EQ(yard.run("MakeHole({0, 1, 0}, 1, 0 / 0)").substr(0, 49),
              "test:2: MakeHole: r1: expected a radius of 0 or m");
    EXPECT_EQ(yard.run("MakeHole({0, 1e12, 0}, 1)").find("count_carve"), std::string::npos);
    EXPECT_EQ(yard.run("local v = Vec(1, 2, 3) v.x = nil"),
              "test:2: x of a vector: expected a number, found a value of type nil");
    EXPECT_EQ(yard.run("SetLightColor(FindLight('bulb'), 1, -2, 0)"),
              "test:2: SetLightColor: g: expected 0 or more, found -2");
    EXPECT_EQ(yard.run("local t = {1} for k in next, t do t = {} next(t, 'none') end").substr(0, 7), "test:2:")
        << "what Lua gives no place";
    EXPECT_EQ(yard.run("\nerror('plain', 0)"), "test:3: plain");
    EXPECT_EQ(yard.run("QueryRejectBody(999) QueryRejectShape(FindBody('crate')) "
                       "assert(QueryRaycast({0, 1, -5}, {0, 0, 1}, 10))"),
              "");
    EXPECT_EQ(yard.run("Delete(0)"), "");
    EXPECT_NE(yard.logged(0).find("test:2: Delete: handle: nothing has the handle 0"), std::string::npos);
}

TEST(ScriptErrors, NumbersThatAreBroughtIntoTheirRangeAreTold) {
    Yard yard;
    EXPECT_EQ(yard.run("for i = 1, 3 do Explosion({0, 50, 0}, -1) SetTimeScale(100) end"), "");
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING),
              "test:2: Explosion: size: expected 0.5 to 4, found -1: it counts as 0.5\n")
        << "once for a line";
    EXPECT_EQ(yard.host().timeScale(), 10.0);
    EXPECT_EQ(yard.run("\nExplosion({0, 50, 0}) Explosion({0, 50, 0}, 4)"), "");
}

TEST(ScriptErrors, OfOneLineDoNotFillTheLog) {
    Yard yard;
    yard.host().add("flood.lua", "n = 0\nfunction update() n = n + 1 error('bad ' .. n) end");
    for (int i = 0; i < 100; ++i) yard.host().step();
    const std::string log = yard.logged(0);
    EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 20) << log;
    EXPECT_TRUE(log.ends_with("flood.lua:2: bad 20 (what else goes wrong there is not logged)\n")) << log;
    EXPECT_EQ(yard.host().scripts().front().error(), "flood.lua:2: bad 100");
}

TEST(ScriptErrors, PrintDoesNotFillTheLog) {
    Yard yard;
    size_t bytes = 0;
    std::string told;
    ScriptHostSettings settings;
    settings.log = [&](int level, const std::string& line) {
        bytes += line.size();
        if (level) told += line + "\n";
    };
    ScriptHost host(yard.api(), yard.world(), settings);
    host.add("print.lua", "local line = ('x'):rep(999) function update() for i = 1, 500 do print(line) end end");
    for (int i = 0; i < 20; ++i) ASSERT_EQ(host.step(), RUBBLE_OK);
    EXPECT_LT(bytes, size_t(Script::kPrintBurst + 21 * Script::kPrintPerFrame + 50'000));
    EXPECT_GT(bytes, size_t(Script::kPrintBurst));
    EXPECT_EQ(told, "print.lua: print: expected at most 16384 bytes a frame, found more: lines are left out\n");
}

TEST(ScriptText, ReadsBooleansOfAnyForm) {
    Yard yard;
    EXPECT_EQ(yard.run("for _, word in ipairs{'', ' ', '0', '0.0', '-0', 'false', 'False', ' no ', 'OFF'} do "
                       "SetString('b', word) assert(not GetBool('b'), word) end "
                       "for _, word in ipairs{'1', 'true', 'yes', 'on', '0.5', 'x'} do "
                       "SetString('b', word) assert(GetBool('b'), word) end"),
              "");
}

TEST(ScriptText, MayBeLoadedInPieces) {
    Yard yard;
    EXPECT_EQ(yard.run("local parts, i = {'return ', '4', '2'}, 0 "
                       "assert(load(function() i = i + 1 return parts[i] end)() == 42) "
                       "assert(not pcall(load, function() return 5 end) and not pcall(load, 5))"),
              "");
    EXPECT_NE(yard.run("load(function() return 'x' end)").find("instructions in one"), std::string::npos);
}

TEST(ScriptBudget, ManyModelsOfOneFileFitIntoACall) {
    Yard yard;
    EXPECT_EQ(yard.run("for i = 1, 60 do assert(#Spawn('post.vox', Transform({i, 5, 0})) == 2) end"), "");
    EXPECT_LT(yard.host().scripts().back().profile(Callback::Init).work, 1'000'000);
}

TEST(ScriptReload, CallsDestroyAndRevivesAStoppedScript) {
    Yard yard;
    yard.host().add("mod.lua", "local kept = saved('t', {n = 1}) function destroy() print('ends') kept.n = 2 end");
    EXPECT_TRUE(yard.host().reload("mod.lua", "print(saved('t').n)"));
    EXPECT_EQ(yard.logged(0), "mod.lua: ends\nmod.lua: 2\n");
    EXPECT_FALSE(yard.host().reload("mod.lua", "while true do end"));
    EXPECT_TRUE(yard.host().scripts().front().isStopped());
    EXPECT_FALSE(yard.host().reload("mod.lua", "x = = 1"));
    EXPECT_TRUE(yard.host().reload("mod.lua", "print('again')"));
    EXPECT_TRUE(yard.logged(0).ends_with("mod.lua: again\n")) << yard.logged(0);
}

}  // namespace
}  // namespace rubble::script
