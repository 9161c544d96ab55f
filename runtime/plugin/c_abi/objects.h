#pragma once
#include <optional>

#include "runtime/plugin/c_abi/calls.h"

namespace rubble::abi {

/// Which objects a handle may name: those of now, or also those that waiting edits make.
enum class Found { Present, Reserved };

/// The object of a handle of any kind; none if it names nothing in the World.
std::optional<AnyObject> findObject(const World& world, uint64_t bits, Found which = Found::Present);
/// The same; refuses the call if there is none. `name`: of the argument.
std::optional<AnyObject> readObject(const World& world, uint64_t bits, const char* name, Found which = Found::Present);

}  // namespace rubble::abi
