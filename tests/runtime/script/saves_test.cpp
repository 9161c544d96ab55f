// What saves keep of scripts, reloads, levels that name scripts, and replays without them.
#include <gtest/gtest.h>

#include <fstream>

#include "runtime/assets/rubble_file.h"
#include "tests/runtime/script/yard_fixture.h"
#include "tests/support/grids.h"

namespace rubble::script {
namespace {

constexpr const char* kCounter =
    "local kept = saved('count', {n = 0, at = Vec(1, 2, 3), names = {'a', 'b'}})\n"
    "function init() SetString('first', 'init') end\n"
    "function onLoad() SetString('first', 'load') end\n"
    "function update() kept.n = kept.n + 1 SetInt('n', kept.n) SetString('at', tostring(kept.at + Vec(0, 0, 1))) end\n";

void steps(Yard& yard, int count) {
    for (int i = 0; i < count; ++i) ASSERT_EQ(yard.host().step(), RUBBLE_OK);
}

TEST(ScriptSaves, TablesAndRegistryAreInASave) {
    Yard yard;
    const std::string save = (yard.folder() / "save.rubble").string();
    yard.host().add("counter.lua", kCounter);
    steps(yard, 5);
    ASSERT_EQ(yard.host().save(), RUBBLE_OK);
    ASSERT_EQ(yard.api().save_game(yard.world(), save.c_str()), RUBBLE_OK);
    const double time = yard.host().shared().time;
    steps(yard, 7);
    EXPECT_EQ(yard.host().shared().registry["n"], "12");
    ASSERT_EQ(yard.api().load_game(yard.world(), save.c_str()), RUBBLE_OK) << yard.api().get_last_error();
    yard.host().load();
    EXPECT_EQ(yard.host().shared().registry["n"], "5");
    EXPECT_EQ(yard.host().shared().registry["first"], "load");
    EXPECT_EQ(yard.host().shared().time, time);
    steps(yard, 1);
    EXPECT_EQ(yard.host().shared().registry["n"], "6");
    EXPECT_EQ(yard.host().shared().registry["at"], "(1.0, 2.0, 4.0)");
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING), "");
}

TEST(ScriptSaves, AReloadKeepsState) {
    Yard yard;
    yard.host().add("counter.lua", kCounter);
    steps(yard, 4);
    std::string faster = kCounter;
    faster.replace(faster.find("kept.n + 1"), 10, "kept.n + 5");
    EXPECT_TRUE(yard.host().reload("counter.lua", faster));
    steps(yard, 1);
    EXPECT_EQ(yard.host().shared().registry["n"], "9");
    EXPECT_FALSE(yard.host().reload("counter.lua", "x = = 1")) << "what does not compile changes nothing";
    steps(yard, 1);
    EXPECT_EQ(yard.host().shared().registry["n"], "14");
    EXPECT_FALSE(yard.host().reload("other.lua", faster));
}

TEST(ScriptSaves, WhatCannotBeKeptIsNamedAndTheRestIsKept) {
    Yard yard;
    const std::string text =
        "local s = saved('s', {n = 0})\n"
        "function update() s.n = s.n + 1 s.a = print s.cars = {{body = 7, hit = print}, {[print] = 1}}\n"
        "s.spot = Vec(1, 2, 3) s.spot.name = 'x' s.pose = Transform() s.pose[1] = 2\n"
        "s.self = s s['two words'] = {at = Vec(1, 2, 3), co = coroutine.create(print)} end\n"
        "function onLoad() local c = saved('s') assert(c.n == 3 and c.a == nil and c.cars[1].body == 7 and #c.cars == "
        "2)\n"
        "assert(c.self == nil and c['two words'].at == Vec(1, 2, 3)) SetInt('loaded', 1) end";
    yard.host().add("keep.lua", text);
    steps(yard, 3);
    ASSERT_EQ(yard.host().save(), RUBBLE_OK);
    const std::string log = yard.logged(RUBBLE_LOG_WARNING);
    const std::string begin =
        "keep.lua:1: saved \"s\": expected numbers, texts, booleans, vectors and tables of these, found s";
    for (const char* loss : {".a: a function", ".cars[1].hit: a function", ".cars[2]: a key that is a function",
                             ".spot.name: a field of a Vec", ".pose[1]: a field of a Transform",
                             ".self: a table that is in itself", "[\"two words\"].co: a thread"})
        EXPECT_NE(log.find(begin + loss + ": it is not kept\n"), std::string::npos) << loss << " in " << log;
    ASSERT_EQ(yard.host().save(), RUBBLE_OK);
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING), log) << "told once";
    yard.host().load();
    EXPECT_EQ(yard.host().shared().registry["loaded"], "1") << yard.logged(RUBBLE_LOG_WARNING);
}

TEST(ScriptSaves, ATableThatIsTooLargeLosesNoOther) {
    Yard yard;
    yard.host().add("large.lua",
                    "local small = saved('small', {n = 5}) local deep = saved('deep', {})\n"
                    "local large = saved('large', {}) for i = 1, 5 do large[i] = ('x'):rep(250000) end\n"
                    "local t = deep for i = 1, 40 do t.t = {n = i} t = t.t end");
    ASSERT_EQ(yard.host().save(), RUBBLE_OK);
    const std::string log = yard.logged(RUBBLE_LOG_WARNING);
    EXPECT_NE(log.find("found large: more than 1048576 bytes as a text: it is not kept"), std::string::npos) << log;
    EXPECT_NE(log.find(".t.t: a table within 32 others: it is not kept"), std::string::npos) << log;
    ASSERT_TRUE(yard.host().reload("large.lua", "assert(saved('small').n == 5 and saved('deep').t.t.t.n == 3)"))
        << yard.logged(RUBBLE_LOG_WARNING);
}

TEST(ScriptSaves, WhatIsBrokenIsKeptAndAnUndoMakesItWhole) {
    Yard yard;
    const auto isBroken = [&](const char* expected) {
        EXPECT_EQ(yard.run("local w = FindShape('wall') local found = tostring(IsShapeBroken(w)) .. ' ' .. "
                           "tostring(IsBodyBroken(GetShapeBody(w))) if found ~= '" +
                           std::string(expected) + "' then error(found) end"),
                  "");
    };
    const std::string save = (yard.folder() / "save.rubble").string();
    ASSERT_EQ(yard.api().set_undo_limit(yard.world(), 2), RUBBLE_OK);
    ASSERT_EQ(yard.api().add_undo_mark(yard.world()), RUBBLE_OK);
    isBroken("false false");
    EXPECT_EQ(yard.run("MakeHole({0, 1.2, 0}, 0.4, 0.4)"), "");
    steps(yard, 1);
    isBroken("true true");
    ASSERT_EQ(yard.api().save_game(yard.world(), save.c_str()), RUBBLE_OK);
    ASSERT_EQ(yard.api().undo(yard.world()), RUBBLE_OK);
    steps(yard, 1);
    isBroken("false false");
    ASSERT_EQ(yard.api().load_game(yard.world(), save.c_str()), RUBBLE_OK);
    yard.host().scripts().clear();  // which ask again
    yard.host().load();
    isBroken("true true");
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING), "");
}

TEST(ScriptSaves, WhatIsCutAndThenChangedInOneStepIsBroken) {
    for (const char* edits :
         {"MakeHole({0, 1.2, 0}, 0.4, 0.4) SetBodyDynamic(b, true)",
          "MakeHole({0, 1.2, 0}, 0.4, 0.4) ResizeShape(s, -2, 0, 0, 60, 30, 5)", "ResizeShape(s, 0, 0, 0, 5, 5, 1)"}) {
        Yard yard;
        EXPECT_EQ(yard.run("local s, told = FindShape('wall'), 0 local b = GetShapeBody(s) "
                           "function onBodyBreak(body) if body == b then told = told + 1 end end " +
                           std::string(edits) +
                           " wait(0) wait(0) assert(IsBodyBroken(b) and IsShapeBroken(s) and told == 1, told)"),
                  "")
            << edits;
    }
}

TEST(ScriptSaves, ARecordingOfScriptsPlaysWithoutThem) {
    Yard yard;
    const std::string log = (yard.folder() / "game.rubblelog").string();
    ASSERT_EQ(yard.api().start_recording(yard.world(), log.c_str()), RUBBLE_OK);
    yard.host().add("breaks.lua",
                    "function init() for i = 1, 5 do MakeHole({i - 3, 1.5, 0.1}, 0.4, 0.4) wait(0.1) end "
                    "Explosion({0, 0.5, -1}, 2) end\n"
                    "function update() local crate = FindBody('crate') if crate ~= 0 then "
                    "ConstrainPosition(crate, 0, GetBodyTransform(crate).pos, {0, 2, -2}, 2) end end");
    steps(yard, 60);
    const uint64_t end = yard.hash();
    ASSERT_EQ(yard.api().stop_recording(yard.world()), RUBBLE_OK);
    rubble_world other = 0;
    auto settings = sized<rubble_world_settings>();
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    ASSERT_EQ(yard.api().create_world(&settings, &other), RUBBLE_OK);
    uint64_t played = 0, hash = 0;
    EXPECT_EQ(yard.api().play_recording(other, log.c_str(), &played), RUBBLE_OK) << yard.api().get_last_error();
    EXPECT_EQ(played, 60u) << "each step has the recorded hash";
    EXPECT_EQ(yard.api().get_state_hash(other, &hash), RUBBLE_OK);
    EXPECT_EQ(hash, end);
    yard.api().destroy_world(other);
}

/// A level of nothing but a place and a script.
std::string writeLevel(const std::filesystem::path& folder, const std::string& name, const std::string& script) {
    Level level;
    level.name = "scripted";
    LevelBody& body = level.bodies.emplace_back();
    LevelShape& shape = body.shapes.emplace_back();
    body.name = shape.name = "post";
    shape.grid = solidGrid({2, 2, 2}, 1);
    shape.palette = std::make_shared<const Palette>();
    level.locations.emplace_back("spawn", Pose{{1.0, 2.0, 3.0}, {1, 0, 0, 0}});
    level.scripts.push_back({script, "speed=3\nname=lift"});
    const std::vector<uint8_t> bytes = levelToRubble(level);
    std::ofstream(folder / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    return (folder / name).string();
}

TEST(ScriptSaves, ALoadAndALevelCallDestroyWhichDoesNotChangeTheWorldThatComes) {
    Yard yard;
    const std::string save = (yard.folder() / "save.rubble").string();
    const std::string text =
        "function destroy() print('ends') SetGravity({0, 5, 0}) MakeHole({0, 1, 0}, 0.5) Delete(crate) "
        "Delete(FindBody('wall')) SetBodyVelocity(crate, {0, 9, 0}) assert(FindBody('floor') == 0) "
        "CreateShape(crate, Transform()) assert(not QueryRaycast({0, 9, 0}, {0, -1, 0}, 20)) Spawn('post.vox') "
        "PointLight({0, 1, 0}, 1, 1, 1) Paint({0, 1, 0}, 1) SetTag(crate, 'x') end "
        "crate = FindBody('crate')";
    std::ofstream(yard.folder() / "level.lua") << text;
    yard.host().add("mod.lua", text);
    steps(yard, 2);
    ASSERT_EQ(yard.host().save(), RUBBLE_OK);
    ASSERT_EQ(yard.api().save_game(yard.world(), save.c_str()), RUBBLE_OK);
    ASSERT_EQ(yard.api().load_game(yard.world(), save.c_str()), RUBBLE_OK);
    const uint64_t loaded = yard.hash();
    yard.host().load();
    EXPECT_EQ(yard.logged(0), "mod.lua: ends\n");
    EXPECT_EQ(yard.hash(), loaded);
    steps(yard, 1);
    const uint64_t stepped = yard.hash();
    ASSERT_EQ(yard.api().load_game(yard.world(), save.c_str()), RUBBLE_OK);
    ASSERT_EQ(yard.api().step(yard.world()), RUBBLE_OK);
    EXPECT_EQ(yard.hash(), stepped) << "the step carries out nothing of it";

    const std::string level = writeLevel(yard.folder(), "level.rubble", "level.lua");
    const auto enter = [&] {
        ASSERT_EQ(yard.api().load_level(yard.world(), level.c_str(), nullptr), RUBBLE_OK);
        yard.host().addLevelScripts();
    };
    enter();
    enter();
    EXPECT_EQ(yard.logged(0), "mod.lua: ends\nlevel.lua: ends\n");
    steps(yard, 1);
    auto environment = sized<rubble_environment>();
    ASSERT_EQ(yard.api().get_environment(yard.world(), &environment), RUBBLE_OK);
    EXPECT_LT(environment.gravity[1], 0.0);
}

int countCalls(lua_State* L) {
    ++*static_cast<int*>(ScriptContext::of(L).shared.host);
    return 0;
}

TEST(ScriptSaves, AfterALoadDestroyCallsNoFunctionOfTheHost) {
    Yard yard;
    int calls = 0;
    const ScriptFunction functions[] = {{"SaveGame(name)", "Counts.", countCalls}};
    ScriptHostSettings settings;
    settings.functions = functions, settings.host = &calls;
    {
        ScriptHost host(yard.api(), yard.world(), settings);
        host.add("mod.lua", "SaveGame() function destroy() SaveGame() end");
        EXPECT_EQ(calls, 1);
        host.load();
        EXPECT_EQ(calls, 2) << "its text runs again";
    }
    EXPECT_EQ(calls, 3) << "at the end the world is there";
}

TEST(ScriptSaves, LevelsNameTheirScripts) {
    Yard yard;
    std::ofstream(yard.folder() / "level.lua")
        << "function init() SetInt('speed', GetIntParam('speed', 1)) "
           "SetString('name', GetStringParam('name', '')) "
           "SetString('at', tostring(GetLocationTransform(FindLocation('spawn')).pos)) end";
    const std::string level = writeLevel(yard.folder(), "level.rubble", "level.lua");
    ASSERT_EQ(yard.api().load_level(yard.world(), level.c_str(), nullptr), RUBBLE_OK) << yard.api().get_last_error();
    yard.host().addLevelScripts();
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING), "");
    EXPECT_EQ(yard.host().shared().registry["speed"], "3");
    EXPECT_EQ(yard.host().shared().registry["name"], "lift");
    EXPECT_EQ(yard.host().shared().registry["at"], "(1.0, 2.0, 3.0)");
    ASSERT_EQ(yard.api().load_level(yard.world(), level.c_str(), nullptr), RUBBLE_OK);
    yard.host().shared().registry.clear();
    yard.host().addLevelScripts();
    EXPECT_EQ(yard.host().scripts().size(), 1u) << "that of the level before has ended";
    EXPECT_EQ(yard.host().shared().registry["speed"], "3") << "it has begun again";
}

TEST(ScriptSaves, ScriptsOfALevelLieBesideIt) {
    Yard yard;
    const TempFolder other;
    std::ofstream(other.path() / "level.lua") << "function init() SetInt('answer', require('near').value) end";
    std::ofstream(other.path() / "near.lua") << "return {value = 7}";
    std::ofstream(yard.folder() / "level.lua") << "function init() SetInt('answer', 1) end";
    const std::string level = writeLevel(other.path(), "level.rubble", "level.lua");
    ASSERT_EQ(yard.api().load_level(yard.world(), level.c_str(), nullptr), RUBBLE_OK);
    ScriptHost host(yard.api(), yard.world(),
                    {.folder = yard.folder().string(), .levelFolder = other.path().string(), .log = yard.log()});
    host.addLevelScripts();
    EXPECT_EQ(host.shared().registry["answer"], "7") << yard.logged(RUBBLE_LOG_WARNING);
    const std::string text = host.scripts().front().text();
    EXPECT_TRUE(host.reload("level.lua", text)) << "it still reads beside the level";
    EXPECT_TRUE(host.scripts().front().ofLevel()) << "and ends with it";
    host.add("own.lua", "assert(not pcall(require, 'near')) assert(require('tools').double(2) == 4)");
    EXPECT_EQ(host.scripts().back().error(), "") << "the host's own scripts read in the host's folder";
}

TEST(ScriptSaves, PrefabsBringTheirScripts) {
    Yard yard;
    std::ofstream(yard.folder() / "prefab.lua") << "function init() SetInt('begun', GetInt('begun') + 1) end";
    writeLevel(yard.folder(), "prefab.rubble", "prefab.lua");
    EXPECT_EQ(yard.run("Spawn('prefab.rubble') Spawn('prefab.rubble')"), "");
    steps(yard, 2);
    EXPECT_EQ(yard.host().shared().registry["begun"], "2");
    EXPECT_EQ(yard.logged(RUBBLE_LOG_WARNING), "");
}

TEST(ScriptSaves, NamesOfScriptsEndInLuaAndAreOfOneLine) {
    Yard yard;
    for (const char* path : {"level.txt", "one.lua\nerror: two.lua", "level"}) {
        std::ofstream(yard.folder() / path) << "function init() SetInt('begun', 1) end";
        const std::string level = writeLevel(yard.folder(), "level.rubble", path);
        ASSERT_EQ(yard.api().load_level(yard.world(), level.c_str(), nullptr), RUBBLE_OK);
        yard.host().addLevelScripts();
        EXPECT_TRUE(yard.host().scripts().empty()) << path;
    }
    EXPECT_EQ(yard.logged(RUBBLE_LOG_ERROR),
              "the level names the script \"level.txt\": expected a name of one line that ends in .lua\n"
              "the level names the script \"one.lua?error: two.lua\": expected a name of one line that ends in .lua\n"
              "the level names the script \"level\": expected a name of one line that ends in .lua\n");
}

TEST(ScriptSaves, AScriptThatIsNotThereIsLogged) {
    Yard yard;
    for (const char* path : {"missing.lua", "../outside.lua", "/etc/passwd"}) {
        const std::string level = writeLevel(yard.folder(), "level.rubble", path);
        ASSERT_EQ(yard.api().load_level(yard.world(), level.c_str(), nullptr), RUBBLE_OK);
        ScriptHost host(yard.api(), yard.world(), {.folder = yard.folder().string(), .log = yard.log()});
        host.addLevelScripts();
        EXPECT_TRUE(host.scripts().empty());
        EXPECT_NE(yard.logged(RUBBLE_LOG_ERROR).find(std::string("the level names the script \"") + path),
                  std::string::npos);
        const std::string play = RUBBLE_LUA_PROGRAM " --steps 5 --level " + level + " < /dev/null > /dev/null 2>&1";
        EXPECT_NE(std::system(play.c_str()), 0) << "a level without its scripts is no reason to read lines";
    }
}

TEST(ScriptFiles, RequireRunsAFileOnce) {
    Yard yard;
    std::ofstream(yard.folder() / "once.lua") << "SetInt('runs', GetInt('runs') + 1) return {n = 1}";
    std::ofstream(yard.folder() / "self.lua") << "require('self')";
    std::ofstream(yard.folder() / "bad.lua") << "local x = = 1";
    EXPECT_EQ(yard.run("assert(require('once') == require('once.lua') and require('./once') == require('MOD/once'))"
                       "assert(require('once') == require('./once') and GetInt('runs') == 1)"),
              "");
    EXPECT_NE(yard.run("require('self')").find("does not require itself"), std::string::npos);
    EXPECT_NE(yard.run("require('bad')").find("bad.lua:1"), std::string::npos);
    EXPECT_NE(yard.run("require('../once')").find("inside of the folder"), std::string::npos);
    EXPECT_NE(yard.run("require('none')").find("found no none.lua"), std::string::npos);
}

TEST(ScriptProfile, FunctionsAreMeasuredWhereTheHostAsks) {
    Yard yard;
    ScriptHost host(yard.api(), yard.world(), {.measuresFunctions = true});
    const Script& script = host.add("calls.lua", "for i = 1, 100 do Vec(1, 2, 3) end");
    double seconds = 0.0;
    uint64_t allocations = 0;
    for (const FunctionCost& cost : script.context().costs) seconds += cost.seconds, allocations += cost.allocations;
    EXPECT_GT(seconds, 0.0);
    EXPECT_GE(allocations, 100u);
    EXPECT_TRUE(yard.host().add("plain.lua", "Vec()").context().costs.empty());
}

TEST(Script, AnAnswerShowsVectors) {
    Yard yard;
    std::string answer;
    EXPECT_TRUE(yard.host().add("eval", "").evaluate("return Vec(1, 2, 3), true, 5, nil, {}", answer));
    EXPECT_EQ(answer, "(1.0, 2.0, 3.0)\ttrue\t5\tnil\ttable: 1");
}

TEST(ScriptSaves, OddTablesDoNoHarm) {
    Yard yard;
    size_t known = 0;
    const auto toldOf = [&](const std::string& text) {
        Script& script = yard.host().add("odd.lua", text);
        yard.host().save();
        EXPECT_EQ(script.error(), "");
        yard.host().scripts().clear();
        const std::string log = yard.logged(RUBBLE_LOG_WARNING), news = log.substr(known);
        known = log.size();
        return news;
    };
    EXPECT_EQ(toldOf("local loop = function() while true do end end saved('t', setmetatable({a = 1}, "
                     "{__index = loop, __pairs = loop, __len = loop, __tostring = loop, __metatable = loop}))"),
              "")
        << "nothing of the script runs";
    EXPECT_NE(toldOf("local t = saved('t') for i = 1, 1000 do t.t = {} t = t.t end").find("a table within 32 others"),
              std::string::npos);
    EXPECT_NE(toldOf("local t = saved('t') t.t = t").find(".t: a table that is in itself"), std::string::npos);
    EXPECT_NE(toldOf("local t = saved('t') for i = 1, 8 do t[i] = ('x'):rep(200000) end").find("bytes"),
              std::string::npos);
    EXPECT_NE(toldOf("saved('t').f = print").find("a function"), std::string::npos);
    EXPECT_NE(toldOf("saved('t')[{}] = 1").find("a key that is a table"), std::string::npos);
    EXPECT_EQ(toldOf("saved('t')[('k'):rep(100000)] = 1"), "");
    EXPECT_EQ(toldOf("local t = saved('t') t[0/1] = -1/0 t.nan = 0/0 t[math.mininteger] = true"), "");
}

}  // namespace
}  // namespace rubble::script
