#pragma once
#include <string>

#include "runtime/script/sandbox/sandbox.h"

namespace rubble::script {

/// A value as a text of Lua that gives it again: nil, true, false, numbers, texts, and tables of these, also Vec(),
/// Quat() and Transform(), in a fixed order. Anything else, more than 32 tables in each other and more than 1 MiB are
/// errors that name `what`.
std::string dataText(lua_State* L, int index, const std::string& what);

}  // namespace rubble::script
