// Texts of the scripts' folder, and tables that saves keep.
#include "runtime/script/binding/files.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/directives.h"
#include "runtime/script/functions/vocabulary.h"
#include "runtime/script/sandbox/libraries.h"
#include "runtime/script/sandbox/script_name.h"

namespace rubble::script {
namespace {

constexpr size_t kMaxTextBytes = 1 << 20, kMaxSaved = 100;
const char kLoaded = 0, kLoading = 0;  ///< their addresses: the table of what require() has loaded, and a mark in it

/// Compiles a text onto the stack, or raises what is wrong with it.
void compile(lua_State* L, const std::string& given, const std::string& name) {
    Sandbox::of(L).charge(L, compileCost(given));
    const std::string text = withoutDirectives(given);
    if (luaL_loadbufferx(L, text.data(), text.size(), ("=" + name).c_str(), "t") != LUA_OK) lua_error(L);
}

std::string readText(lua_State* L, const std::string& path, const std::string& name) {
    std::ifstream file(path, std::ios::binary);
    if (!file) luaL_error(L, "require: name: expected a file of the scripts' folder, found no %s", name.c_str());
    std::string text(kMaxTextBytes + 1, '\0');
    file.read(text.data(), std::streamsize(text.size()));
    text.resize(size_t(file.gcount()));
    if (text.size() > kMaxTextBytes) luaL_error(L, "require: %s: expected at most 1 MiB", name.c_str());
    return text;
}

/// Leaves the table of what was loaded on the stack.
void pushLoaded(lua_State* L) {
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &kLoaded) == LUA_TTABLE) return;
    lua_pop(L, 1);
    lua_newtable(L);
    lua_pushvalue(L, -1);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &kLoaded);
}

int requireFile(lua_State* L) {
    std::string name = textAt(L, 1, "name");
    if (!hasEnding(name, ".lua")) name += ".lua";
    lua_settop(L, 0);
    lua_pushlstring(L, name.data(), name.size());
    const std::string path = std::filesystem::path(fileAt(L, 1, "name")).lexically_normal().string();
    lua_pushlstring(L, path.data(), path.size());
    lua_replace(L, 1);  // a file has one path, and many names
    pushLoaded(L);
    lua_pushvalue(L, 1);
    if (lua_rawget(L, 2) == LUA_TLIGHTUSERDATA)
        return luaL_error(L, "require: name: expected a file that does not require itself, found %s", name.c_str());
    if (!lua_isnil(L, -1)) return 1;
    Sandbox::of(L).charge(L, 10'000);  // reading a file
    ScriptContext::of(L).required.insert(path);
    compile(L, readText(L, path, name), name);
    lua_pushvalue(L, 1);
    lua_pushlightuserdata(L, const_cast<char*>(&kLoading));
    lua_rawset(L, 2);
    if (lua_pcall(L, 0, 1, 0) != LUA_OK) {
        lua_pushvalue(L, 1);
        lua_pushnil(L);
        lua_rawset(L, 2);  // another require() tries again
        if (Sandbox::of(L).isStopped()) Sandbox::raiseStop(L);
        return lua_error(L);
    }
    if (lua_isnil(L, -1)) {
        lua_pop(L, 1);
        lua_pushboolean(L, 1);
    }
    lua_pushvalue(L, 1);
    lua_pushvalue(L, -2);
    lua_rawset(L, 2);
    return 1;
}

int saved(lua_State* L) {
    const std::string name = textAt(L, 1, "name");
    ScriptContext& context = ScriptContext::of(L);
    if (const auto known = context.saved.find(name); known != context.saved.end()) {
        lua_rawgeti(L, LUA_REGISTRYINDEX, known->second.reference);
        return 1;
    }
    if (context.saved.size() >= kMaxSaved)
        return luaL_error(L, "saved: expected at most %d tables, found one more", int(kMaxSaved));
    const auto restored = context.restored.find(name);
    if (restored != context.restored.end()) {
        compile(L, "return " + restored->second, "saved " + name);
        lua_call(L, 0, 1);
    } else if (lua_isnoneornil(L, 2)) {
        lua_newtable(L);
    } else {
        lua_pushvalue(L, 2);
    }
    if (lua_type(L, -1) != LUA_TTABLE) refuseArgument(L, 2, "table", "a table");
    lua_pushvalue(L, -1);
    const int reference = luaL_ref(L, LUA_REGISTRYINDEX);
    context.saved[name] = {reference, placeOf(L)};
    return 1;
}

constexpr ScriptFunction kFunctions[] = {
    {"require(name) -> value",
     "Runs a file of the scripts' folder once, and gives what it returns: \"tools/laser\" is tools/laser.lua.",
     requireFile},
    {"saved(name, table) -> table",
     "A table that saves keep and that outlives a reload: at first the one given, later what was saved of it. It holds "
     "numbers, texts, booleans, vectors and tables of these, 32 deep and 1 MiB as a text at most; the log names what "
     "is "
     "not kept. A script has 100 of them.",
     saved},
};

}  // namespace

std::span<const ScriptFunction> fileFunctions() {
    return kFunctions;
}

}  // namespace rubble::script
