#pragma once
#include <string>
#include <vector>

#include "runtime/script/sandbox/sandbox.h"

namespace rubble::script {

/// What of a value is left out, and what was found there: ".cars[2].body: a function".
using DataLosses = std::vector<std::string>;

/// A value as a text of Lua that gives it again: nil, true, false, numbers, texts, and tables of these, also Vec(),
/// Quat() and Transform(), in a fixed order. What else is in a table is left out and listed, as is what is beyond 32
/// tables in each other or larger than 1 MiB; of a long list only the first ones. "nil": nothing is left.
std::string dataText(lua_State* L, int index, DataLosses& losses);

}  // namespace rubble::script
