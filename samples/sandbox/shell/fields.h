#pragma once
#include <span>

#include "runtime/script/binding/arguments.h"
#include "runtime/script/binding/calls.h"

namespace sandbox {

/// Refuses an argument of the running function that is no table.
void requireTable(lua_State* L, int index, const char* name);
/// Refuses a table with a key beside these and the numbers from 1 to `length`.
void requireKeys(lua_State* L, int index, const char* name, std::span<const char* const> keys, lua_Integer length = 0);
/// A number within a range; another one is refused.
double rangedAt(lua_State* L, int index, const char* name, double low, double high);
/// A vector of finite numbers; another one is refused.
rubble::script::Vector finiteVectorAt(lua_State* L, int index, const char* name);
/// The same for a transform.
rubble::script::Placement finitePlacementAt(lua_State* L, int index, const char* name);
/// A whole number within a range; another one is refused.
int wholeAt(lua_State* L, int index, const char* name, int low, int high);
/// Makes a joint, and leaves its handle on the stack; 1.
int pushJoint(lua_State* L, const rubble_joint_settings& settings);

}  // namespace sandbox
