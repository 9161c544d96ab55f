#pragma once
#include <string>

#include "runtime/script/sandbox/sandbox.h"

namespace rubble::script {

/// The name of a parameter of the running function, by the index of its argument.
std::string parameterAt(lua_State* L, int index);

/// A message of the interface as the running function gives it: with the names of its parameters in place of fields,
/// without the name of the function of the interface, and without the folder that the host gives to scripts.
std::string messageOf(lua_State* L, std::string message);

}  // namespace rubble::script
