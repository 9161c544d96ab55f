// When the names of callbacks are looked up, and what of them scripts can reach.
#include <gtest/gtest.h>

#include "tests/runtime/script/yard_fixture.h"

namespace rubble::script {
namespace {

void frames(Yard& yard, int count) {
    for (int i = 0; i < count; ++i) {
        yard.host().tick(1.0 / 60.0);
        ASSERT_EQ(yard.host().draw(0, viewOf(960, 540), 1.0 / 60.0), RUBBLE_OK);
        ASSERT_EQ(yard.host().step(), RUBBLE_OK);
    }
}

TEST(LateCallback, IsCalledWhereverItIsDefined) {
    Yard yard;
    yard.host().add("late.lua",
                    "function init() wait(0.02) function tick() tick = nil print('tick')\n"
                    "function draw() draw = nil print('draw') update = later end end end\n"
                    "function later() update = nil print('update') MakeHole({0, 1, 0.1}, 0.3, 0.3)\n"
                    "function onBreak() print('break') onBreak = nil\n"
                    "function destroy() print('destroy') end end end");
    frames(yard, 8);
    EXPECT_EQ(yard.logged(0), "late.lua: tick\nlate.lua: draw\nlate.lua: update\nlate.lua: break\n");
}

TEST(LateCallback, IsToldOfWhatTheWorldReports) {
    Yard yard;
    yard.host().add("late.lua",
                    "function tick() tick = nil\n"
                    "function onContact() onContact = nil print('contact') end\n"
                    "function onJoint(joint, what) onJoint = nil print(what) end\n"
                    "function onTrigger() onTrigger = nil print('trigger') end\n"
                    "function onFire() onFire = nil print('fire') end\n"
                    "SetBodyVelocity(FindBody('crate'), {0, 4, -4}) Delete(FindJoint('hinge')) "
                    "SpawnFire({0, 0.8, -1.6}) end");
    frames(yard, 120);
    for (const char* word : {"contact", "removed", "trigger", "fire"})
        EXPECT_NE(yard.logged(0).find(word), std::string::npos) << word << " in " << yard.logged(0);
}

TEST(LateCallback, CostsAScriptNothingThatDoesNotRun) {
    Yard yard;
    Script& script = yard.host().add("idle.lua", "x = 1");
    EXPECT_FALSE(script.has(Callback::Tick));
    const uint64_t allocations = script.sandbox().allocations();
    frames(yard, 10);
    EXPECT_EQ(script.sandbox().allocations(), allocations);
}

TEST(CoroutineOfACallback, IsOutOfReach) {
    Yard yard;
    yard.host().add("reach.lua",
                    "function init() co = coroutine.running() wait(0.1) print('waited', GetTime() > 0.09) end\n"
                    "function tick() tick = nil assert(coroutine.status(co) == 'suspended')\n"
                    "local ok, why = pcall(coroutine.resume, co) print(ok, why)\n"
                    "ok, why = pcall(coroutine.close, co) print(ok)\n"
                    "coroutine.resume(co) end\n");
    frames(yard, 12);
    const std::string why = "coroutine: expected one that the script has made, found that of a callback or of start()";
    EXPECT_EQ(yard.logged(0),
              "reach.lua: false\t" + why + "\nreach.lua: false\nreach.lua:5: " + why + "\nreach.lua: waited\ttrue\n");
}

TEST(CoroutineOfTheScript, IsInReachAlsoWhereCallbacksHadOnes) {
    Yard yard;
    EXPECT_EQ(yard.run("for i = 1, 20 do start(function() wait(0) error('ends') end) end wait(0.1)\n"
                       "for i = 1, 50 do local co = coroutine.create(function() coroutine.yield(i) end)\n"
                       "assert(select(2, coroutine.resume(co)) == i and coroutine.close(co)) end"),
              "test:2: ends");
}

}  // namespace
}  // namespace rubble::script
