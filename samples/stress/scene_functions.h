#pragma once
#include <span>

#include "runtime/script/binding/script_context.h"

namespace stress {

/// Functions that scenarios have beside the vocabulary of scripts: they make things by the C interface, and say what
/// shall hold. docs/stress.md lists them.
std::span<const rubble::script::ScriptFunction> sceneFunctions();

}  // namespace stress
