#pragma once
#include <cstdint>
#include <lua.hpp>
#include <string_view>

namespace rubble::script {

/// Opens the safe libraries in a new state: those of Lua 5.4 without what reaches outside or cannot be bounded.
void openLibraries(lua_State* L);

/// assert, error, pairs, pcall, load, print, ... into the table of globals on the stack. Of Lua's are missing dofile,
/// loadfile, warn; `load` takes text alone, `setmetatable` no finaliser, `collectgarbage` counts and collects.
void openBase(lua_State* L);
/// `pairs`, which goes through the keys of a table in a fixed order: numbers, strings, booleans, each sorted, then
/// objects as they were made. That of Lua depends on where objects lie in memory.
void openPairs(lua_State* L);
/// `coroutine`, whose functions pass a stop on.
void openCoroutine(lua_State* L);
/// `string`, whose patterns and formats are bounded, and the metatable of strings. Without `dump`.
void openString(lua_State* L);
/// `table`, with a sort that is stable and ends whatever its comparison says.
void openTable(lua_State* L);
/// `math` with random numbers of the limits' seed, and `utf8`.
void openMath(lua_State* L);

/// Replaces functions of the table on the stack by ones that first charge what their arguments hold: a unit for each,
/// and one for 16 bytes of each string. Names end with a null.
void chargeArguments(lua_State* L, const char* const* names);

/// The most values that a function of the libraries gives at once: what many values cost, calls with them cost again.
inline constexpr lua_Integer kMaxResults = 8000;
/// The same for functions of a string and two positions, as string.byte, that give a value for each byte between.
void limitResults(lua_State* L, const char* const* names);

/// Replaces a function of the table on the stack by one that has it as its upvalue.
void wrapField(lua_State* L, const char* name, lua_CFunction function);

/// Orders the blocks of a state by when they were made.
uint64_t creationOf(const void* block);

/// Units of work to compile a byte.
inline constexpr int64_t kCompileWork = 4;
/// What it costs to compile a text, in units of work.
int64_t compileCost(std::string_view text);

/// Pushes the text of a value as tostring() gives it: of what has no text its kind and a number, never an address.
void pushText(lua_State* L, int index);

}  // namespace rubble::script
