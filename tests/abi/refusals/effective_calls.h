#pragma once
#include <map>
#include <string>

#include "tests/abi/refusals/usual_calls.h"

namespace rubble {

/// What a call needs beyond usualCalls() to change a FullWorld: a place where something is, or what it acts on. They
/// may step the world.
const std::map<std::string, Prepare>& effectiveCalls();

}  // namespace rubble
