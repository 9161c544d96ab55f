#include "runtime/script/script.h"

#include <gtest/gtest.h>

#include "tests/runtime/script/attacks.h"
#include "tests/runtime/script/yard_fixture.h"

namespace rubble::script {
namespace {

TEST(Script, CallbacksAreCalled) {
    Yard yard;
    Script& script = yard.host().add("calls.lua",
                                     "function init() print('init') end\n"
                                     "function tick(dt) print('tick', dt) end\n"
                                     "function update(dt) print('update', dt * 60) end\n"
                                     "function destroy() print('destroy') end");
    yard.host().tick(0.25);
    yard.host().step();
    EXPECT_EQ(yard.logged(0), "calls.lua: init\ncalls.lua: tick\t0.25\ncalls.lua: update\t1.0\n");
    EXPECT_EQ(script.profile(Callback::Tick).calls, 1u);
    EXPECT_GT(script.profile(Callback::Tick).work, 0);
    EXPECT_EQ(script.profile(Callback::Contact).calls, 0u);
}

TEST(Script, AnErrorNamesScriptLineAndValue) {
    Yard yard;
    yard.host().add("bad.lua",
                    "function update()\n  MakeHole({1, 2}, 0.5)\nend\nfunction tick()\n  MakeHole(Vec(), 'big') end");
    yard.host().step();
    yard.host().step();
    yard.host().tick(0.1);
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING),
              "bad.lua:2: MakeHole: pos: expected a vector {x, y, z}, found a table of 2 values\n"
              "bad.lua:2: MakeHole: pos: expected a vector {x, y, z}, found a table of 2 values (1 times more)\n"
              "bad.lua:5: MakeHole: r0: expected a number, found \"big\"\n");
}

TEST(Script, DirectivesOfTeardownAreUnderstood) {
    Yard yard;
    std::ofstream(yard.folder() / "common.lua") << "#version 2\nfunction twice(x) return 2 * x end\nstep = 5";
    Script& script = yard.host().add("mod.lua",
                                     "#version 2\n#include \"common.lua\"\n\n"
                                     "function init() print(twice(step)) error('line 4') end");
    EXPECT_EQ(script.error(), "mod.lua:4: line 4");
    EXPECT_NE(yard.logged(0).find("mod.lua: 10"), std::string::npos) << yard.logged(0);
    EXPECT_EQ(yard.host().add("bad.lua", "\n#define X 1").error(), "bad.lua:2: unexpected symbol near '#'");
    EXPECT_NE(yard.host().add("bad.lua", "#include common.lua").error(), "");
    EXPECT_NE(yard.host().add("bad.lua", "#include \"../secret.lua\"").error().find("inside of the folder"),
              std::string::npos);
}

TEST(Script, ATextThatDoesNotCompileIsReported) {
    Yard yard;
    EXPECT_EQ(yard.host().add("bad.lua", "function init()\n  x = = 1\nend").error(),
              "bad.lua:2: unexpected symbol near '='");
}

TEST(Script, DirectionsOfAnyLengthAreNormalized) {
    Yard yard;
    EXPECT_EQ(yard.run("for _, size in ipairs({1e-300, 1e-160, 1, 1e200, 1e308}) do "
                       "local v = VecNormalize(Vec(size, size, 0)) "
                       "assert(math.abs(v.x - 0.5 ^ 0.5) < 1e-15 and v.x == v.y and v.z == 0, v.x) end"),
              "");
}

TEST(Script, WhatIsGoneIsToldOnceForEachLine) {
    Yard yard;
    EXPECT_EQ(yard.run("local crate = FindBody('crate') Delete(crate) wait(0.1) "
                       "for i = 1, 3 do assert(VecLength(GetBodyVelocity(crate)) == 0) end"),
              "");
    const std::string log = yard.logged(RUBBLE_LOG_WARNING);
    EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 1) << log;
    EXPECT_NE(log.find("test:2: GetBodyVelocity: body is stale"), std::string::npos) << log;
}

TEST(Script, BothVelocitiesAreSetInOneStep) {
    Yard yard;
    const std::string test =
        "SetBodyTransform(b, Transform({0, 9, -5})) SetBodyVelocity(b, {0, 0, 14}) SetBodyAngularVelocity(b, {0, 2, "
        "0}) "
        "wait(0) assert(GetBodyVelocity(b).z > 13 and GetBodyAngularVelocity(b).y > 1.5) "
        "SetBodyAngularVelocity(b, {0, 0, 0}) wait(0) "
        "assert(GetBodyVelocity(b).z > 13 and math.abs(GetBodyAngularVelocity(b).y) < 0.1)";
    EXPECT_EQ(yard.run("b = FindBody('crate') " + test), "");
    EXPECT_EQ(yard.run("b = Spawn('post.vox', Transform({0, 9, -9}))[1] SetBodyDynamic(b, true) " + test), "")
        << "also of a body that the step makes";
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING), "");
}

TEST(Script, TagsAreReadAsTheyWereSet) {
    Yard yard;
    EXPECT_EQ(
        yard.run("local b = FindBody('crate') assert(not HasTag(b, 'seen')) SetTag(b, 'seen', '5') "
                 "assert(HasTag(b, 'seen') and GetTagValue(b, 'seen') == '5') SetTag(b, 'seen') "
                 "assert(HasTag(b, 'seen') and GetTagValue(b, 'seen') == '') RemoveTag(b, 'seen') "
                 "assert(not HasTag(b, 'seen') and GetTagValue(b, 'seen') == '') SetTag(b, 'seen', 'x') wait(0.1) "
                 "assert(GetTagValue(b, 'seen') == 'x') RemoveTag(b, 'seen') wait(0.1) assert(not HasTag(b, 'seen'))"),
        "");
}

TEST(Script, DrawingKeepsTheHolesOfItsStep) {
    Yard yard;
    EXPECT_EQ(yard.run("local wall = FindShape('wall') or GetBodyShapes(FindBody('wall'))[1] "
                       "local voxels = GetShapeVoxelCount(wall) "
                       "MakeHole({0, 1.5, 0.15}, 0.5, 0.5) wait(0.1) "
                       "local holed = GetShapeVoxelCount(wall) assert(holed < voxels, 'no hole') "
                       "SetBrush('sphere', 1, 1) "
                       "MakeHole({0.8, 1.5, 0.15}, 0.3, 0.3) "
                       "DrawShapeLine(wall, 0, 0, 0, 60, 25, 2, false, true) wait(0.1) "
                       "print(GetShapeVoxelCount(wall) - holed)"),
              "");
    const std::string log = yard.logged(0);
    EXPECT_NE(log.find("test: -"), std::string::npos) << "the hole is filled again: " << log;
}

TEST(Script, WaitingStepsWithTheWorld) {
    Yard yard;
    yard.host().add("wait.lua",
                    "function init() wait(0.5) print(GetTime() * 60) local ok = pcall(wait, 0.5) "
                    "print(ok, GetTime() * 60) end");
    for (int i = 0; i < 70; ++i) yard.host().step();
    EXPECT_EQ(yard.logged(0), "wait.lua: 30.0\nwait.lua: true\t60.0\n");
}

TEST(Script, OnlyCallbacksWait) {
    Yard yard;
    EXPECT_EQ(yard.run("coroutine.wrap(function() wait(1) end)()"),
              "test:2: wait: expected a callback or what start() has begun, found a coroutine of the script");
    EXPECT_EQ(yard.run("coroutine.yield(5)"),
              "test:2: coroutine.yield: expected a coroutine, found a callback: use wait()");
}

TEST(Script, EventsAreTold) {
    Yard yard;
    yard.host().add(
        "events.lua",
        "function init() start(function() MakeHole({-5, 2.2, 0}, 1.5, 1.5) wait(0.1) SpawnFire({0, 0.8, -1.6}) "
        "Delete(FindJoint('hinge')) end) end\n"
        "local told = {}\n"
        "local function tell(name) if not told[name] then told[name] = true print(name) end end\n"
        "function onSplit(shape, pieces) assert(#pieces > 0 and IsHandleValid(pieces[1])) tell('split') end\n"
        "function onBreak(shape, voxels, entry) assert(voxels > 0 and entry > 0) tell('break') end\n"
        "function onBodyBreak(body) tell('body') end\n"
        "function onFire(shape, pos, lit) assert(#pos == 3) tell('fire') end\n"
        "function onJoint(joint, what) tell(what) end\n"
        "function onContact(a, b, pos, normal, impulse) assert(impulse >= 0) tell('contact') end\n"
        "function onTrigger(trigger, body, entered) tell('trigger') end\n");
    yard.host().add("throw.lua", "function init() wait(0.2) SetBodyVelocity(FindBody('crate'), {0, 4, -4}) end");
    for (int i = 0; i < 180; ++i) yard.host().step();
    const std::string log = yard.logged(0);
    for (const char* name : {"split", "break", "body", "fire", "removed", "contact", "trigger"})
        EXPECT_NE(log.find("events.lua: " + std::string(name) + "\n"), std::string::npos) << name << " in\n" << log;
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING), "");
}

TEST(Script, ScriptsDoNotSeeEachOther) {
    Yard yard;
    yard.host().add("a.lua", "secret = 1 SetInt('shared', 7)");
    yard.host().add("b.lua", "print(secret, GetInt('shared')) string.format = nil");
    yard.host().add("c.lua", "print(string.format('%d', 3))");
    EXPECT_EQ(yard.logged(0), "b.lua: nil\t7\nc.lua: 3\n");
}

TEST(Script, OneThatIsStoppedLetsTheGameGoOn) {
    Yard yard;
    Script& bad = yard.host().add("bad.lua", "function update() while true do end end");
    yard.host().add("good.lua", "function update() print('here') end");
    EXPECT_EQ(yard.host().step(), RUBBLE_OK);
    EXPECT_EQ(yard.host().step(), RUBBLE_OK);
    EXPECT_TRUE(bad.isStopped());
    EXPECT_EQ(yard.logged(0),
              "bad.lua:1: the script wanted more than its 2000000 instructions in one call and was stopped\n"
              "good.lua: here\ngood.lua: here\n");
}

TEST(Script, AnEmptyShapeIsResizedWithinItsGridOnly) {
    Yard yard;
    const std::string empty = "local s = CreateShape(FindBody('wall'), Transform({0, 2.5, 0}), FindShape('wall')) ";
    EXPECT_NE(yard.run(empty + "ResizeShape(s, -5, -5, -5, -2, -2, -2) SetBrush('cube', 1, 7) "
                               "DrawShapeBox(s, 0, 0, 0, 3, 3, 3)")
                  .find("expected a box that meets the grid of an empty shape"),
              std::string::npos);
    EXPECT_EQ(yard.run(empty + "ResizeShape(s, -2, -2, -2, 3, 3, 3) ResizeShape(s, 1, 1, 1, 5, 5, 5) "
                               "SetBrush('cube', 1, 7) DrawShapeBox(s, 0, 0, 0, 1, 1, 1) wait(0.1) "
                               "assert(GetShapeVoxelCount(s) == 8, GetShapeVoxelCount(s))"),
              "");
}

TEST(Script, ATableIsSavedOnceHoweverOftenItIsAskedFor) {
    Yard yard;
    EXPECT_EQ(yard.run("local a = saved('t', {n = 1}) a.n = 2 assert(saved('t', {n = 5}).n == 2) "
                       "saved('t').n = 3 assert(a.n == 3)"),
              "");
}

TEST(Script, WordsOfAnAlignmentAreKnownEachByItself) {
    Yard yard;
    EXPECT_EQ(yard.run("assert(pcall(UiAlign, 'center middle')) assert(not pcall(UiAlign, 'center foo')) "
                       "assert(not pcall(UiAlign, 'middle centre'))"),
              "");
}

TEST(Script, AFullMemoryDoesNotReachTheHost) {
    SandboxLimits limits;
    limits.memory = 1 << 20;
    Yard yard(limits);
    yard.host().add(
        "full.lua",
        "local all = {}\nfunction init() pcall(function() while true do all[#all + 1] = 'x' .. #all end end) end\n"
        "function update(dt) end\nfunction onBreak(shape, voxels) end\nfunction onSplit(shape, pieces) end");
    yard.run("MakeHole({-5, 2.2, 0}, 1.5, 1.5) wait(0.5)");
    EXPECT_EQ(yard.host().step(), RUBBLE_OK);
}

TEST(Script, IsStoppedWhereItsMemoryHasNoRoomForACallback) {
    SandboxLimits limits;
    limits.memory = 1 << 20;
    Yard yard(limits);
    Script& script =
        yard.host().add("many.lua", "function update() for i = 1, 200 do start(function() wait(100) end) end end");
    for (int i = 0; i < 60; ++i) yard.host().step();
    EXPECT_TRUE(script.isStopped()) << "it would go on without some of its callbacks";
    EXPECT_EQ(script.error(), "many.lua: the script wanted more than its 1048576 bytes of memory and was stopped");
}

TEST(Script, OneThatDoesNothingCostsNothing) {
    Yard plain, scripted;
    Script& script = scripted.host().add("nothing.lua", "local x = 1");
    const uint64_t before = script.sandbox().allocations();
    for (int i = 0; i < 30; ++i) {
        plain.host().step();
        scripted.host().tick(0.1);
        scripted.host().step();
    }
    EXPECT_EQ(script.sandbox().allocations(), before);
    EXPECT_EQ(plain.hash(), scripted.hash());
}

TEST(Script, TheSameScriptGivesTheSameWorld) {
    const std::string text =
        "for i = 1, 20 do MakeHole({math.random() * 4 - 2, math.random() * 2, 0}, 0.3, 0.3) wait(0.05) "
        "for k, v in pairs({a = 1, b = 2, c = 3}) do ApplyBodyImpulse(FindBody('crate'), {0, 0.4, -2}, "
        "{v * 10, 0, 0}) end end";
    Yard first, second;
    EXPECT_EQ(first.run(text), "");
    EXPECT_EQ(second.run(text), "");
    EXPECT_EQ(first.hash(), second.hash());
}

TEST(Script, CallbacksMayDestroyWhatTheyAreToldOf) {
    Yard yard;
    const std::string removeAll =
        "function onBreak(shape) Delete(shape) end "
        "function onSplit(shape, pieces) Delete(shape) for _, p in ipairs(pieces) do Delete(p) end end "
        "function onBodyBreak(body) Delete(body) end "
        "function onContact(a, b) Delete(a) Delete(b) end "
        "function onFire(shape) Delete(shape) end "
        "function onJoint(joint, what, from, to) Delete(joint) Delete(from) Delete(to) end "
        "function onTrigger(trigger, body) Delete(trigger) Delete(body) end ";
    for (const char* name : {"first.lua", "second.lua"})
        yard.host().add(name, removeAll +
                                  "function init() for i = 1, 30 do "
                                  "Explosion({math.random() * 4 - 2, math.random() * 2, 0}, 1) "
                                  "MakeHole({4.1, 1, 0}, 0.5, 0.5, 0.5) SpawnFire({-5, 1, -0.7}) "
                                  "ApplyBodyImpulse(FindBody('crate'), {0, 0.4, -2}, {0, 500, 0}) wait(0.05) end end");
    for (int i = 0; i < 120; ++i) ASSERT_EQ(yard.host().step(), RUBBLE_OK);
    EXPECT_EQ(yard.logged(RUBBLE_LOG_ERROR), "");
    for (const Script& script : yard.host().scripts()) EXPECT_GT(script.profile(Callback::Break).calls, 0u);
}

TEST(Script, EditsOfOneStepAreBounded) {
    Yard yard;
    const std::string text =
        "function update()\nlocal n = 0\nlocal ok, why = pcall(function() for i = 1, 1e6 do\n"
        "Explosion({0, 500, 0}, 4)\nn = n + 1 end end)\nprint(n, why)\nend";
    for (const char* name : {"a.lua", "b.lua", "c.lua"}) yard.host().add(name, text);
    const std::string own =
        ".lua:4: Explosion: expected edits of at most 2000000 of a script for one step, found "
        "more: wait(0) lets the step take place\n";
    const std::string all =
        "c.lua: 1\tc.lua:4: Explosion: expected edits of at most 4000000 of all scripts for one "
        "step, found more: wait(0) lets the step take place\n";
    const std::string step = "a.lua: 6\ta" + own + "b.lua: 6\tb" + own + all;
    EXPECT_EQ(yard.host().step(), RUBBLE_OK);
    EXPECT_EQ(yard.logged(0), step);
    EXPECT_EQ(yard.host().step(), RUBBLE_OK);
    EXPECT_EQ(yard.logged(0), step + step);
}

TEST(Script, EachEditCountsForTheStep) {
    for (const char* call :
         {"Shoot({-5, 1, -5}, {0, -1, 0.1}, 'rocket')", "MakeHole({0, 500, 0}, 50)", "Crack({0, 500, 0}, 50)",
          "MakeHoleLine({0, 500, 0}, {900, 500, 0}, 1)", "Paint({0, 500, 0}, 10)", "CopyShapePalette(floor, wall)",
          "TrimShape(floor)", "ConstrainPosition(crate, 0, {0, 1, 0}, {0, 2, 0})", "SpawnFire({0, 500, 0})",
          "SetBodyDynamic(crate, true)"}) {
        SandboxLimits limits;
        limits.workPerFrame = limits.work = 10'000;
        Yard yard(limits);
        const std::string error = yard.run(
            "local floor, wall, crate = FindShape('floor'), FindShape('wall'), "
            "FindBody('crate') for i = 1, 300 do " +
            std::string(call) + " end");
        EXPECT_NE(error.find("expected edits of at most"), std::string::npos) << call << ": " << error;
    }
}

/// As many as a step takes in less than 0.3 s in the town, by docs/scripting.md.
TEST(Script, AStepHasSoManyOfEachEdit) {
    const std::pair<const char*, int> kCalls[] = {
        {"Explosion({0, 500, 0}, 4)", 6},  {"Explosion({0, 500, 0}, 2)", 18},
        {"Explosion({0, 500, 0}, 1)", 52}, {"Crack({0, 500, 0}, 20)", 1},
        {"Crack({0, 500, 0}, 2)", 41},     {"Crack({0, 500, 0}, 1)", 115},
        {"Paint({0, 500, 0}, 10)", 33},    {"MakeHoleLine({0, 500, 0}, {40, 500, 0}, 1)", 190}};
    for (const auto& [call, count] : kCalls) {
        Yard yard;
        EXPECT_EQ(yard.run("local n = 0 pcall(function() while true do " + std::string(call) +
                           " n = n + 1 end end) assert(n == " + std::to_string(count) + ", n)"),
                  "")
            << call;
    }
}

TEST(Script, AttacksLeaveTheWorldAsItWas) {
    SandboxLimits limits;
    limits.memory = 4 << 20;
    limits.work = 100'000;
    limits.processorSeconds = 0.2;
    Yard plain, attacked(limits);
    for (const Attack& attack : readAttacks()) {
        attacked.host().add(attack.name, attack.text);
        attacked.host().add(attack.name, "function init() " + attack.text + "\nend");
        attacked.host().scripts().clear();
    }
    for (int i = 0; i < 5; ++i) {
        plain.host().step();
        attacked.host().step();
    }
    EXPECT_EQ(plain.hash(), attacked.hash());
}

TEST(Script, TheHostReadsWhatScriptsSet) {
    Yard yard;
    EXPECT_EQ(yard.run("SetTimeScale(0.5) DebugLine({0, 0, 0}, {0, 5, 0}) DebugWatch('n', 3) DebugWatch('t', {}) "
                       "PointLight({0, 2, 0})"),
              "");
    EXPECT_EQ(yard.host().timeScale(), 0.5);
    EXPECT_EQ(yard.host().shared().lines.size(), 1u);
    EXPECT_EQ(yard.host().shared().watches["n"], "3");
    EXPECT_LT(yard.host().shared().watches["t"].size(), 12u) << "not an address: " << yard.host().shared().watches["t"];
    EXPECT_EQ(yard.host().shared().pointLights.size(), 1u);
}

}  // namespace
}  // namespace rubble::script
