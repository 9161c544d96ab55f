#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/files.h"
#include "runtime/script/functions/ui.h"
#include "runtime/script/functions/vocabulary.h"
#include "runtime/script/sandbox/libraries.h"

namespace rubble::script {
namespace {

constexpr size_t kMaxLines = 10'000, kMaxKnown = 1000;
/// Of Spawn(): for a file that the script has not placed before, for another one, and for each object.
constexpr int64_t kReadWork = 100'000, kSpawnWork = 5'000, kObjectWork = 500;
constexpr int64_t kSpawnStepWork = 500, kObjectStepWork = 2000;  ///< the same of the step, where they come into being

int setTimeScale(lua_State* L) {
    ScriptContext::of(L).shared.timeScale = limitedAt(L, 1, "scale", 0.0, 10.0);
    return 0;
}

int setGravity(lua_State* L) {
    const Vector gravity = vectorAt(L, 1, "gravity");
    auto environment = sized<rubble_environment>();
    isDone(L, apiOf(L).get_environment(worldOf(L), &environment));
    copy(environment.gravity, gravity);
    isDone(L, apiOf(L).set_environment(worldOf(L), &environment));
    return 0;
}

int getTime(lua_State* L) {
    lua_pushnumber(L, ScriptContext::of(L).shared.time);
    return 1;
}

int getTimeStep(lua_State* L) {
    lua_pushnumber(L, ScriptContext::of(L).shared.timeStep);
    return 1;
}

int spawn(lua_State* L) {
    const std::string path = fileAt(L, 1, "file");
    const Placement placement = lua_isnoneornil(L, 2) ? Placement{} : poseAt(L, 2, "transform");
    auto prefab = sized<rubble_prefab>();
    prefab.path = path.c_str();
    copy(prefab.position, placement.position);
    copy(prefab.rotation, placement.rotation);
    uint32_t count = 0;
    std::set<std::string>& known = ScriptContext::of(L).spawned;
    Sandbox::of(L).charge(L, known.contains(path) ? kSpawnWork : kReadWork);
    isDone(L, apiOf(L).create_prefab(worldOf(L), &prefab, nullptr, 0, &count));
    if (known.size() < kMaxKnown) known.insert(path);  // the library reads it once
    Sandbox::of(L).charge(L, kObjectWork * count);
    chargeStep(L, kSpawnStepWork + kObjectStepWork * count);
    std::vector<rubble_prefab_row> rows(count);
    isDone(L, apiOf(L).create_prefab(worldOf(L), &prefab, rows.data(), count, &count));
    std::vector<uint64_t> handles;
    ScriptContext::of(L).shared.followsLevel = true;
    static constexpr uint32_t kKinds[] = {RUBBLE_KIND_BODY, RUBBLE_KIND_SHAPE, RUBBLE_KIND_JOINT, RUBBLE_KIND_LIGHT};
    for (const rubble_prefab_row& row : rows) {
        ScriptContext::of(L).shared.pending.created[row.handle] = kKinds[row.kind];
        handles.push_back(row.handle);
    }
    return pushHandles(L, handles.data(), handles.size());
}

/// Beyond kMaxLines, as of a host that never draws, lines are left out.
void addLine(lua_State* L, const Vector& from, const Vector& to, int colorAt, bool isOccluded = false) {
    WorldLine line{from, to, {1.0, 1.0, 1.0, 1.0}, isOccluded};
    const char* const names[] = {"r", "g", "b", "a"};
    for (int i = 0; i < 4; ++i) line.color[size_t(i)] = numberOr(L, colorAt + i, names[i], 1.0);
    Sandbox::of(L).charge(L, 20);
    std::vector<WorldLine>& lines = ScriptContext::of(L).shared.lines;
    if (lines.size() < kMaxLines) lines.push_back(line);
}

int debugLine(lua_State* L) {
    addLine(L, vectorAt(L, 1, "p0"), vectorAt(L, 2, "p1"), 3);
    return 0;
}

int debugCross(lua_State* L) {
    const Vector middle = vectorAt(L, 1, "pos");
    for (size_t axis = 0; axis < 3; ++axis) {
        Vector from = middle, to = middle;
        from[axis] -= 0.25;
        to[axis] += 0.25;
        addLine(L, from, to, 2);
    }
    return 0;
}

int drawLine(lua_State* L) {
    addLine(L, vectorAt(L, 1, "p0"), vectorAt(L, 2, "p1"), 3, true);
    return 0;
}

int debugProfile(lua_State* L) {
    ScriptContext::of(L).shared.showsProfile = boolOr(L, 1, true);
    return 0;
}

int debugPrint(lua_State* L) {
    lua_settop(L, 1);  // nothing is written as nil
    pushText(L, 1);
    Sandbox& box = Sandbox::of(L);
    box.charge(L, 100 + int64_t(lua_rawlen(L, -1)));
    if (box.output) box.output(lua_tostring(L, -1));
    return 0;
}

int debugWatch(lua_State* L) {
    const std::string name = textAt(L, 1, "name");
    lua_settop(L, 2);
    pushText(L, 2);
    auto& watches = ScriptContext::of(L).shared.watches;
    if (watches.size() >= 1000 && !watches.count(name)) return 0;
    std::string& line = watches[name] = std::string(lua_tostring(L, -1)).substr(0, 1000);
    std::replace(line.begin(), line.end(), '\n', ' ');
    return 0;
}

int wait(lua_State* L) {
    const double seconds = numberOr(L, 1, "seconds", 0.0);
    if (!(seconds >= 0.0)) refuseArgument(L, 1, "seconds", "0 or more");
    return waitUntil(L, ScriptContext::of(L).shared.time + seconds);
}

int start(lua_State* L) {
    if (lua_type(L, 1) != LUA_TFUNCTION) refuseArgument(L, 1, "f", "a function");
    std::vector<int>& started = ScriptContext::of(L).started;
    if (started.size() >= 1000) return luaL_error(L, "start: expected at most 1000 in one callback, found more");
    const int count = lua_gettop(L);
    lua_createtable(L, count, 0);
    for (int i = 1; i <= count; ++i) {
        lua_pushvalue(L, i);
        lua_rawseti(L, -2, i);
    }
    lua_pushinteger(L, count);
    lua_rawseti(L, -2, 0);
    started.push_back(luaL_ref(L, LUA_REGISTRYINDEX));
    return 0;
}

constexpr ScriptFunction kFunctions[] = {
    {"SetTimeScale(scale)", "How fast the world's time goes: 1 as usual, 0 stands still.", setTimeScale},
    {"SetGravity(gravity)", "The acceleration of all that falls, in m/s2.", setGravity, 30},
    {"GetTime() -> seconds", "The seconds of all steps since the scripts began.", getTime},
    {"GetTimeStep() -> seconds", "What tick() or update() was given.", getTimeStep},
    {"Spawn(file, transform) -> list",
     "Places a model or level of the scripts' folder into the world; gives its bodies, shapes, joints and lights.",
     spawn},
    {"DebugLine(p0, p1, r, g, b, a)", "A line of the world until the next tick(); of draw(), for its frame.",
     debugLine},
    {"DebugCross(pos, r, g, b, a)", "A cross at a place, drawn likewise.", debugCross},
    {"DrawLine(p0, p1, r, g, b, a)", "A line of the world that voxels hide, drawn likewise.", drawLine},
    {"DebugPrint(text)", "Writes a line to the log.", debugPrint},
    {"DebugWatch(name, value)", "Shows a value by its name until it is given again.", debugWatch},
    {"DebugProfile(show)",
     "Shows over the image what each script, its callbacks and the functions that it calls have cost lately, a frame: "
     "calls, milliseconds, allocations. false: no more.",
     debugProfile},
    {"wait(seconds)", "Lets the world go on for so long, then continues. In callbacks and in what start() began.",
     wait},
    {"start(f, ...)", "Begins a function beside the callbacks, which may wait: at most 1,000 from one callback.",
     start},
};

}  // namespace

std::span<const ScriptFunction> worldFunctions() {
    return kFunctions;
}

}  // namespace rubble::script
